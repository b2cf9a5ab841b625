// No content of an imported file may be lost without a line in the report: every name and value of the source
// must occur in the written files or in the report.

#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "codec/compression.hpp"
#include "import/import_file.hpp"
#include "import/loaders/ldtk_loader.hpp"
#include "import/loaders/tmx_loader.hpp"
#include "import/loaders/xml.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/tiles_json.hpp"
#include "tests/support/foreign_maps.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::string unpacked(const Path& file) {
    Result<std::string> bytes = readFile(file);
    if (!bytes) bytes = readFile(file.string() + ".gz");
    if (bytes && startsWith(*bytes, "\x1f\x8b")) bytes = unpackGzip(*bytes, std::size_t{1} << 28, "");
    return bytes ? *bytes : std::string{};
}

/// The files and the report of an import.
class Imported {
public:
    Imported(const Path& file, const Path& project) {
        const Result<ImportReport> imported = importFile(file, {}, project);
        refused = !imported.ok();
        if (refused) {
            refusal = imported.error();
            return;
        }
        report = *imported;
        for (const std::string& path : report.files) {
            if (!endsWith(path, ".json")) continue;
            const Result<Json> json = parseJson(*readFile(project / path), path);
            EXPECT_TRUE(json.ok());
            if (json) collect(*json);
        }
        const std::string text = report.text();
        said_ = text;
        scene = *parseJson(*readFile(project / report.scene), "");
    }

    /// True if a text of the source occurs in the written files or in the report.
    [[nodiscard]] bool has(const std::string& text) const {
        return texts_.count(text) > 0 || said_.find(text) != std::string::npos;
    }
    /// Returns the number of non-empty cells, and of sprites off the grid, in all entities that `wanted`
    /// accepts.
    [[nodiscard]] int tiles(const std::function<bool(const Json&)>& wanted) const {
        int count = 0;
        for (const Json& entity : scene["entities"]) {
            const auto layer = entity["components"].find("TileLayer");
            if (layer == entity["components"].end() || !wanted(entity)) continue;
            const Result<ReadTiles> read = tilesFromJson((*layer)["cells"]);
            EXPECT_TRUE(read.ok());
            for (int y = 0; read.ok() && y < read->grid.height(); ++y) {
                for (int x = 0; x < read->grid.width(); ++x) count += read->grid.at(x, y) != 0 ? 1 : 0;
            }
        }
        return count;
    }
    [[nodiscard]] int entitiesWith(const char* key, const char* member) const {
        int count = 0;
        for (const Json& entity : scene["entities"])
            count += entity.contains(key) && entity[key].contains(member);
        return count;
    }

    ImportReport report;
    Json scene;
    bool refused = false;
    Error refusal;

private:
    void collect(const Json& json) {
        if (json.is_string()) ++texts_[json.get<std::string>()];
        if (!json.is_structured()) return;
        if (json.is_object()) {
            for (const auto& [key, value] : json.items()) ++texts_[key];
        }
        for (const Json& inner : json) collect(inner);
    }

    std::map<std::string, int> texts_;
    std::string said_;
};

struct XmlCounts {
    int layers = 0;
    int objects = 0;
    std::vector<std::string> names;  ///< texts that must occur in the written files or in the report
};

/// Counts the content of a map, without the importer's code.
void countXml(const XmlElement& element, XmlCounts& counts, bool inTileset) {
    const bool isLayer =
        element.name == "layer" || element.name == "objectgroup" || element.name == "imagelayer";
    counts.layers += isLayer && !inTileset ? 1 : 0;
    counts.objects += element.name == "object" && !inTileset ? 1 : 0;
    const bool named = element.name == "property" || element.name == "wangset" ||
                       element.name == "wangcolor" || element.name == "group" || element.name == "object" ||
                       isLayer || element.name == "tileset";
    for (const char* attribute : {"name", "class", "type", "propertytype", "template"}) {
        const std::string* text = element.find(attribute);
        const bool isKind = element.name == "property" || element.name == "map" || element.name == "wangset";
        if (named && text != nullptr && !text->empty() && !(isKind && std::string_view{attribute} == "type"))
            counts.names.push_back(*text);
    }
    for (const XmlElement& child : element.children)
        countXml(child, counts, inTileset || element.name == "tileset");
}

int cellsOf(const tiled::Map& map) {
    int count = 0;
    for (const tiled::Layer& layer : map.layers) {
        for (const tiled::Gid gid : layer.cells) count += (gid & ~tiled::kFlags) != 0 ? 1 : 0;
    }
    return count;
}

class ImportCompletenessTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(writeFile(project_ / "project.json", "{}").ok()); }

    test::TemporaryFolder folder_;
    Path project_ = folder_.path / "game";
};

