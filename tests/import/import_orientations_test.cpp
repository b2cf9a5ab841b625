// Maps that are isometric, staggered or hexagonal: cells, turns, collision shapes and objects.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "import/import_tiled.hpp"
#include "import/loaders/tmx_loader.hpp"
#include "import/map_lattice.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/tiles_json.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

using tiled::Gid;

constexpr Gid kTurn60 = tiled::kFlipDiagonal;
constexpr Gid kTurn120 = tiled::kRotateHex;
constexpr const char* kHexagonal =
    R"(orientation="hexagonal" tilewidth="16" tileheight="12" hexsidelength="4" staggeraxis="y" staggerindex="odd")";

Vec2 vec2Of(const Json& json) { return {json[0].get<float>(), json[1].get<float>()}; }

class ImportOrientationsTest : public ::testing::Test {
protected:
    void SetUp() override {
        put("art/sheet.png", *encodePng(Image{64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 255)}));
        put("game/project.json", "{}");
    }
    void put(const std::string& name, const std::string& text) const {
        ASSERT_TRUE(writeFile(folder_.path / name, text).ok());
    }
    /// Imports a map with these attributes and content.
    void import(const std::string& attributes, const std::string& content, int width, int height) {
        put("art/level.tmx",
            format("<map {} width=\"{}\" height=\"{}\">{}</map>", attributes, width, height, content));
        Result<ImportReport> imported = importTiled(folder_.path / "art/level.tmx", scene_);
        ASSERT_TRUE(imported.ok()) << imported.error().text();
        report_ = *imported;
        entities_ = read(scene_)["entities"];
    }
    [[nodiscard]] static Json read(const Path& file) { return *parseJson(*readFile(file), "test"); }
    [[nodiscard]] Json readAsset(const std::string& name) const {
        return read(folder_.path / "game/assets/level" / name);
    }
    [[nodiscard]] Json entity(const std::string& name) const {
        for (const Json& entity : entities_) {
            if (entity.value("name", "") == name) return entity;
        }
        ADD_FAILURE() << "there is no entity " << name;
        return Json::object();
    }
    /// Returns the colliders' corners in the world, px, in the order of the entities.
    [[nodiscard]] std::vector<std::vector<Vec2>> outlines(const std::string& component) const {
        std::vector<std::vector<Vec2>> all;
        for (const Json& entity : entities_) {
            if (!entity["components"].contains(component)) continue;
            Vec2 place = placeOf(entity);
            for (const Json& parent : entities_) {
                if (parent["id"] == entity.value("parent", "")) place += placeOf(parent);
            }
            std::vector<Vec2>& points = all.emplace_back();
            for (const Json& point : entity["components"][component]["points"])
                points.push_back(place + vec2Of(point));
        }
        return all;
    }
    [[nodiscard]] static Vec2 placeOf(const Json& entity) {
        const Json& transform = entity["components"]["Transform"];
        return transform.contains("position") ? vec2Of(transform["position"]) : Vec2{};
    }
    [[nodiscard]] bool said(const std::string& text) const {
        return report_.text().find(text) != std::string::npos;
    }

    test::TemporaryFolder folder_;
    Path scene_ = folder_.path / "game/scenes/level.scene.json";
    ImportReport report_;
    Json entities_;
};

std::string tileset(const std::string& content, int width = 16, int height = 16,
                    const std::string& attributes = "") {
    return format(
        "<tileset firstgid=\"1\" name=\"set\" tilewidth=\"{}\" tileheight=\"{}\" {}><image "
        "source=\"sheet.png\"/>{}</tileset>",
        width, height, attributes, content);
}

std::string layer(int width, int height, const std::function<Gid(int x, int y)>& gidAt) {
    std::string cells;
    for (int i = 0; i < width * height; ++i)
        cells += format("{}{}", i == 0 ? "" : ",", gidAt(i % width, i / width));
    return format(
        "<layer name=\"ground\" width=\"{}\" height=\"{}\"><data encoding=\"csv\">{}</data></layer>", width,
        height, cells);
}

