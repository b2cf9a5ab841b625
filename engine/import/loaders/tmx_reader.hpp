#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/limits.hpp"
#include "import/loaders/tmx_fields.hpp"
#include "import/loaders/tmx_loader.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// The parsed elements of a Tiled file, and the folder that paths in it are relative to.
struct TmxFile {
    XmlElement root;
    Path folder;
    std::string name;  ///< path used in messages
};

/// Reads one map with its tilesets and templates. Implemented in tmx_loader, tmx_tilesets and tmx_objects.
class TmxReader {
public:
    TmxReader(const FileReader& readFrom, std::vector<Error>& warnings)
        : readFrom_{&readFrom}, warnings_{&warnings} {}

    Result<tiled::Map> readMap(std::string_view text, const Path& file);

private:
    /// Fields that layers inherit from the groups that contain them.
    struct Inherited {
        tiled::Layer layer;
        int depth = 0;
    };
    /// A template's object, with its tile already resolved in the template's own tileset.
    struct Template {
        bool found = false;  ///< the template file was read and has an object
        tiled::Object object;
    };

    Result<TmxFile> open(std::string_view text, const Path& file, std::string_view element);
    Result<TmxFile> openNamed(const Path& folder, const std::string& name, std::string_view element);
    [[nodiscard]] TmxFields fields(const XmlElement& element, const TmxFile& file) {
        return {element, file.name, *warnings_};
    }
    /// Reports unknown elements and attributes of the file, each name once.
    void reportUnknown(const XmlElement& element, const TmxFile& file);

    void readMapFields(const TmxFile& file);
    void readLayers(const XmlElement& parent, const TmxFile& file, const Inherited& inherited);
    void readLayer(const XmlElement& element, const TmxFile& file, const Inherited& inherited);
    void inheritFields(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);
    void readGroup(const XmlElement& element, const TmxFile& file, const Inherited& inherited);
    void readTiles(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);
    void readObjects(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);
    void readImage(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);

    void readTileset(const XmlElement& element, const TmxFile& file);
    /// Returns the index of an external tileset in the map; a new one is added with firstGid 0.
    int tilesetOf(const XmlElement& reference, const TmxFile& file);
    void readTilesetFields(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset);
    void readTile(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset);
    void readWangSets(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset);

    /// Values of `templateTileset` that are not an index in Map::tilesets.
    static constexpr int kGlobalId = -1;   ///< the object is in a map: its tile id is global
    static constexpr int kNoTileset = -2;  ///< the object is in a template without a tileset

    /// Reads an object of a map or of a template.
    /// @param templateTileset  kGlobalId for an object in a map; for an object in a template the index of the
    /// template's tileset in Map::tilesets, or kNoTileset
    bool readObject(const XmlElement& element, const TmxFile& file, tiled::Object& object,
                    int templateTileset = kGlobalId);
    void readShape(const XmlElement& element, const TmxFile& file, tiled::Object& object);
    void readTile(const TmxFields& from, tiled::Object& object, int templateTileset);
    bool readPoints(const XmlElement& element, const TmxFile& file, tiled::Object& object);
    const Template& templateOf(const std::string& name, const TmxFile& file);

    const FileReader* readFrom_;
    std::vector<Error>* warnings_;
    tiled::Map map_;
    std::set<std::string, std::less<>> reported_;
    std::map<Path, Template> templates_;
    std::size_t cellsLeft_ = limits::kTiledCells;
    std::size_t objectsLeft_ = limits::kEntities;
};

}  // namespace plumb
