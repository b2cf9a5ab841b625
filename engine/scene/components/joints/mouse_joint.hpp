#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Pulls an anchor of the body to a place in the world, as a hand or a mouse would.
struct MouseJoint : JointLink, JointStiffness {
    Vec2 target;            ///< px in the world
    float maxForce = 0.0f;  ///< kg px/s^2; 0 is as much as it takes

    MouseJoint() {
        hertz = 5.0f;
        dampingRatio = 1.0f;
        collide = true;
    }

    static void describe(TypeBuilder<MouseJoint>& type) {
        type.name("MouseJoint").doc("Pulls an anchor of the body to a place in the world.");
        describeLink(type);
        type.field<&MouseJoint::target>("target").unit(Unit::Pixels).doc("In the world.");
        type.field<&MouseJoint::maxForce>("maxForce")
            .range(0.0f, 1e18f)
            .doc("kg px/s2; 0 is as much as it takes.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Mouse;
        joint.target = target * metres;
        joint.maxForce = forceOrEndless(maxForce, metres);
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
