#include <bit>

#include "physics/edits.hpp"
#include "physics/measure/measures.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

void note(const World& world, Workspace& work, std::uint32_t body, std::uint8_t colour) {
    if (colour < kColours && isDynamic(world, body)) work.colourMasks[body] |= 1u << colour;
}
void note(const World& world, Workspace& work, const Contact& contact) {
    // Reads kFixedA, not the body's kind, which setKind() may have changed after the color was assigned.
    if ((contact.flags & kFixedA) == 0) note(world, work, contact.bodyA, contact.colour);
    note(world, work, contact.bodyB, contact.colour);
}

}  // namespace

std::uint8_t takeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB) {
    constexpr std::uint32_t kFixedColours = ~0u << kFirstFixedColour;
    std::vector<std::uint32_t>& masks = work.colourMasks;
    const std::uint32_t taken = (bodyA != kNone ? masks[bodyA] : 0u) | masks[bodyB];
    const std::uint32_t allowed = bodyA == kNone ? kFixedColours : ~kFixedColours;
    const std::uint32_t open = allowed & ~taken;
    if (open == 0) return kOverflow;
    const std::uint32_t bit = open & (~open + 1u);
    if (bodyA != kNone) masks[bodyA] |= bit;
    masks[bodyB] |= bit;
    return static_cast<std::uint8_t>(std::countr_zero(bit));
}

void freeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB, std::uint8_t colour) {
    if (colour >= kColours) return;
    const std::uint32_t keep = ~(1u << colour);
    if (bodyA != kNone) work.colourMasks[bodyA] &= keep;
    work.colourMasks[bodyB] &= keep;
}

void refreshColours(World& world, Workspace& work) {
    work.colourMasks.resize(world.bodies.size());
    if (!world.work.stale()) return;
    work.colourMasks.assign(world.bodies.size(), 0);
    forContacts(world, [&](const Contact& contact) { note(world, work, contact); });
    for (const Joint& joint : world.joints.hot) {
        if (joint.bodyA == kNone) continue;
        if (joint.kind != JointKind::Mouse) note(world, work, joint.bodyA, joint.colour);
        note(world, work, joint.bodyB, joint.colour);
    }
}

void colourJoints(StepContext& step) {
    World& world = step.world;
    refreshColours(world, step.work);
    if (std::exchange(world.newJoints, false)) {
        for (const std::uint32_t index : world.joints.awake) {
            Joint& joint = world.joints.hot[index];
            if (joint.colour != kNoColour) continue;
            const auto [a, b] = pushedBodies(world, joint);
            joint.colour = takeColour(step.work, a, b);
            if (openingOf(world, index) > world.settings.slop) joint.flags |= kEdited;
        }
    }
    growTrees(world, step.work);
}

}  // namespace plumb::physics
