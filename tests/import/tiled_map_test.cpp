#include <map>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "import/loaders/tmx_loader.hpp"

namespace plumb {
namespace {

using tiled::Gid;
using tiled::Shape;

/// A file reader with files in memory, by name.
class FakeFiles {
public:
    std::map<std::string, std::string> files;
    std::vector<Error> warnings;

    Result<tiled::Map> load(const std::string& text) {
        warnings.clear();
        const FileReader readFrom = [this](const Path& path) -> Result<std::string> {
            const auto found = files.find(path.generic_string());
            if (found == files.end()) return Error{path.generic_string(), "missing", "make it"};
            return found->second;
        };
        return parseTiledMap(text, "maps/level.tmx", readFrom, warnings);
    }
};

std::string mapOf(const std::string& inside, const std::string& attributes = "") {
    return "<map orientation=\"orthogonal\" width=\"3\" height=\"2\" tilewidth=\"16\" tileheight=\"16\" " +
           attributes +
           "><tileset firstgid=\"1\" name=\"t\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"9\" "
           "columns=\"3\">"
           "<image source=\"t.png\" width=\"48\" height=\"48\"/></tileset>" +
           inside + "</map>";
}

// First row: 1, 0, 2 flipped horizontally. Second: 3 flipped vertically, 4 diagonally, 5 with all four bits.
const std::vector<Gid> kCells{1, 0, 0x80000002u, 0x40000003u, 0x20000004u, 0xf0000005u};

struct Encoding {
    const char* attributes;
    const char* data;
};
const Encoding kEncodings[] = {
    {"",
     "<tile gid='1'/><tile/><tile gid='2147483650'/><tile gid='1073741827'/><tile gid='536870916'/>"
     "<tile gid='4026531845'/>"},
    {"encoding='csv'", "1,0,2147483650,\n1073741827,536870916,4026531845\n"},
    {"encoding='base64'", "AQAAAAAAAAACAACAAwAAQAQAACAFAADw"},
    {"encoding='base64' compression='zlib'", "eJxjZIAAJgaGBmYGBgcWBgYFVgaGDwAK+AHg"},
    {"encoding='base64' compression='gzip'", "H4sIAAAAAAACA2NkgAAmBoYGZgYGBxYGBgVWBoYPAFRdymMYAAAA"},
    {"encoding='base64' compression='zstd'", "KLUv/QRYwQAAAQAAAAAAAAACAACAAwAAQAQAACAFAADwaTO9jA=="},
};

TEST(TiledMapTest, allEncodingsGiveTheSameCells) {
    FakeFiles fake;
    for (const Encoding& encoding : kEncodings) {
        SCOPED_TRACE(encoding.attributes);
        const Result<tiled::Map> map =
            fake.load(mapOf(format("<layer name='a' width='3' height='2'><data {}>{}</data></layer>",
                                   encoding.attributes, encoding.data)));
        ASSERT_TRUE(map.ok()) << map.error().text();
        ASSERT_EQ(map->layers.size(), 1u);
        EXPECT_EQ(map->layers[0].cells, kCells);
        EXPECT_TRUE(fake.warnings.empty());
    }
}

TEST(TiledMapTest, theFlagBitsAreNoPartOfTheTile) {
    FakeFiles fake;
    const Result<tiled::Map> map = fake.load(mapOf(""));
    ASSERT_TRUE(map.ok());
    EXPECT_EQ(map->resolve(0xf0000005u), (tiled::TileRef{0, 4, 0xf0000000u}));
    EXPECT_TRUE(map->resolve(0x80000000u).empty());
}

TEST(TiledMapTest, chunksBelowZeroBecomeOneGrid) {
    FakeFiles fake;
    const Result<tiled::Map> map =
        fake.load(mapOf("<layer name='a' width='3' height='2'><data encoding='csv'>"
                        "<chunk x='-2' y='-1' width='2' height='1'>1,2</chunk>"
                        "<chunk x='0' y='0' width='1' height='2'>3,4</chunk></data></layer>",
                        "infinite='1'"));
    ASSERT_TRUE(map.ok()) << map.error().text();
    const tiled::Layer& layer = map->layers.at(0);
    EXPECT_EQ(layer.x, -2);
    EXPECT_EQ(layer.y, -1);
    EXPECT_EQ(layer.width, 3);
    EXPECT_EQ(layer.height, 3);
    EXPECT_EQ(layer.cells, (std::vector<Gid>{1, 2, 0, 0, 0, 3, 0, 0, 4}));
}

TEST(TiledMapTest, groupsAddTheirOffsetAndMultiplyTheRest) {
    FakeFiles fake;
    const Result<tiled::Map> map = fake.load(
        mapOf("<group name='g' offsetx='10' opacity='0.5' parallaxx='0.5' tintcolor='#ff8000' visible='0'>"
              "<imagelayer name='i' offsetx='5' opacity='0.5' parallaxx='0.5' repeatx='1'>"
              "<image source='sky.png' trans='ff00ff'/></imagelayer></group>"));
    ASSERT_TRUE(map.ok());
    const tiled::Layer& layer = map->layers.at(0);
    EXPECT_EQ(layer.group, "g");
    EXPECT_EQ(layer.offset, (Vec2{15.0f, 0.0f}));
    EXPECT_EQ(layer.opacity, 0.25);
    EXPECT_EQ(layer.parallax, (Vec2{0.25f, 1.0f}));
    EXPECT_EQ(layer.tint, (Color{255, 128, 0, 255}));
    EXPECT_FALSE(layer.visible);
    EXPECT_TRUE(layer.repeatX);
    EXPECT_EQ(layer.transparent, (Color{255, 0, 255, 255}));
}

constexpr const char* kObjects = R"(<objectgroup name="o">
 <object id="1" name="box" x="1" y="2" width="3" height="4" rotation="90"/>
 <object id="2" x="1" y="2" width="8" height="8"><ellipse/></object>
 <object id="3" x="1" y="2"><point/></object>
 <object id="4" x="1" y="2"><polygon points="0,0 4.5,0 4,-3"/></object>
 <object id="5" x="1" y="2"><polyline points="0,0 4,4"/></object>
 <object id="6" x="1" y="2" width="4" height="9"><capsule/></object>
 <object id="7" x="1" y="2" width="40" height="9"><text wrap="1" pixelsize="12" halign="center">Hi &amp; bye</text></object>
 <object id="8" gid="2147483650" x="1" y="32" width="16" height="16" rotation="45"/>
</objectgroup>)";

TEST(TiledMapTest, everyKindOfObjectIsRead) {
    FakeFiles fake;
    const Result<tiled::Map> map = fake.load(mapOf(kObjects));
    ASSERT_TRUE(map.ok());
    EXPECT_TRUE(fake.warnings.empty());
    const std::vector<tiled::Object>& objects = map->layers.at(0).objects;
    const Shape shapes[] = {Shape::Rectangle, Shape::Ellipse, Shape::Point, Shape::Polygon,
                            Shape::Polyline,  Shape::Capsule, Shape::Text,  Shape::Tile};
    ASSERT_EQ(objects.size(), std::size(shapes));
    for (std::size_t i = 0; i < objects.size(); ++i) EXPECT_EQ(objects[i].shape, shapes[i]) << i;
    EXPECT_EQ(objects[0].rotation, 90.0);
    EXPECT_EQ(objects[3].points, (std::vector<Vec2>{{0, 0}, {4.5f, 0}, {4, -3}}));
    EXPECT_EQ(objects[6].text.text, "Hi & bye");
    EXPECT_EQ(objects[7].tile, (tiled::TileRef{0, 1, tiled::kFlipX}));
}

TEST(TiledMapTest, propertiesKeepTheirTypesClassesAndLists) {
    FakeFiles fake;
    const Result<tiled::Map> map = fake.load(mapOf(
        "<properties><property name='n' type='int' value='-3'/><property name='f' type='float' value='0.5'/>"
        "<property name='b' type='bool' value='true'/><property name='s' value='x'/>"
        "<property name='m'>two\nlines</property><property name='c' type='color' value='#ff112233'/>"
        "<property name='k' type='class' propertytype='Boss'><properties><property name='hp' type='int' "
        "value='9'/>"
        "</properties></property><property name='l' type='list'><item type='int' value='1'/><item "
        "value='a'/></property>"
        "</properties>"));
    ASSERT_TRUE(map.ok());
    EXPECT_EQ(map->properties.dump(),
              R"({"n":-3,"f":0.5,"b":true,"s":"x","m":"two\nlines","c":{"type":"color","value":"#ff112233"},)"
              R"("k":{"type":"class","class":"Boss","value":{"hp":9}},"l":[1,"a"]})");
}

constexpr const char* kTileset =
    R"(<tileset name="things" tilewidth="40" tileheight="30" spacing="1" margin="2">
 <tileoffset x="-3" y="4"/>
 <tile id="7" type="tree" probability="0.5"><image source="tree.png" width="40" height="30"/>
  <animation><frame tileid="7" duration="100"/><frame tileid="9" duration="50"/></animation>
  <objectgroup><object id="1" x="0" y="0" width="40" height="30"/></objectgroup></tile>
 <tile id="2" x="1" y="2" width="3" height="4"><image source="../sheet.png"/></tile>
 <wangsets><wangset name="w" type="corner" tile="2"><wangcolor name="c" color="#ff0000" tile="2" probability="1"/>
  <wangtile tileid="2" wangid="0,1,0,1,0,1,0,1"/></wangset></wangsets>
</tileset>)";

