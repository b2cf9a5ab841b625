#include "editor/ui/widgets/asset_mark.hpp"

#include "editor/ui/icons.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kSide = 17.0f;  // px at scale 1
constexpr float kSign = 11.0f;

/// Draws two beamed musical notes.
void drawNotes(ImDrawList& list, ImVec2 center, float size, ImU32 color) {
    const float half = size * 0.5f;
    const auto at = [&](float x, float y) { return ImVec2{center.x + x * half, center.y + y * half}; };
    const float line = size > 18.0f ? 2.0f : 1.5f;
    for (const float x : {-0.45f, 0.75f}) {
        list.AddCircleFilled(at(x - 0.25f, 0.65f), half * 0.34f, color);
        list.AddLine(at(x, 0.65f), at(x, -0.75f), color, line);
    }
    list.AddLine(at(-0.45f, -0.75f), at(0.75f, -0.75f), color, line * 1.6f);
}

}  // namespace

void drawAssetMark(const Ui& ui, ImDrawList& list, AssetKind kind, ImVec2 corner) {
    if (kind == AssetKind::None) return;
    const float side = ui.px(kSide);
    const ImVec2 from{corner.x - side, corner.y - side};
    const ImVec2 center{corner.x - side * 0.5f, corner.y - side * 0.5f};
    list.AddRectFilled(from, corner, palette::kPopup, ui.px(4.0f));
    outline(list, from, corner, palette::kBorder, ui.px(4.0f), 1.0f);
    const auto icon = [&](Icon which, ImU32 color) { drawIcon(list, which, center, ui.px(kSign), color); };
    switch (kind) {
        case AssetKind::Texture: return icon(Icon::Picture, palette::kAccent);
        case AssetKind::Tileset: return icon(Icon::Tiles, palette::kOrange);
        case AssetKind::Animation: return icon(Icon::Play, palette::kPlay);
        case AssetKind::Sound: return drawNotes(list, center, ui.px(kSign), palette::kBlue);
        case AssetKind::Font: return icon(Icon::Text, palette::kSand);
        case AssetKind::Scene: return icon(Icon::Layers, palette::kOrange);
        case AssetKind::Prefab: return icon(Icon::Star, palette::kViolet);
        case AssetKind::None: return;
    }
}

}  // namespace plumb::editor::ui
