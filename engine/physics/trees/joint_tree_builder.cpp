#include <algorithm>

#include "physics/edits.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

/// True if a joint can be solved directly: no spring, softness, limited length or locked axis of its bodies.
bool canBeInTree(const World& world, const Joint& joint) {
    if (joint.awakeIndex == kNone || (joint.flags & (kSoft | kSprung)) != 0) return false;
    if (joint.kind == JointKind::Distance && (joint.flags & (kLimited | kDriven)) != 0) return false;
    for (const std::uint32_t body : {joint.bodyA, joint.bodyB}) {
        if (isDynamic(world, body) && (world.bodies.info[body].flags & (kLockX | kLockY)) != 0) return false;
    }
    return joint.kind == JointKind::Revolute || joint.kind == JointKind::Weld ||
           joint.kind == JointKind::Distance || joint.kind == JointKind::Prismatic;
}

class Grower {
public:
    Grower(const World& world, JointTrees& trees)
        : world_{world}, trees_{trees}, reached_{trees.reachedBodies}, held_{trees.heldJoints} {}

    void run() {
        std::vector<std::uint32_t>& joints = trees_.candidates;
        joints = world_.joints.awake;
        std::sort(joints.begin(), joints.end());
        trees_.reached.assign(world_.bodies.size(), 0);
        // First trees that hang on a static or kinematic body, then floating trees with any body as root.
        for (const bool hanging : {true, false}) {
            for (const std::uint32_t index : joints) {
                const Joint& joint = world_.joints.hot[index];
                if (!canBeInTree(world_, joint)) continue;
                const bool a = isDynamic(world_, joint.bodyA), b = isDynamic(world_, joint.bodyB);
                if (hanging == (a && b)) continue;
                const std::uint32_t root = a ? joint.bodyA : joint.bodyB;
                if (trees_.reached[root] == 0) grow({root, kNone, hanging ? index : kNone});
            }
        }
    }

private:
    void grow(const ReachedBody& root) {
        reached_.assign(1, root);
        held_.clear();
        trees_.reached[root.body] = 1;
        bool isTree = true;
        for (std::uint32_t i = 0; i < reached_.size(); ++i) isTree &= reachFrom(i);
        if (isTree && canBeHeld()) keep();
    }

    /// Adds the bodies that joints connect to an already reached body.
    /// @return false if a joint closes a loop, or cannot be solved in a tree: a spring in SIMD lanes would
    ///         use the inertia of its two bodies only, not of the rigid tree, and arms would shake
    bool reachFrom(std::uint32_t place) {
        const ReachedBody from = reached_[place];
        bool isTree = true;
        forJointsOf(world_, from.body, [&](std::uint32_t index) {
            const Joint& joint = world_.joints.hot[index];
            const std::uint32_t other = joint.bodyA == from.body ? joint.bodyB : joint.bodyA;
            if (index == from.joint || joint.awakeIndex == kNone)
                return;  // a filter, or a joint of a disabled body
            const bool can = canBeInTree(world_, joint);
            if (can && !isDynamic(world_, other)) {
                held_.push_back({other, place, index});
            } else if (!can || trees_.reached[other] != 0) {
                isTree = false;
            } else {
                trees_.reached[other] = 1;
                reached_.push_back({other, place, index});
            }
        });
        return isTree;
    }

    /// True if the tree has degrees of freedom left with all joints to static and kinematic bodies: a
    /// redundant constraint makes the system singular. The root already has one of these joints.
    [[nodiscard]] bool canBeHeld() const {
        int freedom = 0;
        const auto rows = [&](std::uint32_t joint) { return rowsOf(world_.joints.hot[joint].kind); };
        for (const ReachedBody& body : reached_) freedom += body.joint == kNone ? 3 : 3 - rows(body.joint);
        for (const ReachedBody& held : held_) {
            if (held.parent == 0) return false;
            freedom -= rows(held.joint);
        }
        return held_.empty() || freedom > 0;
    }

    Link linkOf(std::uint32_t index, std::uint32_t body) {
        const Joint& joint = world_.joints.hot[index];
        const bool isB = joint.bodyB == body;
        trees_.isDirect[index] = 1;
        return {.joint = index,
                .kind = joint.kind,
                .treeBodyIsB = isB,
                .ground = isB ? joint.bodyA : joint.bodyB};
    }