/// Attributes of maps of every orientation, stagger axis and index.
std::vector<std::string> everyOrientation() {
    std::vector<std::string> all;
    for (const char* orientation : {"isometric", "staggered", "hexagonal"}) {
        for (const char* axis : {"x", "y"}) {
            for (const char* index : {"odd", "even"}) {
                all.push_back(
                    format("orientation=\"{}\" staggeraxis=\"{}\" staggerindex=\"{}\" hexsidelength=\"4\" "
                           "tilewidth=\"16\" tileheight=\"12\"",
                           orientation, axis, index));
            }
        }
    }
    return all;
}

TEST_F(ImportOrientationsTest, everyTileStandsWhereItsCellIsWithItsFlips) {
    constexpr int kWidth = 3;
    constexpr int kHeight = 5;
    const auto gidAt = [](int x, int y) {
        const Gid flips = (x % 2 == 1 ? tiled::kFlipX : 0) | (y % 3 == 1 ? tiled::kFlipY : 0);
        return static_cast<Gid>(1 + y * kWidth + x) | flips;
    };
    for (const std::string& attributes : everyOrientation()) {
        SCOPED_TRACE(attributes);
        import(attributes, tileset("") + layer(kWidth, kHeight, gidAt), kWidth, kHeight);
        EXPECT_TRUE(report_.problems.empty()) << report_.text();
        EXPECT_EQ(report_.tiles, kWidth * kHeight);
        std::vector<Error> ignored;
        const tiled::Map map = *loadTiledMap(folder_.path / "art/level.tmx", ignored);
        const MapLattice lattice{map};
        const Json ground = entity("ground");
        const Json& tiles = ground["components"]["TileLayer"];
        const TileGrid grid = tilesFromJson(tiles["cells"])->grid;
        int found = 0;
        for (int y = 0; y < grid.height(); ++y) {
            for (int x = 0; x < grid.width(); ++x) found += grid.at(x, y) != 0 ? 1 : 0;
        }
        EXPECT_EQ(found, kWidth * kHeight);
        const Vec2 cellSize = vec2Of(tiles["tileSize"]);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                // MapLatticeTest proves the position of the cell.
                const MapLattice::Cell at = lattice.cellOf(x, y);
                const Vec2 place{static_cast<float>(at.column * lattice.cellWidth()),
                                 static_cast<float>(at.row * lattice.cellHeight() + lattice.drop())};
                const Vec2 cell = place - placeOf(ground);
                const Gid gid = gidAt(x, y);
                EXPECT_EQ(
                    grid.at(static_cast<int>(cell.x / cellSize.x), static_cast<int>(cell.y / cellSize.y)),
                    plumb::cellOf(static_cast<int>(gid & ~tiled::kFlags) - 1, gid & tiled::kFlags));
            }
        }
    }
}

TEST_F(ImportOrientationsTest, chunksBelowZeroKeepTheirParity) {
    const std::string chunks =
        R"(<layer name="ground"><data encoding="csv"><chunk x="-2" y="-3" width="2" height="2">1,0,2,0</chunk>
 </data></layer>)";
    import(std::string{kHexagonal} + " infinite=\"1\"", tileset("") + chunks, 2, 2);
    const Json ground = entity("ground");
    // Row -3 is odd, hence shifted by half a tile; rows are 8 px high, tiles 12 px.
    EXPECT_EQ(placeOf(ground), (Vec2{-32.0f, -20.0f}));
    EXPECT_EQ(ground["components"]["TileLayer"]["cells"]["rows"].dump(), R"(["0 1 0 0","2 0 0 0"])");
    EXPECT_EQ(entity("camera")["components"]["Camera"]["limits"].dump(), "[-32,-24,40,20]");
}

TEST_F(ImportOrientationsTest, theJsonFormHasTheSameLattice) {
    import(kHexagonal, tileset("") + layer(2, 2, [](int, int) { return Gid{1};
}), 2, 2);
const Json cells = entity("ground")["components"]["TileLayer"];
put("art/level.tmj",
    R"({"type": "map", "orientation": "hexagonal", "tilewidth": 16, "tileheight": 12, "hexsidelength": 4,
 "staggeraxis": "y", "staggerindex": "odd", "width": 2, "height": 2, "tilesets": [{"firstgid": 1, "name": "set",
 "tilewidth": 16, "tileheight": 16, "image": "sheet.png", "imagewidth": 64, "imageheight": 64}],
 "layers": [{"type": "tilelayer", "name": "ground", "width": 2, "height": 2, "data": [1, 1, 1, 1]}]})");
