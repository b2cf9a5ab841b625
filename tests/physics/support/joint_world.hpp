#pragma once

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

/// A world for bodies that hang on joints: y up, no sleep, no collisions.
struct JointWorld {
    static constexpr float kDt = 1.0f / 60.0f;
    static constexpr float kGravity = 10.0f;

    World world;
    BodyId ground;
    StepOptions options;

    JointWorld() {
        world.settings.gravity = {0.0f, -kGravity};
        world.settings.sleeping = false;
        BodyDefinition definition;
        definition.kind = BodyKind::Static;
        ground = *createBody(world, definition);
    }

    /// Creates a disc of radius 0.5 m; with a mass of 1 kg its moment of inertia is 1/8 kg m2.
    BodyId disc(WorldPosition place, float mass = 1.0f) {
        constexpr float kRadius = 0.5f;
        BodyDefinition definition;
        definition.position = place;
        const BodyId body = *createBody(world, definition);
        ShapeDefinition shape;
        shape.mask = 0;
        shape.density = mass / (kPi * kRadius * kRadius);
        (void)*createShape(world, body, circle(kRadius), shape);
        return body;
    }

    JointDefinition define(JointKind kind, BodyId a, BodyId b, WorldPosition pivot) const {
        JointDefinition definition;
        definition.kind = kind;
        definition.a = a;
        definition.b = b;
        definition.anchorA = pivot - positionOf(world, a);
        definition.anchorB = pivot - positionOf(world, b);
        return definition;
    }
    /// Creates discs of 1 and 2 kg, each 3 m below its pulley wheel. @return a pulley joint between them
    JointDefinition definePulley(float ratio) {
        JointDefinition definition;
        definition.kind = JointKind::Pulley;
        definition.a = disc({-1.0, -3.0}, 1.0f);
        definition.b = disc({1.0, -3.0}, 2.0f);
        definition.groundA = {-1.0f, 0.0f};
        definition.groundB = {1.0f, 0.0f};
        definition.ratio = ratio;
        definition.length = 3.0f + ratio * 3.0f;
        return definition;
    }
    JointId join(const JointDefinition& definition) { return *createJoint(world, definition); }

    void run(float seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kDt + 0.5f); ++i) step(world, kDt, options);
    }

    /// Vector from anchor A to anchor B of a joint, world space, m.
    [[nodiscard]] Vec2 gapOf(JointId id) const {
        const Joint& joint = world.joints.hot[id.index];
        const BodyPose& a = world.bodies.pose[joint.bodyA];
        const BodyPose& b = world.bodies.pose[joint.bodyB];
        return (b.centre - a.centre) + rotate(b.rotation, joint.anchorB) - rotate(a.rotation, joint.anchorA);
    }
    [[nodiscard]] float angle(BodyId body) const { return angleOf(rotationOf(world, body)); }
    [[nodiscard]] Vec2 place(BodyId body) const { return toVec2(centreOf(world, body)); }

    /// Returns the kinetic plus potential energy of a body, J.
    [[nodiscard]] double energyOf(BodyId body) const {
        const BodyMass& mass = world.bodies.mass[body.index];
        const double speed = length(velocityOf(world, body)), spin = angularVelocityOf(world, body);
        return 0.5 * mass.mass * speed * speed + 0.5 * mass.inertia * spin * spin +
               mass.mass * -static_cast<double>(world.settings.gravity.y) * centreOf(world, body).y;
    }

    /// Runs for `seconds`. @return the mean time between upward crossings of `rest` by measure(), s; 0: none
    template <class Measure>
    float periodOf(float rest, float seconds, Measure&& measure) {
        float first = 0.0f, last = 0.0f, before = measure();
        int crossings = 0;
        for (int i = 1; i <= static_cast<int>(seconds / kDt); ++i) {
            step(world, kDt, options);
            const float now = measure();
            if (before < rest && now >= rest) {
                last = (static_cast<float>(i) - (now - rest) / (now - before)) * kDt;
                if (crossings++ == 0) first = last;
            }
            before = now;
        }
        return crossings > 1 ? (last - first) / static_cast<float>(crossings - 1) : 0.0f;
    }
};

/// Creates a random tree of discs with joints that the direct solver supports.
/// @param hangs  true: attaches the root of the tree to the ground
inline std::vector<JointId> growTree(JointWorld& scene, Random& random, WorldPosition root, bool hangs) {
    constexpr JointKind kKinds[] = {JointKind::Revolute, JointKind::Weld, JointKind::Prismatic,
                                    JointKind::Distance};
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
    for (int i = 0; i < 12; ++i) {
        const bool first = bodies.empty();
        const BodyId above =
            first ? scene.ground : bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        const WorldPosition at =
            first ? root : positionOf(scene.world, above) + Vec2{random.unit() - 0.5f, -1.0f};
        const BodyId body = scene.disc(at, i % 4 == 3 ? 50.0f : 0.5f);
        if (!first || hangs) {
            const JointKind kind = first ? JointKind::Revolute : kKinds[random.below(4)];
            JointDefinition definition = scene.define(kind, above, body, at + Vec2{0.0f, 0.5f});
            definition.length = 0.5f;
            definition.axis = {1.0f, 0.0f};
            if (kind == JointKind::Distance) definition.anchorB = {};
            joints.push_back(scene.join(definition));
        }
        bodies.push_back(body);
    }
    return joints;
}

}  // namespace plumb::physics