TEST(TiledMapTest, externalTilesetsAndTemplatesAreRelativeToTheFileThatNamesThem) {
    FakeFiles fake;
    fake.files["sets/things.tsx"] = kTileset;
    fake.files["maps/templates/tree.tx"] =
        "<template><tileset firstgid='1' source='../../sets/things.tsx'/><object name='oak' type='tree' "
        "gid='8' "
        "width='40' height='30'><properties><property name='a' value='1'/><property name='b' "
        "value='1'/></properties>"
        "</object></template>";
    const Result<tiled::Map> map =
        fake.load(mapOf("<tileset firstgid='10' source='../sets/things.tsx'/><objectgroup name='o'>"
                        "<object id='5' template='templates/tree.tx' x='9' y='8' width='80'><properties>"
                        "<property name='b' value='2'/></properties></object></objectgroup>"));
    ASSERT_TRUE(map.ok()) << map.error().text();
    EXPECT_TRUE(fake.warnings.empty());
    ASSERT_EQ(map->tilesets.size(), 2u);
    const tiled::Tileset& things = map->tilesets[1];
    EXPECT_EQ(things.folder, Path{"sets"});
    EXPECT_EQ(things.offsetX, -3);
    ASSERT_EQ(things.tiles.size(), 2u);
    EXPECT_EQ(things.tiles[0].source, (Rect{1, 2, 3, 4}));
    EXPECT_EQ(things.find(7)->animation.size(), 2u);
    EXPECT_EQ(things.find(7)->collision.size(), 1u);
    EXPECT_EQ(things.find(3), nullptr);
    EXPECT_EQ(things.wangSets[0]["tiles"][0]["ids"].size(), 8u);
    const tiled::Object& oak = map->layers.at(0).objects.at(0);
    EXPECT_EQ(oak.name, "oak");
    EXPECT_EQ(oak.width, 80.0);
    EXPECT_EQ(oak.height, 30.0);
    EXPECT_EQ(oak.tile, (tiled::TileRef{1, 7, 0}));
    EXPECT_EQ(oak.properties.dump(), R"({"a":"1","b":"2"})");
}