ASSERT_TRUE(importTiled(folder_.path / "art/level.tmj", scene_).ok());
entities_ = read(scene_)["entities"];
EXPECT_EQ(entity("ground")["components"]["TileLayer"], cells);
EXPECT_EQ(read(scene_)["tiled"]["hexSide"], 4);
EXPECT_EQ(read(scene_)["tiled"]["staggerAxis"], "y");
EXPECT_EQ(read(scene_)["tiled"]["staggerIndex"], "odd");
}  // namespace

TEST_F(ImportOrientationsTest, aValueThatIsNoStaggerAxisIsReported) {
    import(R"(orientation="staggered" tilewidth="16" tileheight="8" staggeraxis="z" staggerindex="two")", "",
           1, 1);
    EXPECT_TRUE(said("staggeraxis is \"z\"")) << report_.text();
    EXPECT_TRUE(said("staggerindex is \"two\"")) << report_.text();
}

/// A picture of 16 x 16 px, transparent but for 4 x 4 px around the point (11, 4).
Image markedPicture() {
    Image image{16, 16, std::vector<std::uint8_t>(16 * 16 * 4, 0)};
    for (int y = 2; y < 6; ++y) {
        for (int x = 9; x < 13; ++x) std::fill_n(image.rgba.begin() + 4 * (y * 16 + x), 4, std::uint8_t{255});
    }
    return image;
}

/// Returns the center of the visible pixels of a region, px from the region's center.
Vec2 markIn(const Image& image, const Rect& region) {
    Vec2 sum;
    int count = 0;
    for (int y = 0; y < static_cast<int>(region.height); ++y) {
        for (int x = 0; x < static_cast<int>(region.width); ++x) {
            const int row = static_cast<int>(region.y) + y;
            const int column = static_cast<int>(region.x) + x;
            if (image.rgba[4 * static_cast<std::size_t>(row * image.width + column) + 3] == 0) continue;
            sum += Vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            ++count;
        }
    }
    EXPECT_GT(count, 0);
    return sum * (1.0f / static_cast<float>(std::max(count, 1))) - Vec2{region.width, region.height} * 0.5f;
}

TEST_F(ImportOrientationsTest, hexagonalTilesShowEveryTurnAndFlip) {
    put("art/sheet.png", *encodePng(markedPicture()));
    // Sixteen combinations of the four bits, one in each cell.
    const auto gidAt = [](int x, int y) { return Gid{1} | static_cast<Gid>(x + 4 * y) << 28; };
    import(kHexagonal, tileset("") + layer(4, 4, gidAt), 4, 4);
    EXPECT_TRUE(report_.problems.empty()) << report_.text();

    const Json ground = entity("ground")["components"]["TileLayer"];
    EXPECT_EQ(ground["tileset"], "assets/level/set_turned.tileset.json");
    const TileGrid grid = tilesFromJson(ground["cells"])->grid;
    const Json set = readAsset("set_turned.tileset.json");
    EXPECT_EQ(set["count"], 3) << "the tile, and its pictures turned by 60 and 120 degrees";
    const Image sheet = *decodeImage(*readFile(folder_.path / "game/assets/level/set_turned.png"), "");
    const Vec2 offset = vec2Of(set["offset"]);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            const Gid gid = gidAt(x, y);
            SCOPED_TRACE(hexText(gid));
            // The format: flips first, then turns by 60 and 120 degrees, all about the tile's center.
            Vec2 expected = Vec2{11.0f, 4.0f} - Vec2{8.0f, 8.0f};
            if ((gid & tiled::kFlipX) != 0) expected.x = -expected.x;
            if ((gid & tiled::kFlipY) != 0) expected.y = -expected.y;
            const double degrees =
                ((gid & kTurn60) != 0 ? 60.0 : 0.0) + ((gid & kTurn120) != 0 ? 120.0 : 0.0);
            const auto sin = static_cast<float>(std::sin(degrees * 3.14159265358979 / 180.0));
            const auto cos = static_cast<float>(std::cos(degrees * 3.14159265358979 / 180.0));
            expected = {expected.x * cos - expected.y * sin, expected.x * sin + expected.y * cos};

            const TileCell cell = grid.at(2 * x + y % 2, y);
            EXPECT_EQ(cell & kTileFlipDiagonal, 0u);
            const Json& source = set["images"][static_cast<std::size_t>(tileOf(cell))]["source"];
            const Rect region{source[0], source[1], source[2], source[3]};
            Vec2 mark = markIn(sheet, region);
            if ((cell & kTileFlipX) != 0) mark.x = -mark.x;
            if ((cell & kTileFlipY) != 0) mark.y = -mark.y;
            EXPECT_NEAR(mark.x, expected.x, 0.35f);
            EXPECT_NEAR(mark.y, expected.y, 0.35f);
            // The picture's center is that of a tile of 16 x 16 px on the cell's lower left corner.
            EXPECT_EQ((offset + Vec2{region.width, -region.height} * 0.5f), (Vec2{8.0f, -8.0f}));
        }
    }
}