    void keep() {
        JointTree tree;
        tree.begin = static_cast<std::uint32_t>(trees_.treeBodies.size());
        tree.end = tree.begin + static_cast<std::uint32_t>(reached_.size());
        tree.rooted = reached_[0].joint != kNone;
        for (auto it = reached_.rbegin(); it != reached_.rend(); ++it) {
            trees_.treeBodies.push_back({.body = it->body});
            Link& link = trees_.links.emplace_back();
            link.joint = kNone;
            if (it->joint == kNone) continue;
            link = linkOf(it->joint, it->body);
            link.treeBody = static_cast<std::uint32_t>(trees_.treeBodies.size()) - 1;
            link.parent = it->parent == kNone ? kNone : tree.end - 1 - it->parent;
        }
        tree.holdBegin = static_cast<std::uint32_t>(trees_.holds.size());
        for (const ReachedBody& held : held_) {
            trees_.holds.push_back(linkOf(held.joint, reached_[held.parent].body));
            trees_.holds.back().treeBody = tree.end - 1 - held.parent;
        }
        tree.holdEnd = static_cast<std::uint32_t>(trees_.holds.size());
        trees_.trees.push_back(tree);
    }

    const World& world_;
    JointTrees& trees_;
    std::vector<ReachedBody>& reached_;
    std::vector<ReachedBody>& held_;
};

/// Hands a tree over to the SIMD solver. Resets warm starting of a tree held at several ends if it was solved
/// directly before (no flags of holds), because its forces when taut are too large for soft constraints.
void leave(World& world, JointTrees& trees, const JointTree& tree) {
    const auto holds = trees.holdsOf(tree);
    const bool resets = !holds.empty() && (world.joints.hot[holds.front().joint].flags & kStretched) == 0;
    forLinks(trees, tree, [&](const Link& link) {
        Joint& joint = world.joints.hot[link.joint];
        if (resets) joint.force = {};
        joint.flags |= kStretched;
    });
}

/// Decides which trees are solved directly in this step. A tree with contacts is solved by the SIMD solver,
/// sequentially with its contacts (Gauss-Seidel): contacts of a directly solved, rigid tree converge too
/// slowly, and heaps of chains tremble (measured).
void choose(World& world, Workspace& work) {
    JointTrees& trees = work.joints.trees;
    trees.some = false;
    trees.freeMasks.resize(trees.trees.empty() ? 0 : world.bodies.size());
    for (JointTree& tree : trees.trees) {
        const auto treeBodies = trees.bodiesOf(tree);
        const bool touching = std::any_of(
            treeBodies.begin(), treeBodies.end(),
            [&](const TreeBody& treeBody) { return treeBody.colours != work.colourMasks[treeBody.body]; });
        if (touching) leave(world, trees, tree);
        tree.direct = !touching;
        trees.some = trees.some || tree.direct;
        for (const TreeBody& treeBody : treeBodies)
            trees.freeMasks[treeBody.body] = tree.direct ? treeBody.colours : 0;
        forLinks(trees, tree, [&](const Link& link) { trees.isDirect[link.joint] = tree.direct ? 1 : 0; });
    }
}

}  // namespace

void growTrees(World& world, Workspace& work) {
    JointTrees& trees = work.joints.trees;
    const bool wanted = world.settings.directJoints;
    if (!trees.stale && !world.work.stale() && trees.wanted == wanted) return choose(world, work);
    trees.stale = false;
    trees.wanted = wanted;
    trees.trees.clear();
    trees.treeBodies.clear();
    trees.links.clear();
    trees.holds.clear();
    trees.isDirect.assign(world.joints.size(), 0);
    if (wanted) Grower{world, trees}.run();
    for (const std::uint32_t joint : world.joints.awake) {
        if (trees.isDirect[joint] == 0) world.joints.hot[joint].flags |= kStretched;
    }
    // Stores the colors of each body's joints: any other color of the body belongs to a contact.
    for (TreeBody& treeBody : trees.treeBodies) {
        forJointsOf(world, treeBody.body, [&](std::uint32_t j) {
            const std::uint8_t colour = world.joints.hot[j].colour;
            if (colour < kColours) treeBody.colours |= 1u << colour;
        });
    }
    trees.freeMasks.assign(trees.trees.empty() ? 0 : world.bodies.size(), 0);
    choose(world, work);
}

}  // namespace plumb::physics
