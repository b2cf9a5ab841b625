#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/geometry.hpp"
#include "physics/model/joint.hpp"

namespace plumb::physics {

/// A velocity, an impulse or a row of a Jacobian: components along x and y, and of the rotation.
struct Triple {
    double x = 0.0;
    double y = 0.0;
    double turn = 0.0;
};

inline double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.turn * b.turn; }
inline Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.turn + b.turn}; }
inline Triple operator*(double s, const Triple& a) { return {s * a.x, s * a.y, s * a.turn}; }
inline Triple operator-(const Triple& a, const Triple& b) { return a + -1.0 * b; }
inline Triple& operator+=(Triple& a, const Triple& b) { return a = a + b; }

struct Symmetric {  // symmetric 3 x 3 matrix; t: rotation
    double xx = 1.0;
    double xy = 0.0;
    double yy = 1.0;
    double xt = 0.0;
    double yt = 0.0;
    double tt = 1.0;
};

inline Triple operator*(const Symmetric& m, const Triple& v) {
    return {m.xx * v.x + m.xy * v.y + m.xt * v.turn, m.xy * v.x + m.yy * v.y + m.yt * v.turn,
            m.xt * v.x + m.yt * v.y + m.tt * v.turn};
}

/// Returns the inverse of a positive definite matrix by L D L^T: positive definite for any condition number.
inline Symmetric inverse(const Symmetric& m) {
    const double d0 = 1.0 / m.xx, l10 = m.xy * d0, l20 = m.xt * d0;
    const double d1 = 1.0 / (m.yy - m.xy * l10), below = m.yt - m.xt * l10, l21 = below * d1;
    const double d2 = 1.0 / (m.tt - m.xt * l20 - below * l21);
    const double n20 = l10 * l21 - l20;
    Symmetric w;
    w.tt = d2;
    w.yt = -l21 * d2;
    w.xt = n20 * d2;
    w.yy = d1 + l21 * l21 * d2;
    w.xy = n20 * w.yt - l10 * d1;
    w.xx = d0 + l10 * l10 * d1 + n20 * n20 * d2;
    return w;
}

/// Returns the inverse of a mass matrix of a body that cannot rotate.
inline Symmetric inverseUnturned(const Symmetric& m) {
    const double scale = 1.0 / (m.xx * m.yy - m.xy * m.xy);
    return {m.yy * scale, -m.xy * scale, m.xx * scale, 0.0, 0.0, 0.0};
}

// Data of the direct solver for trees of joints, see joint_tree_solver.hpp. A link is a joint between a tree
// body and its parent; a hold is a further joint of a tree body to a static or kinematic body: a loop.

/// Displacement and rotation of a body since the start of the step.
struct PoseChange {
    double x = 0.0;        ///< m
    double y = 0.0;        ///< m
    double sine = 0.0;     ///< sine of the rotation
    double versine = 0.0;  ///< cosine of the rotation, minus 1
};

struct TreeBody {
    std::uint32_t body = 0;
    std::int32_t slot = 0;
    std::uint32_t colours = 0;  ///< bits: colors of all its joints
    double mass = 0.0;          ///< kg
    double inertia = 0.0;       ///< kg m2; 0 if it cannot rotate
    double straining = 0.0;     ///< N m/rad: rotational stiffness due to the tension of its joints
    PoseChange poseChange;      ///< since the start of the step
    Triple velocity;
    Symmetric own;   ///< effective mass matrix of body and subtree; after factoring, the inverse
    Triple impulse;  ///< impulse of its subtree on it; later the change of its velocity
};

/// Motor and limits of a link's value, which is the angle of a hinge or the displacement of a slider, as row
/// 2 of the link. Its impulse determines its velocity: that of the motor while the impulse is below the
/// motor's maximum, and above that the velocity with which the value reaches a limit.
struct Drive {
    /// Impulses below, within and above those that the motor can give.
    enum class Range : std::uint8_t { Below, Within, Above };
    bool on = false;
    bool limited = false;
    bool exerts =
        false;  ///< the impulse is an end of a range, so the velocity is between those of two ranges
    Range range = Range::Within;
    double speed = 0.0;     ///< m/s or rad/s: target velocity of the motor
    double maxForce = 0.0;  ///< N or N m: of the motor; 0 without one
    double force = 0.0;     ///< N or N m: in the last step
    double lower = 0.0;     ///< m or rad: limits
    double upper = 0.0;
    double returnSpeed = 0.0;  ///< m/s or rad/s: maximum speed at which the value returns to its limits
    double value = 0.0;        ///< m or rad, at the current poses
    double velocity = 0.0;     ///< m/s or rad/s, without the impulses that this pass computes
    double slowest = 0.0;      ///< m/s or rad/s: velocities with which the value reaches a limit
    double fastest = 0.0;
    double most = 0.0;      ///< N s or N m s: maximum impulse of the motor in a substep
    double impulse = 0.0;   ///< N s or N m s: total in this substep
    double ofMotor = 0.0;   ///< N s or N m s: the motor's part of it
    double softness = 0.0;  ///< compliance of the row
};