TEST_F(ImportOrientationsTest, turnedTilesKeepTheirDataAndTheirAnimation) {
    const std::string tiles =
        R"(<tile id="2" type="spring"><properties><property name="force" type="int" value="7"/></properties>
 <animation><frame tileid="2" duration="100"/><frame tileid="5" duration="50"/></animation></tile>)";
    import(kHexagonal, tileset(tiles) + layer(2, 1, [](int x, int) { return x == 0 ? 3 | kTurn60 : Gid{1};
}), 2, 1);
EXPECT_TRUE(report_.problems.empty()) << report_.text();
const Json set = readAsset("set_turned.tileset.json");
EXPECT_EQ(set["count"], 3) << "an upright tile and two turned frames";
const Json& spring = set["tiles"][0];
EXPECT_EQ(spring["id"], 1);
EXPECT_EQ(spring["properties"]["force"], 7);
EXPECT_EQ(spring["tiled"]["type"], "spring");
EXPECT_EQ(spring["animation"][0]["tile"], 1);
EXPECT_EQ(spring["animation"][1]["tile"], 2);
EXPECT_EQ(readAsset("set.tileset.json")["count"], 16) << "objects still use the upright tiles";
}  // namespace plumb

TEST_F(ImportOrientationsTest, turnsWithoutAPictureAreReported) {
    put("art/sheet.png", "no picture");
    import(kHexagonal,
           R"(<tileset firstgid="1" name="set" tilewidth="16" tileheight="16"><image source="sheet.png" width="64"
 height="64"/></tileset>)" +
               layer(2, 1, [](int, int) { return 1 | kTurn60;
}),
           2, 1);
EXPECT_TRUE(said("2 cells are turned by 60 or 120 degrees")) << report_.text();
EXPECT_EQ(entity("ground")["components"]["TileLayer"]["cells"]["rows"].dump(), R"(["1 0 1 0"])");
}

TEST_F(ImportOrientationsTest, turnBitsOfOtherMapsAreNoTurns) {
    import(R"(orientation="staggered" tilewidth="16" tileheight="12")",
           tileset("") + layer(2, 1, [](int x, int) { return 1 | (x == 0 ? kTurn60 : kTurn120);
}), 2, 1);
EXPECT_EQ(entity("ground")["components"]["TileLayer"]["cells"]["rows"].dump(), R"(["1d 0 1 0"])");
}

