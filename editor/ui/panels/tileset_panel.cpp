#include "editor/ui/panels/tileset_panel.hpp"

#include <algorithm>
#include <array>

#include "assets/asset_store.hpp"
#include "editor/model/assets/make_tileset.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tileset_edit.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/palette_view.hpp"
#include "scene/components/drawing/tile_layer.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kPagesWidth = 330.0f;  // px at scale 1

enum class Page : unsigned char { Tile, Animation, Terrain };

/// Edits the tileset of the active layer: collision shapes and properties, animations, terrains.
class TilesetPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        Workspace& workspace = ui.workspace;
        if (workspace.document.scenePath.empty()) {
            return emptyState(ui, "Tileset", "No scene is open.",
                              "The tileset of the active tile layer appears here.",
                              {"file.open", "file.new"});
        }
        const ObjectId layer = activeTileLayer(workspace.document, workspace.tiles);
        const Tileset* tileset = tilesetOf(workspace.document, layer);
        if (tileset == nullptr || tileset->count == 0) {
            return emptyState(ui, "Tileset", "The active layer has no tileset.",
                              "Select a tile layer and set its tileset in the Inspector. To make a tileset, "
                              "right-click an image in Assets and choose \"Make tileset\".");
        }
        const TilesetId id = workspace.document.world.get<TileLayer>(workspace.document.find(layer)).tileset;
        std::erase_if(chosen_, [&](int tile) { return tile >= tileset->count; });
        const float width = ImGui::GetContentRegionAvail().x - ui.px(kPagesWidth + 12.0f);
        beginChild("picture", {width, 0.0f}, false);
        drawHead(ui, *tileset, workspace.assets.pathOf(id));
        beginChild("palette", {0.0f, 0.0f}, false, ImGuiWindowFlags_HorizontalScrollbar);
        drawPalette(ui, *tileset);
        ImGui::EndChild();
        ImGui::EndChild();
        ImGui::SameLine(0.0f, ui.px(12.0f));
        beginChild("pages", {0.0f, 0.0f}, false);
        drawPages(ui, *tileset);
        ImGui::EndChild();
    }