/// A joint between a tree body and its parent or a static or kinematic body. Signs: a gap grows with the
/// velocity of the tree body, and impulses act on the tree body.
struct Link {
    std::uint32_t joint = 0;  ///< kNone at the root of a floating tree
    JointKind kind = JointKind::Revolute;
    bool treeBodyIsB = true;
    std::uint32_t treeBody = 0;    ///< index in JointTrees::treeBodies
    std::uint32_t parent = kNone;  ///< index in JointTrees::treeBodies; kNone for a static or kinematic body
    std::uint32_t ground = 0;      ///< the static or kinematic body, if parent is kNone
    // At the start of the step.
    Vec2 treeBodyArm;  ///< m, in the world, from the center of mass to the anchor
    Vec2 parentArm;
    Vec2 apart;          ///< m: from the parent's anchor to the tree body's anchor
    Vec2 axis;           ///< sliding axis
    float angle = 0.0f;  ///< rad, relative to the joint's reference angle
    float rest = 0.0f;   ///< m: length of rods
    // At the current poses.
    Double2 limb;  ///< m: arms of point constraints
    Double2 parentLimb;
    Symmetric stiffness;  ///< effective mass: impulse per change of velocity
    Triple across[3];     ///< indexed by row: change of the tree body's velocity by a unit impulse
    Triple softness;      ///< indexed by row: compliance
    Triple gap;           ///< m or rad
    Triple error;         ///< m/s: relative velocity to remove
    Triple answer;        ///< N s: impulse if the parent could not move
    Triple given;         ///< N s: total impulse in this substep
    Triple force;         ///< N, N, N m: force in the last substep
    Triple groundVelocity;
    Drive drive;
    Triple onTreeBody[3];  ///< indexed by row: Jacobian of the tree body; below, that of its parent
    Triple onParent[3];

    /// True for a hinge, which is computed from its arms instead of rows.
    [[nodiscard]] bool byArms() const { return kind == JointKind::Revolute; }
    /// True if the drive gives the value a velocity.
    [[nodiscard]] bool turns() const { return drive.on && !drive.exerts; }
    [[nodiscard]] bool hasTwoRows() const { return byArms() && !turns(); }
};

/// A tree of joints; its bodies are ordered from the leaves to the root.
struct JointTree {
    std::uint32_t begin = 0;  ///< range in JointTrees::treeBodies and links
    std::uint32_t end = 0;
    std::uint32_t holdBegin = 0;  ///< range in JointTrees::holds
    std::uint32_t holdEnd = 0;
    bool direct = true;      ///< solved directly in this step; false while its bodies have contacts
    bool rooted = false;     ///< the last body has a link, to a static or kinematic body
    std::uint8_t group = 0;  ///< index in Workspace::groups
    bool powered = false;    ///< a change of a joint or a moving kinematic body may do work
    bool drives = false;     ///< a joint has a motor or limits
    bool stretched = false;  ///< the SIMD solver left gaps, which close slowly
    double part = 1.0;       ///< part of its gaps that it closes in this substep
    double lift = 0.0;       ///< J: work of closing such gaps in this step, against external accelerations
    double gain = 0.0;       ///< J: energy added by its joints in this substep
};

/// A body found while a tree is built, from the root outwards; or the body at the other end of a hold.
struct ReachedBody {
    std::uint32_t body = 0;
    std::uint32_t parent = kNone;  ///< index among the bodies found, or kNone
    std::uint32_t joint = 0;       ///< joint to the parent or ground; kNone at the root of a floating tree
};

/// All trees of joints. Link i connects tree body i to its parent.
struct JointTrees {
    std::vector<JointTree> trees;
    std::vector<TreeBody> treeBodies;
    std::vector<Link> links;
    std::vector<Link> holds;
    std::vector<std::uint8_t> isDirect;    ///< indexed by joint: 1 if a tree solves it in this step
    std::vector<std::uint32_t> freeMasks;  ///< [body]: colors of its constraints if all are in its tree
    bool some = false;                     ///< true if a tree is solved directly in this step
    bool stale = true;    ///< to be rebuilt: joints were created or destroyed, woke or fell asleep
    bool wanted = false;  ///< Settings::directJoints when the trees were built
    std::vector<std::uint32_t> candidates;  ///< scratch, as are the following
    std::vector<std::uint8_t> reached;      ///< indexed by body: 1 if visited
    std::vector<ReachedBody> reachedBodies;
    std::vector<ReachedBody> heldJoints;

    [[nodiscard]] std::span<TreeBody> bodiesOf(const JointTree& tree) {
        return std::span{treeBodies}.subspan(tree.begin, tree.end - tree.begin);
    }
    [[nodiscard]] std::span<Link> holdsOf(const JointTree& tree) {
        return std::span{holds}.subspan(tree.holdBegin, tree.holdEnd - tree.holdBegin);
    }
};

/// Returns the number of constraint rows of a joint: distance 1, weld 3 (point and angle), others 2.
constexpr int rowsOf(JointKind kind) {
    return kind == JointKind::Distance ? 1 : kind == JointKind::Weld ? 3 : 2;
}

/// True if a tree body has a link, i.e. is not the root of a floating tree.
inline bool hasLink(const JointTree& tree, std::uint32_t treeBody) {
    return tree.rooted || treeBody + 1 < tree.end;
}

/// Calls act(link) for all links and holds of a tree.
template <class Act>
void forLinks(JointTrees& trees, const JointTree& tree, Act&& act) {
    for (std::uint32_t i = tree.begin; i < tree.end; ++i) {
        if (hasLink(tree, i)) act(trees.links[i]);
    }
    for (Link& hold : trees.holdsOf(tree)) act(hold);
}

/// Returns a pose, rotated further by an angle (rad).
PoseChange turnedBy(const PoseChange& pose, double angle);

/// Computes the arms or rows of a link at two poses.
/// @return the gaps of its rows, m or rad
Triple setRows(Link& link, const PoseChange& treeBody, const PoseChange& parent);
Triple gapsOf(const Link& link, const PoseChange& treeBody, const PoseChange& parent);
/// Returns the angle (rad) of a hinge or the displacement (m) of a slider.
double valueOf(const Link& link, const PoseChange& treeBody, const PoseChange& parent);

}  // namespace plumb::physics