TEST(TiledMapTest, theJsonFormGivesTheSameMap) {
    FakeFiles fake;
    const Result<tiled::Map> map =
        fake.load(R"({"orientation":"orthogonal","width":2,"height":1,"tilewidth":16,
"tileheight":16,"backgroundcolor":"#3b97d3","tilesets":[{"firstgid":1,"name":"t","image":"t.png","tilewidth":16,
"tileheight":16,"tilecount":9,"columns":3}],"layers":[{"type":"tilelayer","name":"a","width":2,"height":1,
"data":[1,2147483650]},{"type":"group","name":"g","layers":[{"type":"objectgroup","name":"o","objects":[
{"id":1,"x":1.5,"y":2,"width":0,"height":0,"polygon":[{"x":0,"y":0},{"x":4,"y":0},{"x":0,"y":4}],
"properties":[{"name":"p","type":"float","value":1.5}]}]}]}]})");
    ASSERT_TRUE(map.ok()) << map.error().text();
    EXPECT_TRUE(fake.warnings.empty());
    EXPECT_EQ(map->background, (Color{0x3b, 0x97, 0xd3, 255}));
    EXPECT_EQ(map->layers.at(0).cells, (std::vector<Gid>{1, 0x80000002u}));
    EXPECT_EQ(map->layers.at(1).group, "g");
    EXPECT_EQ(map->layers.at(1).objects.at(0).points.size(), 3u);
    EXPECT_EQ(map->layers.at(1).objects.at(0).properties["p"], 1.5);
}