TEST_F(ImportCompletenessTest, nothingOfAMapOfTiledVanishesWithoutALine) {
    const std::vector<Path> maps = test::foreignMaps({".tmx", ".tmx.gz"});
    ASSERT_FALSE(maps.empty());
    int looked = 0;
    for (const Path& file : maps) {
        SCOPED_TRACE(file.generic_string());
        const std::string text = unpacked(file);
        const Imported imported{file, project_};
        ASSERT_FALSE(imported.refused) << imported.refusal.text();
        ++looked;
        const Result<XmlElement> root = parseXml(text, "");
        ASSERT_TRUE(root.ok());
        XmlCounts counts;
        countXml(*root, counts, false);
        EXPECT_EQ(imported.report.layers, counts.layers);
        EXPECT_EQ(imported.entitiesWith("tiled", "id"), counts.objects);
        for (const std::string& name : counts.names) EXPECT_TRUE(imported.has(name)) << name << " was lost";
        std::vector<Error> ignored;
        const Result<tiled::Map> map = loadTiledMap(file, ignored);
        ASSERT_TRUE(map.ok());
        EXPECT_EQ(imported.tiles([](const Json&) { return true; }), cellsOf(*map));
        for (const tiled::Tileset& tileset : map->tilesets) {
            EXPECT_TRUE(imported.has(tileset.name)) << tileset.name;
            for (const tiled::Tile& tile : tileset.tiles) {
                for (const auto& [key, value] : tile.properties.items())
                    EXPECT_TRUE(imported.has(key)) << key << " of tile " << tile.id;
            }
        }
    }
    EXPECT_GT(looked, 1);
}

TEST_F(ImportCompletenessTest, aWorldAndMapsInJsonComeInToo) {
    const std::vector<Path> worlds = test::foreignMaps({".world"});
    ASSERT_FALSE(worlds.empty());
    for (const Path& file : worlds) {
        SCOPED_TRACE(file.generic_string());
        const Imported imported{file, project_};
        ASSERT_FALSE(imported.refused) << imported.refusal.text();
        const Json world = *parseJson(*readFile(file), "");
        EXPECT_EQ(imported.report.levels, static_cast<int>(world["maps"].size()));
        EXPECT_TRUE(imported.report.problems.empty()) << imported.report.text();
        for (const Json& map : world["maps"]) {
            const std::string name = Path{map["fileName"].get<std::string>()}.stem().string();
            EXPECT_TRUE(imported.has(name)) << name;
        }
    }
}

/// The texts in the fields of an LDtk project and the number of its items, determined without the importer's
/// code.
struct LdtkCounts {
    int entities = 0;
    int tiles = 0;
    int values = 0;
    std::vector<std::string> names;
};

void countTexts(const Json& json, std::vector<std::string>& names) {
    if (json.is_string()) names.push_back(json.get<std::string>());
    if (!json.is_structured()) return;
    for (const Json& inner : json) countTexts(inner, names);
}

void countLdtk(const Json& project, LdtkCounts& counts) {
    for (const Json& level : project["levels"]) {
        counts.names.push_back(level["identifier"]);
        for (const Json& layer : level["layerInstances"]) {
            counts.names.push_back(layer["__identifier"]);
            counts.tiles += static_cast<int>(layer["autoLayerTiles"].size() + layer["gridTiles"].size());
            for (const Json& value : layer["intGridCsv"]) counts.values += value != 0 ? 1 : 0;
            for (const Json& entity : layer["entityInstances"]) {
                ++counts.entities;
                counts.names.push_back(entity["iid"]);
                for (const Json& field : entity["fieldInstances"]) {
                    counts.names.push_back(field["__identifier"]);
                    countTexts(field["__value"], counts.names);
                }
            }
        }
    }
    for (const Json& tileset : project["defs"]["tilesets"]) counts.names.push_back(tileset["identifier"]);
    countTexts(project["defs"]["enums"], counts.names);
}

TEST_F(ImportCompletenessTest, nothingOfAProjectOfLdtkVanishesWithoutALine) {
    const std::vector<Path> projects = test::foreignMaps({".ldtk"});
    ASSERT_FALSE(projects.empty());
    for (const Path& file : projects) {
        SCOPED_TRACE(file.generic_string());
        const Imported imported{file, project_};
        ASSERT_FALSE(imported.refused) << imported.refusal.text();
        LdtkCounts counts;
        countLdtk(*parseJson(*readFile(file), ""), counts);
        EXPECT_EQ(imported.report.objects, counts.entities);
        EXPECT_EQ(imported.report.tiles, counts.tiles + counts.values);
        for (const std::string& name : counts.names) EXPECT_TRUE(imported.has(name)) << name << " was lost";
        const auto isValues = [](const Json& entity) {
            return endsWith(entity.value("name", ""), " values");
        };
        EXPECT_EQ(imported.tiles(isValues), counts.values);
        const int onGrid = imported.tiles([&](const Json& entity) { return !isValues(entity); });
        int loose = 0;
        for (const Json& entity : imported.scene["entities"])
            loose += startsWith(entity.value("name", ""), "tile ") ? 1 : 0;
        EXPECT_EQ(onGrid + loose, counts.tiles);
    }
}

}  // namespace
}  // namespace plumb
