#include "editor/ui/widget_map.hpp"

#include <imgui.h>

namespace plumb::editor::ui {

void WidgetMap::mark(std::string_view path, std::string_view value) {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    if (ImGui::IsItemFocused()) focused_ = path;
    mark(path, {{from.x, from.y}, {to.x, to.y}}, value);
}

void WidgetMap::mark(std::string_view path, const AABB& box, std::string_view value) {
    widgets_.insert_or_assign(std::string{path}, Widget{box, std::string{value}});
}

const WidgetMap::Widget* WidgetMap::find(std::string_view path) const {
    const auto found = widgets_.find(path);
    return found == widgets_.end() ? nullptr : &found->second;
}

}  // namespace plumb::editor::ui
