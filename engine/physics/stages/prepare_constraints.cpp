#include <algorithm>
#include <utility>

#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

constexpr int kGrain = 32;          // blocks
constexpr int kLayoutGrain = 2048;  // contacts: each piece counts all kinds

/// Keys of contacts without kKeyBegan: those of a group that are alike are solved together.
constexpr std::size_t kKinds = kKeyColour + kKeyFixed + 1;
constexpr std::size_t kOfKind = kKinds - 1;

/// Where each piece of work puts its contacts of each kind: first how many, then the place of the next one.
struct Cursors {
    std::vector<std::int32_t>& all;
    std::size_t kinds;   // of all groups
    std::size_t strips;  // that each kind is divided into
    std::size_t pieces;

    [[nodiscard]] std::int32_t* of(std::size_t piece) const { return all.data() + piece * kinds * strips; }

    /// Turns the numbers of a kind into places.
    /// @param size  places that a contact takes
    /// @return how many contacts there are
    std::int32_t giveRoom(std::size_t kind, std::int32_t begin, std::int32_t size) const {
        std::int32_t next = begin;
        for (std::size_t strip = kind * strips; strip < (kind + 1) * strips; ++strip) {
            for (std::size_t piece = 0; piece < pieces; ++piece)
                next += size * std::exchange(of(piece)[strip], next);
        }
        return (next - begin) / size;
    }
};

void makeRoom(std::vector<BlockLanes>& lanes, const Cursors& cursors, std::size_t kind, int colour) {
    const auto begin = static_cast<std::int32_t>(lanes.size()) * kLanes;
    const int maximum = colour == kOverflow ? 1 : kLanes;
    const std::int32_t contacts = cursors.giveRoom(kind, begin, kLanes / maximum);
    for (std::int32_t left = contacts; left > 0; left -= maximum)
        lanes.emplace_back().count = std::min(left, maximum);
}

void layOut(Workspace& work, const Cursors& cursors) {
    work.contactLanes.clear();
    work.fixedLanes.clear();
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        work.groups[g].contactColours = 0;
        for (int colour = 0; colour <= kColours; ++colour) {
            const auto blocksNow = [&] { return static_cast<std::int32_t>(work.contactLanes.size()); };
            const auto fixedNow = [&] { return static_cast<std::int32_t>(work.fixedLanes.size()); };
            const std::size_t kind = g * kKinds + static_cast<std::size_t>(colour);
            ColourBlocks& blocks = work.groups[g].colours[colour];
            blocks.contactBegin = blocksNow();
            blocks.fixedBegin = fixedNow();
            makeRoom(work.contactLanes, cursors, kind, colour);
            makeRoom(work.fixedLanes, cursors, kind | kKeyFixed, colour);
            blocks.contactEnd = blocksNow();
            blocks.fixedEnd = fixedNow();
            if (blocks.contactBegin < blocks.contactEnd || blocks.fixedBegin < blocks.fixedEnd)
                work.groups[g].contactColours |= std::uint64_t{1} << colour;
        }
    }
}

/// Which contacts are solved together.
/// @param groupOf  the group that a contact is solved in
template <class GroupOf>
void fillLanes(const StepContext& step, GroupOf&& groupOf) {
    Workspace& work = step.work;
    if (work.strips.areUsed) work.strips.ofContact.resize(work.contactKeys.size());
    const std::uint16_t* keys = work.contactKeys.data();
    const auto count = static_cast<int>(work.contactKeys.size());
    const bool shared = step.isShared(count, kLayoutGrain);
    const std::uint8_t* strips = work.strips.areUsed ? work.strips.ofContact.data() : nullptr;
    const Cursors cursors{work.cursors, work.groups.size() * kKinds, work.strips.count(),
                          static_cast<std::size_t>(shared ? piecesOf(count, kLayoutGrain) : 1)};
    work.cursors.assign(cursors.pieces * cursors.kinds * cursors.strips, 0);
    const auto forPushing = [&](auto&& act) {
        forPieces(step, count, kLayoutGrain, [&](int begin, int end, int piece) {
            std::int32_t* own = cursors.of(static_cast<std::size_t>(piece));
            for (std::int32_t i = begin; i < end; ++i) {
                const int colour = keys[i] & kKeyColour;
                if (colour == kKeyIdle) continue;
                std::size_t kind = groupOf(i) * kKinds + (keys[i] & kOfKind);
                // Those without a color are solved in the order of their numbers.
                if (strips != nullptr) kind = kind * Strips::kCount + (colour == kOverflow ? 0 : strips[i]);
                act(own[kind], keys[i], i);
            }
        });
    };
    forPushing([](std::int32_t& number, std::uint16_t, std::int32_t) { ++number; });
    layOut(work, cursors);
    BlockLanes* lanes[] = {work.contactLanes.data(), work.fixedLanes.data()};
    forPushing([&](std::int32_t& next, std::uint16_t key, std::int32_t contact) {
        const auto place = static_cast<std::uint32_t>(next);
        next += (key & kKeyColour) == kOverflow ? kLanes : 1;
        lanes[(key & kKeyFixed) != 0 ? 1 : 0][place / kLanes].contact[place % kLanes] = contact;
    });
}

bool areAlike(const SolveGroup& a, const SolveGroup& b) {
    return a.begin == b.begin && a.end == b.end && a.bodies == b.bodies;
}

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
        fillLanes(step, [](std::int32_t) { return std::size_t{0}; });
    } else {
        fillLanes(step, [&](std::int32_t contact) {
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
    prepareBlocks(step, source, kernels.rotating.contacts[hasFriction], work.contactLanes, work.contactBlocks,
                  0, rotating);
    prepareBlocks(step, source, kernels.rotating.fixedContacts[hasFriction], work.fixedLanes,
                  work.fixedBlocks, 0, rotatingFixed);
    prepareBlocks(step, source, kernels.withoutRotation.contacts[hasFriction], work.contactLanes,
                  work.blocksWithoutRotation, rotating, all);
    prepareBlocks(step, source, kernels.withoutRotation.fixedContacts[hasFriction], work.fixedLanes,
                  work.fixedBlocksWithoutRotation, rotatingFixed, allFixed);
    if (step.runs(Effect::Joints)) prepareJoints(step);
    static_cast<void>(step.starts(Effect::Motors));  // joints with a motor have blocks of their own
}

}  // namespace plumb::physics