private:
    void drawHead(Ui& ui, const Tileset& tileset, std::string_view path) {
        ImGui::SetNextItemWidth(ui.px(112.0f));
        ImGui::InputTextWithHint("##search", "Search tiles", search_.data(), search_.size());
        ui.widgets.mark("Tileset/search");
        ImGui::SameLine();
        view_.zoomButtons(ui, "Tileset");
        ImGui::SameLine(0.0f, ui.px(12.0f));
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", std::string{path.substr(path.rfind('/') + 1)}.c_str());
        ui.widgets.mark("Tileset/path", path);
        tooltip(path);
        drawGrowth(ui, tileset);
        drawTileSize(ui, tileset);
    }

    /// Draws the tile size field, only for a tileset without
    /// tile data and terrains: a new size would invalidate them.
    static void drawTileSize(Ui& ui, const Tileset& tileset) {
        const Texture* picture = ui.workspace.assets.find(tileset.texture);
        if (picture == nullptr || !tileset.tiles.empty() || !tileset.terrains.empty()) return;
        std::array size{tileset.tileWidth, tileset.tileHeight};
        ImGui::SetNextItemWidth(ui.px(112.0f));
        const bool entered =
            ImGui::InputInt2("Tile size, px", size.data(), ImGuiInputTextFlags_EnterReturnsTrue);
        ui.widgets.mark("Tileset/size", format("{} x {}", tileset.tileWidth, tileset.tileHeight));
        if (!entered) return;
        changeTileset(ui.workspace, "set tile size",
                      [&](Tileset& set) { setTileSize(set, size[0], size[1], *picture); });
        ui.workspace.undo.endGesture();
    }

    /// Offers to add tiles if the image file has grown.
    static void drawGrowth(Ui& ui, const Tileset& tileset) {
        const Texture* picture = ui.workspace.assets.find(tileset.texture);
        if (picture == nullptr || tileset.image.empty() || tileset.tileWidth <= 0 || tileset.tileHeight <= 0)
            return;
        const TilesetSize room = roomFor(tileset, *picture);
        Tileset larger = tileset;
        const int more = larger.growTo(room.columns, room.rows);
        if (more <= 0) return;
        if (ImGui::Button(format("Add {} tiles", more).c_str())) {
            changeTileset(ui.workspace, "add tiles to tileset",
                          [&](Tileset& set) { set.growTo(room.columns, room.rows); });
            ui.workspace.undo.endGesture();
        }
        ui.widgets.mark("Tileset/grow", format("{}", more));
        tooltip("The image has room for more tiles. Existing tiles keep their numbers.");
    }

    void drawPalette(Ui& ui, const Tileset& tileset) {
        const std::string_view words{search_.data()};
        const std::vector<int> found = tilesFound(tileset, words);
        view_.draw(ui, tileset, "Tileset/palette", words.empty() ? nullptr : &found);
        choose(tileset);
        drawMarks(tileset);
        for (const int tile : chosen_)
            view_.frame(view_.tiles().placeOf(tile), view_.tiles().placeOf(tile), palette::kAccent);
        if (dragging_) view_.frame(start_, view_.at(), palette::kText, 1.0f);
        if (!dragging_) view_.describe(tileset);
    }

    /// A drag selects a box of tiles; Shift adds to the selection, Ctrl+click toggles one tile.
    void choose(const Tileset& tileset) {
        if (view_.pressed()) start_ = view_.at(), dragging_ = true;
        if (!dragging_ || !view_.released()) return;
        dragging_ = false;
        const ImGuiIO& io = ImGui::GetIO();
        std::vector<int> tiles;
        for (const TileCell cell : view_.tiles().stamp(start_, view_.at()).cells) {
            if (cell != 0 && tileOf(cell) < tileset.count) tiles.push_back(tileOf(cell));
        }
        if (io.KeyCtrl && tiles.size() == 1 && std::erase(chosen_, tiles.front()) > 0) return;
        if (!io.KeyShift && !io.KeyCtrl) chosen_.clear();
        for (const int tile : tiles) {
            if (std::find(chosen_.begin(), chosen_.end(), tile) == chosen_.end()) chosen_.push_back(tile);
        }
    }

    /// Draws the collision shapes over the tiles or, on the page "Terrain", the neighbour masks.
    void drawMarks(const Tileset& tileset) const {
        const auto edited = std::find_if(tileset.terrains.begin(), tileset.terrains.end(),
                                         [&](const Terrain& terrain) { return terrain.id == terrain_; });
        if (page_ == Page::Terrain && edited != tileset.terrains.end()) {
            for (const TerrainTile& tile : edited->tiles)
                drawMask(view_.boxOf(view_.tiles().placeOf(tile.tile)), *edited, tile.mask);
            return;
        }
        for (const Tile& tile : tileset.tiles) {
            if (tile.id < tileset.count)
                drawOutline(tileset, tile, view_.boxOf(view_.tiles().placeOf(tile.id)));
        }
    }

    static void drawOutline(const Tileset& tileset, const Tile& tile, const AABB& box) {
        const Vec2 size{static_cast<float>(tileset.tileWidth), static_cast<float>(tileset.tileHeight)};
        const bool oneWay = tile.oneWay || tile.shape == TileShape::OneWay;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const auto at = [&](Vec2 point) {
            const Vec2 inner = box.size() - Vec2{2.0f, 2.0f};
            return ImVec2{box.min.x + 1.0f + inner.x * point.x / size.x,
                          box.min.y + 1.0f + inner.y * point.y / size.y};
        };
        for (const std::vector<Vec2>& points : outlinesOf(tile, size)) {
            const std::size_t lines = tile.shape == TileShape::OneWay ? 1 : points.size();
            for (std::size_t i = 0; i < lines; ++i)
                list.AddLine(at(points[i]), at(points[(i + 1) % points.size()]),
                             oneWay ? palette::kOneWay : palette::kSolid, 1.5f);
        }
    }

    /// Fills the center, and the side of each neighbour in the mask, in the color of the terrain.
    static void drawMask(const AABB& box, const Terrain& terrain, std::uint8_t mask) {
        const ImU32 color = IM_COL32(terrain.color.r, terrain.color.g, terrain.color.b, 150);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const Vec2 third = box.size() / 3.0f;
        constexpr std::array<std::uint8_t, 9> kBits{128, 1, 2, 64, 0, 4, 32, 16, 8};
        for (int i = 0; i < 9; ++i) {
            const std::uint8_t bit = kBits[static_cast<std::size_t>(i)];
            const bool middle = i == 4 && terrain.mode != TerrainMode::Corners;
            if ((mask & bit) == 0 && !middle) continue;
            const Vec2 corner =
                box.min + scaled({static_cast<float>(i % 3), static_cast<float>(i / 3)}, third);
            list.AddRectFilled({corner.x, corner.y}, {corner.x + third.x, corner.y + third.y}, color);
        }
    }

    void drawPages(Ui& ui, const Tileset& tileset) {
        const auto tab = [&](const char* label, Page page) {
            const bool open = ImGui::BeginTabItem(label);
            ui.widgets.mark(std::string{"Tileset/page/"} + label, open ? "open" : "");
            if (!open) return false;
            page_ = page;
            return true;
        };
        if (!ImGui::BeginTabBar("pages")) return;
        if (tab("Tile", Page::Tile)) meaning_->draw(ui, tileset, chosen_), ImGui::EndTabItem();
        if (tab("Animation", Page::Animation)) animation_->draw(ui, tileset, chosen_), ImGui::EndTabItem();
        if (tab("Terrain", Page::Terrain))
            drawTerrainPage(ui, tileset, chosen_, terrain_), ImGui::EndTabItem();
        ImGui::EndTabBar();
    }

    PaletteView view_;
    std::array<char, 64> search_{};
    std::vector<int> chosen_;
    CellPlace start_;
    bool dragging_ = false;
    Page page_ = Page::Tile;
    std::unique_ptr<TilesetPage> meaning_ = makeTileMeaningPage();
    std::unique_ptr<TilesetPage> animation_ = makeTileAnimationPage();
    int terrain_ = 0;
};

}  // namespace

std::unique_ptr<Panel> makeTilesetPanel() { return std::make_unique<TilesetPanel>(); }

}  // namespace plumb::editor::ui
