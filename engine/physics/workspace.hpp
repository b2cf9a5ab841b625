#pragma once

#include "physics/contacts/detection_counts.hpp"
#include "physics/contacts/pair_set.hpp"
#include "physics/continuous/sweep.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/soft/soft_contacts.hpp"
#include "physics/solver/joint_work.hpp"
#include "physics/solver/strips.hpp"

namespace plumb::physics {

/// Constraints of one color share no body, so they can be solved in parallel and in any order. The first
/// colors are for pairs of dynamic bodies. The last ones are for constraints with a static or kinematic body;
/// they are solved last, so that support by the ground wins.
inline constexpr int kColours = 32;
inline constexpr int kFirstFixedColour = 24;
/// Constraints that found no color: solved sequentially, before all colors.
inline constexpr std::uint8_t kOverflow = 32;

struct BlockRange {
    std::int32_t begin = 0;
    std::int32_t end = 0;
};

/// Blocks of contacts between two dynamic bodies, and of those with a static or kinematic one.
struct ContactRanges {
    BlockRange two;
    BlockRange fixed;
};

struct ColourBlocks {
    ContactRanges contacts;
    BlockRange joints[kJointBlockKinds];
};

/// Islands that are solved with equal parameters: a range of slots, and their constraints by color.
struct SolveGroup {
    Quality quality = 0;
    std::int32_t substeps = 1;
    bool withoutRotation = false;  ///< solved by the reduced kernels; such groups come last
    std::int32_t bodies = 0;
    std::int32_t begin = 0;  ///< slots, in multiples of eight
    std::int32_t end = 0;
    std::uint64_t contactColours = 0;    ///< bits of colors that have contacts
    std::uint64_t jointColours = 0;      ///< bits of colors that have joints
    ColourBlocks colours[kColours + 1];  ///< the last is kOverflow: one lane a block, in order

    /// Of all colors, which follow each other.
    [[nodiscard]] ContactRanges contacts() const {
        const ContactRanges &first = colours[0].contacts, &last = colours[kColours].contacts;
        return {{first.two.begin, last.two.end}, {first.fixed.begin, last.fixed.end}};
    }
};

/// Contacts in blocks. Groups with rotation come first.
template <class Block, class BlockWithoutRotation>
struct ContactStore {
    std::vector<BlockLanes> lanes;
    std::vector<Block> blocks;
    std::vector<BlockWithoutRotation> blocksWithoutRotation;  ///< instead of `blocks`, by the same index
    std::vector<BounceBlock> bounces;                         ///< parallel to `blocks`, if something bounces
    std::vector<RollingBlock> rollings;  ///< parallel to `blocks`, if something resists rolling

    template <class Bodies>
    auto& blocksOf() {
        if constexpr (Bodies::kRotate) {
            return blocks;
        } else {
            return blocksWithoutRotation;
        }
    }
};

/// Assignment of contacts to blocks. It follows from the contact keys and the groups: a contact that is new,
/// or takes the index of another one, changes its key or comes with other bodies.
struct ContactLayout {
    std::vector<std::uint16_t> keys;  ///< this and the following: from which it was made
    std::vector<std::uint32_t> order;
    std::vector<SolveGroup> groups;
    bool isCurrent = false;  ///< the lanes still match
};

/// The properties of a contact that later stages read to decide whether to skip it.
enum ContactKey : std::uint16_t {
    kKeyColour = 63,  ///< its color, if it pushes
    kKeyIdle = 63,    ///< as a color: it does not push
    kKeyFixed = 64,   ///< A is static or kinematic
    kKeyBegan = 128   ///< in this step
};

inline std::uint16_t keyOf(const Contact& contact) {
    const bool pushes =
        (contact.flags & (kTouching | kTriggered | kDisabled)) == kTouching && contact.colour <= kOverflow;
    const int idle = pushes ? 0 : kKeyIdle;  // all bits of a color
    const int fixed = (contact.flags & kFixedA) != 0 ? kKeyFixed : 0;
    const int began = (contact.flags & kBegan) != 0 ? kKeyBegan : 0;
    return static_cast<std::uint16_t>((contact.colour & kKeyColour) | idle | fixed | began);
}

constexpr bool pushes(std::uint16_t key) { return (key & kKeyColour) != kKeyIdle; }

/// A slot whose body is locked along x or y.
struct AxisLock {
    std::uint32_t slot = 0;
    std::uint8_t flags = 0;  ///< kLockX, kLockY
};

/// Sum of the normal impulses of a contact over the substeps: contact_extras.cpp.
struct ImpulseSum {
    const float* points[2];  ///< N s: current impulses in its block; null without a second point
    float last = 0.0f;       ///< N s: both, when they were last added
    std::int32_t contact = 0;
};

/// Number of contacts between a chain and something that touches it (chain_events.cpp).
struct ChainTouch {
    PairKey pair = 0;
    std::int32_t count = 0;
};

/// What happened to one of these contacts in this step.
struct ChainChange {
    PairKey pair = 0;
    std::uint32_t order = 0;
    ContactEvent event;
};

/// A contact of a dynamic body with one that is not.
struct FixedPair {
    std::uint32_t body = 0;
    std::uint32_t contact = 0;
    std::uint32_t next = kNone;  ///< index in Workspace::fixedPairs: another one of the body
};

struct ContactFindings {
    std::vector<std::uint32_t> changed;  ///< contacts that began, ended, or are gone
    std::vector<FixedPair> fixed;
    DetectionCounts counts;

