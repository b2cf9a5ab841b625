#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Keeps two anchors at a length: a rod, a rope, or a spring.
struct DistanceJoint : JointLink, JointStiffness {
    float length = 0.0f;  ///< px; 0 is as long as at the start
    bool rope = false;    ///< may be shorter

    DistanceJoint() { autoAnchor = false; }

    static void describe(TypeBuilder<DistanceJoint>& type) {
        type.name("DistanceJoint").doc("A rod, rope or spring to another body, or the world.");
        describeLink(type);
        type.field<&DistanceJoint::length>("length")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("0 is as long as at the start.");
        type.field<&DistanceJoint::rope>("rope").doc("May be shorter.");
        describeStiffness(type);
    }
    void apply(physics::JointDefinition& joint, float metres) const {
        joint.kind = physics::JointKind::Distance;
        joint.length = length * metres;
        joint.limit = {rope, 0.0f, joint.length};
        joint.spring = {hertz > 0.0f, hertz, dampingRatio, joint.length};
    }
};

}  // namespace plumb
