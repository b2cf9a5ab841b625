#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::scenes {

namespace {

physics::BodyKind kindOf(Motion motion) {
    switch (motion) {
        case Motion::Static: return physics::BodyKind::Static;
        case Motion::Kinematic: return physics::BodyKind::Kinematic;
        case Motion::Dynamic: break;
    }
    return physics::BodyKind::Dynamic;
}

physics::JointKind kindOf(JointKind kind) {
    switch (kind) {
        case JointKind::Hinge: return physics::JointKind::Revolute;
        case JointKind::Slider: return physics::JointKind::Prismatic;
        case JointKind::Rod: return physics::JointKind::Distance;
        case JointKind::Wheel: return physics::JointKind::Wheel;
        case JointKind::Weld: break;
    }
    return physics::JointKind::Weld;
}

physics::ShapeDefinition definitionOf(const Material& material) {
    return {.density = material.density,
            .friction = material.friction,
            .bounciness = material.bounciness,
            .surfaceSpeed = -material.surfaceSpeed,  // the library's sign convention is for y down
            .layers = material.layers,
            .mask = material.mask,
            .group = material.group,
            .oneWay = material.oneWay,
            .oneWayDirection = material.oneWayDirection,
            .reportsContacts = material.reports};
}

}  // namespace

void PlumbWorld::makeBody(BodyHandle /*body*/, const BodySetup& setup) {
    const auto made = physics::createBody(world_, {.kind = kindOf(setup.motion),
                                                   .position = origin_ + setup.position,
                                                   .angle = setup.angle,
                                                   .velocity = setup.velocity,
                                                   .angularVelocity = setup.spin,
                                                   .gravityScale = setup.gravityScale,
                                                   .linearDrag = setup.drag,
                                                   .sleepSpeed = setup.sleepSpeed,
                                                   .fixedRotation = setup.fixedRotation,
                                                   .bullet = setup.bullet,
                                                   .canSleep = setup.canSleep,
                                                   .awake = setup.awake});
    ids_.push_back(made.ok() ? *made : physics::BodyId{});
    if (!made) lacks(made.error().text());
}

void PlumbWorld::makeShape(BodyHandle body, const Outline& outline, const Material& material) {
    const physics::ShapeDefinition definition = definitionOf(material);
    const auto& points = outline.points;
    switch (outline.kind) {
        case OutlineKind::Circle: return add(body, physics::circle(outline.radius, points[0]), definition);
        case OutlineKind::Capsule:
            return add(body, physics::capsule(points[0], points[1], outline.radius), definition);
        case OutlineKind::Box:
            return add(body, physics::box(outline.half, outline.centre, {}, outline.radius), definition);
        case OutlineKind::Segment: return add(body, physics::segment(points[0], points[1]), definition);
        case OutlineKind::Polygon:
        case OutlineKind::ChainSegment:
            return check(
                physics::createPolygon(world_, at(body), outline.corners(), outline.radius, definition));
    }
}

void PlumbWorld::makeLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) {
    check(physics::createChain(world_, at(body), points, true, definitionOf(material)));
}

void PlumbWorld::makeJoint(const JointSetup& joint) {
    if (!isDynamic(joint.a) && !isDynamic(joint.b)) return;  // joints need a dynamic body
    check(physics::createJoint(
        world_, {.kind = kindOf(joint.kind),
                 .a = at(joint.a),
                 .b = at(joint.b),
                 .anchorA = joint.anchorA,
                 .anchorB = joint.anchorB,
                 .axis = joint.axis,
                 .referenceAngle = joint.reference,
                 .length = joint.length,
                 .limit = {.on = joint.limited, .lower = joint.lower, .upper = joint.upper},
                 .motor = {.on = joint.driven, .speed = joint.speed, .maxForce = joint.maxForce},
                 .spring = {.on = joint.sprung,
                            .hertz = joint.hertz,
                            .dampingRatio = joint.dampingRatio,
                            .rest = joint.kind == JointKind::Rod ? joint.length : 0.0f}}));
}

Engine plumbEngine() {
    return {.name = "plumb",
            .maxThreads = 2,
            .profiles = true,
            .open = [](const WorldSetup& setup) -> std::unique_ptr<SceneBuilder> {
                return std::make_unique<PlumbWorld>(setup);
            }};
}

}  // namespace plumb::scenes
