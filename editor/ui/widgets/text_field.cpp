#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

/// Callback of ImGui::InputText that resizes the string while the user types.
int grow(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag != ImGuiInputTextFlags_CallbackResize) return 0;
    auto& text = *static_cast<std::string*>(data->UserData);
    text.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = text.data();
    return 0;
}

}  // namespace

bool textField(const char* label, std::string& text, ImGuiInputTextFlags flags, const char* hint) {
    return ImGui::InputTextWithHint(label, hint, text.data(), text.capacity() + 1,
                                    flags | ImGuiInputTextFlags_CallbackResize, &grow, &text);
}

}  // namespace plumb::editor::ui
