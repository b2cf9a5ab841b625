#include "editor/model/tiles/tileset_edit.hpp"

#include <array>

#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tile_palette.hpp"
#include "tests/editor/support/tile_scene.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kPath = "assets/ground.tileset.json";

/// A tile layer whose tileset is a file of the project.
class TilesetEditing : public TileScene {
protected:
    TilesetEditing() {
        putFile(kPath, writeTileset(terrainSet(TerrainMode::Blob, 0)));
        workspace.document.world.get<TileLayer>(workspace.document.find(layer())).tileset =
            workspace.assets.loadTileset(kPath);
        original_ = fileText(kPath);
    }
    [[nodiscard]] const Tileset& tileset() const { return *tilesetOf(workspace.document, layer()); }
    std::string original_;
};

TEST_F(TilesetEditing, aCollisionOfManyTilesIsOneStepAndInTheFileAtOnce) {
    const std::array tiles{3, 5, 9};
    EXPECT_TRUE(changeTileset(workspace, "set collision",
                              [&](Tileset& set) { setShape(set, tiles, TileShape::SlopeUp); }));
    for (const int tile : tiles) EXPECT_EQ(tileset().shapeOf(tile), TileShape::SlopeUp);
    EXPECT_NE(fileText(kPath).find("slopeUp"), std::string::npos);
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_EQ(fileText(kPath), original_);
    EXPECT_EQ(tileset().shapeOf(3), TileShape::None);
    workspace.undo.redo();
    EXPECT_EQ(tileset().shapeOf(9), TileShape::SlopeUp);
}

TEST_F(TilesetEditing, editsWithoutChangeAreNoUndoStepAndDefaultsAreNotWritten) {
    const std::array tiles{1};
    EXPECT_FALSE(changeTileset(workspace, "set collision",
                               [&](Tileset& set) { setShape(set, tiles, TileShape::None); }));
    EXPECT_EQ(workspace.undo.size(), 0u);
    EXPECT_EQ(fileText(kPath), original_);
}

TEST_F(TilesetEditing, aTilesetWithoutAFileReportsThatItCannotBeChanged) {
    useTileset(terrainSet(TerrainMode::Blob, 1));
    EXPECT_FALSE(changeTileset(workspace, "grow", [](Tileset& set) { set.growTo(20, 20); }));
    EXPECT_NE(workspace.notice.find("no file of its own"), std::string::npos);
}

TEST_F(TilesetEditing, framesProbabilitiesPropertiesAndTerrainsAreReadBackFromTheFile) {
    changeTileset(workspace, "all", [](Tileset& set) {
        tileIn(set, 4).animation = {{4, 0.2f}, {5, 0.3f}};
        tileIn(set, 6).probability = 0.25f;
        const std::array tiles{7, 8};
        setProperty(set, tiles, "hazard", propertyJson("true"));
        setProperty(set, tiles, "sound", propertyJson("splash"));
        setPolygons(set, tiles, {{{0.0f, 0.0f}, {16.0f, 8.0f}, {0.0f, 16.0f}}});
        addTerrain(set, TerrainMode::Edges).tiles = {{1, Neighbour::kUp}};
    });
    std::vector<Error> problems;
    const Result<Tileset> read = parseTileset(fileText(kPath), "test", problems);
    ASSERT_TRUE(read.ok());
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(*read, tileset());
    EXPECT_EQ(read->find(8)->property("sound"), "\"splash\"");
    EXPECT_TRUE(read->find(7)->hasFlag("hazard"));
    EXPECT_EQ(read->terrains.front().tiles.front().mask, Neighbour::kUp);
}

TEST_F(TilesetEditing, tilesAreFoundByNumberCollisionAndProperty) {
    changeTileset(workspace, "some", [](Tileset& set) {
        const std::array one{12};
        setProperty(set, one, "hazard", "true");
        setShape(set, one, TileShape::HalfTop);
    });
    EXPECT_EQ(tilesFound(tileset(), "HAZ"), std::vector{12});
    EXPECT_EQ(tilesFound(tileset(), "halfTop"), std::vector{12});
    EXPECT_EQ(tilesFound(tileset(), "55"), std::vector{55});
    EXPECT_EQ(tilesFound(tileset(), "").size(), 200u);
}

