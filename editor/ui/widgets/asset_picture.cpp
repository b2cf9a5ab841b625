#include "editor/ui/widgets/asset_picture.hpp"

#include <algorithm>
#include <cmath>

#include "assets/asset_store.hpp"
#include "editor/model/assets/sheet_part.hpp"
#include "editor/ui/scene_picture.hpp"
#include "editor/ui/ui_compat.hpp"
#include "reflect/json_members.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kLargestZoom = 4.0f;
constexpr float kSquare = 5.0f;  // px at scale 1, side of a square of the checkerboard

/// Draws a checkerboard background, which makes transparent and dark parts of an image visible.
void drawChecks(const Ui& ui, ImDrawList& list, const AABB& box) {
    list.AddRectFilled({box.min.x, box.min.y}, {box.max.x, box.max.y}, palette::kHover);
    const float side = ui.px(kSquare);
    for (int row = 0; box.min.y + static_cast<float>(row) * side < box.max.y; ++row) {
        for (int column = row % 2; box.min.x + static_cast<float>(column) * side < box.max.x; column += 2) {
            const Vec2 from = box.min + Vec2{static_cast<float>(column), static_cast<float>(row)} * side;
            const Vec2 to = min(from + Vec2{side, side}, box.max);
            list.AddRectFilled({from.x, from.y}, {to.x, to.y}, palette::kHover);
        }
    }
}

/// Draws a part of a texture as large as the box allows, enlarged by whole factors only.
/// @param wanted  source rectangle, px; empty: the whole texture, or the start of a very long one
void drawPart(Ui& ui, ImDrawList& list, TextureId id, const Rect& wanted, const AABB& box) {
    const Texture* texture = ui.workspace.assets.find(id);
    if (ui.picture == nullptr || texture == nullptr || texture->width <= 0 || texture->height <= 0) return;
    const Rect source =
        !wanted.empty()
            ? wanted
            : legiblePart({static_cast<float>(texture->width), static_cast<float>(texture->height)});
    const Vec2 size{source.width, source.height};
    const Vec2 room = box.size();
    float zoom = std::min(room.x / size.x, room.y / size.y);
    if (zoom > 1.0f) zoom = std::min(std::floor(zoom), kLargestZoom * ui.scale);
    const Vec2 half = size * (zoom * 0.5f);
    const Vec2 center = box.center();
    const std::array corners{
        ImVec2{center.x - half.x, center.y - half.y}, ImVec2{center.x + half.x, center.y - half.y},
        ImVec2{center.x + half.x, center.y + half.y}, ImVec2{center.x - half.x, center.y + half.y}};
    const TexturePart part = ui.picture->part(id, source);
    const std::array uv{part.from, Vec2{part.to.x, part.from.y}, part.to, Vec2{part.from.x, part.to.y}};
    quadOfPixels(list, textureId(part.texture), corners, uv, IM_COL32_WHITE);
}

/// Returns the frame of the first clip at a time, s; null if there is none.
const AnimationFrame* frameAt(const AnimationSet& set, double seconds) {
    if (set.clips.empty() || set.clips.front().frames.empty()) return nullptr;
    const std::vector<AnimationFrame>& frames = set.clips.front().frames;
    double total = 0.0;
    for (const AnimationFrame& frame : frames) total += static_cast<double>(frame.seconds);
    double rest = total > 0.0 ? std::fmod(seconds, total) : 0.0;
    for (const AnimationFrame& frame : frames) {
        rest -= static_cast<double>(frame.seconds);
        if (rest < 0.0) return &frame;
    }
    return &frames.front();
}

void drawSheet(ImDrawList& list, const Ui& ui, const AABB& box, ImU32 color, const char* word) {
    const Vec2 center = box.center();
    const float side = std::min(box.size().x, box.size().y) * 0.3f;
    const ImVec2 size = ImGui::CalcTextSize(word);
    const bool fits = size.x + ui.px(12.0f) <= box.size().x;  // false for the small thumbnail beside a field
    const float half = fits ? std::max(side * 0.8f, size.x * 0.5f + ui.px(6.0f)) : side * 0.8f;
    const ImVec2 from{center.x - half, center.y - side};
    const ImVec2 to{center.x + half, center.y + side};
    list.AddRectFilled(from, to, palette::kCard, ui.px(4.0f));
    outline(list, from, to, color, ui.px(4.0f), ui.px(1.5f));
    if (fits) list.AddText({center.x - size.x * 0.5f, center.y - size.y * 0.5f}, color, word);
}

