#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Drives the body to an offset and angle relative to another body, with limited force and torque.
struct MotorJoint : JointLink, JointStiffness {
    Vec2 offset;             ///< px, target offset in the other body's frame
    float angle = 0.0f;      ///< rad, target angle relative to the one at the start
    float maxForce = 0.0f;   ///< kg px/s^2, maximum force; 0: unlimited
    float maxTorque = 0.0f;  ///< kg px^2/s^2, maximum torque; 0: unlimited

    MotorJoint() {
        hertz = 5.0f;
        dampingRatio = 1.0f;
        collide = true;
    }

    static void describe(TypeBuilder<MotorJoint>& type) {
        type.name("MotorJoint")
            .doc("Drives the body to an offset and angle relative to another body, with limited force.");
        describeLink(type);
        type.field<&MotorJoint::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Target offset in the other body's frame, px.");
        type.field<&MotorJoint::angle>("angle")
            .unit(Unit::Radians)
            .doc("Target angle relative to the one at the start, degrees.");
        type.field<&MotorJoint::maxForce>("maxForce")
            .range(0.0f, 1e18f)
            .doc("Maximum force, kg px/s2; 0: unlimited.");
        type.field<&MotorJoint::maxTorque>("maxTorque")
            .range(0.0f, 1e18f)
            .doc("Maximum torque, kg px2/s2; 0: unlimited.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Motor;
        joint.offset = offset * metres;
        joint.referenceAngle += angle;
        joint.maxForce = forceLimit(maxForce, metres);
        joint.maxTorque = forceLimit(maxTorque, metres * metres);
        joint.hertz = hertz;
        joint.dampingRatio = dampingRatio;
    }
};

}  // namespace plumb