TEST(TerrainLayouts, tilesInOrderHaveTheMasksInOrder) {
    const Tileset set = terrainSet(TerrainMode::Blob, 0);
    std::vector<int> chosen;
    for (int tile = 50; tile < 97; ++tile) chosen.push_back(tile);
    Terrain terrain;
    assignMasks(terrain, set, chosen, TerrainLayout::InOrder);
    ASSERT_EQ(terrain.tiles.size(), 47u);
    EXPECT_EQ(maskOf(terrain, 50), 0);
    EXPECT_EQ(maskOf(terrain, 96), Neighbour::kAll);
}

TEST(TerrainLayouts, aBlockHasBordersAndTheFourthColumnIsOneTileWide) {
    using N = Neighbour;
    const Tileset set = terrainSet(TerrainMode::Blob, 0);
    std::vector<int> chosen;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) chosen.push_back(y * set.columns + x + 22);
    }
    Terrain terrain;
    terrain.mode = TerrainMode::Edges;
    assignMasks(terrain, set, chosen, TerrainLayout::FourByFour);
    EXPECT_EQ(maskOf(terrain, 22), N::kRight | N::kDown) << "the upper left corner";
    EXPECT_EQ(maskOf(terrain, 22 + set.columns + 1), N::kEdges) << "the middle";
    EXPECT_EQ(maskOf(terrain, 22 + 3), N::kDown) << "the top of a column";
    EXPECT_EQ(maskOf(terrain, 22 + 3 * set.columns), N::kRight) << "the left end of a row";
    EXPECT_EQ(maskOf(terrain, 22 + 3 * set.columns + 3), 0) << "a tile alone";
    std::vector<bool> seen(256);
    for (const TerrainTile& tile : terrain.tiles) seen[tile.mask] = true;
    for (const std::uint8_t mask : masksOf(TerrainMode::Edges)) EXPECT_TRUE(seen[mask]) << int{mask};
}

TEST(TilesetGrowth, aWiderPictureKeepsAllNumbers) {
    Tileset set;
    set.image = "picture.png";
    set.columns = 3;
    set.count = 6;
    const Tileset before = set;
    EXPECT_EQ(set.growTo(5, 3), 9);
    EXPECT_EQ(set.growTo(6, 4), 9);
    EXPECT_EQ(set.count, 24);
    for (int tile = 0; tile < 6; ++tile) EXPECT_EQ(set.sourceOf(tile), before.sourceOf(tile));
    std::vector<bool> seen(24);
    for (int tile = 0; tile < set.count; ++tile) {
        const Tileset::Place place = set.placeOf(tile);
        EXPECT_EQ(set.tileAt(place), tile);
        const auto slot = static_cast<std::size_t>(place.row * 6 + place.column);
        EXPECT_FALSE(seen[slot]) << "two tiles in one place";
        seen[slot] = true;
    }
    EXPECT_EQ(set.growTo(6, 4), 0);
    EXPECT_EQ(set.tileAt({6, 0}), -1);

    std::vector<Error> problems;
    const Result<Tileset> read = parseTileset(writeTileset(set), "test", problems);
    ASSERT_TRUE(read.ok());
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(read->sizes, set.sizes);
    EXPECT_EQ(paletteOf(set).tileAt({5, 0}), set.tileAt({5, 0}));
}

TEST(TilesetGrowth, sizesThatDoNotMatchTheTileCountAreReportedAndIgnored) {
    std::vector<Error> problems;
    const Result<Tileset> read = parseTileset(
        R"({"format": 1, "image": "a.png", "columns": 3, "count": 9, "sizes": [{"columns": 3, "rows": 2}, {"columns": 5, "rows": 9}]})",
        "test", problems);
    ASSERT_TRUE(read.ok());
    EXPECT_TRUE(read->sizes.empty());
    EXPECT_EQ(problems.size(), 1u);
}

}  // namespace
}  // namespace plumb::editor
