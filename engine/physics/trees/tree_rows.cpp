#include <cmath>

#include "physics/geometry.hpp"
#include "physics/trees/joint_trees.hpp"

namespace plumb::physics {

namespace {

/// Returns the change of a direction or arm by a rotation.
Double2 changeOf(Vec2 arm, const PoseChange& pose) {
    const auto [x, y] = wide(arm);
    return {pose.versine * x - pose.sine * y, pose.sine * x + pose.versine * y};
}

struct Anchors {
    Double2 treeBodyArm;
    Double2 parentArm;
    Double2 apart;
};

Anchors anchorsAt(const Link& link, const PoseChange& treeBody, const PoseChange& parent) {
    const Double2 changeOfLimb = changeOf(link.treeBodyArm, treeBody);
    const Double2 changeOfParent = changeOf(link.parentArm, parent);
    const Double2 moved{treeBody.x - parent.x, treeBody.y - parent.y};
    return {wide(link.treeBodyArm) + changeOfLimb, wide(link.parentArm) + changeOfParent,
            wide(link.apart) + (moved + (changeOfLimb - changeOfParent))};
}

/// Returns the axis of a slider, which rotates with body A.
Double2 axisOf(const Link& link, const PoseChange& treeBody, const PoseChange& parent) {
    return wide(link.axis) + changeOf(link.axis, link.treeBodyIsB ? parent : treeBody);
}

Double2 acrossOf(Double2 axis) { return {-axis.y, axis.x}; }

double angleAt(const Link& link, const PoseChange& treeBody, const PoseChange& parent) {
    const double sine =
        (treeBody.sine - parent.sine) + (treeBody.sine * parent.versine - parent.sine * treeBody.versine);
    const double cosine = 1.0 + ((treeBody.versine + parent.versine) +
                                 (treeBody.versine * parent.versine + treeBody.sine * parent.sine));
    return double{link.angle} + double{arcTangent(static_cast<float>(sine), static_cast<float>(cosine))};
}

Triple along(Double2 direction, Double2 arm) { return {direction.x, direction.y, cross(arm, direction)}; }

void setLine(Link& link, int row, Double2 direction, Double2 treeBodyArm, Double2 parentArm) {
    link.onTreeBody[row] = along(direction, treeBodyArm);
    link.onParent[row] = -1.0 * along(direction, parentArm);
}

void setAngle(Link& link, int row) {
    link.onTreeBody[row] = {0.0, 0.0, 1.0};
    link.onParent[row] = {0.0, 0.0, -1.0};
}

void setPoint(Link& link, const Anchors& at) {
    link.limb = at.treeBodyArm;
    link.parentLimb = at.parentArm;
    setAngle(link, 2);
    if (link.byArms()) return;
    setLine(link, 0, {1.0, 0.0}, at.treeBodyArm, at.parentArm);
    setLine(link, 1, {0.0, 1.0}, at.treeBodyArm, at.parentArm);
}

void setRod(Link& link, const Anchors& at) {
    const double length = std::sqrt(dot(at.apart, at.apart));
    const Double2 direction =
        length > 0.0 ? Double2{at.apart.x / length, at.apart.y / length} : Double2{1.0, 0.0};
    setLine(link, 0, direction, at.treeBodyArm, at.parentArm);
}

void setSlider(Link& link, const Anchors& at, Double2 axis) {
    // The force acts at B's anchor at any displacement along the axis.
    const Double2 treeBodyArm = link.treeBodyIsB ? at.treeBodyArm : at.treeBodyArm - at.apart;
    const Double2 parentArm = link.treeBodyIsB ? at.parentArm + at.apart : at.parentArm;
    setLine(link, 0, acrossOf(axis), treeBodyArm, parentArm);
    setAngle(link, 1);
    if (link.drive.on) setLine(link, 2, axis, treeBodyArm, parentArm);
}

Triple gapsAt(const Link& link, const Anchors& at, const PoseChange& treeBody, const PoseChange& parent) {
    switch (link.kind) {
        case JointKind::Weld: return {at.apart.x, at.apart.y, angleAt(link, treeBody, parent)};
        case JointKind::Revolute: return {at.apart.x, at.apart.y, 0.0};
        case JointKind::Distance: return {std::sqrt(dot(at.apart, at.apart)) - double{link.rest}};
        case JointKind::Prismatic:
            return {dot(at.apart, acrossOf(axisOf(link, treeBody, parent))), angleAt(link, treeBody, parent)};
        default: return {};  // not in trees
    }
}

}  // namespace

PoseChange turnedBy(const PoseChange& pose, double angle) {
    double sine = 0.0, versine = 0.0;
    if (std::fabs(angle) <= 0.5) {  // series, accurate to 1e-9
        const double square = angle * angle;
        sine = angle * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0))));
        versine = -square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square * (1.0 / 40320.0))));
    } else {
        const SinCos rotation = sinCos(static_cast<float>(angle));
        sine = static_cast<double>(rotation.sin);
        versine = static_cast<double>(rotation.cos) - 1.0;
    }
    return {pose.x, pose.y, pose.sine + (pose.sine * versine + sine + pose.versine * sine),
            pose.versine + (versine + pose.versine * versine - pose.sine * sine)};
}

Triple setRows(Link& link, const PoseChange& treeBody, const PoseChange& parent) {
    const Anchors at = anchorsAt(link, treeBody, parent);
    switch (link.kind) {
        case JointKind::Weld:
        case JointKind::Revolute: setPoint(link, at); break;
        case JointKind::Distance: setRod(link, at); break;
        case JointKind::Prismatic: setSlider(link, at, axisOf(link, treeBody, parent)); break;
        default: break;  // not in trees
    }
    return gapsAt(link, at, treeBody, parent);
}

Triple gapsOf(const Link& link, const PoseChange& treeBody, const PoseChange& parent) {
    return gapsAt(link, anchorsAt(link, treeBody, parent), treeBody, parent);
}

double valueOf(const Link& link, const PoseChange& treeBody, const PoseChange& parent) {
    if (link.kind == JointKind::Revolute) return angleAt(link, treeBody, parent);
    return dot(anchorsAt(link, treeBody, parent).apart, axisOf(link, treeBody, parent));
}

}  // namespace plumb::physics