    void clear() { changed.clear(), fixed.clear(), counts = {}; }
};

struct BodyFindings {
    std::vector<std::uint32_t> left;    ///< shapes that left their bounds
    std::vector<std::uint32_t> fast;    ///< bodies that may have passed through something
    std::vector<std::uint32_t> broken;  ///< bodies whose numbers went bad
    bool sleepy = false;                ///< some body has rested long enough to sleep

    void clear() { left.clear(), fast.clear(), broken.clear(), sleepy = false; }
};

struct SweepFindings {
    std::vector<std::uint32_t> shapes;  ///< near the current one
    DetectionCounts counts;

    void clear() { counts = {}; }
};

inline constexpr std::size_t kMaxStages = 24;

/// Input of the automatic quality estimate of an island.
struct SubstepEstimate {
    float lightest = std::numeric_limits<float>::max();  ///< kg
    float heaviest = 0.0f;
    float lowest = std::numeric_limits<float>::max();  ///< m along gravity
    float highest = -std::numeric_limits<float>::max();
    float size = 0.0f;  ///< m: sum of its bodies' inscribed radii
    float bodies = 0.0f;
    float joints = 0.0f;
};

/// An island while its quality is derived from its errors.
struct IslandCase {
    SubstepController controller;  ///< merged from those of its bodies
    Quality minimum = 0;           ///< minimum that its bodies and joints ask for
    bool isNew = false;            ///< some bodies have no state yet
    float error = 0.0f;            ///< m: largest overlap or joint error
};

/// What a body adds to the account of its island.
struct EnergySums {
    float energy = 0.0f;        ///< J, kinetic
    float work = 0.0f;          ///< J, by forces
    float gain = 0.0f;          ///< J, not explained by forces
    float displacement = 0.0f;  ///< kg m2: sum of mass times squared displacement, halved
    float mass = 0.0f;          ///< kg
    bool isLively = false;      ///< a body can rotate or bounces
    Vec2 momentum;              ///< kg m/s
};

/// Energy account of an island in this step: stages/keep_energy.cpp.
struct EnergyAccount : EnergySums {
    bool isOpen = false;
    bool isJointed = false;
    bool isDriven = false;  ///< a motor, kinematic body or conveyor does work on it
    bool isRooted = false;  ///< connected to or touching a static or kinematic body
    bool isWild = false;    ///< its energy is implausible
    float credit = 0.0f;    ///< J, as in EnergyShare
    float peak = 0.0f;      ///< J
    float excess = 0.0f;    ///< J, to be removed
    float own = 0.0f;       ///< J, kinetic relative to `middle`
    float minimum = 0.0f;   ///< J, the part of `own` that is never removed
    float keep = 1.0f;      ///< factor on velocities relative to `middle`
    float part = 1.0f;      ///< factor on displacements, likewise
    Vec2 middle;            ///< m/s
};

/// Boxes that are not the bounds of shapes, as input of a broad phase.
struct BoxProxies {
    std::unique_ptr<BroadPhase> search;
    std::vector<AABB> bounds;
    std::vector<Filter> filters;
    std::vector<ProxyMotion> motions;

    [[nodiscard]] Proxies view() const { return {bounds, filters, motions}; }
};

/// Memory of a step, reused by the next one. Everything in it follows from the world.
struct Workspace {
    std::unique_ptr<BroadPhase> broadPhase;
    BroadPhaseKind broadPhaseKind = BroadPhaseKind::Count;
    std::vector<std::uint32_t> changedProxies;     ///< since the last update of the broad phase
    std::vector<std::uint8_t> isChanged;           ///< by shape: is in `changedProxies`
    std::vector<std::uint8_t> isMoved;             ///< by shape
    PairSet pairs;                                 ///< of all contacts, awake or asleep
    std::vector<std::vector<PairKey>> foundPairs;  ///< per piece of work
    std::vector<PairKey> newPairs;
    std::vector<std::uint32_t> colourMasks;  ///< by body: colors of its constraints

    std::vector<ChainTouch> chainTouches;  ///< sorted by pair

