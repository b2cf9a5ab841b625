#include "import/import_objects.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "import/tile_animation.hpp"
#include "import/tile_shapes.hpp"
#include "import/tiled_json.hpp"
#include "math/angle.hpp"

namespace plumb {
namespace {

using tiled::Object;
using tiled::Shape;

Vec2 positionOf(const Object& object) { return {static_cast<float>(object.x), static_cast<float>(object.y)}; }
float rotationOf(const Object& object) { return radiansFromDegrees(static_cast<float>(object.rotation)); }

/// Returns which point of a tile's image is at the object's position, as a ratio of the image's size.
Vec2 pivotOf(const std::string& alignment) {
    Vec2 pivot{0.0f, 1.0f};
    if (alignment.empty() || alignment == "unspecified") return pivot;
    pivot.x = endsWith(alignment, "left") ? 0.0f : endsWith(alignment, "right") ? 1.0f : 0.5f;
    pivot.y = startsWith(alignment, "top") ? 0.0f : startsWith(alignment, "bottom") ? 1.0f : 0.5f;
    return pivot;
}

struct SpritePose {
    Vec2 position;
    float rotation = 0.0f;
    Vec2 pivot;
    bool flipX = false;
    bool flipY = false;
};

SpritePose poseOf(const Object& object, Vec2 size, Vec2 pivot) {
    const bool flipX = object.tile.flags & tiled::kFlipX;
    const bool flipY = object.tile.flags & tiled::kFlipY;
    SpritePose pose{positionOf(object), rotationOf(object), pivot, flipX, flipY};
    if (!(object.tile.flags & tiled::kFlipDiagonal)) return pose;
    // A diagonal flip is a mirrored image rotated by 90 degrees about its center: width and height swap.
    const Vec2 lying{size.y, size.x};
    const Vec2 middle{(0.5f - pivot.x) * lying.x, (0.5f - pivot.y) * lying.y};
    pose.position += rotated(middle, pose.rotation);
    pose.rotation += kPi * 0.5f;
    pose.pivot = {0.5f, 0.5f};
    pose.flipX = flipY;
    pose.flipY = !flipX;
    return pose;
}

/// Adds a Sprite of the image's size, since sprite sizes are integers; the Transform scales to the object's.
void addSprite(Json& components, const EntityImport& import, const tiled::Layer& layer,
               const LayerPlacement& place, const Object& object) {
    const auto index = static_cast<std::size_t>(object.tile.tileset);
    const ImportedTileset& tileset = import.tilesets[index];
    const tiled::Tileset& original = import.map.tilesets[index];
    const TileRegion picture = tileset.pictureOf(shownTile(original, object.tile.id));
    const bool known = !picture.source.empty();
    if (tileset.count > 0 && object.tile.id >= tileset.count) {
        import.draft.report.problems.push_back(
            {format("layer {}: object {}", layer.name, object.id),
             format("the object's tile {} is past the {} tiles of tileset {}", object.tile.id, tileset.count,
                    original.name),
             "select another tile in Tiled; the imported sprite has no image"});
    }
    if (tileset.isDeleted(object.tile.id)) {
        import.draft.report.problems.push_back(
            {format("layer {}: object {}", layer.name, object.id),
             format("tileset {} no longer has the object's tile {}", original.name, object.tile.id),
             "select another tile in Tiled; the imported sprite has no image"});
    }
    const Vec2 source = known ? Vec2{picture.source.width, picture.source.height}
                              : Vec2{static_cast<float>(std::max(original.tileWidth, 1)),
                                     static_cast<float>(std::max(original.tileHeight, 1))};
    const Vec2 size{object.width > 0.0 ? static_cast<float>(object.width) : source.x,
                    object.height > 0.0 ? static_cast<float>(object.height) : source.y};
    Vec2 pivot = pivotOf(original.objectAlignment);
    pivot -=
        {static_cast<float>(original.offsetX) / source.x, static_cast<float>(original.offsetY) / source.y};
    const SpritePose pose = poseOf(object, size, pivot);

    components["Transform"] =
        transformJson(pose.position + place.offset, pose.rotation, {size.x / source.x, size.y / source.y});
    Json sprite = Json::object();
    sprite["texture"] = picture.texture;
    sprite["width"] = static_cast<int>(source.x);
    sprite["height"] = static_cast<int>(source.y);
    if (known && (picture.source.x != 0.0f || picture.source.y != 0.0f)) {
        sprite["source"] = Json::array({picture.source.x, picture.source.y, source.x, source.y});
    }
    sprite["layer"] = place.order;
    sprite["tint"] = colorOf(layer, object.opacity);
    if (pose.flipX) sprite["flipX"] = true;
    if (pose.flipY) sprite["flipY"] = true;
    sprite["pivot"] = vec2Json(pose.pivot);
    const TileAnimations::StagedAnimation* animation =
        import.animations.of(tileset, object.tile.id, import.draft.stage);
    const bool moving = animation && !animation->file.empty();
    if (moving) {
        sprite["texture"] = animation->texture;
        sprite.erase("source");
    }
    components["Sprite"] = std::move(sprite);
    if (moving) components["Animator"]["animation"] = animation->file;
    if (place.moves) components["ParallaxLayer"] = parallaxJson(layer);
}

/// Inserts line breaks so that text in the engine's own font, whose glyphs are square, fits the box width.
std::string wrapped(const tiled::TextStyle& style, double width) {
    const auto letters = static_cast<std::size_t>(std::clamp(width / style.size, 1.0, 1e6));
    if (!style.wrap) return style.text;
    std::string text;
    std::size_t column = 0;
    for (const std::string_view word : split(style.text, ' ')) {
        if (!text.empty()) {
            const bool fits = column + 1 + word.size() <= letters;
            text += fits ? ' ' : '\n';
            column = fits ? column + 1 : 0;
        }
        text += word;
        const std::size_t lineBreak = word.rfind('\n');
        column = lineBreak == std::string_view::npos ? column + word.size() : word.size() - lineBreak - 1;
    }
    return text;
}

void addLabel(Json& components, const tiled::Layer& layer, const LayerPlacement& place,
              const Object& object) {
    const tiled::TextStyle& style = object.text;
    const std::string text = wrapped(style, object.width);
    const auto lines = static_cast<double>(1 + std::count(text.begin(), text.end(), '\n'));
    const double free = object.height - lines * style.size;
    const double down = style.alignY == "center" ? free * 0.5 : style.alignY == "bottom" ? free : 0.0;
    const bool centered = style.alignX == "center";
    const bool right = style.alignX == "right";
    const double along = centered ? object.width * 0.5 : right ? object.width : 0.0;
    const Vec2 inside{static_cast<float>(along), static_cast<float>(object.height > 0.0 ? down : 0.0)};

    const Vec2 position = positionOf(object) + rotated(inside, rotationOf(object)) + place.offset;
    components["Transform"] = transformJson(position, rotationOf(object), {1.0f, 1.0f});
    Json label = Json::object();
    label["text"] = text;
    label["size"] = style.size;
    Color color = style.color;
    color.a =
        multiplied(color.a, withOpacity(layer.tint, static_cast<float>(layer.opacity * object.opacity)).a);
    label["color"] = colorJson(color);
    if (centered || right) label["align"] = centered ? "center" : "right";
    label["layer"] = place.order;
    components["Label"] = std::move(label);
}

Json pointsJson(const std::vector<Vec2>& points) {
    Json json = Json::array();
    for (const Vec2 point : points) json.push_back(vec2Json(point));
    return json;
}

Json boxJson(const Object& object) {
    Json json = Json::object();
    json["width"] = object.width;
    json["height"] = object.height;
    return json;
}

/// Returns name and JSON of the collider for an object's outline; empty if no collider can store it.
std::pair<std::string, Json> colliderOf(const Object& object) {
    const bool sized = object.width > 0.0 && object.height > 0.0;
    Json json = Json::object();
    switch (object.shape) {
        case Shape::Rectangle:
            if (sized) return {"BoxCollider", boxJson(object)};
            break;
        case Shape::Capsule:
            if (sized) return {"CapsuleCollider", boxJson(object)};
            break;
        case Shape::Ellipse:
            if (!sized) break;
            if (object.width == object.height) {
                json["radius"] = object.width * 0.5;
                json["offset"] = Json::array({object.width * 0.5, object.height * 0.5});
                return {"CircleCollider", std::move(json)};
            }
            json["points"] = pointsJson(outlineOf(object));
            return {"PolygonCollider", std::move(json)};
        case Shape::Polygon:
            if (object.points.size() < 3 || object.points.size() > kMaxOutlineCorners) break;
            json["points"] = pointsJson(object.points);
            return {"PolygonCollider", std::move(json)};
        case Shape::Polyline:
            if (object.points.size() < 2 || object.points.size() > kMaxOutlineCorners) break;
            json["points"] = pointsJson(object.points);
            return {"ChainCollider", std::move(json)};
        case Shape::Point:
        case Shape::Text:
        case Shape::Tile: break;
    }
    return {};
}

/// Adds the object's outline as a trigger, because objects in level editors usually mark areas for events.
void addTrigger(Json& components, const Object& object) {
    auto [name, collider] = colliderOf(object);
    if (name.empty()) return;
    collider["isTrigger"] = true;
    components[name] = std::move(collider);
}

}  // namespace

bool isOutlineLost(const tiled::Object& object) {
    return object.points.size() > kMaxOutlineCorners && colliderOf(object).first.empty();
}

Json objectComponents(const EntityImport& import, const tiled::Layer& layer, const LayerPlacement& place,
                      const Object& object) {
    Json components = Json::object();
    if (object.shape == Shape::Tile && !object.tile.empty()) {
        addSprite(components, import, layer, place, object);
    } else if (object.shape == Shape::Text) {
        addLabel(components, layer, place, object);
    } else {
        components["Transform"] =
            transformJson(positionOf(object) + place.offset, rotationOf(object), {1.0f, 1.0f});
        addTrigger(components, object);
    }
    return components;
}

}  // namespace plumb
