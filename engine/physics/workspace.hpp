#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/detection_counts.hpp"
#include "physics/effects/flyers.hpp"
#include "physics/narrowphase/path_hit.hpp"
#include "physics/pair_set.hpp"
#include "physics/soft_meetings.hpp"
#include "physics/soft_obstacles.hpp"
#include "physics/solver/colours.hpp"
#include "physics/solver/contact_block.hpp"
#include "physics/solver/joint_work.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

struct JointRange {
    std::int32_t begin = 0;
    std::int32_t end = 0;
};

/// What one colour of a group has to solve, as ranges of blocks.
struct ColourBlocks {
    std::int32_t contactBegin = 0;
    std::int32_t contactEnd = 0;
    std::int32_t fixedBegin = 0;
    std::int32_t fixedEnd = 0;
    JointRange joints[kJointBlockKinds];
};

/// Islands that are solved alike: a range of slots, and their constraints by colour.
struct SolveGroup {
    Quality quality = 0;
    std::int32_t substeps = 1;
    std::int32_t iterations = 1;  ///< at least, of each substep
    std::int32_t bodies = 0;
    std::int32_t begin = 0;  ///< slots, in multiples of eight
    std::int32_t end = 0;
    std::uint64_t contactColours = 0;    ///< bits of colours that have contacts
    std::uint64_t jointColours = 0;      ///< bits of colours that have joints
    ColourBlocks colours[kColours + 1];  ///< the last is kOverflow: one lane a block, in order
};

/// Who shares a block, which follows from the keys of contacts alone where there is one group.
struct ContactLayout {
    std::vector<std::uint16_t> keys;  ///< that it was made for
    std::uint64_t colours = 0;        ///< as SolveGroup
    ColourBlocks blocks[kColours + 1];
    bool isCurrent = false;  ///< the lanes are still those of `keys`
};

/// What the later stages need to know of a contact to pass it by.
enum ContactKey : std::uint16_t {
    kKeyColour = 63,  ///< its colour, if it pushes
    kKeyIdle = 63,    ///< as a colour: it does not push
    kKeyFixed = 64,   ///< A cannot be pushed
    kKeyBegan = 128   ///< in this step
};

inline std::uint16_t keyOf(const Contact& contact) {
    const bool pushes =
        (contact.flags & (kTouching | kTriggered | kDisabled)) == kTouching && contact.colour <= kOverflow;
    const int idle = pushes ? 0 : kKeyIdle;  // all bits of a colour
    const int fixed = (contact.flags & kFixedA) != 0 ? kKeyFixed : 0;
    const int began = (contact.flags & kBegan) != 0 ? kKeyBegan : 0;
    return static_cast<std::uint16_t>((contact.colour & kKeyColour) | idle | fixed | began);
}

/// A slot whose body does not move along x or y.
struct AxisLock {
    std::uint32_t slot = 0;
    std::uint8_t flags = 0;  ///< kLockX, kLockY
};

/// How many contacts a surface and somebody who touches it have (surfaces.hpp).
struct SurfaceTouch {
    PairKey pair = 0;
    std::int32_t count = 0;
};

/// What happened to one of these contacts in this step.
struct SurfaceChange {
    PairKey pair = 0;
    std::uint32_t order = 0;
    ContactEvent event;
};

inline constexpr std::size_t kMaxStages = 24;

/// What makes an island hard to solve.
struct IslandHardness {
    float lightest = std::numeric_limits<float>::max();  ///< kg
    float heaviest = 0.0f;
    float lowest = std::numeric_limits<float>::max();  ///< m along gravity
    float highest = -std::numeric_limits<float>::max();
    float size = 0.0f;  ///< m: half widths of all its bodies
    float bodies = 0.0f;
    float joints = 0.0f;
};

/// An island while it is judged by its errors.
struct IslandCase {
    Effort effort;       ///< the highest of its bodies
    Quality least = 0;   ///< what its bodies and joints ask for
    bool isNew = false;  ///< some of its bodies were never judged
    float error = 0.0f;  ///< m: the largest overlap or opening
};

/// What an island has and got in this step: stages/keep_energy.cpp.
struct EnergyAccount {
    bool isOpen = false;
    bool isJointed = false;
    bool isLively = false;  ///< somebody turns or bounces
    bool isDriven = false;  ///< a motor or what its owner moves does work
    bool isRooted = false;  ///< tied to what cannot be pushed, or touches it
    float energy = 0.0f;    ///< J, of motion
    bool isWild = false;    ///< what came out makes no sense
    float work = 0.0f;      ///< J, that forces did
    float gain = 0.0f;      ///< J, that no force explains
    float credit = 0.0f;    ///< J, as EnergyShare
    float peak = 0.0f;      ///< J
    float mass = 0.0f;      ///< kg
    float excess = 0.0f;    ///< J, that it has to give up
    float own = 0.0f;       ///< J, about `middle`
    float least = 0.0f;     ///< J, of `own`: what it may keep in any case
    float way = 0.0f;       ///< kg m2: half of masses times their ways squared
    float keep = 1.0f;      ///< of all speeds about `middle`
    float part = 1.0f;      ///< of all ways, the same
    Vec2 momentum;          ///< kg m/s
    Vec2 middle;            ///< m/s
};

/// The paths of fast bodies as a broad phase sees them, by place in Workspace::swept.
struct SweptProxies {
    std::unique_ptr<BroadPhase> search;
    std::vector<AABB> bounds;
    std::vector<Filter> filters;
    std::vector<ProxyMotion> motions;

    [[nodiscard]] Proxies view() const { return {bounds, filters, motions}; }
};

