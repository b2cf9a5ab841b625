#pragma once

#include <string>

#include <imgui.h>

namespace plumb::editor::ui {

/// Single-line text field for a std::string of any length. @return the result of ImGui::InputText
bool textField(const char* label, std::string& text, ImGuiInputTextFlags flags = 0, const char* hint = "");

}  // namespace plumb::editor::ui
