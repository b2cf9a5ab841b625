#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// A slider: the body moves along an axis of the other body and does not rotate relative to it.
struct PrismaticJoint : JointLink, JointStiffness {
    Vec2 axis{1.0f, 0.0f};    ///< direction of motion, in the other body's frame
    bool limited = false;     ///< limits the motion to `lower` .. `upper`
    float lower = 0.0f;       ///< px along the axis, from the position at the start
    float upper = 0.0f;       ///< px along the axis, from the position at the start
    bool motor = false;       ///< a motor drives the body along the axis
    float motorSpeed = 0.0f;  ///< px/s along the axis, target speed of the motor
    float maxForce = 0.0f;    ///< kg px/s^2, maximum force of the motor; 0: unlimited

    static void describe(TypeBuilder<PrismaticJoint>& type) {
        type.name("PrismaticJoint")
            .doc("A slider along an axis of another body or the world, without rotation.");
        describeLink(type);
        type.field<&PrismaticJoint::axis>("axis").doc("Direction of motion, in the other body's frame.");
        type.field<&PrismaticJoint::limited>("limited").doc("Limits the motion to lower .. upper.");
        type.field<&PrismaticJoint::lower>("lower")
            .unit(Unit::Pixels)
            .shownIf("limited")
            .doc("Minimum translation along the axis from the start, px.");
        type.field<&PrismaticJoint::upper>("upper")
            .unit(Unit::Pixels)
            .shownIf("limited")
            .doc("Maximum translation along the axis from the start, px.");
        type.field<&PrismaticJoint::motor>("motor").doc("Drives the body along the axis.");
        type.field<&PrismaticJoint::motorSpeed>("motorSpeed")
            .unit(Unit::PixelsPerSecond)
            .shownIf("motor")
            .doc("Target speed of the motor, px/s.");
        type.field<&PrismaticJoint::maxForce>("maxForce")
            .range(0.0f, 1e18f)
            .shownIf("motor")
            .doc("Maximum force of the motor, kg px/s2; 0: unlimited.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Prismatic;
        joint.axis = axis;
        joint.limit = {limited, lower * metres, upper * metres};
        joint.motor = {motor, motorSpeed * metres, forceLimit(maxForce, metres)};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
