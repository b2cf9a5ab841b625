#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Ties the hinge or slider of this entity to that of another, as toothed wheels are.
struct GearJoint : JointLink {
    float ratio = 1.0f;  ///< turns of the other for one of this; negative in the same direction

    GearJoint() { collide = true; }

    static void describe(TypeBuilder<GearJoint>& type) {
        type.name("GearJoint")
            .doc("Ties this entity's RevoluteJoint or PrismaticJoint to that of the other.");
        type.field<&GearJoint::other>("other").doc("Has a RevoluteJoint or PrismaticJoint too.");
        type.field<&GearJoint::ratio>("ratio")
            .unit(Unit::Ratio)
            .range(-1000.0f, 1000.0f)
            .doc("Turns of the other for one of this; negative in the same direction.");
    }
    void apply(physics::JointDefinition& joint, float) const {
        joint.kind = physics::JointKind::Gear;
        joint.ratio = ratio;
    }
};

}  // namespace plumb
