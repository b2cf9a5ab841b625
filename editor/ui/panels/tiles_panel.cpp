#include <algorithm>
#include <cmath>

#include "assets/asset_store.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/tile_palette.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/tile_picture.hpp"
#include "scene/components/tile_layer.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kSideWidth = 190.0f;  // px at scale 1
constexpr float kMaxZoom = 8.0f;
constexpr ImU32 kTileLine = IM_COL32(255, 255, 255, 22);

/// The tileset of the layer in hand: click a tile, or drag over several, to paint with them.
class TilesPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        Workspace& workspace = ui.workspace;
        const ObjectId layer = activeTileLayer(workspace.document, workspace.tiles);
        const TileLayer* tiles = workspace.document.world.find<TileLayer>(workspace.document.find(layer));
        if (tiles == nullptr) {
            ImGui::TextWrapped("There are no tiles here to paint with.");
            ImGui::TextDisabled("Create an entity (Ctrl+N) and add the component TileLayer to it.");
            return;
        }
        const Tileset* tileset = workspace.assets.find(tiles->tileset);
        drawSide(ui, layer, tileset);
        ImGui::SameLine();
        beginChild("palette", {0.0f, 0.0f}, false, ImGuiWindowFlags_HorizontalScrollbar);
        if (tileset == nullptr || tileset->count == 0) {
            ImGui::TextWrapped("This layer has no tileset yet.");
            ImGui::TextDisabled("Select the layer and choose one in the inspector: TileLayer, tileset.");
        } else {
            drawPalette(ui, *tileset);
        }
        ImGui::EndChild();
    }

