#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// A rope over two wheels: when one body goes down, the other goes up.
struct PulleyJoint : JointLink {
    Vec2 wheel;           ///< px in the world: above this body
    Vec2 otherWheel;      ///< px in the world: above the other
    float ratio = 1.0f;   ///< how much further the other one moves
    float length = 0.0f;  ///< px: both ropes, the own one times the ratio; 0 is as at the start

    PulleyJoint() {
        autoAnchor = false;
        collide = true;
    }

    static void describe(TypeBuilder<PulleyJoint>& type) {
        type.name("PulleyJoint").doc("A rope over two wheels to another body.");
        describeLink(type);
        type.field<&PulleyJoint::wheel>("wheel").unit(Unit::Pixels).doc("In the world, above this body.");
        type.field<&PulleyJoint::otherWheel>("otherWheel")
            .unit(Unit::Pixels)
            .doc("In the world, above the other body.");
        type.field<&PulleyJoint::ratio>("ratio")
            .unit(Unit::Ratio)
            .range(0.001f, 1000.0f)
            .doc("How much further the other one moves.");
        type.field<&PulleyJoint::length>("length")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Both ropes, the own one times the ratio; 0 is as at the start.");
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
