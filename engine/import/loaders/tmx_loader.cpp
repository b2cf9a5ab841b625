#include "import/loaders/tmx_loader.hpp"

#include <algorithm>

#include "codec/compression.hpp"
#include "core/text.hpp"
#include "import/loaders/tiled_classes.hpp"
#include "import/loaders/tmj_to_xml.hpp"
#include "import/loaders/tmx_cells.hpp"
#include "import/loaders/tmx_elements.hpp"
#include "import/loaders/tmx_reader.hpp"

namespace plumb {
namespace {

using tiled::Layer;
using tiled::LayerKind;

constexpr int kGroupDepth = 32;
constexpr int kManyPixels = 1 << 20;

/// Reads an attribute that has two values. @return true if it has the value `other`
bool readChoice(const TmxFields& from, std::string_view name, std::string_view usual,
                std::string_view other) {
    const std::string text = from.text(name, usual);
    if (text != usual && text != other) {
        from.warn(format("{} is \"{}\", expected \"{}\" or \"{}\"", name, text, usual, other),
                  format("\"{}\" was taken; set it in Tiled: Map, Map Properties", usual));
    }
    return text == other;
}

bool looksLikeJson(std::string_view text) { return startsWith(trimmed(text.substr(0, 64)), "{"); }

}  // namespace

Result<TmxFile> TmxReader::open(std::string_view text, const Path& file, std::string_view element) {
    TmxFile opened;
    opened.folder = file.parent_path();
    opened.name = file.generic_string();
    Result<XmlElement> root =
        looksLikeJson(text) ? tmjToXml(text, element, opened.name) : parseXml(text, opened.name);
    if (!root) return root.error();
    if (root->name != element) {
        return Error{opened.name, format("found <{}>, expected <{}>", root->name, element),
                     format("select a {} file written by Tiled", element)};
    }
    opened.root = std::move(*root);
    reportUnknown(opened.root, opened);
    return opened;
}

Result<TmxFile> TmxReader::openNamed(const Path& folder, const std::string& name, std::string_view element) {
    if (Path{name}.is_absolute() || name.find('\0') != std::string::npos) {
        return Error{name, "the path is absolute",
                     "move the file to the folder of the map and select it again in Tiled"};
    }
    const Path path = (folder / name).lexically_normal();
    const Result<std::string> text = (*readFrom_)(path);
    if (!text) return text.error();
    return open(*text, path, element);
}

void TmxReader::reportUnknown(const XmlElement& element, const TmxFile& file) {
    const TmxElement* known = findTmxElement(element.name);
    const TmxFields from = fields(element, file);
    if (known == nullptr) {
        if (reported_.insert(element.name).second)
            from.warn(format("the element <{}> is unknown and was ignored", element.name),
                      "no action is needed if the map looks right");
        return;
    }
    for (const XmlAttribute& attribute : element.attributes) {
        if (known->reads(attribute.name)) continue;
        if (known->isEditorOnly(attribute.name)) {
            map_.editorKeys.insert(attribute.name);
        } else if (reported_.insert(format("{}@{}", element.name, attribute.name)).second) {
            from.warn(format("the attribute \"{}\" is unknown and was ignored", attribute.name),
                      "no action is needed if the map looks right");
        }
    }
    if (known->editorOnly) map_.editorKeys.insert(element.name);
    for (const XmlElement& child : element.children) {
        if (!known->editorOnly) reportUnknown(child, file);
    }
}

Result<tiled::Map> TmxReader::readMap(std::string_view text, const Path& file) {
    const Result<TmxFile> opened = open(text, file, "map");
    if (!opened) return opened.error();
    const XmlElement& root = opened->root;
    const TmxFields from = fields(root, *opened);
    const std::string name = from.text("orientation", "orthogonal");
    const std::optional<tiled::Orientation> orientation = tiled::orientationNamed(name);
    if (!orientation) {
        return Error{
            from.where(), format("the map is {}", name),
            "only orthogonal, isometric, staggered and hexagonal maps can be imported; select one of "
            "them in Tiled: Map, Map Properties, Orientation"};
    }
    map_.orientation = *orientation;
    readMapFields(*opened);
    if (map_.tileWidth <= 0 || map_.tileHeight <= 0) {
        return Error{from.where(), "the map has no tile size", "set tilewidth and tileheight, in px"};
    }
    for (const XmlElement& child : root.children) {
        if (child.name == "tileset") readTileset(child, *opened);
    }
    readLayers(root, *opened, {});
    return std::move(map_);
}

void TmxReader::readMapFields(const TmxFile& file) {
    const TmxFields from = fields(file.root, file);
    map_.version = from.text("version");
    map_.type = from.text("class");
    map_.renderOrder = from.text("renderorder", "right-down");
    map_.infinite = from.flag("infinite", false);
    map_.width = from.whole("width", 0, 0, kManyPixels);
    map_.height = from.whole("height", 0, 0, kManyPixels);
    map_.tileWidth = from.whole("tilewidth", 0, 1, limits::kImageSide);
    map_.tileHeight = from.whole("tileheight", 0, 1, limits::kImageSide);
    map_.hexSide = from.whole("hexsidelength", 0, 0, limits::kImageSide);
    map_.staggersX = readChoice(from, "staggeraxis", "y", "x");
    map_.staggersEven = readChoice(from, "staggerindex", "odd", "even");
    map_.parallaxOrigin = {static_cast<float>(from.real("parallaxoriginx", 0.0)),
                           static_cast<float>(from.real("parallaxoriginy", 0.0))};
    map_.background = from.color("backgroundcolor");
    map_.folder = file.folder;
    map_.properties = tmxProperties(file.root, file.name, *warnings_);
}

void TmxReader::readLayers(const XmlElement& parent, const TmxFile& file, const Inherited& inherited) {
    for (const XmlElement& child : parent.children) {
        if (child.name == "group") {
            readGroup(child, file, inherited);
        } else if (child.name == "layer" || child.name == "objectgroup" || child.name == "imagelayer") {
            readLayer(child, file, inherited);
        }
    }
}

/// Combines the fields of a layer or group with those inherited from the groups that contain it.
void TmxReader::inheritFields(const XmlElement& element, const TmxFile& file, Layer& layer) {
    const TmxFields from = fields(element, file);
    layer.id = from.whole("id", 0, 0, 1 << 30);
    layer.name = from.text("name");
    layer.type = from.text("class");
    layer.offset +=
        Vec2{static_cast<float>(from.real("offsetx", 0.0)), static_cast<float>(from.real("offsety", 0.0))};
    layer.opacity *= std::clamp(from.real("opacity", 1.0), 0.0, 1.0);
    layer.parallax.x *= static_cast<float>(from.real("parallaxx", 1.0));
    layer.parallax.y *= static_cast<float>(from.real("parallaxy", 1.0));
    layer.visible = layer.visible && from.flag("visible", true);
    layer.locked = layer.locked || from.flag("locked", false);
    if (const std::string blend = from.text("mode", "normal"); blend != "normal") {
        layer.blend = blend;
        from.warn(format("the blend mode \"{}\" of the layer is not supported", blend),
                  "it is drawn with normal blending; use \"normal\" in Tiled, or a tint color");
    }
    const Color tint = from.color("tintcolor").value_or(Color{});
    layer.tint = {multiplied(layer.tint.r, tint.r), multiplied(layer.tint.g, tint.g),
                  multiplied(layer.tint.b, tint.b), multiplied(layer.tint.a, tint.a)};
    layer.properties = tmxProperties(element, file.name, *warnings_);
}

void TmxReader::readGroup(const XmlElement& element, const TmxFile& file, const Inherited& inherited) {
    if (inherited.depth >= kGroupDepth) {
        fields(element, file).warn("groups are nested too deep", "remove levels of groups");
        return;
    }
    Inherited inner = inherited;
    inheritFields(element, file, inner.layer);
    inner.depth = inherited.depth + 1;
    inner.layer.group =
        inherited.layer.group.empty() ? inner.layer.name : inherited.layer.group + "/" + inner.layer.name;
    map_.groups.push_back({inner.layer.group, inner.layer.id, inner.layer.type, inner.layer.properties});
    readLayers(element, file, inner);
}

void TmxReader::readLayer(const XmlElement& element, const TmxFile& file, const Inherited& inherited) {
    Layer layer = inherited.layer;
    inheritFields(element, file, layer);
    if (element.name == "layer") readTiles(element, file, layer);
    if (element.name == "objectgroup") readObjects(element, file, layer);
    if (element.name == "imagelayer") readImage(element, file, layer);
    map_.layers.push_back(std::move(layer));
}

void TmxReader::readTiles(const XmlElement& element, const TmxFile& file, Layer& layer) {
    const TmxFields from = fields(element, file);
    layer.kind = LayerKind::Tiles;
    layer.width = from.whole("width", map_.width, 0, limits::kTileSide);
    layer.height = from.whole("height", map_.height, 0, limits::kTileSide);
    const XmlElement* data = element.child("data");
    if (!data) {
        from.warn("the layer has no data", "save the map again in Tiled");
        layer.width = layer.height = 0;
        return;
    }
    const std::string where = format("{} \"{}\"", from.where(), layer.name);
    if (const Result<Done> cells = readTmxCells(*data, layer, cellsLeft_, where); !cells) {
        warnings_->push_back(cells.error());
        layer.cells.clear();
        layer.width = layer.height = 0;
    }
}

void TmxReader::readObjects(const XmlElement& element, const TmxFile& file, Layer& layer) {
    const TmxFields from = fields(element, file);
    layer.kind = LayerKind::Objects;
    layer.sortByY = from.text("draworder", "topdown") != "index";
    layer.color = from.text("color");
    for (const XmlElement& child : element.children) {
        tiled::Object object;
        if (child.name == "object" && readObject(child, file, object))
            layer.objects.push_back(std::move(object));
    }
}

void TmxReader::readImage(const XmlElement& element, const TmxFile& file, Layer& layer) {
    const TmxFields from = fields(element, file);
    layer.kind = LayerKind::Image;
    layer.offset += Vec2{static_cast<float>(from.real("x", 0.0)), static_cast<float>(from.real("y", 0.0))};
    layer.repeatX = from.flag("repeatx", false);
    layer.repeatY = from.flag("repeaty", false);
    const XmlElement* image = element.child("image");
    if (image) {
        layer.image = fields(*image, file).path("source");
        if (image->child("data"))
            from.warn("the image is embedded in the file", "save it as a separate file in Tiled");
        layer.transparent = fields(*image, file).color("trans");
    }
    if (layer.image.empty()) from.warn("the layer has no image file", "select its image in Tiled");
}

Result<tiled::Map> parseTiledMap(std::string_view text, const Path& file, const FileReader& readFrom,
                                 std::vector<Error>& warnings) {
    return TmxReader{readFrom, warnings}.readMap(text, file);
}

Result<tiled::Map> loadTiledMap(const Path& file, std::vector<Error>& warnings) {
    const FileReader readFrom = [](const Path& path) -> Result<std::string> {
        Result<std::string> bytes = readFile(path);
        // Linux distributions compress Tiled's example files, but references to them lack the ".gz".
        if (!bytes && readFile(path.string() + ".gz")) bytes = readFile(path.string() + ".gz");
        if (bytes && startsWith(*bytes, "\x1f\x8b"))
            return unpackGzip(*bytes, limits::kFileBytes, path.generic_string());
        return bytes;
    };
    const Result<std::string> text = readFrom(file);
    if (!text) return text.error();
    Result<tiled::Map> map = parseTiledMap(*text, file, readFrom, warnings);
    if (!map) return map;
    const TiledClasses classes = tiledClassesAround(file, warnings);
    if (!classes.empty()) applyClasses(*map, classes);
    return map;
}

}  // namespace plumb
