#include <algorithm>
#include <utility>

#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

constexpr int kCountGrain = 2048;  // contacts; large, because each piece has a counter for each kind

/// Contact keys without kKeyBegan: contacts of a group with equal keys are solved together.
constexpr std::size_t kSolveKinds = kKeyColour + kKeyFixed + 1;
constexpr std::size_t kOfKind = kSolveKinds - 1;  // mask of a key without kKeyBegan

/// For each piece of work and kind of contact: first the number of contacts, then the index of the next one.
struct Cursors {
    std::vector<std::int32_t>& all;
    std::size_t kinds;   // number of kinds, of all groups
    std::size_t strips;  // number of strips of each kind
    std::size_t pieces;

    [[nodiscard]] std::int32_t* of(std::size_t piece) const { return all.data() + piece * kinds * strips; }

    /// Converts the numbers of contacts of a kind to indices of lanes, from `begin` on.
    /// @param size  lanes per contact: 1, or kLanes if each contact is alone in a block
    /// @return the index of the lane after those of the last contact
    std::int32_t giveRoom(std::size_t kind, std::int32_t begin, std::int32_t size) const {
        std::int32_t* const own = of(0) + kind * strips;
        for (std::size_t strip = 0; strip < strips; ++strip) {
            for (std::size_t i = strip; i < pieces * kinds * strips; i += kinds * strips)
                begin += size * std::exchange(own[i], begin);
        }
        return begin;
    }
};

BlockRange makeRoom(std::vector<BlockLanes>& lanes, const Cursors& cursors, std::size_t kind, int colour) {
    const auto begin = static_cast<std::int32_t>(lanes.size());
    const bool alone = colour == kOverflow;
    const std::int32_t end = cursors.giveRoom(kind, begin * kLanes, alone ? kLanes : 1);
    for (std::int32_t place = begin * kLanes; place < end; place += kLanes)
        lanes.emplace_back().count = alone ? 1 : std::min(end - place, kLanes);
    return {begin, static_cast<std::int32_t>(lanes.size())};
}

void layOut(Workspace& work, const Cursors& cursors) {
    work.two.lanes.clear();
    work.fixed.lanes.clear();
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        work.groups[g].contactColours = 0;
        for (int colour = 0; colour <= kColours; ++colour) {
            const std::size_t kind = g * kSolveKinds + static_cast<std::size_t>(colour);
            const ContactRanges blocks{makeRoom(work.two.lanes, cursors, kind, colour),
                                       makeRoom(work.fixed.lanes, cursors, kind | kKeyFixed, colour)};
            work.groups[g].colours[colour].contacts = blocks;
            if (blocks.two.begin < blocks.two.end || blocks.fixed.begin < blocks.fixed.end)
                work.groups[g].contactColours |= std::uint64_t{1} << colour;
        }
    }
}

/// Assigns contacts to blocks.
void fillLanes(const StepContext& step) {
    const World& world = step.world;
    Workspace& work = step.work;
    if (work.strips.areUsed) work.strips.ofContact.resize(work.contactKeys.size());
    const std::uint16_t* keys = work.contactKeys.data();
    const auto count = static_cast<int>(work.contactKeys.size());
    const bool shared = step.isShared(count, kCountGrain);
    const std::uint8_t* strips = work.strips.areUsed ? work.strips.ofContact.data() : nullptr;
    const Cursors cursors{work.cursors, work.groups.size() * kSolveKinds, work.strips.count(),
                          static_cast<std::size_t>(shared ? piecesOf(count, kCountGrain) : 1)};
    const bool many = work.groups.size() > 1;
    work.cursors.assign(cursors.pieces * cursors.kinds * cursors.strips, 0);
    const auto forPushing = [&](auto&& act) {
        forPieces(step.pool, count, kCountGrain, [&](int begin, int end, int piece) {
            std::int32_t* own = cursors.of(static_cast<std::size_t>(piece));
            for (std::int32_t i = begin; i < end; ++i) {
                const int colour = keys[i] & kKeyColour;
                if (colour == kKeyIdle) continue;
                std::size_t kind = keys[i] & kOfKind;
                if (many)
                    kind += kSolveKinds * work.groupOf[world.contacts[static_cast<std::size_t>(i)].bodyB];
                // Contacts without a color are solved in the order of their indices, not by strip.
                if (strips != nullptr) kind = kind * Strips::kCount + (colour == kOverflow ? 0 : strips[i]);
                act(own[kind], keys[i], i);
            }
        });
    };
    forPushing([](std::int32_t& number, std::uint16_t, std::int32_t) { ++number; });
    layOut(work, cursors);
    BlockLanes* lanes[] = {work.two.lanes.data(), work.fixed.lanes.data()};
    forPushing([&](std::int32_t& next, std::uint16_t key, std::int32_t contact) {
        const auto place = static_cast<std::uint32_t>(next);
        next += (key & kKeyColour) == kOverflow ? kLanes : 1;
        lanes[(key & kKeyFixed) != 0 ? 1 : 0][place / kLanes].index[place % kLanes] = contact;
    });
}

bool areAlike(const SolveGroup& a, const SolveGroup& b) {
    return a.begin == b.begin && a.end == b.end && a.bodies == b.bodies;
}

/// Reuses the blocks of the last step if contacts and groups are equal, as in a resting scene.
/// @return true if the blocks of the last step are reused
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

ContactSource sourceOf(const StepContext& step) {
    return {.contacts = reinterpret_cast<const Float4*>(step.world.contacts.data()),
            .masses = reinterpret_cast<const Float4*>(step.world.bodies.mass.data()),
            .motions = reinterpret_cast<const Float4*>(step.world.bodies.motion.data()),
            .slots = step.work.slots.data(),
            .idleSlot = static_cast<std::int32_t>(step.work.bodyOf.size()),
            .turning = step.starts(Effect::Rotation),
            .surfaces = step.starts(Effect::Conveyor),
            .kinematics = step.starts(Effect::Kinematics)};
}

}  // namespace

void prepareConstraints(StepContext& step) {
    if (!step.runs(Effect::Contacts)) {
        for (std::uint16_t& key : step.work.contactKeys) key |= kKeyIdle;
    }
    if (!takeLayout(step.work)) {
        fillLanes(step);
        keepLayout(step.work);
    }
    const ContactSource source = sourceOf(step);
    const auto prepareContacts = [&](const auto& kernels) {
        const auto contacts = contactsOf(step, kernels);
        contacts.two.prepare(step, source);
        contacts.fixed.prepare(step, source);
    };
    prepareContacts(solverKernels().rotating);
    prepareContacts(solverKernels().withoutRotation);
    if (step.runs(Effect::Joints)) prepareJoints(step);
    // Counts the runs of effects that select kernels and blocks.
    for (const Effect effect : {Effect::Friction, Effect::Motors}) static_cast<void>(step.starts(effect));
}

}  // namespace plumb::physics
