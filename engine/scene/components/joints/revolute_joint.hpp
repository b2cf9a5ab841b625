#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// A hinge: keeps the two anchors together; the bodies rotate about them.
struct RevoluteJoint : JointLink, JointStiffness {
    bool limited = false;     ///< limits the angle to `lower` .. `upper`
    float lower = 0.0f;       ///< rad, from the angle at the start
    float upper = 0.0f;       ///< rad, from the angle at the start
    bool motor = false;       ///< a motor drives the rotation
    float motorSpeed = 0.0f;  ///< rad/s, target speed of the motor, clockwise on screen
    float maxTorque = 0.0f;   ///< kg px^2/s^2, maximum torque of the motor; 0: unlimited

    static void describe(TypeBuilder<RevoluteJoint>& type) {
        type.name("RevoluteJoint").doc("A hinge between this body and another body or the world.");
        describeLink(type);
        type.field<&RevoluteJoint::limited>("limited").doc("Limits the angle to lower .. upper.");
        type.field<&RevoluteJoint::lower>("lower")
            .unit(Unit::Radians)
            .shownIf("limited")
            .doc("Minimum angle from the start, degrees.");
        type.field<&RevoluteJoint::upper>("upper")
            .unit(Unit::Radians)
            .shownIf("limited")
            .doc("Maximum angle from the start, degrees.");
        type.field<&RevoluteJoint::motor>("motor").doc("Drives the rotation about the hinge.");
        type.field<&RevoluteJoint::motorSpeed>("motorSpeed")
            .unit(Unit::RadiansPerSecond)
            .shownIf("motor")
            .doc("Target speed of the motor, degrees/s, clockwise on screen.");
        type.field<&RevoluteJoint::maxTorque>("maxTorque")
            .range(0.0f, 1e18f)
            .shownIf("motor")
            .doc("Maximum torque of the motor, kg px2/s2; 0: unlimited.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Revolute;
        joint.limit = {limited, lower, upper};
        joint.motor = {motor, motorSpeed, forceLimit(maxTorque, metres * metres)};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
