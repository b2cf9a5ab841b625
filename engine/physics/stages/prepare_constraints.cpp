#include <algorithm>
#include <utility>

#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

constexpr int kGrain = 32;  // blocks

/// Keys of contacts without kKeyBegan: those of a group that are alike are solved together.
constexpr std::size_t kKinds = kKeyColour + kKeyFixed + 1;
constexpr std::size_t kOfKind = kKinds - 1;

/// Room for so many contacts of a colour at the end of `lanes`.
/// @param number  how many; then the first's place among all lanes
void makeRoom(std::vector<BlockLanes>& lanes, std::int32_t& number, int colour) {
    const std::int32_t contacts = std::exchange(number, static_cast<std::int32_t>(lanes.size()) * kLanes);
    const int maximum = colour == kOverflow ? 1 : kLanes;
    for (std::int32_t left = contacts; left > 0; left -= maximum)
        lanes.emplace_back().count = std::min(left, maximum);
}

void layOut(Workspace& work, std::vector<std::int32_t>& cursors) {
    work.contactLanes.clear();
    work.fixedLanes.clear();
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        work.groups[g].contactColours = 0;
        for (int colour = 0; colour <= kColours; ++colour) {
            const auto blocksNow = [&] { return static_cast<std::int32_t>(work.contactLanes.size()); };
            const auto fixedNow = [&] { return static_cast<std::int32_t>(work.fixedLanes.size()); };
            std::int32_t& contacts = cursors[g * kKinds + static_cast<std::size_t>(colour)];
            std::int32_t& fixed = cursors[g * kKinds + static_cast<std::size_t>(colour | kKeyFixed)];
            if (contacts + fixed > 0) work.groups[g].contactColours |= std::uint64_t{1} << colour;
            ColourBlocks& blocks = work.groups[g].colours[colour];
            blocks.contactBegin = blocksNow();
            blocks.fixedBegin = fixedNow();
            makeRoom(work.contactLanes, contacts, colour);
            makeRoom(work.fixedLanes, fixed, colour);
            blocks.contactEnd = blocksNow();
            blocks.fixedEnd = fixedNow();
        }
    }
}

template <class GroupOf, class Act>
void forPushing(const Workspace& work, GroupOf&& groupOf, Act&& act) {
    const auto count = static_cast<std::int32_t>(work.contactKeys.size());
    const std::uint16_t* keys = work.contactKeys.data();
    for (std::int32_t i = 0; i < count; ++i) {
        if ((keys[i] & kKeyColour) != kKeyIdle) act(groupOf(i) * kKinds + (keys[i] & kOfKind), i);
    }
}

/// Which contacts are solved together.
/// @param groupOf  the group that a contact is solved in
template <class GroupOf>
void fillLanes(Workspace& work, GroupOf&& groupOf) {
    std::vector<std::int32_t>& cursors = work.cursors;
    cursors.assign(work.groups.size() * kKinds, 0);
    forPushing(work, groupOf, [&](std::size_t kind, std::int32_t) { ++cursors[kind]; });
    layOut(work, cursors);
    BlockLanes* lanes[] = {work.contactLanes.data(), work.fixedLanes.data()};
    forPushing(work, groupOf, [&](std::size_t kind, std::int32_t contact) {
        const auto place = static_cast<std::uint32_t>(cursors[kind]);
        cursors[kind] += (kind & kKeyColour) == kOverflow ? kLanes : 1;
        lanes[(kind & kKeyFixed) != 0 ? 1 : 0][place / kLanes].contact[place % kLanes] = contact;
    });
}

bool areAlike(const SolveGroup& a, const SolveGroup& b) { return a.begin == b.begin && a.end == b.end; }

/// What rests is solved in the same blocks step after step.
/// @return true if the blocks of the last step are those of this one
bool takeLayout(Workspace& work) {
    const ContactLayout& layout = work.layout;
    if (!layout.isCurrent || layout.keys != work.contactKeys || layout.order != work.solveOrder ||
        !std::equal(work.groups.begin(), work.groups.end(), layout.groups.begin(), layout.groups.end(),
                    areAlike))
        return false;
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        work.groups[g].contactColours = layout.groups[g].contactColours;
        std::copy(std::begin(layout.groups[g].colours), std::end(layout.groups[g].colours),
                  work.groups[g].colours);
    }
    return true;
}

void keepLayout(Workspace& work) {
    work.layout.keys = work.contactKeys;
    work.layout.order = work.solveOrder;
    work.layout.groups = work.groups;
    work.layout.isCurrent = true;
}

void fillLanes(const StepContext& step) {
    const World& world = step.world;
    Workspace& work = step.work;
    if (!step.runs(Effect::Contacts)) {
        for (std::uint16_t& key : work.contactKeys) key |= kKeyIdle;
    }
    if (takeLayout(work)) return;
    if (work.groups.size() == 1) {
        fillLanes(work, [](std::int32_t) { return std::size_t{0}; });
    } else {
        fillLanes(work, [&](std::int32_t contact) {
            return std::size_t{work.groupOf[world.contacts[static_cast<std::size_t>(contact)].bodyB]};
        });
    }
    keepLayout(work);
}

ContactSource sourceOf(const StepContext& step) {
    const World& world = step.world;
    const Workspace& work = step.work;
    ContactSource source;
    source.contacts = reinterpret_cast<const Float4*>(world.contacts.data());
    source.masses = reinterpret_cast<const Float4*>(world.bodies.mass.data());
    source.motions = reinterpret_cast<const Float4*>(world.bodies.motion.data());
    source.slots = work.slots.data();
    source.idleSlot = static_cast<std::int32_t>(work.bodyOf.size());
    source.turning = step.starts(Effect::Rotation);
    source.surfaces = step.starts(Effect::Conveyor);
    source.kinematics = step.starts(Effect::Kinematics);
    return source;
}

template <class Block, class Bodies>
void prepareBlocks(const StepContext& step, const ContactSource& source,
                   const ContactKernels<Block, Bodies>& kernels, const std::vector<BlockLanes>& lanes,
                   std::vector<Block>& blocks, int begin, int end) {
    blocks.resize(begin < end ? static_cast<std::size_t>(end) : 0);
    forRange(step, begin, end, kGrain,
             [&](int first, int last) { kernels.prepare(source, lanes.data(), blocks.data(), first, last); });
}

}  // namespace

void prepareConstraints(StepContext& step) {
    Workspace& work = step.work;
    fillLanes(step);
    const ContactSource source = sourceOf(step);
    const SolverKernels& kernels = solverKernels();
    const std::size_t hasFriction = step.starts(Effect::Friction) ? 1 : 0;
    const auto all = static_cast<int>(work.contactLanes.size()),
               allFixed = static_cast<int>(work.fixedLanes.size());
    const auto [rotating, rotatingFixed] = blocksWithRotation(work);
    prepareBlocks(step, source, kernels.contacts[hasFriction], work.contactLanes, work.contactBlocks, 0,
                  rotating);
    prepareBlocks(step, source, kernels.fixedContacts[hasFriction], work.fixedLanes, work.fixedBlocks, 0,
                  rotatingFixed);
    prepareBlocks(step, source, kernels.plain[hasFriction], work.contactLanes, work.blocksWithoutRotation,
                  rotating, all);
    prepareBlocks(step, source, kernels.plainFixed[hasFriction], work.fixedLanes,
                  work.fixedBlocksWithoutRotation, rotatingFixed, allFixed);
    if (step.runs(Effect::Joints)) prepareJoints(step);
    static_cast<void>(step.starts(Effect::Motors));  // joints with a motor have blocks of their own
}

}  // namespace plumb::physics
