#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// A hinge: the two anchors stay together, the bodies turn about them.
struct RevoluteJoint : JointLink, JointStiffness {
    bool limited = false;
    float lower = 0.0f;  ///< rad, from the angle at the start
    float upper = 0.0f;  ///< rad
    bool motor = false;
    float motorSpeed = 0.0f;  ///< rad/s, clockwise on screen
    float maxTorque = 0.0f;   ///< kg px^2/s^2 of the motor; 0 is as much as it takes

    static void describe(TypeBuilder<RevoluteJoint>& type) {
        type.name("RevoluteJoint").doc("A hinge between this body and another, or the world.");
        describeLink(type);
        type.field<&RevoluteJoint::limited>("limited").doc("Turns between lower and upper only.");
        type.field<&RevoluteJoint::lower>("lower").unit(Unit::Radians).shownIf("limited");
        type.field<&RevoluteJoint::upper>("upper").unit(Unit::Radians).shownIf("limited");
        type.field<&RevoluteJoint::motor>("motor");
        type.field<&RevoluteJoint::motorSpeed>("motorSpeed").unit(Unit::RadiansPerSecond).shownIf("motor");
        type.field<&RevoluteJoint::maxTorque>("maxTorque")
            .range(0.0f, 1e18f)
            .shownIf("motor")
            .doc("kg px2/s2 of the motor; 0 is as much as it takes.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Revolute;
        joint.limit = {limited, lower, upper};
        joint.motor = {motor, motorSpeed, forceOrEndless(maxTorque, metres * metres)};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
