#include <algorithm>

#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/editor/support/tile_scene.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::string_view kPath = "assets/ground.tileset.json";

/// The editor window without a screen, on a tile layer whose tileset is a file.
class TilesWindow : public TileScene {
protected:
    TilesWindow() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        putFile(kPath, writeTileset(terrainSet(TerrainMode::Blob, 1)));
        workspace.document.world.get<TileLayer>(workspace.document.find(layer())).tileset =
            workspace.assets.loadTileset(kPath);
        original_ = fileText(kPath);
        hands.key(Key::B);
        hands.rest(2);
    }
    [[nodiscard]] const Tileset& tileset() const { return *tilesetOf(workspace.document, layer()); }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const WidgetMap::Widget* found = window.widgets().find(widget);
        EXPECT_NE(found, nullptr) << widget << " is not on the screen";
        return found == nullptr ? std::string{} : found->value;
    }
    /// Returns the position of a tile in a palette, which shows ten tiles per row, in window coordinates.
    [[nodiscard]] Vec2 tileAt(std::string_view palette, int tile) const {
        const AABB& box = window.widgets().find(palette)->box;
        const float cell = box.size().x / 10.0f;
        return box.min +
               Vec2{static_cast<float>(tile % 10) + 0.5f, static_cast<float>(tile / 10) + 0.5f} * cell;
    }
    void openTileset() { hands.click("Tab/Tileset"), hands.rest(2); }

    LogBook log;
    EditorWindow window;
    Hands hands;
    std::string original_;
};

TEST_F(TilesWindow, aTerrainIsSelectedByItsButtonAndPainted) {
    hands.click("Tiles/terrain/terrain");
    EXPECT_TRUE(workspace.tiles.activeTerrain);
    EXPECT_EQ(valueOf("Tiles/terrain/terrain"), "in hand");
    stroke({1, 1}, {3, 1});
    EXPECT_NE(gridOf(workspace.document, layer())->at(2, 1), 0u);
    hands.clickAt(tileAt("Tiles/palette", 3));
    EXPECT_FALSE(workspace.tiles.activeTerrain) << "a tile of the palette goes before the terrain";
}

TEST_F(TilesWindow, controlsAboveThePaletteAreVisibleInANarrowPane) {
    const float right = window.widgets().find("Viewport")->box.max.x;
    for (const char* widget : {"Tiles/terrain/terrain", "Tiles/search", "Tiles/zoomIn", "Tiles/grid"})
        EXPECT_LE(window.widgets().find(widget)->box.max.x, right) << widget;
}

TEST_F(TilesWindow, theLayerListChoosesHidesLocksAndShowsAlone) {
    runAction(workspace, "layer.add");
    hands.rest(2);
    hands.click("Tiles/layers/ground");
    EXPECT_EQ(activeTileLayer(workspace.document, workspace.tiles), layer());
    EXPECT_EQ(valueOf("Tiles/layers/ground"), "in hand");
    hands.click("Tiles/layers/ground/seen");
    EXPECT_TRUE(workspace.document.view.isHidden(layer()));
    hands.click("Tiles/layers/ground/lock");
    EXPECT_TRUE(workspace.document.view.locks(layer()));
    hands.click("Tiles/layers/ground/solo");
    EXPECT_EQ(workspace.document.view.solo(), layer());
    EXPECT_EQ(workspace.undo.size(), 1u) << "ways of looking are no edits";
}

TEST_F(TilesWindow, aLayerIsMadeSolidAndNewOnesAreAsSolidAsTheOneInHand) {
    const auto isSolid = [&](ObjectId id) {
        return workspace.document.world.has<TileCollider>(workspace.document.find(id));
    };
    const bool before = isSolid(layer());
    EXPECT_EQ(valueOf("Tiles/layer/solid"), before ? "on" : "off");
    hands.click("Tiles/layer/solid");
    EXPECT_NE(isSolid(layer()), before);
    EXPECT_EQ(workspace.undo.size(), 1u);
    runAction(workspace, "layer.add");
    hands.rest(2);
    ASSERT_NE(workspace.tiles.layer, layer());
    EXPECT_EQ(isSolid(workspace.tiles.layer), isSolid(layer()));
    workspace.undo.jumpTo(0);
    EXPECT_EQ(isSolid(layer()), before);
}

