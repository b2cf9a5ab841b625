#include "editor/model/tools/rotate_tool.hpp"

#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "editor/model/tools/handles.hpp"
#include "math/angle.hpp"

namespace plumb::editor {
namespace {

constexpr float kTolerance = 6.0f;  // px on screen, to both sides of the ring
constexpr float kSnapAngle = radiansFromDegrees(15.0f);

float angleOf(Vec2 arm) { return std::atan2(arm.y, arm.x); }

bool onRing(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Pose> pose = poseInHand(context.document);
    if (!pose) return false;
    const float away = distance(pose->position, pointer.position) / pointer.pixel;
    return std::abs(away - RotateTool::kRing) < kTolerance;
}

}  // namespace

void RotateTool::press(const ToolContext& context, const Pointer& pointer) {
    turning_ = onRing(context, pointer);
    if (!turning_) return select_.press(context, pointer);
    drag_.grab(context);
    before_ = angleOf(pointer.position - drag_.pivot().position);
    turned_ = angle_ = 0.0f;
}

void RotateTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (!turning_) return select_.drag(context, pointer);
    const float now = angleOf(pointer.position - drag_.pivot().position);
    turned_ += wrapAngle(now - std::exchange(before_, now));
    const float start = drag_.pivot().rotation;
    angle_ = turned_;
    if (pointer.snap) angle_ = std::round((start + turned_) / kSnapAngle) * kSnapAngle - start;
    drag_.turn(context, angle_);
}

void RotateTool::release(const ToolContext& context, const Pointer& pointer) {
    if (!std::exchange(turning_, false)) return select_.release(context, pointer);
    drag_.finish(context);
}

bool RotateTool::cancel(const ToolContext& context) {
    if (!std::exchange(turning_, false)) return select_.cancel(context);
    return drag_.cancel(context);
}

void RotateTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    select_.draw(context, pointer, overlay);
    const std::optional<Pose> pose = poseInHand(context.document);
    if (!pose) return;
    const float radius = kRing * pointer.pixel;
    const bool hot = turning_ || onRing(context, pointer);
    const Color color = hot ? handle_colors::kHot : handle_colors::kBoth;
    overlay.circle(pose->position, radius, handle_colors::kShade, 5.0f);
    overlay.circle(pose->position, radius, color, 2.5f);
    overlay.line(pose->position, pose->position + rotated({radius, 0.0f}, pose->rotation), color, 2.0f);
    overlay.circle(pose->position, 3.5f * pointer.pixel, {255, 255, 255, 230}, 2.0f);
    if (!turning_) return;
    const long degrees = std::lround(degreesFromRadians(angle_));
    overlay.text(pose->position + Vec2{radius, -radius} * 0.75f, format("{}\xc2\xb0", degrees), color);
}

}  // namespace plumb::editor
