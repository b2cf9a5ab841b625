#include "import/tiled_json.hpp"

#include <array>
#include <string>

namespace plumb {
namespace {

constexpr std::array<const char*, 8> kShapeNames{"rectangle", "ellipse",  "point", "capsule",
                                                 "polygon",   "polyline", "text",  "tile"};

Json textJson(const tiled::TextStyle& text) {
    Json json = Json::object();
    json["text"] = text.text;
    json["font"] = text.font;
    json["size"] = text.size;
    json["color"] = colorJson(text.color);
    json["wrap"] = text.wrap;
    json["bold"] = text.bold;
    json["italic"] = text.italic;
    if (text.underline) json["underline"] = true;
    if (text.strikeout) json["strikeout"] = true;
    if (!text.kerning) json["kerning"] = false;
    json["alignX"] = text.alignX;
    json["alignY"] = text.alignY;
    return json;
}

}  // namespace

Json vec2Json(Vec2 vector) { return Json::array({vector.x, vector.y}); }

Json colorJson(Color color) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : {color.r, color.g, color.b, color.a}) {
        text += kDigits[part >> 4];
        text += kDigits[part & 15];
    }
    return Json(color.a == 255 ? text.substr(0, 7) : text);
}

Json objectJson(const tiled::Object& object) {
    Json json = Json::object();
    json["id"] = object.id;
    json["shape"] = kShapeNames[static_cast<std::size_t>(object.shape)];
    if (!object.type.empty()) json["type"] = object.type;
    if (!object.name.empty()) json["name"] = object.name;
    json["position"] = Json::array({object.x, object.y});
    if (object.width != 0.0 || object.height != 0.0)
        json["size"] = Json::array({object.width, object.height});
    if (object.rotation != 0.0) json["degrees"] = object.rotation;
    if (!object.templateFile.empty()) json["template"] = object.templateFile;
    for (const Vec2 point : object.points) json["points"].push_back(vec2Json(point));
    if (object.shape == tiled::Shape::Text) json["text"] = textJson(object.text);
    if (object.shape == tiled::Shape::Tile && !object.tile.empty()) json["tile"] = object.tile.id;
    return json;
}

}  // namespace plumb