private:
    void drawSide(Ui& ui, ObjectId layer, const Tileset* tileset) {
        beginChild("side", {ui.px(kSideWidth), 0.0f}, false);
        ImGui::TextDisabled("Layer");
        chooseLayer(ui, layer);
        ImGui::Spacing();
        const TileStamp& stamp = ui.workspace.tiles.stamp;
        ImGui::TextDisabled(
            "%s", stamp.single() ? "Tile" : format("Pattern {} x {}", stamp.width, stamp.height).c_str());
        if (tileset != nullptr) drawStamp(ui, *tileset);
        stampButton(ui, "tiles.flipX", "Flip X");
        ImGui::SameLine();
        stampButton(ui, "tiles.flipY", "Flip Y");
        ImGui::SameLine();
        stampButton(ui, "tiles.turn", "Turn");
        ImGui::Spacing();
        ImGui::TextDisabled("Zoom");
        ImGui::SameLine();
        if (ImGui::SmallButton(" - ")) zoomBy(-1.0f);
        ImGui::SameLine();
        ImGui::TextUnformatted(format("{}x", zoom_).c_str());
        ImGui::SameLine();
        if (ImGui::SmallButton(" + ")) zoomBy(1.0f);
        tooltip("Ctrl and the wheel over the tiles do the same.");
        ImGui::EndChild();
    }

    void zoomBy(float steps) { zoom_ = std::clamp(zoom_ + steps, 1.0f, kMaxZoom); }

    static void chooseLayer(Ui& ui, ObjectId layer) {
        Workspace& workspace = ui.workspace;
        const Document& document = workspace.document;
        ImGui::SetNextItemWidth(-1.0f);
        const bool open = ImGui::BeginCombo("##layer", document.nameOf(layer).c_str());
        ui.widgets.mark("Tiles/layer", document.nameOf(layer));
        if (!open) return;
        for (const ObjectId id : document.objects()) {
            if (!document.world.has<TileLayer>(document.find(id))) continue;
            ImGui::PushID(static_cast<int>(id.value));
            const std::string name = document.nameOf(id);
            const bool chosen = ImGui::Selectable(name.c_str(), id == layer);
            ui.widgets.mark("Tiles/layer/" + name);
            ImGui::PopID();
            if (!chosen) continue;
            workspace.tiles.layer = id;
            workspace.document.selection.set({id});
            break;
        }
        ImGui::EndCombo();
    }

    static void stampButton(Ui& ui, const char* id, const char* label) {
        const Action& action = *findAction(id);
        if (ImGui::Button(label)) runAction(ui.workspace, id);
        ui.widgets.mark(std::string{"Tiles/"} + label);
        tooltip(format("{}  ({})", action.label, action.shortcut.text()));
    }

    /// What the brush would paint, as it would look.
    static void drawStamp(Ui& ui, const Tileset& tileset) {
        const TileStamp& stamp = ui.workspace.tiles.stamp;
        const float room = ui.px(56.0f);
        const float side = std::floor(room / static_cast<float>(std::max({stamp.width, stamp.height, 1})));
        const ImVec2 from = ImGui::GetCursorScreenPos();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{from.x + side * static_cast<float>(stamp.width),
                        from.y + side * static_cast<float>(stamp.height)};
        list.AddRectFilled(from, to, palette::kCanvas);
        for (int y = 0; y < stamp.height; ++y) {
            for (int x = 0; x < stamp.width; ++x) {
                const Vec2 at{from.x + side * static_cast<float>(x), from.y + side * static_cast<float>(y)};
                drawTile(ui, list, tileset, stamp.at(x, y), {at, at + Vec2{side, side}});
            }
        }
        outline(list, from, to, palette::kAccent);
        ImGui::Dummy({room, room});
    }

    void drawPalette(Ui& ui, const Tileset& tileset) {
        const TilePalette shown = paletteOf(tileset);
        if (zoom_ == 0.0f) {
            const float room = ImGui::GetContentRegionAvail().x / (shown.size().x * ui.scale);
            zoom_ = std::clamp(std::floor(room), 2.0f, 4.0f);
        }
        const float zoom = zoom_ * ui.scale;
        const Vec2 size = shown.size() * zoom;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::InvisibleButton("tiles", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
        ui.widgets.mark("Tiles/palette");
        const ImGuiIO& io = ImGui::GetIO();
        if (ImGui::IsItemHovered() && io.KeyCtrl && io.MouseWheel != 0.0f)
            zoomBy(io.MouseWheel > 0.0f ? 1.0f : -1.0f);
        const Vec2 mouse = (Vec2{io.MousePos.x, io.MousePos.y} - Vec2{at.x, at.y}) / zoom;
        choose(ui, shown, shown.nearest(mouse));

        ImDrawList& list = *ImGui::GetWindowDrawList();
        const Vec2 from{at.x, at.y};
        const Vec2 cell = shown.tileSize * zoom;
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, palette::kCanvas);
        const auto boxOf = [&](CellPlace place) {
            const Vec2 corner =
                from + scaled({static_cast<float>(place.x), static_cast<float>(place.y)}, cell);
            return AABB{corner, corner + cell};
        };
        for (int tile = 0; tile < shown.count; ++tile) {
            const AABB box = boxOf(shown.placeOf(tile));
            if (!ImGui::IsRectVisible({box.min.x, box.min.y}, {box.max.x, box.max.y})) continue;
            drawTile(ui, list, tileset, cellOf(tile), box);
            outline(list, {box.min.x, box.min.y}, {box.max.x, box.max.y}, kTileLine);
        }
        if (dragging_ || chosen_) {
            const AABB box = merged(boxOf(start_), boxOf(end_));
            outline(list, {box.min.x, box.min.y}, {box.max.x, box.max.y}, palette::kAccent, 0.0f, 2.0f);
        }
        if (ImGui::IsItemHovered() && !dragging_)
            drawHover(tileset, shown, list, boxOf(shown.nearest(mouse)), shown.nearest(mouse));
    }

    static void drawHover(const Tileset& tileset, const TilePalette& shown, ImDrawList& list, const AABB& box,
                          CellPlace place) {
        const int tile = shown.tileAt(place);
        if (tile < 0) return;
        outline(list, {box.min.x, box.min.y}, {box.max.x, box.max.y}, IM_COL32(255, 255, 255, 160));
        const std::string_view shape = tileShapeNames()[static_cast<std::size_t>(tileset.shapeOf(tile))];
        tooltip(tileset.shapeOf(tile) == TileShape::None ? format("Tile {}", tile)
                                                         : format("Tile {}: {}", tile, shape));
    }

    /// A drag over the tiles makes them the pattern to paint with; the brush comes to hand.
    void choose(Ui& ui, const TilePalette& shown, CellPlace at) {
        Workspace& workspace = ui.workspace;
        if (ImGui::IsItemActivated()) start_ = at, dragging_ = true;
        if (dragging_) {
            end_ = at;
            made_ = workspace.tiles.stamp = shown.stamp(start_, end_);
        }
        chosen_ = workspace.tiles.stamp == made_;
        if (!dragging_ || !ImGui::IsItemDeactivated()) return;
        dragging_ = false;
        const std::string_view tool = toolTable()[workspace.toolIndex()].action;
        const bool paints = tool == "tool.brush" || tool == "tool.rectangle" || tool == "tool.fill";
        if (!paints && workspace.canEdit()) workspace.useTool("tool.brush");
    }

    float zoom_ = 0.0f;  ///< 0: as large as the panel is wide
    CellPlace start_;
    CellPlace end_;
    TileStamp made_;
    bool dragging_ = false;
    bool chosen_ = false;  ///< the stamp is what was chosen here
};

}  // namespace

std::unique_ptr<Panel> makeTilesPanel() { return std::make_unique<TilesPanel>(); }

}  // namespace plumb::editor::ui
