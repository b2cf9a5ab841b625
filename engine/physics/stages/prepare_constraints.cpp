#include <algorithm>

#include "physics/solver/joint_lanes.hpp"

namespace plumb::physics {

namespace {

constexpr int kGrain = 32;  // blocks

/// The group that a contact is solved in.
std::size_t groupOf(const World& world, const Workspace& work, std::size_t contact) {
    return work.groups.size() == 1 ? 0 : work.groupOf[world.contacts[contact].bodyB];
}

std::int32_t blocksFor(std::int32_t contacts, int colour) {
    return colour == kOverflow ? contacts : (contacts + kLanes - 1) / kLanes;
}

void layOut(Workspace& work, const std::vector<Cursor>& counts) {
    std::int32_t contacts = 0, fixed = 0;
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        work.groups[g].contactColours = 0;
        for (int colour = 0; colour <= kColours; ++colour) {
            const Cursor& count = counts[g * (kColours + 1) + static_cast<std::size_t>(colour)];
            ColourBlocks& blocks = work.groups[g].colours[colour];
            blocks.contactBegin = contacts;
            blocks.contactEnd = contacts += blocksFor(count.contacts, colour);
            blocks.fixedBegin = fixed;
            blocks.fixedEnd = fixed += blocksFor(count.fixed, colour);
            if (count.contacts + count.fixed > 0) work.groups[g].contactColours |= std::uint64_t{1} << colour;
        }
    }
    work.contactBlocks.resize(static_cast<std::size_t>(contacts));
    work.contactLanes.resize(static_cast<std::size_t>(contacts));
    work.fixedBlocks.resize(static_cast<std::size_t>(fixed));
    work.fixedLanes.resize(static_cast<std::size_t>(fixed));
}

void putIn(std::vector<BlockLanes>& lanes, std::int32_t begin, std::int32_t& number, int colour,
           int contact) {
    const std::int32_t lane = colour == kOverflow ? 0 : number % kLanes;
    const std::int32_t block = begin + (colour == kOverflow ? number : number / kLanes);
    ++number;
    BlockLanes& target = lanes[static_cast<std::size_t>(block)];
    target.contact[lane] = contact;
    target.count = lane + 1;
}

template <class Act>
void forPushing(const World& world, const Workspace& work, Act&& act) {
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        const int key = work.contactKeys[i], colour = key & kKeyColour;
        if (colour == kKeyIdle) continue;
        act(groupOf(world, work, i), colour, (key & kKeyFixed) != 0, static_cast<std::int32_t>(i));
    }
}

/// Which contacts are solved together.
void fillLanes(World& world, Workspace& work) {
    std::vector<Cursor>& cursors = work.cursors;
    cursors.assign(work.groups.size() * (kColours + 1), {});
    const auto cursorOf = [&](std::size_t group, int colour) -> Cursor& {
        return cursors[group * (kColours + 1) + static_cast<std::size_t>(colour)];
    };
    forPushing(world, work, [&](std::size_t group, int colour, bool fixed, std::int32_t) {
        Cursor& cursor = cursorOf(group, colour);
        ++(fixed ? cursor.fixed : cursor.contacts);
    });
    layOut(work, cursors);
    std::fill(cursors.begin(), cursors.end(), Cursor{});
    forPushing(world, work, [&](std::size_t group, int colour, bool fixed, std::int32_t contact) {
        const ColourBlocks& blocks = work.groups[group].colours[colour];
        Cursor& cursor = cursorOf(group, colour);
        if (fixed) {
            putIn(work.fixedLanes, blocks.fixedBegin, cursor.fixed, colour, contact);
        } else {
            putIn(work.contactLanes, blocks.contactBegin, cursor.contacts, colour, contact);
        }
    });
}

ContactSource sourceOf(const World& world, const Workspace& work) {
    ContactSource source;
    source.contacts = reinterpret_cast<const Float4*>(world.contacts.data());
    source.masses = reinterpret_cast<const Float4*>(world.bodies.mass.data());
    source.motions = reinterpret_cast<const Float4*>(world.bodies.motion.data());
    source.slots = work.slots.data();
    source.idleSlot = static_cast<std::int32_t>(work.bodyOf.size());
    source.surfaces = world.manifest.runs(Effect::Conveyor);
    source.kinematics = world.manifest.runs(Effect::Kinematics);
    return source;
}

}  // namespace

void prepareConstraints(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    fillLanes(world, work);
    const ContactSource source = sourceOf(world, work);
    const SolverKernels& kernels = solverKernels();
    forPieces(step, static_cast<int>(work.contactBlocks.size()), kGrain, [&](int begin, int end, int) {
        kernels.prepare(source, work.contactLanes.data(), work.contactBlocks.data(), begin, end);
    });
    forPieces(step, static_cast<int>(work.fixedBlocks.size()), kGrain, [&](int begin, int end, int) {
        kernels.prepareFixed(source, work.fixedLanes.data(), work.fixedBlocks.data(), begin, end);
    });
    if (world.manifest.runs(Effect::Joints)) prepareJoints(step);
}

}  // namespace plumb::physics