TEST(TiledMapTest, brokenPartsAreReportedOnceAndTheRestIsRead) {
    FakeFiles fake;
    const Result<tiled::Map> map =
        fake.load(mapOf("<tileset firstgid='100' source='missing.tsx'/><wonder/><wonder/>"
                        "<layer name='short' width='3' height='2'><data encoding='csv'>1,2</data></layer>"
                        "<layer name='odd' width='3' height='2'><data encoding='base64' "
                        "compression='lzma'>AAAA</data></layer>"
                        "<objectgroup name='o'><object id='1' x='far' y='2'/><object id='2' "
                        "template='none.tx'/></objectgroup>"));
    ASSERT_TRUE(map.ok());
    EXPECT_EQ(map->layers.size(), 3u);
    EXPECT_TRUE(map->tilesets[1].missing);
    EXPECT_EQ(fake.warnings.size(), 6u);
    for (const Error& warning : fake.warnings) {
        EXPECT_FALSE(warning.where.empty());
        EXPECT_FALSE(warning.what.empty());
        EXPECT_FALSE(warning.remedy.empty());
    }
}

TEST(TiledMapTest, whatHasNoKnownOrientationOrTileSizeIsRefused) {
    FakeFiles fake;
    for (const char* text :
         {"", "{}", "[]", "<tileset/>", "<map orientation='oblique' tilewidth='1' tileheight='1'/>",
          "<map orientation='hexagonal'/>", "<map/>", "<map tilewidth='0' tileheight='16'/>"}) {
        const Result<tiled::Map> map = fake.load(text);
        EXPECT_FALSE(map.ok()) << text;
    }
}

TEST(TiledMapTest, aSmallFileCannotRequireAHugeGrid) {
    FakeFiles fake;
    const Result<tiled::Map> map = fake.load(mapOf(
        "<layer name='a' width='16384' height='16384'><data encoding='base64' compression='zlib'>eJwDAAAAAAE="
        "</data></layer><layer name='b'><data encoding='csv'><chunk x='-100000000' y='0' width='1' "
        "height='1'>1"
        "</chunk><chunk x='100000000' y='0' width='1' height='1'>1</chunk></data></layer>"));
    ASSERT_TRUE(map.ok());
    EXPECT_EQ(fake.warnings.size(), 2u);
}

TEST(TiledMapTest, twentyThousandMutationsEndInAnAnswer) {
    FakeFiles fake;
    fake.files["sets/things.tsx"] = kTileset;
    std::string layers;
    for (const Encoding& encoding : kEncodings) {
        layers += format("<layer width='3' height='2'><data {}>{}</data></layer>", encoding.attributes,
                         encoding.data);
    }
    const std::string original =
        mapOf("<tileset firstgid='10' source='../sets/things.tsx'/>" + layers + kObjects);
    ASSERT_TRUE(fake.load(original).ok());
    constexpr std::string_view kLikely = "<>/=\"'&; 0123456789-,.eE\xff";
    Random random = Random::seeded(3);
    for (int i = 0; i < 20000; ++i) {
        std::string text = original;
        const std::uint32_t changes = 1 + random.below(4);
        for (std::uint32_t change = 0; change < changes; ++change) {
            const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
            text[at] = kLikely[random.below(static_cast<std::uint32_t>(kLikely.size()))];
        }
        if (random.below(8) == 0) text.resize(random.below(static_cast<std::uint32_t>(text.size())));
        const Result<tiled::Map> map = fake.load(text);
        EXPECT_TRUE(map.ok() || !map.error().what.empty());
    }
}

}  // namespace
}  // namespace plumb
