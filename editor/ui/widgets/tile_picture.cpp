#include "editor/ui/widgets/tile_picture.hpp"

#include <array>
#include <utility>

#include "editor/ui/scene_picture.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {

void drawTile(Ui& ui, ImDrawList& list, const Tileset& tileset, TileCell cell, const AABB& box, ImU32 tint) {
    const int tile = tileOf(cell);
    if (tile < 0 || ui.picture == nullptr) return;
    const TileImage* own = tileset.imageOf(tile);
    const TexturePart part = ui.picture->part(own != nullptr ? own->texture : tileset.texture,
                                              own != nullptr ? own->source : tileset.sourceOf(tile));
    // Flips exchange corners of the texture rectangle.
    std::array<Vec2, 4> uv{part.from, Vec2{part.to.x, part.from.y}, part.to, Vec2{part.from.x, part.to.y}};
    if ((cell & kTileFlipDiagonal) != 0) std::swap(uv[1], uv[3]);
    if ((cell & kTileFlipX) != 0) std::swap(uv[0], uv[1]), std::swap(uv[2], uv[3]);
    if ((cell & kTileFlipY) != 0) std::swap(uv[0], uv[3]), std::swap(uv[1], uv[2]);
    const std::array corners{ImVec2{box.min.x, box.min.y}, ImVec2{box.max.x, box.min.y},
                             ImVec2{box.max.x, box.max.y}, ImVec2{box.min.x, box.max.y}};
    quadOfPixels(list, textureId(part.texture), corners, uv, tint);
}

}  // namespace plumb::editor::ui
