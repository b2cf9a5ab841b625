#include "editor/ui/widgets/palette_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/tile_picture.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kMaxZoom = 8.0f;

ImVec2 toImgui(Vec2 point) { return {point.x, point.y}; }

}  // namespace

AABB PaletteView::boxOf(CellPlace place) const {
    const Vec2 corner = from_ + scaled({static_cast<float>(place.x), static_cast<float>(place.y)}, cell_);
    return {corner, corner + cell_};
}

void PaletteView::frame(CellPlace a, CellPlace b, ImU32 color, float thickness) const {
    const AABB box = merged(boxOf(a), boxOf(b));
    outline(*ImGui::GetWindowDrawList(), toImgui(box.min), toImgui(box.max), color, 0.0f, thickness);
}

void PaletteView::zoomButtons(Ui& ui, const std::string& path) {
    const auto zoomBy = [&](float steps) { zoom_ = std::clamp(zoom_ + steps, 1.0f, kMaxZoom); };
    if (ImGui::SmallButton(" - ")) zoomBy(-1.0f);
    ui.widgets.mark(path + "/zoomOut");
    ImGui::SameLine();
    ImGui::TextUnformatted(format("{}x", zoom_).c_str());
    ui.widgets.mark(path + "/zoom", format("{}", zoom_));
    ImGui::SameLine();
    if (ImGui::SmallButton(" + ")) zoomBy(1.0f);
    ui.widgets.mark(path + "/zoomIn");
    tooltip("Ctrl+wheel over the tiles zooms too; the middle button pans.");
    ImGui::SameLine();
    ImGui::Checkbox("Grid", &grid);
    ui.widgets.mark(path + "/grid", grid ? "on" : "off");
}

void PaletteView::navigate(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    hovered_ = ImGui::IsItemHovered();
    if (hovered_ && io.KeyCtrl && io.MouseWheel != 0.0f)
        zoom_ = std::clamp(zoom_ + (io.MouseWheel > 0.0f ? 1.0f : -1.0f), 1.0f, kMaxZoom);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseDragging(2, 0.0f)) {
        ImGui::SetScrollX(ImGui::GetScrollX() - io.MouseDelta.x);
        ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
    }
    static_cast<void>(ui);
}

void PaletteView::draw(Ui& ui, const Tileset& tileset, const std::string& path,
                       const std::vector<int>* found) {
    tiles_ = paletteOf(tileset);
    if (zoom_ == 0.0f) {
        const float room = ImGui::GetContentRegionAvail().x / (tiles_.size().x * ui.scale);
        zoom_ = std::clamp(std::floor(room), 2.0f, 4.0f);
    }
    const float zoom = zoom_ * ui.scale;
    const Vec2 size = tiles_.size() * zoom;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    from_ = {at.x, at.y};
    cell_ = tiles_.tileSize * zoom;
    ImGui::InvisibleButton("tiles", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    ui.widgets.mark(path, format("{} tiles", tiles_.count));
    const ImGuiIO& io = ImGui::GetIO();
    at_ = tiles_.nearest((Vec2{io.MousePos.x, io.MousePos.y} - from_) / zoom);
    pressed_ = ImGui::IsItemActivated();
    held_ = ImGui::IsItemActive();
    released_ = ImGui::IsItemDeactivated();
    navigate(ui);
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, palette::kCanvas);
    drawTiles(ui, tileset, found);
}

void PaletteView::drawTiles(Ui& ui, const Tileset& tileset, const std::vector<int>* found) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int tile = 0; tile < tiles_.count; ++tile) {
        const AABB box = boxOf(tiles_.placeOf(tile));
        if (!ImGui::IsRectVisible(toImgui(box.min), toImgui(box.max))) continue;
        const bool bright = found == nullptr || std::binary_search(found->begin(), found->end(), tile);
        drawTile(ui, list, tileset, cellOf(tileset.shownTile(tile, ImGui::GetTime())), box,
                 bright ? IM_COL32_WHITE : palette::kFaded);
        if (grid) outline(list, toImgui(box.min), toImgui(box.max), palette::kCellLine);
    }
}

void PaletteView::describe(const Tileset& tileset) const {
    const int tile = tiles_.tileAt(at_);
    if (!hovered_ || tile < 0) return;
    frame(at_, at_, palette::kCellHovered, 1.0f);
    std::string words = format("Tile {}", tile);
    if (tileset.shapeOf(tile) != TileShape::None)
        words += format(": {}", tileShapeNames()[static_cast<std::size_t>(tileset.shapeOf(tile))]);
    if (const Tile* known = tileset.find(tile)) {
        for (const TileProperty& property : known->properties)
            words += format("\n{} = {}", property.name, property.json);
        if (!known->animation.empty()) words += format("\n{} frames", known->animation.size());
    }
    tooltip(words);
}

}  // namespace plumb::editor::ui
