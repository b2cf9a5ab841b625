#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Attaches a wheel to a car (the other body): the wheel rotates
/// freely and is suspended by a spring along an axis of the car.
struct WheelJoint : JointLink, JointStiffness {
    Vec2 axis{0.0f, 1.0f};    ///< direction of the spring, in the other body's frame
    bool limited = false;     ///< limits the spring travel to `lower` .. `upper`
    float lower = 0.0f;       ///< px along the axis, from the position at the start
    float upper = 0.0f;       ///< px along the axis, from the position at the start
    bool motor = false;       ///< a motor drives the rotation of the wheel
    float motorSpeed = 0.0f;  ///< rad/s, target speed of the motor, clockwise on screen
    float maxTorque = 0.0f;   ///< kg px^2/s^2, maximum torque of the motor; 0: unlimited

    WheelJoint() { hertz = 4.0f; }

    static void describe(TypeBuilder<WheelJoint>& type) {
        type.name("WheelJoint").doc("Attaches a wheel to a car, which is the other body, with a spring.");
        describeLink(type);
        type.field<&WheelJoint::axis>("axis").doc("Direction of the spring, in the other body's frame.");
        type.field<&WheelJoint::limited>("limited").doc("Limits the spring travel to lower .. upper.");
        type.field<&WheelJoint::lower>("lower")
            .unit(Unit::Pixels)
            .shownIf("limited")
            .doc("Minimum translation along the axis from the start, px.");
        type.field<&WheelJoint::upper>("upper")
            .unit(Unit::Pixels)
            .shownIf("limited")
            .doc("Maximum translation along the axis from the start, px.");
        type.field<&WheelJoint::motor>("motor").doc("Drives the rotation of the wheel.");
        type.field<&WheelJoint::motorSpeed>("motorSpeed")
            .unit(Unit::RadiansPerSecond)
            .shownIf("motor")
            .doc("Target speed of the motor, degrees/s, clockwise on screen.");
        type.field<&WheelJoint::maxTorque>("maxTorque")
            .range(0.0f, 1e18f)
            .shownIf("motor")
            .doc("Maximum torque of the motor, kg px2/s2; 0: unlimited.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Wheel;
        joint.axis = axis;
        joint.limit = {limited, lower * metres, upper * metres};
        joint.motor = {motor, motorSpeed, forceLimit(maxTorque, metres * metres)};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
