#include "editor/model/tools/rotate_tool.hpp"

#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "math/angle.hpp"

namespace plumb::editor {
namespace {

constexpr float kTolerance = 6.0f;  // px on screen: hit distance on both sides of the ring

float angleOf(Vec2 arm) { return std::atan2(arm.y, arm.x); }

}  // namespace

Handle RotateTool::handleAt(const Pose& pose, const Pointer& pointer) const {
    const float away = distance(pose.position, pointer.position) / pointer.pixel;
    return std::abs(away - kRing) < kTolerance ? Handle::Both : Handle::None;
}

void RotateTool::take(const Pointer& pointer) {
    before_ = angleOf(pointer.position - drag_.pivot().position);
    turned_ = angle_ = 0.0f;
}

void RotateTool::pull(const ToolContext& context, const Pointer& pointer) {
    const float now = angleOf(pointer.position - drag_.pivot().position);
    turned_ += wrapAngle(now - std::exchange(before_, now));
    const float start = drag_.pivot().rotation;
    angle_ = turned_;
    if (pointer.snap && pointer.angle > 0.0f)
        angle_ = std::round((start + turned_) / pointer.angle) * pointer.angle - start;
    drag_.turn(context, angle_);
}

void RotateTool::drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const {
    const float radius = kRing * pointer.pixel;
    const Color color = hot != Handle::None ? handle_colors::kHot : handle_colors::kBoth;
    overlay.circle(pose.position, radius, handle_colors::kShade, 5.0f);
    overlay.circle(pose.position, radius, color, 2.5f);
    overlay.line(pose.position, pose.position + rotated({radius, 0.0f}, pose.rotation), color, 2.0f);
    overlay.circle(pose.position, 3.5f * pointer.pixel, {255, 255, 255, 230}, 2.0f);
    if (held() == Handle::None) return;
    const long degrees = std::lround(degreesFromRadians(angle_));
    overlay.text(pose.position + Vec2{radius, -radius} * 0.75f, format("{}\xc2\xb0", degrees), color);
}

}  // namespace plumb::editor
