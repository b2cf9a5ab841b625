#include "editor/ui/widgets/held_value.hpp"

#include "core/text.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kMost = 1e9f;  // numbers of files stay below it

}  // namespace

std::optional<float> HeldNumber::draw(Ui& ui, const std::string& path, float now, float speed,
                                      const char* format) {
    float shown = path_ == path ? value_ : now;
    ImGui::DragFloat(("##" + path).c_str(), &shown, speed, -kMost, kMost, format,
                     ImGuiSliderFlags_AlwaysClamp);
    ui.widgets.mark(path, shortestText(shown));
    if (ImGui::IsItemActive()) {
        path_ = path;
        value_ = shown;
    } else if (path_ == path) {
        path_.clear();
    }
    if (!ImGui::IsItemDeactivatedAfterEdit() || shown == now) return std::nullopt;
    return shown;
}

std::optional<std::string> HeldText::draw(Ui& ui, const std::string& path, const std::string& now) {
    if (path_ != path || before_ != now) {
        path_ = path;
        text_ = before_ = now;
    }
    textField(("##" + path).c_str(), text_);
    ui.widgets.mark(path, text_);
    if (!ImGui::IsItemDeactivatedAfterEdit()) return std::nullopt;
    before_.clear();  // what is there from now on, taken or refused
    path_.clear();
    if (text_ == now) return std::nullopt;
    return text_;
}

}  // namespace plumb::editor::ui