TEST_F(ImportOrientationsTest, collisionShapesFollowTheirTiles) {
    const std::string tiles =
        R"(<tileoffset x="3" y="-2"/><tile id="0"><objectgroup><object id="1" x="2" y="4" width="6" height="10"/>
 <object id="2" x="8" y="16"><polygon points="0,0 8,0 8,-4"/></object></objectgroup></tile>)";
    const auto gidAt = [](int x, int) { return x == 0 ? Gid{1} : 1 | tiled::kFlipX; };
    import(R"(orientation="staggered" tilewidth="16" tileheight="8" staggeraxis="x")",
           tileset(tiles) + layer(2, 1, gidAt), 2, 1);
    EXPECT_TRUE(report_.problems.empty()) << report_.text();
    EXPECT_EQ(report_.colliders, 4);
    EXPECT_FALSE(entity("ground")["components"].contains("TileCollider"));
    // The images' upper left corners: cells at (0, 0) and (8, 4) px, 8 px lower than the images, and the
    // offset.
    const Vec2 first{3.0f, -10.0f};
    const Vec2 second{11.0f, -6.0f};
    const auto moved = [](std::vector<Vec2> points, Vec2 by) {
        for (Vec2& point : points) point += by;
        return points;
    };
    const std::vector<std::vector<Vec2>> expected{
        moved({{2, 4}, {8, 4}, {8, 14}, {2, 14}}, first), moved({{8, 16}, {16, 16}, {16, 12}}, first),
        moved({{14, 4}, {8, 4}, {8, 14}, {14, 14}}, second), moved({{8, 16}, {0, 16}, {0, 12}}, second)};
    EXPECT_EQ(outlines("PolygonCollider"), expected);
    EXPECT_TRUE(said("tiles painted later have none")) << report_.text();
}

TEST_F(ImportOrientationsTest, collisionShapesTurnWithTheirTiles) {
    const std::string tiles =
        R"(<tile id="0"><objectgroup><object id="1" x="8" y="8"><polygon points="0,0 6,0 0,2"/></object>
 </objectgroup></tile>)";
    import(kHexagonal, tileset(tiles) + layer(1, 1, [](int, int) { return 1 | kTurn60;
}), 1, 1);
const std::vector<std::vector<Vec2>> found = outlines("PolygonCollider");
ASSERT_EQ(found.size(), 1u);
// The image's center is 8 px above the lower edge of a cell 12 px high.
const Vec2 center{8.0f, 4.0f};
const std::vector<Vec2> expected{center, center + Vec2{3.0f, 5.196152f}, center + Vec2{-1.732051f, 1.0f}};
for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(length(found[0][i] - expected[i]), 1e-4f) << found[0][i].x << " " << found[0][i].y;
}

TEST_F(ImportOrientationsTest, linesAreSolidFromBothSides) {
    const std::string tiles =
        R"(<tile id="0"><objectgroup><object id="1" x="0" y="8"><polyline points="0,0 8,-4 16,0"/></object>
 <object id="2" x="1" y="1"><point/></object></objectgroup></tile>)";
    import(R"(orientation="isometric" tilewidth="16" tileheight="8")",
           tileset(tiles) + layer(1, 1, [](int, int) { return Gid{1};
}), 1, 1);
const std::vector<Vec2> line{{0, 0}, {8, -4}, {16, 0}};
EXPECT_EQ(outlines("ChainCollider"), (std::vector<std::vector<Vec2>>{line, {line.rbegin(), line.rend()}}));
EXPECT_TRUE(said("tile 0: point 2: the collision shape is not as in Tiled: it has neither")) << report_.text();
}

TEST_F(ImportOrientationsTest, shapesInAnIsometricGridAreProjected) {
    const std::string tiles =
        R"(<grid orientation="isometric" width="16" height="8"/><tile id="0"><objectgroup>
 <object id="1" x="0" y="0" width="8" height="8"/></objectgroup></tile>)";
    import(R"(orientation="isometric" tilewidth="16" tileheight="8")",
           tileset(tiles) + layer(1, 1, [](int, int) { return Gid{1};
}), 1, 1);
// The whole cell: a diamond of 16 x 8 px on the lower edge of the image and of the map's only cell.
EXPECT_EQ(outlines("PolygonCollider"), (std::vector<std::vector<Vec2>>{{{8, 0}, {16, 4}, {8, 8}, {0, 4}}}));
}

