#pragma once

#include <cmath>

#include "math/portable.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

/// A world to hang things up in: metres, y up, nothing sleeps, nothing collides.
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

    /// A disc of 1 kg and 1/8 kg m2, unless its mass is given.
    BodyId disc(Place place, float mass = 1.0f) {
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

    JointDefinition define(JointKind kind, BodyId a, BodyId b, Place pivot) const {
        JointDefinition definition;
        definition.kind = kind;
        definition.a = a;
        definition.b = b;
        definition.anchorA = pivot - positionOf(world, a);
        definition.anchorB = pivot - positionOf(world, b);
        return definition;
    }
    JointId join(const JointDefinition& definition) { return *createJoint(world, definition); }

    void run(float seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kDt + 0.5f); ++i) step(world, kDt, options);
    }

    /// m: between the two anchors of a joint.
    [[nodiscard]] Vec2 gapOf(JointId id) const {
        const Joint& joint = world.joints.hot[id.index];
        const BodyPose& a = world.bodies.pose[joint.bodyA];
        const BodyPose& b = world.bodies.pose[joint.bodyB];
        return (b.centre - a.centre) + rotate(b.rotation, joint.anchorB) - rotate(a.rotation, joint.anchorA);
    }
    [[nodiscard]] float angle(BodyId body) const { return angleOf(rotationOf(world, body)); }
    [[nodiscard]] Vec2 place(BodyId body) const { return toVec2(centreOf(world, body)); }

    /// J: of motion and height.
    [[nodiscard]] double energyOf(BodyId body) const {
        const BodyMass& mass = world.bodies.mass[body.index];
        const double speed = length(velocityOf(world, body)), spin = angularVelocityOf(world, body);
        return 0.5 * mass.mass * speed * speed + 0.5 * mass.inertia * spin * spin +
               mass.mass * -static_cast<double>(world.settings.gravity.y) * centreOf(world, body).y;
    }

    /// s: mean time between upward crossings of `rest` by what `measure` tells.
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

}  // namespace plumb::physics
