#pragma once

#include <string>
#include <vector>

#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/tile_grid.hpp"
#include "reflect/field_types.hpp"

namespace plumb::editor {

/// Collects shapes to be drawn over the scene, in world px; the thickness of lines does not depend on the
/// zoom. As plain data, it lets tools and overlays work without a window, and tests inspect their shapes.
class Overlay {
public:
    enum class Kind : unsigned char { Line, Arrow, Box, FilledBox, Circle, Text, Tile };
    struct Shape {
        Kind kind = Kind::Line;
        Vec2 from;
        Vec2 to;
        float radius = 0.0f;     ///< px, world: radius of a circle
        float thickness = 1.0f;  ///< px on screen: line thickness
        Color color;
        std::string text;
        TilesetId tileset;  ///< tileset, for Kind::Tile
        TileCell cell = 0;  ///< tile and its flips, for Kind::Tile
    };

    void line(Vec2 from, Vec2 to, Color color, float thickness = 1.0f) {
        shapes_.push_back({Kind::Line, from, to, 0.0f, thickness, color, {}, {}, 0});
    }
    void arrow(Vec2 from, Vec2 to, Color color, float thickness = 1.0f) {
        shapes_.push_back({Kind::Arrow, from, to, 0.0f, thickness, color, {}, {}, 0});
    }
    void box(const AABB& box, Color color, float thickness = 1.0f) {
        shapes_.push_back({Kind::Box, box.min, box.max, 0.0f, thickness, color, {}, {}, 0});
    }
    void filledBox(const AABB& box, Color color) {
        shapes_.push_back({Kind::FilledBox, box.min, box.max, 0.0f, 1.0f, color, {}, {}, 0});
    }
    void circle(Vec2 center, float radius, Color color, float thickness = 1.0f) {
        shapes_.push_back({Kind::Circle, center, center, radius, thickness, color, {}, {}, 0});
    }
    void text(Vec2 at, std::string words, Color color) {
        shapes_.push_back({Kind::Text, at, at, 0.0f, 1.0f, color, std::move(words), {}, 0});
    }
    /// Adds the image of a tile, scaled to the box. @param color  tint
    void tile(const AABB& box, TilesetId tileset, TileCell cell, Color color) {
        Shape& shape = shapes_.emplace_back();
        shape.kind = Kind::Tile;
        shape.from = box.min;
        shape.to = box.max;
        shape.color = color;
        shape.tileset = tileset;
        shape.cell = cell;
    }
    void clear() { shapes_.clear(); }
    [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }

private:
    std::vector<Shape> shapes_;
};

}  // namespace plumb::editor