/// Returns the asset path stored in a field of a component; empty if there is none.
std::string namedBy(const PrefabEntity& entity, const char* component, const char* field) {
    const Json* found = findMember(entity.components, component);
    const std::string* path = found == nullptr ? nullptr : findText(*found, field);
    return path == nullptr ? std::string{} : *path;
}

/// Draws the first entity with an animation or a texture. @return true if there is one
bool drawPrefab(Ui& ui, ImDrawList& list, std::string_view path, const AABB& box, double playing) {
    PrefabLibrary* prefabs = ui.workspace.prefabs().prefabs;
    const Result<const Prefab*> prefab = prefabs != nullptr ? prefabs->find(path) : Error{};
    if (!prefab) return false;
    for (const PrefabEntity& entity : (*prefab)->entities) {
        if (const std::string animation = namedBy(entity, "Animator", "animation"); !animation.empty())
            return drawAsset(ui, list, AssetKind::Animation, animation, box, playing), true;
        if (const std::string texture = namedBy(entity, "Sprite", "texture"); !texture.empty())
            return drawPart(ui, list, ui.workspace.assets.loadTexture(texture), {}, box), true;
    }
    return false;
}

}  // namespace

void drawAsset(Ui& ui, ImDrawList& list, AssetKind kind, std::string_view path, const AABB& box,
               double playing) {
    AssetStore& assets = ui.workspace.assets;
    switch (kind) {
        case AssetKind::Texture:
            drawChecks(ui, list, box);
            return drawPart(ui, list, assets.loadTexture(path), {}, box);
        case AssetKind::Tileset: {
            const Tileset& set = assets.tileset(assets.loadTileset(path));
            if (!set.image.empty()) return drawPart(ui, list, set.texture, {}, box);
            if (!set.images.empty())
                return drawPart(ui, list, set.images.front().texture, set.images.front().source, box);
            return drawSheet(list, ui, box, palette::kGreen, "Tiles");
        }
        case AssetKind::Animation: {
            const AnimationSet& set = assets.animation(assets.loadAnimation(path));
            const AnimationFrame* frame = frameAt(set, playing);
            if (frame == nullptr || set.frameWidth <= 0 || set.frameHeight <= 0)
                return drawPart(ui, list, set.texture, {}, box);
            const Rect source{static_cast<float>(frame->cellX * set.frameWidth),
                              static_cast<float>(frame->cellY * set.frameHeight),
                              static_cast<float>(set.frameWidth), static_cast<float>(set.frameHeight)};
            return drawPart(ui, list, set.texture, source, box);
        }
        case AssetKind::Sound: return drawSheet(list, ui, box, palette::kBlue, "Sound");
        case AssetKind::Font: return drawSheet(list, ui, box, palette::kSand, "Aa");
        case AssetKind::Scene: return drawSheet(list, ui, box, palette::kOrange, "Scene");
        case AssetKind::Prefab:
            if (drawPrefab(ui, list, path, box, playing)) return;
            return drawSheet(list, ui, box, palette::kViolet, "Prefab");
        case AssetKind::None: break;
    }
    drawSheet(list, ui, box, palette::kTextDim, "File");
}

void drawImage(Ui& ui, ImDrawList& list, std::string_view path, const AABB& box) {
    const TextureId id = ui.workspace.assets.loadTexture(path);
    const Texture* texture = ui.workspace.assets.find(id);
    if (texture == nullptr) return;
    drawChecks(ui, list, box);
    drawPart(ui, list, id,
             {0.0f, 0.0f, static_cast<float>(texture->width), static_cast<float>(texture->height)}, box);
}

std::string acceptAsset(std::string& hovering) {
    hovering.clear();
    std::string dropped;
    if (!ImGui::BeginDragDropTarget()) return dropped;
    constexpr ImGuiDragDropFlags kFlags =
        ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect;
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kAssetPayload, kFlags)) {
        hovering = static_cast<const char*>(payload->Data);
        if (payload->IsDelivery()) dropped = hovering;
    }
    ImGui::EndDragDropTarget();
    return dropped;
}

}  // namespace plumb::editor::ui
