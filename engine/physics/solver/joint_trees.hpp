#pragma once

#include <cstdint>
#include <vector>

#include "math/vec2.hpp"
#include "physics/solver/symmetric.hpp"

namespace plumb::physics {

// Joints that are solved all at once, tree by tree: see solve_trees.hpp.

/// What a joint of a tree holds, as rows: a point (2), a point and an angle (3), a length (1), a way and an
/// angle (2).
enum class LinkKind : std::uint8_t { Point, Weld, Rod, Slider };

/// How far a body has moved since the start of the step: m, m, sine and (cosine - 1) of its turn.
struct TreePose {
    double x = 0.0;
    double y = 0.0;
    double sine = 0.0;
    double versine = 0.0;
};

/// A body of a tree.
struct Limb {
    std::uint32_t body = 0;
    std::int32_t slot = 0;
    std::uint32_t colours = 0;  ///< of all its joints
    bool hasOthers = false;     ///< joints that are not of the tree
    double mass = 0.0;          ///< kg
    double inertia = 0.0;       ///< kg m2
    bool turns = true;          ///< a push can turn it
    double straining = 0.0;     ///< N m: torque by which its joints turn it back, for each radian
    TreePose pose;
    Triple velocity;
    Symmetric own;   ///< its mass, and what hangs on it as one feels it here; then the inverse of that
    Triple impulse;  ///< on it, of what hangs on it; then by how much its velocity changes
};

/// A joint of a tree, between a limb and its parent, or what cannot be pushed. All of it is as seen from the
/// parent: a gap grows with the velocity of the limb, and an impulse is what the limb gets.
struct Link {
    std::uint32_t joint = 0;  ///< kNone at the root of a tree that flies
    LinkKind kind = LinkKind::Point;
    bool limbIsB = true;
    bool shared = false;       ///< the lanes solve something else of it: a limit, a motor, a spring
    bool byArms = false;       ///< a point that needs no rows: they are in its arms
    std::int32_t limb = 0;     ///< in JointTrees::limbs
    std::int32_t parent = -1;  ///< in JointTrees::limbs; -1 for what cannot be pushed
    std::uint32_t ground = 0;  ///< that body then
    // At the start of the step.
    Vec2 limbArm;  ///< m, world, from the centre of mass
    Vec2 parentArm;
    Vec2 apart;          ///< m: from the parent's anchor to the limb's
    Vec2 axis;           ///< of sliders
    float angle = 0.0f;  ///< rad, less where it is held
    float rest = 0.0f;   ///< m: of rods
    float reach = 0.0f;  ///< m: how large a gap is closed within a substep
    // Of the poses of now.
    double limbX = 0.0;  ///< m: arms of points
    double limbY = 0.0;
    double parentX = 0.0;
    double parentY = 0.0;
    Symmetric stiffness;  ///< the impulse that takes away a speed
    Triple across[3];     ///< by row: what an impulse does to the limb
    Triple softness;
    Triple gap;     ///< m or rad
    Triple error;   ///< m/s: that it has to answer
    Triple answer;  ///< N s: if the parent kept still
    Triple given;   ///< N s in this substep
    Triple force;   ///< N, N, N m in the last substep
    Triple groundVelocity;
    Triple onLimb[3];  ///< by row: how it grows with the velocity of the limb, and of its parent
    Triple onParent[3];
};

/// A tree: its limbs, those furthest from the root first.
struct JointTree {
    std::int32_t begin = 0;  ///< of limbs, and of their links
    std::int32_t end = 0;
    std::int32_t holdBegin = 0;  ///< links to what cannot be pushed besides that of the root
    std::int32_t holdEnd = 0;
    bool direct = true;   ///< in this step: left to the lanes while its limbs touch something
    bool rooted = false;  ///< the last limb has a link too: to what cannot be pushed
    std::uint8_t group = 0;
    double gain = 0.0;  ///< J: of energy in this substep, from its joints
};

/// How much of a joint is solved in a tree.
enum DirectPart : std::uint8_t { kNotDirect, kPartlyDirect, kWhollyDirect };

/// A body as it was reached when trees grew, from the root outwards.
struct ReachedBody {
    std::uint32_t body = 0;
    std::int32_t parent = -1;  ///< place among those reached, or -1
    std::uint32_t joint = 0;   ///< to the parent or to what cannot be pushed; kNone where a tree flies
    LinkKind kind = LinkKind::Point;
};

/// A joint besides to what cannot be pushed.
struct HeldJoint {
    std::int32_t limb = 0;  ///< place among those reached
    std::uint32_t joint = 0;
    LinkKind kind = LinkKind::Point;
};

/// All trees. Limb i hangs on link i.
struct JointTrees {
    std::vector<JointTree> trees;
    std::vector<Limb> limbs;
    std::vector<Link> links;
    std::vector<Link> holds;
    std::vector<std::uint8_t> isDirect;    ///< by joint: DirectPart
    std::vector<std::uint32_t> freeMasks;  ///< by body: colours of what acts on it, where all is solved here
    bool some = false;                     ///< a tree is solved directly in this step
    bool stale = true;                     ///< joints came, went, woke or fell asleep
    bool wanted = false;                   ///< Settings::directJoints, when they grew
    std::vector<std::uint32_t> candidates;
    std::vector<std::uint8_t> reached;  ///< by body
    std::vector<ReachedBody> reachedBodies;
    std::vector<HeldJoint> heldJoints;
};

}  // namespace plumb::physics