TEST_F(TilesWindow, theButtonsAboveTheLayersAreVisible) {
    const float right = window.widgets().find("Viewport")->box.max.x;
    for (const char* widget : {"Tiles/layer.add", "Tiles/layer.raise", "Tiles/layer.lower"})
        EXPECT_LE(window.widgets().find(widget)->box.max.x, right) << widget;
}

TEST_F(TilesWindow, opacityIsOneStepForOneDrag) {
    const AABB box = window.widgets().find("Tiles/layer/opacity")->box;
    hands.drag(box.center(), {box.min.x + 2.0f, box.center().y});
    const auto& tiles = workspace.document.world.get<TileLayer>(workspace.document.find(layer()));
    EXPECT_LT(tiles.tint.a, 40);
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.document.world.get<TileLayer>(workspace.document.find(layer())).tint.a, 255);
}

TEST_F(TilesWindow, stampsAreStoredByTheRightButtonAndLoadedByTheLeft) {
    hands.clickAt(tileAt("Tiles/palette", 12));
    hands.clickAt(hands.middleOf("Tiles/kept/2"), MouseButton::Right);
    hands.clickAt(tileAt("Tiles/palette", 5));
    hands.click("Tiles/kept/2");
    EXPECT_EQ(workspace.tiles.stamp.cells, std::vector{cellOf(12)});
}

TEST_F(TilesWindow, collisionsAreSetForManyTilesAtOnce) {
    openTileset();
    hands.drag(tileAt("Tileset/palette", 11), tileAt("Tileset/palette", 13));
    EXPECT_EQ(valueOf("Tileset/chosen"), "3");
    hands.click("Tileset/collision/slopeUp");
    for (const int tile : {11, 12, 13}) EXPECT_EQ(tileset().shapeOf(tile), TileShape::SlopeUp);
    EXPECT_EQ(workspace.undo.size(), 1u);
    hands.click("Tileset/oneWay");
    EXPECT_TRUE(tileset().find(12)->oneWay);
    workspace.undo.undo();
    workspace.undo.undo();
    EXPECT_EQ(fileText(kPath), original_);
}

TEST_F(TilesWindow, chosenTilesBecomeFrames) {
    openTileset();
    hands.drag(tileAt("Tileset/palette", 10), tileAt("Tileset/palette", 12));
    hands.click("Tileset/page/Animation");
    hands.click("Tileset/makeFrames");
    ASSERT_NE(tileset().find(10), nullptr);
    EXPECT_EQ(tileset().find(10)->animation.size(), 3u);
    EXPECT_EQ(tileset().find(10)->animation.back().tile, 12);
    hands.click("Tileset/frame/1/remove");
    EXPECT_EQ(tileset().find(10)->animation.size(), 2u);
}

TEST_F(TilesWindow, aTerrainIsMadeOfTheChosenTilesAndItsMasksAreMended) {
    openTileset();
    hands.drag(tileAt("Tileset/palette", 0), tileAt("Tileset/palette", 33));
    hands.click("Tileset/page/Terrain");
    hands.click("Tileset/addTerrain/edges");
    ASSERT_EQ(tileset().terrains.size(), 2u);
    hands.rest(2);
    hands.click("Tileset/layout/4 x 4");
    EXPECT_EQ(tileset().terrains.back().tiles.size(), 16u);
    hands.clickAt(tileAt("Tileset/palette", 11));
    hands.rest(2);
    EXPECT_EQ(valueOf("Tileset/mask/1"), "on");
    hands.click("Tileset/mask/1");
    const auto& tiles = tileset().terrains.back().tiles;
    const auto tile =
        std::find_if(tiles.begin(), tiles.end(), [](const TerrainTile& t) { return t.tile == 11; });
    ASSERT_NE(tile, tiles.end());
    EXPECT_EQ(tile->mask & Neighbour::kUp, 0);
}

}  // namespace
}  // namespace plumb::editor::ui