TEST_F(ImportOrientationsTest, objectsStandWhereTiledDrawsThem) {
    const std::string objects =
        R"(<objectgroup name="things"><object id="1" name="pill" x="8" y="0" width="8" height="8"><capsule/></object>
 <object id="2" name="spot" x="16" y="8"><point/></object></objectgroup>)";
    import(R"(orientation="isometric" tilewidth="16" tileheight="8")", objects, 2, 3);
    // 24 px: half a cell for each of three rows. An object's px are 8 a cell on both axes.
    EXPECT_EQ(placeOf(entity("spot")), (Vec2{24.0f + (2 - 1) * 8.0f, (2 + 1) * 4.0f}));
    EXPECT_EQ(placeOf(entity("pill")), (Vec2{24.0f + 8.0f, 4.0f}));
    const Json pill = entity("pill")["components"]["PolygonCollider"];
    EXPECT_EQ(pill["isTrigger"], true);
    float right = 0.0f;
    for (const Json& point : pill["points"]) right = std::max(right, vec2Of(point).x);
    EXPECT_NEAR(right, 5.656854f, 0.1f) << "a circle of 4 px of the map, seen from the side";

    import(kHexagonal, objects, 2, 3);
    EXPECT_EQ(placeOf(entity("spot")), (Vec2{16.0f, 8.0f})) << "pixels of the screen";
    EXPECT_EQ(placeOf(entity("pill")), (Vec2{8.0f, 0.0f}));
}

TEST_F(ImportOrientationsTest, tilesThatFillTheGridAreAsLargeAsACellOfTheMap) {
    import(R"(orientation="isometric" tilewidth="32" tileheight="16")",
           tileset("", 64, 64, "tilerendersize=\"grid\"") + layer(1, 1, [](int, int) { return Gid{1};
}), 1, 1);
EXPECT_TRUE(report_.problems.empty()) << report_.text();
const Json set = readAsset("set.tileset.json");
const Vec2 cell = vec2Of(entity("ground")["components"]["TileLayer"]["tileSize"]);
const Vec2 own = vec2Of(set["tileSize"]);
const Json& source = set["images"][0]["source"];
EXPECT_EQ(source[2].get<float>() * cell.x / own.x, 32.0f);
EXPECT_EQ(source[3].get<float>() * cell.y / own.y, 16.0f);

    import(R"(orientation="isometric" tilewidth="32" tileheight="14")",
           tileset("", 10, 9, "tilerendersize=\"grid\"") + layer(1, 1, [](int, int) { return Gid{1};
    }), 1, 1);
    EXPECT_TRUE(said("cannot be stretched exactly")) << report_.text();
    }

    TEST_F(ImportOrientationsTest, anOrderThatSeveralTilesetsChangeIsReported) {
        const std::string sets =
            tileset("") +
            R"(<tileset firstgid="50" name="more" tilewidth="16" tileheight="16"><image source="sheet.png"/></tileset>)";
    import(kHexagonal, sets + layer(2, 1, [](int x, int) { return x == 0 ? Gid{1} : Gid{50};
    }), 2, 1);
    EXPECT_TRUE(said("layer ground: tiles of 2 tilesets")) << report_.text();
    import(kHexagonal, sets + layer(2, 1, [](int, int) { return Gid{50};
    }), 2, 1);
    EXPECT_FALSE(said("tiles of 2 tilesets")) << report_.text();
    }

    TEST_F(ImportOrientationsTest, importingAgainChangesNoByte) {
        const std::string tiles =
            R"(<tile id="0"><objectgroup><object id="1" x="2" y="4" width="6" height="10"/></objectgroup></tile>)";
        const std::string content =
            tileset(tiles) + layer(3, 3, [](int x, int) { return x == 1 ? 1 | kTurn60 : 1; });
        import(kHexagonal, content, 3, 3);
        std::vector<std::string> first;
        for (const std::string& file : report_.files)
            first.push_back(*readFile(folder_.path / "game" / file));
        const std::vector<std::string> files = report_.files;
        import(kHexagonal, content, 3, 3);
        ASSERT_EQ(report_.files, files);
        for (std::size_t i = 0; i < files.size(); ++i)
            EXPECT_EQ(*readFile(folder_.path / "game" / files[i]), first[i]) << files[i];
    }

    }  // namespace
    }  // namespace plumb
