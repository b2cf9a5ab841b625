#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Couples this entity's RevoluteJoint or PrismaticJoint to that of another entity, like gears.
struct GearJoint : JointLink {
    float ratio = 1.0f;  ///< motion of the other joint per motion of this one; negative: same direction

    GearJoint() { collide = true; }

    static void describe(TypeBuilder<GearJoint>& type) {
        type.name("GearJoint")
            .doc(
                "Couples this entity's RevoluteJoint or PrismaticJoint to that of another entity, like "
                "gears.");
        type.field<&GearJoint::other>("other").doc(
            "Other entity; it must have a RevoluteJoint or PrismaticJoint too.");
        type.field<&GearJoint::ratio>("ratio")
            .unit(Unit::Ratio)
            .range(-1000.0f, 1000.0f)
            .doc("Ratio: motion of the other joint per motion of this one; negative: in the same direction.");
    }
    void apply(physics::JointDefinition& joint, float) const {
        joint.kind = physics::JointKind::Gear;
        joint.ratio = ratio;
    }
};

}  // namespace plumb
