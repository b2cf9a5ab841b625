#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Pulls an anchor of the body towards a point in the world, like a mouse that drags it.
struct MouseJoint : JointLink, JointStiffness {
    Vec2 target;            ///< px in the world: the point that the anchor is pulled to
    float maxForce = 0.0f;  ///< kg px/s^2, maximum force; 0: unlimited

    MouseJoint() {
        hertz = 5.0f;
        dampingRatio = 1.0f;
        collide = true;
    }

    static void describe(TypeBuilder<MouseJoint>& type) {
        type.name("MouseJoint").doc("Pulls an anchor of the body towards a point in the world.");
        describeLink(type);
        type.field<&MouseJoint::target>("target")
            .unit(Unit::Pixels)
            .doc("Point in the world that the anchor is pulled to, px.");
        type.field<&MouseJoint::maxForce>("maxForce")
            .range(0.0f, 1e18f)
            .doc("Maximum force, kg px/s2; 0: unlimited.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Mouse;
        joint.target = target * metres;
        joint.maxForce = forceLimit(maxForce, metres);
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
