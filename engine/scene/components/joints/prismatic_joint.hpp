#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// A slider: the body moves along the axis of the other, and does not turn against it.
struct PrismaticJoint : JointLink, JointStiffness {
    Vec2 axis{1.0f, 0.0f};  ///< direction, turned with the other body
    bool limited = false;
    float lower = 0.0f;  ///< px along the axis, from the start
    float upper = 0.0f;  ///< px
    bool motor = false;
    float motorSpeed = 0.0f;  ///< px/s
    float maxForce = 0.0f;    ///< kg px/s^2 of the motor; 0 is as much as it takes

    static void describe(TypeBuilder<PrismaticJoint>& type) {
        type.name("PrismaticJoint").doc("A slider along an axis of another body, or the world.");
        describeLink(type);
        type.field<&PrismaticJoint::axis>("axis").doc("Direction, turned with the other body.");
        type.field<&PrismaticJoint::limited>("limited").doc("Moves between lower and upper only.");
        type.field<&PrismaticJoint::lower>("lower").unit(Unit::Pixels).shownIf("limited");
        type.field<&PrismaticJoint::upper>("upper").unit(Unit::Pixels).shownIf("limited");
        type.field<&PrismaticJoint::motor>("motor");
        type.field<&PrismaticJoint::motorSpeed>("motorSpeed").unit(Unit::PixelsPerSecond).shownIf("motor");
        type.field<&PrismaticJoint::maxForce>("maxForce")
            .range(0.0f, 1e18f)
            .shownIf("motor")
            .doc("kg px/s2 of the motor; 0 is as much as it takes.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Prismatic;
        joint.axis = axis;
        joint.limit = {limited, lower * metres, upper * metres};
        joint.motor = {motor, motorSpeed * metres, forceOrEndless(maxForce, metres)};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio};
    }
};

}  // namespace plumb
