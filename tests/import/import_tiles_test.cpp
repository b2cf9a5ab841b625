// Tiles of Tiled maps: their collision shapes, and images and tiles that are not where a map looks for them.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "import/import_tiled.hpp"
#include "math/vec2.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

/// A project, and a map with an image in a folder next to it.
class ImportTilesTest : public ::testing::Test {
protected:
    void SetUp() override {
        const Image sheet{32, 32, std::vector<std::uint8_t>(32 * 32 * 4, 255)};
        ASSERT_TRUE(writeFile(folder_.path / "art/sheet.png", *encodePng(sheet)).ok());
        ASSERT_TRUE(writeFile(project_ / "project.json", "{\"resolution\": [320, 180]}").ok());
    }
    Result<ImportReport> import() { return importTiled(folder_.path / "art/level.tmx", scene_); }
    static Json read(const Path& file) { return *parseJson(*readFile(file), "test"); }

    test::TemporaryFolder folder_;
    Path project_ = folder_.path / "game";
    Path scene_ = project_ / "scenes/level.scene.json";
};

TEST_F(ImportTilesTest, theShapesOfATileBecomeItsPolygons) {
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="land" tilewidth="16" tileheight="16"><image source="sheet.png"/>
  <tile id="0"><objectgroup><object id="1" x="0" y="8" width="16" height="8"/>
   <object id="2" x="8" y="0" width="8" height="8"/></objectgroup></tile>
  <tile id="1"><objectgroup><object id="1" x="0" y="0" width="16" height="6"/>
   <object id="2" x="0" y="6" width="16" height="10"/></objectgroup></tile>
  <tile id="2"><objectgroup><object id="1" x="0" y="0" width="4" height="4"/>
   <object id="2" x="8" y="8"><polygon points="0,0 8,0 8,8"/></object></objectgroup></tile>
  <tile id="3"><objectgroup><object id="1" x="-4" y="8" width="24" height="12"/></objectgroup></tile>
 </tileset><layer name="ground" width="1" height="1"><data encoding="csv">1</data></layer></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    const Json tiles = read(project_ / "assets/level/land.tileset.json")["tiles"];
    EXPECT_EQ(tiles[0]["collision"].dump(), "[[[0,8],[16,8],[16,16],[0,16]],[[8,0],[16,0],[16,8],[8,8]]]");
    EXPECT_EQ(tiles[1]["collision"], "full");
    EXPECT_EQ(tiles[2]["collision"].dump(), "[[[0,0],[4,0],[4,4],[0,4]],[[8,8],[16,8],[16,16]]]");
    EXPECT_EQ(tiles[3]["collision"].dump(), "[[0,8],[16,8],[16,16],[0,16]]");
    const std::string text = report->text();
    EXPECT_EQ(report->problems.size(), 1u) << text;
    EXPECT_NE(text.find("tile 3: rectangle 1: the collision shape is not as in Tiled: it reaches out"),
              std::string::npos)
        << text;
}

/// True if one of the polygons in a tileset file contains a point; the file has one or a list of them.
bool isSolidAt(const Json& collision, Vec2 point) {
    const Json all = collision[0][0].is_array() ? collision : Json::array({collision});
    for (const Json& polygon : all) {
        bool inside = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Json& from = polygon[i];
            const Json& to = polygon[(i + 1) % polygon.size()];
            const Vec2 a{from[0].get<float>(), from[1].get<float>()};
            const Vec2 b{to[0].get<float>(), to[1].get<float>()};
            if ((a.y <= point.y) == (b.y <= point.y)) continue;
            if (a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) > point.x) inside = !inside;
        }
        if (inside) return true;
    }
    return false;
}

/// Expects that points are solid where a function is positive and open where it is negative.
template <class Function>
void expectSolid(const Json& collision, const Function& depth) {
    for (float y = 0.3f; y < 16.0f; y += 0.37f) {
        for (float x = 0.3f; x < 16.0f; x += 0.37f) {
            const float deep = depth(Vec2{x, y});
            if (std::abs(deep) <= 0.15f) continue;
            ASSERT_EQ(isSolidAt(collision, {x, y}), deep > 0.0f) << x << " " << y;
        }
    }
}

