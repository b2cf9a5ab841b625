#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "import/loaders/tmx_reader.hpp"

namespace plumb {
namespace {

using tiled::Object;
using tiled::Shape;

constexpr std::size_t kMaxPoints = std::size_t{1} << 16;

struct ShapeName {
    std::string_view element;
    Shape shape;
};
constexpr ShapeName kShapes[] = {{"ellipse", Shape::Ellipse},   {"point", Shape::Point},
                                 {"capsule", Shape::Capsule},   {"polygon", Shape::Polygon},
                                 {"polyline", Shape::Polyline}, {"text", Shape::Text}};

void readText(const XmlElement& element, const TmxFields& from, tiled::TextStyle& text) {
    text.text = element.text;
    text.font = from.text("fontfamily", text.font);
    text.size = std::clamp(from.real("pixelsize", text.size), 1.0, 4096.0);
    text.color = from.color("color").value_or(text.color);
    text.wrap = from.flag("wrap", text.wrap);
    text.bold = from.flag("bold", text.bold);
    text.italic = from.flag("italic", text.italic);
    text.underline = from.flag("underline", text.underline);
    text.strikeout = from.flag("strikeout", text.strikeout);
    text.kerning = from.flag("kerning", text.kerning);
    text.alignX = from.text("halign", text.alignX);
    text.alignY = from.text("valign", text.alignY);
}

}  // namespace

bool TmxReader::readObject(const XmlElement& element, const TmxFile& file, Object& object,
                           int templateTileset) {
    const TmxFields from = fields(element, file);
    if (objectsLeft_ == 0) {
        if (reported_.insert("too many objects").second)
            from.warn("the map has too many objects", "split the map");
        return false;
    }
    --objectsLeft_;
    // A template supplies all fields that the object does not set. Templates cannot use templates.
    if (const std::string name = from.path("template"); !name.empty() && templateTileset == kGlobalId) {
        object = templateOf(name, file).object;
        object.templateFile = name;
    }
    object.id = from.whole("id", object.id, 0, 1 << 30);
    object.name = from.text("name", object.name);
    object.type = from.text("type", from.text("class", object.type));
    object.x = from.real("x", object.x);
    object.y = from.real("y", object.y);
    object.width = from.real("width", object.width);
    object.height = from.real("height", object.height);
    object.rotation = from.real("rotation", object.rotation);
    object.opacity = std::clamp(from.real("opacity", object.opacity), 0.0, 1.0);
    object.visible = from.flag("visible", object.visible);
    if (from.has("gid")) readTile(from, object, templateTileset);
    readShape(element, file, object);
    const Json own = tmxProperties(element, file.name, *warnings_);
    for (const auto& [key, value] : own.items()) object.properties[key] = value;
    return true;
}

void TmxReader::readTile(const TmxFields& from, Object& object, int templateTileset) {
    const std::optional<std::int64_t> gid = parseInt(from.text("gid", "0"));
    if (!gid || *gid < 0 || *gid > 0xffffffffll) {
        from.warn(format("gid is \"{}\"", from.text("gid")), "save the map again in Tiled");
        return;
    }
    const auto cell = static_cast<tiled::Gid>(*gid);
    object.shape = Shape::Tile;
    if (templateTileset == kGlobalId) {
        object.tile = map_.resolve(cell);
    } else if (templateTileset >= 0) {
        // The id in a template includes the template's own firstgid, which templateOf() subtracts.
        object.tile = {templateTileset, static_cast<int>(cell & ~tiled::kFlags), cell & tiled::kFlags};
    }
    if (object.tile.empty())
        from.warn(format("no tileset has the tile {}", cell & ~tiled::kFlags),
                  "add the missing tileset to the map in Tiled");
}

void TmxReader::readShape(const XmlElement& element, const TmxFile& file, Object& object) {
    for (const XmlElement& child : element.children) {
        const auto known = std::find_if(std::begin(kShapes), std::end(kShapes),
                                        [&](const ShapeName& name) { return name.element == child.name; });
        if (known == std::end(kShapes)) continue;
        object.shape = known->shape;
        if (known->shape == Shape::Text) readText(child, fields(child, file), object.text);
        if (known->shape != Shape::Polygon && known->shape != Shape::Polyline) continue;
        if (!readPoints(child, file, object)) object.shape = Shape::Point;
    }
}

bool TmxReader::readPoints(const XmlElement& element, const TmxFile& file, Object& object) {
    const TmxFields from = fields(element, file);
    object.points.clear();
    const std::string text = from.text("points");
    for (const std::string_view pair : split(text, ' ')) {
        if (trimmed(pair).empty()) continue;
        const std::size_t comma = pair.find(',');
        const std::optional<float> x = parseFloat(pair.substr(0, comma));
        const std::optional<float> y =
            comma == std::string_view::npos ? std::nullopt : parseFloat(pair.substr(comma + 1));
        const bool good = x && y && std::abs(*x) < 1e9f && std::abs(*y) < 1e9f;
        if (!good || object.points.size() >= kMaxPoints) {
            from.warn(format("\"{}\" is not a point", pair.substr(0, 40)),
                      "points must have the form x,y x,y");
            object.points.clear();
            return false;
        }
        object.points.push_back({*x, *y});
    }
    return !object.points.empty();
}

const TmxReader::Template& TmxReader::templateOf(const std::string& name, const TmxFile& file) {
    const Path path = (file.folder / name).lexically_normal();
    const auto [at, isNew] = templates_.try_emplace(path);
    Template& result = at->second;
    if (!isNew) return result;
    const Result<TmxFile> opened = openNamed(file.folder, name, "template");
    if (!opened) {
        warnings_->push_back(opened.error());
        return result;
    }
    const XmlElement* object = opened->root.child("object");
    if (!object) {
        fields(opened->root, *opened).warn("the template has no object", "save the template again in Tiled");
        return result;
    }
    int tileset = kNoTileset;
    int first = 1;
    if (const XmlElement* reference = opened->root.child("tileset")) {
        tileset = tilesetOf(*reference, *opened);
        first = fields(*reference, *opened).whole("firstgid", 1, 1, 1 << 28);
    }
    result.found = readObject(*object, *opened, result.object, tileset);
    if (!result.object.tile.empty() && tileset >= 0)
        result.object.tile.id = std::max(result.object.tile.id - first, 0);
    return result;
}

}  // namespace plumb
