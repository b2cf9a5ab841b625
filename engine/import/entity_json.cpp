#include "import/entity_json.hpp"

#include "core/hash.hpp"
#include "core/text.hpp"
#include "import/tiled_json.hpp"

namespace plumb {

std::string EntityIds::next(std::string_view key) {
    std::uint64_t id = mixBits(hashText(key));
    while (id == 0 || !taken_.insert(id).second) id = mixBits(id + 1);
    return hexText(id);
}

Json transformJson(Vec2 position, float rotation, Vec2 scale) {
    Json json = Json::object();
    if (position != Vec2{}) json["position"] = vec2Json(position);
    if (rotation != 0.0f) json["rotation"] = rotation;
    if (scale != Vec2{1.0f, 1.0f}) json["scale"] = vec2Json(scale);
    return json;
}

Json parallaxJson(const tiled::Layer& layer) {
    Json json = Json::object();
    json["factor"] = vec2Json(layer.parallax);
    json["repeatX"] = layer.repeatX;
    json["repeatY"] = layer.repeatY;
    return json;
}

Json colorOf(const tiled::Layer& layer, double opacity) {
    return colorJson(withOpacity(layer.tint, static_cast<float>(layer.opacity * opacity)));
}

}  // namespace plumb
