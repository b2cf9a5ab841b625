#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// A rope over two fixed wheels that connects two bodies: when one moves down, the other moves up.
struct PulleyJoint : JointLink {
    Vec2 wheel;           ///< px in the world, position of the wheel above this body
    Vec2 otherWheel;      ///< px in the world, position of the wheel above the other body
    float ratio = 1.0f;   ///< displacement of the other body per displacement of this one
    float length = 0.0f;  ///< px: rope on the other side + ratio * rope on this side; 0: as at the start

    PulleyJoint() {
        autoAnchor = false;
        collide = true;
    }

    static void describe(TypeBuilder<PulleyJoint>& type) {
        type.name("PulleyJoint").doc("A rope over two fixed wheels to another body.");
        describeLink(type);
        type.field<&PulleyJoint::wheel>("wheel")
            .unit(Unit::Pixels)
            .doc("Position of the wheel above this body, px in the world.");
        type.field<&PulleyJoint::otherWheel>("otherWheel")
            .unit(Unit::Pixels)
            .doc("Position of the wheel above the other body, px in the world.");
        type.field<&PulleyJoint::ratio>("ratio")
            .unit(Unit::Ratio)
            .range(0.001f, 1000.0f)
            .doc("Displacement of the other body per displacement of this one, as a ratio.");
        type.field<&PulleyJoint::length>("length")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Rope on the other side plus ratio times rope on this side, px; 0: as at the start.");
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Pulley;
        joint.groundA = otherWheel * metres;
        joint.groundB = wheel * metres;
        joint.ratio = ratio;
        joint.length = length * metres;
    }
};

}  // namespace plumb
