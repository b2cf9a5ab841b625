#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Drives the body to an offset and angle from another one, with limited force.
struct MotorJoint : JointLink, JointStiffness {
    Vec2 offset;             ///< px, turned with the other body
    float angle = 0.0f;      ///< rad, from the angle at the start
    float maxForce = 0.0f;   ///< kg px/s^2; 0 is as much as it takes
    float maxTorque = 0.0f;  ///< kg px^2/s^2; 0 is as much as it takes

    MotorJoint() {
        hertz = 5.0f;
        dampingRatio = 1.0f;
        collide = true;
    }

    static void describe(TypeBuilder<MotorJoint>& type) {
        type.name("MotorJoint").doc("Drives the body to an offset from another one, with limited force.");
        describeLink(type);
        type.field<&MotorJoint::offset>("offset").unit(Unit::Pixels).doc("Turned with the other body.");
        type.field<&MotorJoint::angle>("angle").unit(Unit::Radians).doc("From the angle at the start.");
        type.field<&MotorJoint::maxForce>("maxForce")
            .range(0.0f, 1e18f)
            .doc("kg px/s2; 0 is as much as it takes.");
        type.field<&MotorJoint::maxTorque>("maxTorque")
            .range(0.0f, 1e18f)
            .doc("kg px2/s2; 0 is as much as it takes.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Motor;
        joint.offset = offset * metres;
        joint.referenceAngle += angle;
        joint.maxForce = forceOrEndless(maxForce, metres);
        joint.maxTorque = forceOrEndless(maxTorque, metres * metres);
        joint.hertz = hertz;
        joint.dampingRatio = dampingRatio;
    }
};

}  // namespace plumb
