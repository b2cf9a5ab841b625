#pragma once

#include <string>

#include <imgui.h>

namespace plumb::editor::ui {

/// One line of text that grows as it is typed. @return as ImGui::InputText
bool textField(const char* label, std::string& text, ImGuiInputTextFlags flags = 0, const char* hint = "");

}  // namespace plumb::editor::ui
