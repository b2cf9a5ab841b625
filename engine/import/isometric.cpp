#include "import/isometric.hpp"

#include "import/tile_shapes.hpp"

namespace plumb {

using tiled::Shape;

IsometricPlane IsometricPlane::of(const tiled::Map& map) {
    return {map.tileWidth, map.tileHeight, static_cast<double>(map.height) * map.tileWidth * 0.5};
}

Vec2 IsometricPlane::direction(double x, double y) const {
    const double column = x / height_;
    const double row = y / height_;
    return {static_cast<float>((column - row) * width_ * 0.5),
            static_cast<float>((column + row) * height_ * 0.5)};
}

Vec2 IsometricPlane::onScreen(double x, double y) const {
    return direction(x, y) + Vec2{static_cast<float>(originX_), 0.0f};
}

void IsometricPlane::project(tiled::Object& object) const {
    const bool hasArea = object.width > 0.0 && object.height > 0.0;
    const bool isArea =
        object.shape == Shape::Rectangle || object.shape == Shape::Ellipse || object.shape == Shape::Capsule;
    if (isArea && hasArea) {
        object.points = outlineOf(object);
        object.shape = Shape::Polygon;
        object.width = object.height = 0.0;
    }
    for (Vec2& point : object.points)
        point = direction(static_cast<double>(point.x), static_cast<double>(point.y));
    const Vec2 place = onScreen(object.x, object.y);
    object.x = static_cast<double>(place.x);
    object.y = static_cast<double>(place.y);
}

}  // namespace plumb
