#include "editor/ui/widgets/held_value.hpp"

#include "core/text.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kMost = 1e9f;  // limit of dragged numbers

}  // namespace

std::optional<float> DeferredNumber::draw(Ui& ui, const std::string& path, float now, float speed,
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

std::optional<std::string> DeferredText::draw(Ui& ui, const std::string& path, const std::string& now) {
    if (path_ != path || before_ != now) {
        path_ = path;
        text_ = before_ = now;
    }
    textField(("##" + path).c_str(), text_);
    ui.widgets.mark(path, text_);
    if (!ImGui::IsItemDeactivatedAfterEdit()) return std::nullopt;
    before_.clear();  // the next call reads the text again, whether the change was accepted or rejected
    path_.clear();
    if (text_ == now) return std::nullopt;
    return text_;
}

}  // namespace plumb::editor::ui
