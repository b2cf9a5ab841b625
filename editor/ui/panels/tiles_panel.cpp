#include <algorithm>
#include <cmath>

#include "assets/asset_store.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tile_brush.hpp"
#include "editor/model/tiles/tileset_edit.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/panels/tile_layer_list.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/palette_view.hpp"
#include "editor/ui/widgets/tile_picture.hpp"
#include "scene/components/drawing/tile_layer.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kLayersWidth = 236.0f;  // px at scale 1
constexpr float kStampWidth = 196.0f;
constexpr float kSearchWidth = 112.0f;
constexpr float kZoomWidth = 170.0f;
constexpr std::size_t kKeptInRow = 5;

/// Painting of tiles: the layers, the tileset and terrains
/// of the active layer, and the tile pattern of the brush.
class TilesPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        Workspace& workspace = ui.workspace;
        if (workspace.document.scenePath.empty()) {
            return emptyState(ui, "Tiles", "No scene is open.",
                              "Tiles are painted on the tile layers of a scene.", {"file.open", "file.new"});
        }
        const ObjectId layer = activeTileLayer(workspace.document, workspace.tiles);
        if (!workspace.document.world.has<TileLayer>(workspace.document.find(layer))) {
            return emptyState(
                ui, "Tiles", "This scene has no tile layer.",
                "Tiles are painted on tile layers. Dragging a tileset from Assets into the scene "
                "adds one too.",
                {"layer.add"});
        }
        const Tileset* tileset = tilesetOf(workspace.document, layer);
        beginChild("layers", {ui.px(kLayersWidth), 0.0f}, false);
        drawTileLayerList(ui);
        ImGui::EndChild();
        ImGui::SameLine(0.0f, ui.px(12.0f));
        beginChild("stamp", {ui.px(kStampWidth), 0.0f}, false);
        drawStampSide(ui, tileset);
        ImGui::EndChild();
        ImGui::SameLine(0.0f, ui.px(12.0f));
        ImGui::BeginGroup();
        drawTiles(ui, tileset);
        ImGui::EndGroup();
    }

