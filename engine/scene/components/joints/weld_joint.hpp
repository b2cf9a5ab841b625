#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Keeps two bodies as one piece; with hertz, as one that bends.
struct WeldJoint : JointLink, JointStiffness {
    static void describe(TypeBuilder<WeldJoint>& type) {
        type.name("WeldJoint").doc("Makes two bodies one piece; with hertz, one that bends.");
        describeLink(type);
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float) const {
        joint.kind = physics::JointKind::Weld;
        joint.hertz = hertz;
        joint.dampingRatio = dampingRatio;
    }
};

}  // namespace plumb
