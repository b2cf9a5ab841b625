#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Keeps two anchors at a given distance: a rod, a rope, or a spring.
struct DistanceJoint : JointLink, JointStiffness {
    float length = 0.0f;  ///< px, distance of the anchors; 0: their distance at the start
    bool rope = false;    ///< limits only the maximum distance; the anchors may come closer

    DistanceJoint() { autoAnchor = false; }

    static void describe(TypeBuilder<DistanceJoint>& type) {
        type.name("DistanceJoint")
            .doc(
                "Keeps two anchors at a given distance: a rod, rope or spring to another body or the world.");
        describeLink(type);
        type.field<&DistanceJoint::length>("length")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Distance of the anchors, px; 0: their distance at the start.");
        type.field<&DistanceJoint::rope>("rope").doc("Limits only the maximum distance, like a rope.");
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
