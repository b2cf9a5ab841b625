#include <algorithm>

#include "core/text.hpp"
#include "import/loaders/tmx_reader.hpp"

namespace plumb {
namespace {

constexpr int kMaxTileId = (1 << 28) - 1;
constexpr int kMaxOffset = 1 << 20;

/// Converts an element to JSON: attributes as strings, child elements as arrays.
Json attributesJson(const XmlElement& element) {
    Json json = Json::object();
    for (const XmlAttribute& attribute : element.attributes) json[attribute.name] = attribute.value;
    for (const XmlElement& child : element.children) json[child.name].push_back(attributesJson(child));
    return json;
}

void tellPicture(const XmlElement& image, const TmxFields& from) {
    if (image.child("data")) {
        from.warn("the image is embedded in the file", "save it as a separate file in Tiled");
    } else if (from.text("source").empty()) {
        from.warn("the image has no file", "select its image in Tiled");
    }
}

Json wangColor(const TmxFields& from, Json properties) {
    Json color = Json::object();
    color["name"] = from.text("name");
    color["color"] = from.text("color");
    color["tile"] = from.whole("tile", -1, -1, kMaxTileId);
    color["probability"] = from.real("probability", 1.0);
    if (from.has("class")) color["class"] = from.text("class");
    if (!properties.empty()) color["properties"] = std::move(properties);
    return color;
}

/// Reads the eight color indices of a Wang id, clockwise from top to top left: a list, or the digits of one
/// hexadecimal number as written before Tiled 1.5.
Json wangId(const std::string& text) {
    Json id = Json::array();
    if (startsWith(text, "0x")) {
        const std::uint64_t bits = parseHex(text.substr(2)).value_or(0);
        for (int i = 0; i < 8; ++i) id.push_back(static_cast<int>(bits >> (4 * i) & 15));
        return id;
    }
    for (const std::string_view part : split(text, ',')) {
        if (id.size() < 8) id.push_back(parseInt(trimmed(part)).value_or(0));
    }
    return id;
}

}  // namespace

void TmxReader::readTileset(const XmlElement& element, const TmxFile& file) {
    const TmxFields from = fields(element, file);
    const int first = from.whole("firstgid", 0, 1, kMaxTileId);
    if (first == 0) {
        from.warn("the tileset has no firstgid", "save the map again in Tiled");
        return;
    }
    if (from.text("source").empty()) {
        tiled::Tileset tileset;
        tileset.folder = file.folder;
        readTilesetFields(element, file, tileset);
        tileset.firstGid = static_cast<tiled::Gid>(first);
        map_.tilesets.push_back(std::move(tileset));
        return;
    }
    auto index = static_cast<std::size_t>(tilesetOf(element, file));
    if (map_.tilesets[index].firstGid != 0) {
        // A map may reference the same tileset file twice, with different first ids.
        tiled::Tileset again = map_.tilesets[index];
        index = map_.tilesets.size();
        map_.tilesets.push_back(std::move(again));
    }
    map_.tilesets[index].firstGid = static_cast<tiled::Gid>(first);
}

int TmxReader::tilesetOf(const XmlElement& reference, const TmxFile& file) {
    const std::string source = fields(reference, file).path("source");
    const Path path = (file.folder / source).lexically_normal();
    for (std::size_t i = 0; i < map_.tilesets.size(); ++i) {
        if (map_.tilesets[i].file == path) return static_cast<int>(i);
    }
    // Added before its content is read, because templates in it may reference this file or further tilesets.
    const std::size_t index = map_.tilesets.size();
    tiled::Tileset tileset;
    tileset.firstGid = 0;
    tileset.file = path;
    tileset.folder = path.parent_path();
    tileset.name = path.stem().string();
    map_.tilesets.push_back(tileset);
    if (const Result<TmxFile> opened = openNamed(file.folder, source, "tileset")) {
        readTilesetFields(opened->root, *opened, tileset);
    } else {
        warnings_->push_back(opened.error());
        tileset.missing = true;
    }
    map_.tilesets[index] = std::move(tileset);
    return static_cast<int>(index);
}

void TmxReader::readTilesetFields(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset) {
    const TmxFields from = fields(element, file);
    tileset.name = from.text("name", tileset.file.stem().string());
    tileset.type = from.text("class");
    tileset.tileWidth = from.whole("tilewidth", map_.tileWidth, 0, limits::kImageSide);
    tileset.tileHeight = from.whole("tileheight", map_.tileHeight, 0, limits::kImageSide);
    tileset.spacing = from.whole("spacing", 0, 0, limits::kImageSide);
    tileset.margin = from.whole("margin", 0, 0, limits::kImageSide);
    tileset.count = from.whole("tilecount", 0, 0, kMaxTileId);
    tileset.columns = from.whole("columns", 0, 0, limits::kImageSide);
    tileset.objectAlignment = from.text("objectalignment");
    tileset.fitsGrid = from.text("tilerendersize") == "grid";
    tileset.keepsAspect = from.text("fillmode") == "preserve-aspect-fit";
    tileset.properties = tmxProperties(element, file.name, *warnings_);
    for (const XmlElement& child : element.children) {
        const TmxFields inner = fields(child, file);
        if (child.name == "tileoffset") {
            tileset.offsetX = inner.whole("x", 0, -kMaxOffset, kMaxOffset);
            tileset.offsetY = inner.whole("y", 0, -kMaxOffset, kMaxOffset);
        } else if (child.name == "image") {
            tileset.image = inner.path("source");
            tellPicture(child, inner);
            tileset.transparent = inner.color("trans");
            tileset.imageWidth = inner.whole("width", 0, 0, limits::kImageSide);
            tileset.imageHeight = inner.whole("height", 0, 0, limits::kImageSide);
        } else if (child.name == "tile") {
            readTile(child, file, tileset);
        } else if (child.name == "wangsets") {
            readWangSets(child, file, tileset);
        } else if (child.name == "grid" || child.name == "transformations" || child.name == "terraintypes") {
            tileset.notes[child.name] = attributesJson(child);
            if (child.name == "grid" && inner.text("orientation") == "isometric") {
                tileset.isometricWidth = inner.whole("width", tileset.tileWidth, 1, limits::kImageSide);
                tileset.isometricHeight = inner.whole("height", tileset.tileHeight, 1, limits::kImageSide);
            }
        }
    }
    if (from.has("backgroundcolor")) tileset.notes["backgroundColor"] = from.text("backgroundcolor");
    const auto byId = [](const tiled::Tile& a, const tiled::Tile& b) { return a.id < b.id; };
    std::stable_sort(tileset.tiles.begin(), tileset.tiles.end(), byId);
}

void TmxReader::readTile(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset) {
    const TmxFields from = fields(element, file);
    tiled::Tile tile;
    tile.id = from.whole("id", -1, 0, kMaxTileId);
    if (tile.id < 0) {
        from.warn("a tile has no id", "save the tileset again in Tiled");
        return;
    }
    tile.type = from.text("type", from.text("class"));
    tile.probability = from.real("probability", 1.0);
    tile.terrain = from.text("terrain");
    tile.properties = tmxProperties(element, file.name, *warnings_);
    if (from.has("width") && from.has("height") && (from.has("x") || from.has("y"))) {
        tile.source = Rect{static_cast<float>(from.whole("x", 0, 0, limits::kImageSide)),
                           static_cast<float>(from.whole("y", 0, 0, limits::kImageSide)),
                           static_cast<float>(from.whole("width", 0, 0, limits::kImageSide)),
                           static_cast<float>(from.whole("height", 0, 0, limits::kImageSide))};
    }
    if (const XmlElement* image = element.child("image")) {
        const TmxFields inner = fields(*image, file);
        tile.image = inner.path("source");
        tellPicture(*image, inner);
        tile.transparent = inner.color("trans");
        tile.width = inner.whole("width", 0, 0, limits::kImageSide);
        tile.height = inner.whole("height", 0, 0, limits::kImageSide);
    }
    if (const XmlElement* animation = element.child("animation")) {
        for (const XmlElement& frame : animation->children) {
            const TmxFields inner = fields(frame, file);
            const int id = inner.whole("tileid", -1, 0, kMaxTileId);
            if (id >= 0) tile.animation.push_back({id, inner.whole("duration", 100, 0, 1 << 30)});
        }
    }
    if (const XmlElement* group = element.child("objectgroup")) {
        for (const XmlElement& child : group->children) {
            tiled::Object object;
            if (child.name == "object" && readObject(child, file, object))
                tile.collision.push_back(std::move(object));
        }
    }
    tileset.tiles.push_back(std::move(tile));
}

void TmxReader::readWangSets(const XmlElement& element, const TmxFile& file, tiled::Tileset& tileset) {
    for (const XmlElement& child : element.children) {
        const TmxFields from = fields(child, file);
        Json set = Json::object();
        set["name"] = from.text("name");
        set["type"] = from.text("type", "mixed");
        set["tile"] = from.whole("tile", -1, -1, kMaxTileId);
        if (from.has("class")) set["class"] = from.text("class");
        set["colors"] = Json::array();
        set["tiles"] = Json::array();
        for (const XmlElement& item : child.children) {
            const TmxFields inner = fields(item, file);
            if (endsWith(item.name, "color")) {
                set["colors"].push_back(wangColor(inner, tmxProperties(item, file.name, *warnings_)));
            } else if (item.name == "wangtile") {
                Json tile = Json::object();
                tile["tile"] = inner.whole("tileid", 0, 0, kMaxTileId);
                tile["ids"] = wangId(inner.text("wangid"));
                set["tiles"].push_back(std::move(tile));
            }
        }
        if (Json properties = tmxProperties(child, file.name, *warnings_); !properties.empty()) {
            set["properties"] = std::move(properties);
        }
        tileset.wangSets.push_back(std::move(set));
    }
}

}  // namespace plumb