    // Of the step.
    std::vector<ChainChange> chainChanges;
    std::vector<std::pair<PairKey, float>> approaches;  ///< m/s: of contacts that began
    std::vector<ChainTouch> chainScratch;
    std::vector<std::uint16_t>
        contactKeys;  ///< by contact: bits of ContactKey, so that few contacts have to be read
    std::vector<ContactFindings> contactFindings;  ///< per piece of work
    std::vector<FixedPair> fixedPairs;
    std::vector<std::uint32_t>
        firstFixedPair;                       ///< by body: index in `fixedPairs`, if it has one in this step
    std::vector<std::uint32_t> seamBodies;    ///< those with several fixed pairs
    std::vector<std::uint32_t> endedAtSeams;  ///< contacts without points that were touching
    std::vector<std::int32_t> slots;          ///< by body; -1 if it is not solved
    std::vector<std::uint32_t> bodyOf;        ///< by slot; kNone for idle slots
    std::vector<Float4> velocity;             ///< by slot, as in SolverBodies
    std::vector<Float4> deltaPosition;
    std::vector<Float4> drive;
    std::vector<Float4> keep;
    std::vector<Float4> ballisticDrift;
    std::vector<Float4> velocityBeforeImpulses;
    std::vector<Float4> statesWithoutRotation;  ///< BodiesWithoutRotation::velocity
    std::vector<SolveGroup> groups;
    Strips strips;
    std::vector<std::int32_t> cursors;  ///< by group and key, see prepareConstraints()
    ContactLayout layout;               ///< of the lanes, while contacts stay the same
    ContactStore<SolverBodies::TwoBlock, BodiesWithoutRotation::TwoBlock> two;
    ContactStore<SolverBodies::FixedBlock, BodiesWithoutRotation::FixedBlock> fixed;
    std::vector<ImpactPlace> impacts;  ///< of a group: candidates for propagation
    std::vector<std::uint8_t> hits;    ///< by slot: number of impacts of a body
    std::vector<AxisLock> locks;
    std::vector<ImpulseSum> impulseSums;  ///< of the group that is solved
    std::vector<float> stepImpulses;      ///< N s, by contact: of all substeps, if it causes an event
    JointWork joints;
    SoftSurroundings softSurroundings;
    SoftSoftContacts softSoftContacts;
    SmoothForces smooth;                        ///< if there are fields
    std::vector<std::uint32_t> searchedFields;  ///< see fieldsNear(), ascending
    BoxProxies fieldBoxes;                      ///< by index in `searchedFields`: where they act
    std::vector<std::uint32_t> solveOrder;      ///< awake bodies by group; empty if there is only one group
    std::vector<std::uint8_t> groupOf;          ///< by body, if there are several groups
    std::vector<std::uint8_t> needsRotation;    ///< by root, if some islands can be solved without rotation
    std::vector<std::uint32_t> bodyScratch;     ///< by body
    std::vector<BodyFindings> bodyFindings;     ///< per piece of work
    std::vector<std::uint32_t> fastBodies;      ///< those that may have passed through something in this step
    bool kinematicsAtRest = false;              ///< some kinematic bodies are not among these
    std::vector<SweptBody> swept;               ///< these, and what they hit
    BoxProxies sweptProxies;  ///< by index in `swept`: their paths, if they may hit each other
    std::vector<std::pair<float, std::uint32_t>> dueHits;   ///< heap: fraction of the step, index in `swept`
    std::vector<Contact> madeHits;                          ///< in the order of the hits
    std::vector<std::pair<PairKey, std::size_t>> hitOrder;  ///< indices in `madeHits`
    std::vector<SweepFindings> sweepFindings;               ///< per piece of work
    std::vector<std::uint32_t> passedBodies;                ///< that a fast kinematic one may have passed
    std::vector<std::uint32_t> candidates;                  ///< of the current query
    bool sleepy = false;                                    ///< some body has rested long enough to sleep
    DetectionCounts counts;
    std::array<std::uint64_t, kMaxStages> stageRuns{};   ///< by stage: see runsOf()
    std::uint32_t effectsRun = 0;                        ///< bits of effects whose code ran in this step
    std::array<std::uint64_t, kEffects> effectRuns{};    ///< by effect: steps in which its code ran
    std::vector<SubstepEstimate> estimate;               ///< by root of an island: automatic quality estimate
    bool rootsKnown = false;                             ///< findRoots() was called in this step
    std::vector<std::uint32_t> roots;                    ///< by body: root of its island
    std::vector<EnergyAccount> accounts;                 ///< by root, for islands with an energy account
    std::vector<std::uint32_t> openAccounts;             ///< roots of those in use
    std::vector<std::uint32_t> bookedBodies;             ///< their bodies
    std::vector<EnergySums> bookings;                    ///< by index in `bookedBodies`
    std::vector<std::vector<std::uint32_t>> pieceLists;  ///< scratch of collect(), per piece of work
    std::vector<std::uint32_t> pieceFound;               ///< joined
    std::vector<std::uint32_t> gainers;  ///< bodies that gained energy from contacts in this step
    std::vector<IslandCase> cases;       ///< by root, if there is a tolerance
};

/// Allocates a color that neither body uses. Pass kNone for a body that is not dynamic.
std::uint8_t takeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB);
void freeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB, std::uint8_t colour);

/// Resizes Workspace::colourMasks to the world, and recomputes the masks after the world was overwritten.
void refreshColours(World& world, Workspace& work);

}  // namespace plumb::physics