/// Memory that a step needs and the next one reuses. Everything in it follows from the world.
struct Workspace {
    std::unique_ptr<BroadPhase> broadPhase;
    BroadPhaseKind broadPhaseKind = BroadPhaseKind::Count;
    std::vector<std::uint32_t> changedProxies;     ///< since the broad phase was last told
    std::vector<std::uint8_t> isChanged;           ///< by shape: is in `changedProxies`
    std::vector<std::uint8_t> isMoved;             ///< by shape
    PairSet pairs;                                 ///< of all contacts, awake or asleep
    std::vector<std::vector<PairKey>> foundPairs;  ///< by piece of work
    std::vector<PairKey> newPairs;
    std::vector<std::uint32_t> colourMasks;  ///< by body: which colours its constraints have

    std::vector<SurfaceTouch> surfaceTouches;  ///< by pair, rising

    // Of the step.
    std::vector<SurfaceChange> surfaceChanges;
    std::vector<SurfaceTouch> surfaceScratch;
    std::vector<std::uint16_t>
        contactKeys;  ///< by contact: bits of ContactKey, so that few have to be looked at
    std::vector<std::vector<std::uint32_t>> changedContacts;  ///< by piece: began, ended, or gone
    std::vector<DetectionCounts> countsOfPiece;
    std::vector<std::int32_t> slots;    ///< by body; -1 for what is not solved
    std::vector<std::uint32_t> bodyOf;  ///< by slot; kNone for idle ones
    std::vector<Float4> velocity;       ///< by slot, as SolverBodies
    std::vector<Float4> shift;
    std::vector<Float4> drive;
    std::vector<Float4> keep;
    std::vector<Float4> flight;
    std::vector<Float4> undisturbed;
    std::vector<Float4> plainStates;  ///< as PlainBodies, where nobody turns
    std::vector<SolveGroup> groups;
    std::vector<std::int32_t> cursors;  ///< by group and key, see prepareConstraints()
    ContactLayout layout;               ///< of contactLanes and fixedLanes, while contacts stay the same
    std::vector<ContactBlock> contactBlocks;
    std::vector<PlainBlock> plainBlocks;  ///< instead, where nobody turns
    std::vector<BlockLanes> contactLanes;
    std::vector<FixedContactBlock> fixedBlocks;
    std::vector<PlainFixedBlock> plainFixedBlocks;
    std::vector<BlockLanes> fixedLanes;
    std::vector<BounceBlock> bounces;     ///< beside contactBlocks, where something bounces
    std::vector<ImpactPlace> impacts;     ///< of a group, that may run on
    std::vector<std::uint8_t> hits;       ///< by slot: of so many impacts a body is part
    std::vector<HitBody> hitBodies;       ///< of `impacts`, before they run on
    std::vector<HitImpulse> hitImpulses;  ///< by place in `impacts`
    std::vector<BounceBlock> fixedBounces;
    std::vector<RollingBlock> rollings;  ///< beside contactBlocks, where something resists rolling
    std::vector<RollingBlock> fixedRollings;
    std::vector<AxisLock> locks;
    JointWork joints;
    SoftSurroundings softSurroundings;
    SoftMeetings softMeetings;
    SmoothForces smooth;                     ///< where there are fields
    std::vector<std::uint32_t> solveOrder;   ///< awake bodies by group; empty where there is one group
    std::vector<std::uint8_t> groupOf;       ///< by body, where there are several
    std::vector<std::uint32_t> bodyScratch;  ///< by body
    std::vector<std::vector<std::uint32_t>> leftShapes;  ///< by piece: shapes that left their bounds
    std::vector<std::vector<std::uint32_t>> fastOfPiece;
    std::vector<std::vector<std::uint32_t>> brokenOfPiece;
    std::vector<std::uint32_t> fastBodies;  ///< that may have passed through something in this step
    std::vector<SweptBody> swept;           ///< these, and what they hit
    SweptProxies sweptProxies;              ///< of `swept`, where they may meet each other
    std::vector<std::pair<float, std::uint32_t>> dueHits;   ///< a heap: parts of the step, places in `swept`
    std::vector<Contact> madeHits;                          ///< in the order of the hits
    std::vector<std::pair<PairKey, std::size_t>> hitOrder;  ///< places in `madeHits`
    std::vector<std::vector<std::uint32_t>> sweptPast;      ///< by piece: shapes near the way of one of them
    std::vector<std::uint32_t> candidates;                  ///< of the query that is being answered
    bool sleepy = false;                                    ///< some body has rested for long enough
    DetectionCounts counts;
    std::array<std::uint64_t, kMaxStages> stageRuns{};  ///< by stage: see runsOf()
    std::uint32_t effectsRun = 0;                       ///< bits of those whose code ran in this step
    std::array<std::uint64_t, kEffects> effectRuns{};   ///< by effect: steps in which its code ran
    std::vector<std::uint8_t> leverageOf;               ///< by root of an island, where hasLeverage()
    std::vector<IslandHardness> hardness;               ///< by root of an island: see sortByQuality()
    bool rootsKnown = false;                            ///< in this step: findRoots()
    std::vector<std::uint32_t> roots;                   ///< of islands, by body
    std::vector<EnergyAccount> accounts;                ///< by root, where islands are looked at for energy
    std::vector<std::uint32_t> openAccounts;            ///< which of them are in use
    std::vector<std::uint32_t> gainers;                 ///< bodies that contacts gave energy in this step
    std::vector<IslandCase> cases;                      ///< the same, where there is a tolerance
};

}  // namespace plumb::physics
