#pragma once

#include "scene/joint_link.hpp"

namespace plumb {

/// Fixes two bodies to each other; with `hertz` above 0 the connection is elastic.
struct WeldJoint : JointLink, JointStiffness {
    static void describe(TypeBuilder<WeldJoint>& type) {
        type.name("WeldJoint")
            .doc("Fixes two bodies to each other; with hertz above 0 the connection is elastic.");
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
