#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Ties a wheel to its car: it turns freely and moves along the car's axis by a spring.
struct WheelJoint : JointLink, JointStiffness {
    Vec2 axis{0.0f, 1.0f};  ///< direction of the spring, turned with the other body
    bool limited = false;
    float lower = 0.0f;  ///< px along the axis, from the start
    float upper = 0.0f;  ///< px
    bool motor = false;
    float motorSpeed = 0.0f;  ///< rad/s, clockwise on screen
    float maxTorque = 0.0f;   ///< kg px^2/s^2 of the motor; 0 is as much as it takes

    WheelJoint() { hertz = 4.0f; }

    static void describe(TypeBuilder<WheelJoint>& type) {
        type.name("WheelJoint").doc("Ties a wheel to a car, which is the other body, by a spring.");
        describeLink(type);
        type.field<&WheelJoint::axis>("axis").doc("Direction of the spring, turned with the other body.");
        type.field<&WheelJoint::limited>("limited").doc("Moves between lower and upper only.");
        type.field<&WheelJoint::lower>("lower").unit(Unit::Pixels).shownIf("limited");
        type.field<&WheelJoint::upper>("upper").unit(Unit::Pixels).shownIf("limited");
        type.field<&WheelJoint::motor>("motor");
        type.field<&WheelJoint::motorSpeed>("motorSpeed").unit(Unit::RadiansPerSecond).shownIf("motor");
        type.field<&WheelJoint::maxTorque>("maxTorque")
            .range(0.0f, 1e18f)
            .shownIf("motor")
            .doc("kg px2/s2 of the motor; 0 is as much as it takes.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Wheel;
        joint.axis = axis;
        joint.limit = {limited, lower * metres, upper * metres};
        joint.motor = {motor, motorSpeed, forceOrEndless(maxTorque, metres * metres)};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