private:
    void drawTiles(Ui& ui, const Tileset* tileset) {
        if (tileset == nullptr || tileset->count == 0) {
            return emptyState(ui, "Tiles", "This layer has no tileset.",
                              "Select one in the Inspector: TileLayer, tileset. To make one, right-click an "
                              "image in Assets and choose \"Make tileset\".");
        }
        drawTerrains(ui, *tileset);
        ImGui::SetNextItemWidth(ui.px(kSearchWidth));
        ImGui::InputTextWithHint("##search", "Search tiles", search_.data(), search_.size());
        ui.widgets.mark("Tiles/search");
        tooltip("Searches by number, collision, material, or property name or value.");
        ImGui::SameLine();
        view_.zoomButtons(ui, "Tiles");
        beginChild("palette", {0.0f, 0.0f}, false, ImGuiWindowFlags_HorizontalScrollbar);
        const std::string_view words{search_.data()};
        const std::vector<int> found = tilesFound(*tileset, words);
        view_.draw(ui, *tileset, "Tiles/palette", words.empty() ? nullptr : &found);
        choose(ui);
        if ((dragging_ || chosen_) && !ui.workspace.tiles.activeTerrain)
            view_.frame(start_, end_, palette::kAccent);
        if (!dragging_) view_.describe(*tileset);
        ImGui::EndChild();
    }

    /// Draws a button per terrain, with one of its tiles as icon.
    static void drawTerrains(Ui& ui, const Tileset& tileset) {
        Workspace& workspace = ui.workspace;
        const Terrain* inHand =
            workspace.tiles.activeTerrain ? activeTerrain(tileset, workspace.tiles) : nullptr;
        for (const Terrain& terrain : tileset.terrains) {
            const float side = ImGui::GetFrameHeight();
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float width = side + ImGui::CalcTextSize(terrain.name.c_str()).x + ui.px(14.0f);
            ImGui::PushID(terrain.id);
            if (ImGui::Button("##terrain", {width, side})) {
                workspace.useTool("tool.terrain");
                workspace.tiles.terrain = terrain.id;
            }
            ImGui::PopID();
            ui.widgets.mark("Tiles/terrain/" + terrain.name, inHand == &terrain ? "in hand" : "");
            tooltip(format("Paint {} (T): borders and corners are set automatically", terrain.name));
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const float inset = ui.px(3.0f);
            drawTile(ui, list, tileset, cellOf(iconTileOf(terrain)),
                     {{at.x + inset, at.y + inset}, {at.x + side - inset, at.y + side - inset}});
            list.AddText({at.x + side + ui.px(4.0f), at.y + ImGui::GetStyle().FramePadding.y}, palette::kText,
                         terrain.name.c_str());
            if (inHand == &terrain)
                outline(list, at, {at.x + width, at.y + side}, palette::kAccent, ui.px(3.0f), 2.0f);
            ImGui::SameLine(0.0f, ui.px(5.0f));
        }
        if (tileset.terrains.empty()) return;
        // In a narrow panel the search field starts a new line.
        const float end = ImGui::GetItemRectMax().x + ui.px(12.0f + kSearchWidth + kZoomWidth);
        if (end <= ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) {
            ImGui::SameLine(0.0f, ui.px(12.0f));
        } else {
            ImGui::NewLine();
        }
    }

    /// Returns the tile used as icon: an upper edge tile, as
    /// inner tiles are often plain; else the innermost tile.
    static int iconTileOf(const Terrain& terrain) {
        constexpr int kAbove = 128 | 1 | 2;  // the three neighbours in the row above
        const TerrainTile* inside = nullptr;
        for (const TerrainTile& tile : terrain.tiles) {
            if (inside == nullptr || tile.mask > inside->mask) inside = &tile;
        }
        if (inside == nullptr) return -1;
        for (const TerrainTile& tile : terrain.tiles) {
            if (int{tile.mask} == (int{inside->mask} & ~kAbove)) return tile.tile;
        }
        return inside->tile;
    }

    /// A drag over the palette sets the pattern of the brush,
    /// and activates the brush if no painting tool is active.
    void choose(Ui& ui) {
        Workspace& workspace = ui.workspace;
        if (view_.pressed()) start_ = view_.at(), dragging_ = true;
        if (dragging_) {
            end_ = view_.at();
            made_ = workspace.tiles.stamp = view_.tiles().stamp(start_, end_);
        }
        chosen_ = workspace.tiles.stamp == made_;
        if (!dragging_ || !view_.released()) return;
        dragging_ = false;
        workspace.tiles.activeTerrain = false;
        const std::string_view tool = toolTable()[workspace.toolIndex()].action;
        const bool paints = tool == "tool.brush" || tool == "tool.rectangle" || tool == "tool.fill" ||
                            tool == "tool.line" || tool == "tool.ellipse";
        if (!paints && workspace.canEdit()) workspace.useTool("tool.brush");
    }

    // Drawing of the brush's tile pattern and its buttons.

    void drawStampSide(Ui& ui, const Tileset* tileset) const {
        const TileStamp& stamp = ui.workspace.tiles.stamp;
        ImGui::TextDisabled(
            "%s", stamp.single() ? "Tile" : format("Pattern {} x {}", stamp.width, stamp.height).c_str());
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (tileset != nullptr) drawStamp(ui, *tileset, stamp, {at.x, at.y}, ui.px(64.0f), palette::kAccent);
        ImGui::Dummy({ui.px(64.0f), ui.px(64.0f)});
        ui.widgets.mark("Tiles/stamp", format("{} x {}", stamp.width, stamp.height));
        ImGui::SameLine(0.0f, ui.px(8.0f));
        ImGui::BeginGroup();
        const float gap = ui.px(4.0f);
        const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) * 0.5f);
        stampButton(ui, "tiles.flipX", "Flip X", width);
        ImGui::SameLine(0.0f, gap);
        stampButton(ui, "tiles.flipY", "Flip Y", width);
        stampButton(ui, "tiles.turnBack", "Turn L", width);
        ImGui::SameLine(0.0f, gap);
        stampButton(ui, "tiles.turn", "Turn R", width);
        bool random = ui.workspace.tiles.random;
        if (ImGui::Checkbox("Random", &random)) runAction(ui.workspace, "tiles.random");
        ui.widgets.mark("Tiles/Random", random ? "on" : "off");
        tooltip("Paints random tiles of the pattern, weighted by probability (D)");
        ImGui::EndGroup();
        drawKept(ui, tileset);
    }

    /// Draws the pattern slots 1 to 9: a click activates a
    /// slot's pattern, a right click stores the present pattern.
    static void drawKept(Ui& ui, const Tileset* tileset) {
        TilePaint& tiles = ui.workspace.tiles;
        ImGui::TextDisabled("Kept");
        // Narrow enough to fit beside a scroll bar too.
        const float gap = ui.px(4.0f);
        const float room = ImGui::GetContentRegionAvail().x - gap * static_cast<float>(kKeptInRow - 1);
        const float side = std::min(std::floor(room / static_cast<float>(kKeptInRow)), ui.px(30.0f));
        for (std::size_t i = 0; i < TilePaint::kKept; ++i) {
            if (i % kKeptInRow != 0) ImGui::SameLine(0.0f, gap);
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const std::string path = format("Tiles/kept/{}", i + 1);
            const bool clicked = ImGui::InvisibleButton(path.c_str(), {side, side});
            ui.widgets.mark(
                path, tiles.kept[i] ? format("{} x {}", tiles.kept[i]->width, tiles.kept[i]->height) : "");
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right))
                runAction(ui.workspace, format("tiles.keep{}", i + 1));
            const auto keys = [&](const char* what) {
                const Action& action = *findAction(format("tiles.{}{}", what, i + 1));
                return ui.workspace.settings.keys.shownOf(action).text();
            };
            if (ImGui::IsItemHovered())
                tooltip(
                    format("Click or {}: paint with this pattern. Right-click or {}: store the present "
                           "pattern here.",
                           keys("recall"), keys("keep")));
            if (clicked) runAction(ui.workspace, format("tiles.recall{}", i + 1));
            ImDrawList& list = *ImGui::GetWindowDrawList();
            list.AddRectFilled(at, {at.x + side, at.y + side}, palette::kField, ui.px(3.0f));
            outline(list, at, {at.x + side, at.y + side}, palette::kBorder, ui.px(3.0f));
            if (tiles.kept[i] && tileset != nullptr) {
                drawStamp(ui, *tileset, *tiles.kept[i], {at.x, at.y}, side, palette::kLine);
            } else {
                list.AddText({at.x + side * 0.5f - ui.px(4.0f), at.y + side * 0.5f - ui.fonts.size * 0.5f},
                             palette::kTextDim, format("{}", i + 1).c_str());
            }
        }
    }

    static void stampButton(Ui& ui, const char* id, const char* label, float width) {
        const Action& action = *findAction(id);
        if (ImGui::Button(label, {width, 0.0f})) runAction(ui.workspace, id);
        ui.widgets.mark(std::string{"Tiles/"} + label);
        tooltip(ui.workspace.settings.keys.labelOf(action));
    }

    /// Draws a tile pattern.
    static void drawStamp(Ui& ui, const Tileset& tileset, const TileStamp& stamp, Vec2 at, float room,
                          ImU32 border) {
        const float side =
            std::max(room / static_cast<float>(std::max({stamp.width, stamp.height, 1})), 1.0f);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{at.x + side * static_cast<float>(stamp.width),
                        at.y + side * static_cast<float>(stamp.height)};
        list.AddRectFilled({at.x, at.y}, to, palette::kCanvas);
        for (int y = 0; y < std::min(stamp.height, 64); ++y) {
            for (int x = 0; x < std::min(stamp.width, 64); ++x) {
                const Vec2 corner = at + Vec2{side * static_cast<float>(x), side * static_cast<float>(y)};
                drawTile(ui, list, tileset, stamp.at(x, y), {corner, corner + Vec2{side, side}});
            }
        }
        outline(list, {at.x, at.y}, to, border);
    }

    PaletteView view_;
    std::array<char, 64> search_{};
    CellPlace start_;
    CellPlace end_;
    TileStamp made_;
    bool dragging_ = false;
    bool chosen_ = false;  ///< true if the present pattern was selected in this palette
};

}  // namespace

std::unique_ptr<Panel> makeTilesPanel() { return std::make_unique<TilesPanel>(); }

}  // namespace plumb::editor::ui
