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

/// An open file of Tiled: its elements, and what names in it are relative to.
struct TmxFile {
    XmlElement root;
    Path folder;
    std::string name;  ///< for messages
};

/// Reads one map with everything that it names. Its parts are in tmx_loader, tmx_tilesets and tmx_objects.
class TmxReader {
public:
    TmxReader(const FileReader& readFrom, std::vector<Error>& warnings)
        : readFrom_{&readFrom}, warnings_{&warnings} {}

    Result<tiled::Map> readMap(std::string_view text, const Path& file);

private:
    /// What layers inherit from the groups around them.
    struct Inherited {
        tiled::Layer layer;
        int depth = 0;
    };
    /// A template: its object, already resolved against the template's own tileset.
    struct Template {
        bool found = false;
        tiled::Object object;
    };

    Result<TmxFile> open(std::string_view text, const Path& file, std::string_view element);
    Result<TmxFile> openNamed(const Path& folder, const std::string& name, std::string_view element);
    [[nodiscard]] TmxFields fields(const XmlElement& element, const TmxFile& file) {
        return {element, file.name, *warnings_};
    }
    /// Reports once per name every element and attribute of the file that no reader asks for.
    void tellUnknown(const XmlElement& element, const TmxFile& file);

    void readMapFields(const TmxFile& file);
    void readLayers(const XmlElement& parent, const TmxFile& file, const Inherited& inherited);
    void readLayer(const XmlElement& element, const TmxFile& file, const Inherited& inherited);
    void inheritFields(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);
    void readGroup(const XmlElement& element, const TmxFile& file, const Inherited& inherited);
    void readTiles(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);
    void readObjects(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);
    void readImage(const XmlElement& element, const TmxFile& file, tiled::Layer& layer);

    void readTileset(const XmlElement& element, const TmxFile& file);
    /// The place of an external tileset in the map; it is added with no numbers of its own when it is new.
    int tilesetOf(const XmlElement& reference, const TmxFile& file);
    void readTilesetFields(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset);
    void readTile(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset);
    void readWangSets(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset);

    /// To which tileset the number of an object's tile belongs, where it is not one of a template.
    static constexpr int kOfMap = -1;
    static constexpr int kOfNone = -2;

    /// @param templateTileset  that of the template in which the object stands, kOfNone when it has none
    bool readObject(const XmlElement& element, const TmxFile& file, tiled::Object& object,
                    int templateTileset = kOfMap);
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
