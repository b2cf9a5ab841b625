#include "physics/model/shape_wind.hpp"

#include <algorithm>

#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/shapes.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

Result<Done> applyWind(World& world, ShapeId shape, Vec2 air, float drag, float lift) {
    const auto checked =
        firstOf(checkAlive("applyWind", world, shape), checkVector("applyWind air", air, kFastest),
                checkNumber("applyWind drag", drag, 0.0, kFastest),
                checkNumber("applyWind lift", lift, 0.0, kFastest));
    if (!checked) return checked;
    const BodyId body = bodyOf(world, shape);
    const BodyPose& pose = world.bodies.pose[body.index];
    const BodyMotion& motion = world.bodies.motion[body.index];
    const Convex outline = convexOf(world.shapes.geometry[shape.index], world.shapes.corners);
    const std::span<const Corner> corners = outline.corners();
    const auto feltAt = [&](Vec2 arm) { return air - motion.velocity - cross(motion.angularVelocity, arm); };
    const auto armOf = [&](Vec2 point) { return rotate(pose.rotation, point - pose.localCentre); };
    Vec2 force;           // N
    float torque = 0.0f;  // N m, about the center of mass
    // Adds the force on a piece of the outline with a width (m) across the air: F = q * width * speed^2.
    const auto add = [&](Vec2 arm, Vec2 felt, float width, Vec2 lifting) {
        const Vec2 own = (width * length(felt)) * (drag * felt + length(felt) * lifting);
        force += own;
        torque += cross(arm, own);
    };
    for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i) {
        const Vec2 to = corners[(i + 1) % corners.size()].point;
        const Vec2 arm = armOf(0.5f * (corners[i].point + to)), felt = feltAt(arm);
        const Vec2 normal = rotate(pose.rotation, corners[i].normal), along = normalized(felt);
        const float facing = -dot(normal, along);
        if (!(facing > 0.0f)) continue;
        add(arm, felt, facing * length(to - corners[i].point), lift * (-normal - facing * along));
    }
    const Vec2 middle = armOf(outline.centre);  // rounded corners only have drag
    add(middle, feltAt(middle), 2.0f * outline.radius, {});
    // Limits the force: in a step the body reaches at most the speed of the air.
    const float maximum = massOf(world, body) * length(feltAt(middle)) / world.stepLength;
    const float part = std::min(1.0f, maximum / std::max(length(force), 1.0e-30f));
    const Result<Done> pushed = applyForce(world, body, part * force);
    return pushed ? applyTorque(world, body, part * torque) : pushed;
}

}  // namespace plumb::physics