TEST_F(ImportTilesTest, shapesOfATileThatAreNotConvexCollideWhereTheyAreDrawn) {
    const auto xml = [](const char* shapes) {
        return format(
            R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="land" tilewidth="16" tileheight="16"><image source="sheet.png"/>
{}</tileset><layer name="ground" width="1" height="1"><data encoding="csv">1</data></layer></map>)",
            shapes);
    };
    ASSERT_TRUE(writeFile(folder_.path / "art/level.tmx", xml(R"(
  <tile id="0"><objectgroup><object id="1" x="0" y="0"><polygon points="0,0 16,0 8,8 16,16 0,16"/></object>
   </objectgroup></tile>
  <tile id="1"><objectgroup><object id="1" x="2" y="4" width="12" height="8"><ellipse/></object>
   </objectgroup></tile>
  <tile id="2"><objectgroup><object id="1" x="8" y="2" width="8" height="4" rotation="45"/>
   <object id="2" x="1" y="10"><polyline points="0,0 14,0 14,5"/></object></objectgroup></tile>
  <tile id="3"><objectgroup><object id="1" x="0" y="0" width="4" height="4"/>
   <object id="2" x="8" y="8"><point/></object></objectgroup></tile>)"))
                    .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    const Json tiles = read(project_ / "assets/level/land.tileset.json")["tiles"];
    ASSERT_EQ(tiles.size(), 4u);
    expectSolid(tiles[0]["collision"],
                [](Vec2 p) { return std::max(8.0f - p.x, std::abs(p.y - 8.0f) - p.x + 8.0f); });
    expectSolid(tiles[1]["collision"], [](Vec2 p) {
        const Vec2 part{(p.x - 8.0f) / 6.0f, (p.y - 8.0f) / 4.0f};
        return 4.0f * (1.0f - length(part));
    });
    expectSolid(tiles[2]["collision"], [](Vec2 p) {
        const auto box = [](Vec2 at, Vec2 half) {
            return std::min(half.x - std::abs(at.x), half.y - std::abs(at.y));
        };
        const Vec2 from = p - Vec2{8.0f, 2.0f};
        const Vec2 along = Vec2{from.x + from.y, from.y - from.x} * 0.70710678f;
        const float turned = box(along - Vec2{4.0f, 2.0f}, {4.0f, 2.0f});
        const float flat = box(p - Vec2{8.0f, 10.0f}, {7.25f, 0.25f});
        return std::max({turned, flat, box(p - Vec2{15.0f, 12.5f}, {0.25f, 2.75f})});
    });
    const std::string text = report->text();
    EXPECT_EQ(report->problems.size(), 1u) << text;
    EXPECT_NE(text.find("tile 3: point 2: the collision shape is not as in Tiled: it has neither"),
              std::string::npos)
        << text;
}

TEST_F(ImportTilesTest, shapesThatNoFormCanHoldAreReported) {
    std::string shapes;
    for (int i = 0; i < 12; ++i)
        shapes += format(R"(<object id="{}" x="{}" y="{}" width="3" height="3"><ellipse/></object>)", i + 1,
                         i % 4 * 4, i / 4 * 4);
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  format(R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="land" tilewidth="16" tileheight="16"><image source="sheet.png"/>
 <tile id="0"><objectgroup>{}</objectgroup></tile>
 </tileset><layer name="ground" width="1" height="1"><data encoding="csv">1</data></layer></map>)",
                         shapes))
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(read(project_ / "assets/level/land.tileset.json")["tiles"][0]["collision"], "full");
    EXPECT_NE(
        report->text().find("tile 0: a tile form has more than 256 corners; the tile collides as a full"),
        std::string::npos)
        << report->text();
}

TEST_F(ImportTilesTest, pathsWithBackslashesAreFound) {
    ASSERT_TRUE(
        writeFile(folder_.path / "art/sub/sheet.png", *readFile(folder_.path / "art/sheet.png")).ok());
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="land" tilewidth="16" tileheight="16"><image source="sub\sheet.png"/></tileset>
 <layer name="ground" width="1" height="1"><data encoding="csv">1</data></layer></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_TRUE(report->problems.empty()) << report->text();
}

TEST_F(ImportTilesTest, tilesDeletedFromACollectionAreReported) {
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  R"(<map orientation="orthogonal" width="3" height="1" tilewidth="32" tileheight="32">
 <tileset firstgid="1" name="things" tilewidth="32" tileheight="32">
  <tile id="0"><image source="sheet.png" width="32" height="32"/></tile>
  <tile id="4"><image source="sheet.png" width="32" height="32"/></tile></tileset>
 <layer name="ground" width="3" height="1"><data encoding="csv">1,3,5</data></layer>
 <objectgroup name="loose"><object id="7" gid="2" x="0" y="32" width="32" height="32"/></objectgroup></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    const std::string text = report->text();
    EXPECT_EQ(report->problems.size(), 2u) << text;
    EXPECT_NE(text.find("layer ground: 1 cells contain tiles that tileset things no longer has"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("object 7: tileset things no longer has the object's tile 1"), std::string::npos)
        << text;
}

}  // namespace
}  // namespace plumb
