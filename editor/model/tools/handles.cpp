#include "editor/model/tools/handles.hpp"

#include <cmath>

#include "math/angle.hpp"

namespace plumb::editor {
namespace {

constexpr float kEndBox = 4.5f;  // px on screen: half the side length of the boxes at the ends of the arms

Color of(Handle handle, Handle hot, Color color) { return handle == hot ? handle_colors::kHot : color; }

}  // namespace

Vec2 AxisHandles::point(float x, float y) const { return origin + rotated(Vec2{x, y} * pixel, rotation); }

Handle AxisHandles::at(Vec2 place) const {
    const Vec2 local = rotated(place - origin, -rotation) / pixel;
    const auto inside = [](float value, float from, float to) { return value > from && value < to; };
    if (inside(local.x, kSquareFrom, kSquareTo) && inside(local.y, kSquareFrom, kSquareTo))
        return Handle::Both;
    if (inside(local.x, kTolerance, kArm + kOverhang) && std::abs(local.y) < kTolerance) return Handle::X;
    if (inside(local.y, kTolerance, kArm + kOverhang) && std::abs(local.x) < kTolerance) return Handle::Y;
    return Handle::None;
}

Vec2 AxisHandles::middleOf(Handle handle) const {
    const float square = (kSquareFrom + kSquareTo) * 0.5f;
    switch (handle) {
        case Handle::X: return point(kArm * 0.7f, 0.0f);
        case Handle::Y: return point(0.0f, kArm * 0.7f);
        case Handle::Both: return point(square, square);
        case Handle::None: break;
    }
    return origin;
}

void AxisHandles::draw(Overlay& overlay, Handle hot, bool boxes) const {
    const auto arm = [&](Vec2 to, Color color) {
        overlay.line(origin, to, handle_colors::kShade, 5.0f);
        if (!boxes) return overlay.arrow(origin, to, color, 2.5f);
        overlay.line(origin, to, color, 2.5f);
        const Vec2 half{kEndBox * pixel, kEndBox * pixel};
        overlay.filledBox({to - half, to + half}, color);
    };
    arm(point(kArm, 0.0f), of(Handle::X, hot, handle_colors::kX));
    arm(point(0.0f, kArm), of(Handle::Y, hot, handle_colors::kY));
    const Color both = of(Handle::Both, hot, handle_colors::kBoth);
    const Vec2 middle = middleOf(Handle::Both);
    const Vec2 half = Vec2{1.0f, 1.0f} * ((kSquareTo - kSquareFrom) * 0.5f * pixel);
    overlay.filledBox({middle - half, middle + half}, {both.r, both.g, both.b, 90});
    overlay.box({middle - half, middle + half}, both, 1.5f);
    overlay.circle(origin, 3.5f * pixel, {255, 255, 255, 230}, 2.0f);
}

}  // namespace plumb::editor
