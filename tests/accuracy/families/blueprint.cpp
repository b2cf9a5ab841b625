#include "tests/accuracy/families/blueprint.hpp"

#include "math/rot.hpp"

namespace plumb::families {

namespace {

/// Transforms a point from world coordinates into the frame of a body.
Vec2 localPoint(const BodySetup& body, Vec2 point) {
    return unrotate(rotFromAngle(body.angle), point - body.position);
}

}  // namespace

std::uint32_t Blueprint::add(const BodyPlan& plan) {
    bodies.push_back(plan);
    return static_cast<std::uint32_t>(bodies.size() - 1);
}

std::uint32_t Blueprint::add(const BodySetup& setup, const Outline& outline, const Material& material) {
    BodyPlan plan;
    plan.setup = setup;
    plan.shapes.push_back({outline, material});
    return add(plan);
}

std::uint32_t Blueprint::addStatic(const Outline& outline, Vec2 position, const Material& material,
                                   float angle) {
    return add({.motion = Motion::Static, .position = position, .angle = angle}, outline, material);
}

std::uint32_t Blueprint::addDynamic(const Outline& outline, Vec2 position, const Material& material,
                                    float angle) {
    return add({.position = position, .angle = angle}, outline, material);
}

std::uint32_t Blueprint::addFloor(const Material& material) {
    return addStatic(scenes::box({100.0f, 1.0f}), {0.0f, -1.0f}, material);
}

std::uint32_t Blueprint::addAnchor(Vec2 position) {
    BodyPlan plan;
    plan.setup = {.motion = Motion::Static, .position = position};
    return add(plan);
}

void Blueprint::join(std::uint32_t a, std::uint32_t b, Vec2 point, JointSetup joint) {
    joint.a = handleOf(a);
    joint.b = handleOf(b);
    joint.anchorA = localPoint(bodies[a].setup, point);
    joint.anchorB = localPoint(bodies[b].setup, point);
    joint.axis = unrotate(rotFromAngle(bodies[a].setup.angle), joint.axis);
    joint.reference = bodies[b].setup.angle - bodies[a].setup.angle;
    joints.push_back(joint);
}

}  // namespace plumb::families
