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
/// colors are for pairs of dynamic bodies, the last ones for constraints with a static or kinematic body.
/// These are solved last, so that contacts with the ground have the smallest errors.
inline constexpr int kColours = 32;
inline constexpr int kFirstFixedColour = 24;
/// Color of constraints for which no color was free: solved sequentially, before all colors.
inline constexpr std::uint8_t kOverflow = 32;

struct BlockRange {
    std::int32_t begin = 0;  ///< index of the first block
    std::int32_t end = 0;    ///< index after the last block
};

/// Blocks of contacts between two dynamic bodies (two), and with a static or kinematic body (fixed).
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
    std::int32_t begin = 0;  ///< range of slots, in multiples of eight
    std::int32_t end = 0;
    std::uint64_t contactColours = 0;    ///< bits of colors that have contacts
    std::uint64_t jointColours = 0;      ///< bits of colors that have joints
    ColourBlocks colours[kColours + 1];  ///< the last is kOverflow: one contact or joint per block

    /// Returns the blocks of all colors, which are consecutive.
    [[nodiscard]] ContactRanges contacts() const {
        const ContactRanges &first = colours[0].contacts, &last = colours[kColours].contacts;
        return {{first.two.begin, last.two.end}, {first.fixed.begin, last.fixed.end}};
    }
};

/// Blocks of contacts. Groups with rotation come first.
template <class Block, class BlockWithoutRotation>
struct ContactStore {
    std::vector<BlockLanes> lanes;
    std::vector<Block> blocks;
    std::vector<BlockWithoutRotation> blocksWithoutRotation;  ///< used instead of `blocks`, same index
    std::vector<BounceBlock> bounces;                         ///< parallel to `blocks`, if a shape bounces
    std::vector<RollingBlock> rollings;  ///< parallel to `blocks`, if a shape has rolling resistance

    template <class Bodies>
    auto& blocksOf() {
        if constexpr (Bodies::kRotate) {
            return blocks;
        } else {
            return blocksWithoutRotation;
        }
    }
};

/// Assignment of contacts to blocks. The next step reuses it if the contact keys and groups are the same: if
/// another contact takes the index of a removed one, its key or the bodies of its group differ.
struct ContactLayout {
    std::vector<std::uint16_t> keys;   ///< contact keys for which it was made
    std::vector<std::uint32_t> order;  ///< Workspace::solveOrder for which it was made
    std::vector<SolveGroup> groups;
    bool isCurrent = false;  ///< true if the lanes of the blocks correspond to it
};

/// Properties of a contact by which later stages decide whether to skip it.
enum ContactKey : std::uint16_t {
    kKeyColour = 63,  ///< mask: color, if it exerts forces
    kKeyIdle = 63,    ///< value of the color bits of a contact that exerts no forces
    kKeyFixed = 64,   ///< A is static or kinematic
    kKeyBegan = 128   ///< the shapes began to touch in this step
};

inline std::uint16_t keyOf(const Contact& contact) {
    const bool pushes =
        (contact.flags & (kTouching | kTriggered | kDisabled)) == kTouching && contact.colour <= kOverflow;
    const int idle = pushes ? 0 : kKeyIdle;  // sets all bits of the color
    const int fixed = (contact.flags & kFixedA) != 0 ? kKeyFixed : 0;
    const int began = (contact.flags & kBegan) != 0 ? kKeyBegan : 0;
    return static_cast<std::uint16_t>((contact.colour & kKeyColour) | idle | fixed | began);
}

constexpr bool pushes(std::uint16_t key) { return (key & kKeyColour) != kKeyIdle; }

/// A slot whose body is locked along x or y.
struct AxisLock {
    std::uint32_t slot = 0;
    std::uint8_t flags = 0;  ///< bits: kLockX, kLockY
};

/// Sum of the normal impulses of a contact over the substeps: contact_extras.cpp.
struct ImpulseSum {
    const float* points[2];  ///< N s: impulses in its block; null without a second point
    float last = 0.0f;       ///< N s: sum of both when last added
    std::int32_t contact = 0;
};

/// Number of contacts between a chain and another shape or chain (chain_events.cpp).
struct ChainTouch {
    PairKey pair = 0;
    std::int32_t count = 0;
};

/// Event of a contact of a chain in this step.
struct ChainChange {
    PairKey pair = 0;
    std::uint32_t order = 0;
    ContactEvent event;
};

/// A contact of a dynamic body with a static or kinematic body.
struct FixedPair {
    std::uint32_t body = 0;
    std::uint32_t contact = 0;
    std::uint32_t next = kNone;  ///< index in Workspace::fixedPairs: next contact of the body
};

struct ContactFindings {
    std::vector<std::uint32_t> changed;  ///< contacts that began, ended or have kGone
    std::vector<FixedPair> fixed;
    DetectionCounts counts;

    void clear() { changed.clear(), fixed.clear(), counts = {}; }
};

struct BodyFindings {
    std::vector<std::uint32_t> left;    ///< shapes that left their bounds
    std::vector<std::uint32_t> fast;    ///< bodies that may have tunneled through a shape
    std::vector<std::uint32_t> broken;  ///< bodies whose state became non-finite
    bool sleepy = false;                ///< a body has been at rest for Settings::sleepTime

    void clear() { left.clear(), fast.clear(), broken.clear(), sleepy = false; }
};

struct SweepFindings {
    std::vector<std::uint32_t> shapes;  ///< shapes near the current body
    DetectionCounts counts;

    void clear() { counts = {}; }
};

inline constexpr std::size_t kMaxStages = 24;

/// Input of the automatic quality estimate of an island.
struct SubstepEstimate {
    float lightest = std::numeric_limits<float>::max();  ///< kg
    float heaviest = 0.0f;
    float lowest = std::numeric_limits<float>::max();  ///< m: position along gravity
    float highest = -std::numeric_limits<float>::max();
    float size = 0.0f;  ///< m: sum of the inscribed radii of its bodies
    float bodies = 0.0f;
    float joints = 0.0f;
};

/// Intermediate data of an island while its quality is derived from its errors.
struct IslandCase {
    SubstepController controller;  ///< merged from the controllers of its bodies
    Quality minimum = 0;           ///< lower limit: the highest quality set for its bodies and joints
    bool isNew = false;            ///< true if a body has no controller yet
    float error = 0.0f;            ///< m: largest overlap or joint error
};

/// Contribution of a body to the energy account of its island.
struct EnergySums {
    float energy = 0.0f;        ///< J: kinetic energy
    float work = 0.0f;          ///< J: work of forces
    float gain = 0.0f;          ///< J: gain of energy beyond the work of forces
    float displacement = 0.0f;  ///< kg m2: sum of mass times squared displacement, halved
    float mass = 0.0f;          ///< kg
    bool isLively = false;      ///< true if a body can rotate or bounces
    Vec2 momentum;              ///< kg m/s
};

/// Energy account of an island in this step: stages/keep_energy.cpp.
struct EnergyAccount : EnergySums {
    bool isOpen = false;     ///< the island has an account in this step
    bool isJointed = false;  ///< it has joints
    bool isDriven = false;   ///< a motor, kinematic body or conveyor does work on it
    bool isRooted = false;   ///< connected to or touching a static or kinematic body
    bool isWild = false;     ///< its energy is implausible
    float credit = 0.0f;     ///< J, sum of EnergyShare::credit
    float peak = 0.0f;       ///< J: recent maximum of `energy`
    float excess = 0.0f;     ///< J, to remove
    float own = 0.0f;        ///< J, kinetic energy relative to the mean velocity `middle`
    float minimum = 0.0f;    ///< J, minimum of `own` that always remains
    float keep = 1.0f;       ///< factor on velocities relative to `middle`
    float part = 1.0f;       ///< factor on displacements relative to `middle`
    Vec2 middle;             ///< m/s: mean velocity
};

/// A broad phase for boxes that are not the bounds of shapes.
struct BoxProxies {
    std::unique_ptr<BroadPhase> search;
    std::vector<AABB> bounds;
    std::vector<Filter> filters;
    std::vector<ProxyMotion> motions;

    [[nodiscard]] Proxies view() const { return {bounds, filters, motions}; }
};

/// Memory of a step, reused by the next step. Its contents can be recomputed from the world.
struct Workspace {
    std::unique_ptr<BroadPhase> broadPhase;
    BroadPhaseKind broadPhaseKind = BroadPhaseKind::Count;
    std::vector<std::uint32_t> changedProxies;  ///< shapes changed since the last update of the broad phase
    std::vector<std::uint8_t> isChanged;        ///< indexed by shape: 1 if in `changedProxies`
    std::vector<std::uint8_t> isMoved;          ///< indexed by shape: 1 if in World::moved
    PairSet pairs;                              ///< pairs of all contacts, awake or asleep
    std::vector<std::vector<PairKey>> foundPairs;  ///< per piece of work
    std::vector<PairKey> newPairs;                 ///< pairs without a contact yet, sorted
    std::vector<std::uint32_t> colourMasks;        ///< indexed by body: colors of its constraints

    std::vector<ChainTouch> chainTouches;  ///< sorted by pair

    // Data of the current step.
    std::vector<ChainChange> chainChanges;
    std::vector<std::pair<PairKey, float>> approaches;  ///< m/s: approach speeds of contacts that began
    std::vector<ChainTouch> chainScratch;
    std::vector<std::uint16_t> contactKeys;        ///< indexed by contact: bits of ContactKey
    std::vector<ContactFindings> contactFindings;  ///< per piece of work
    std::vector<FixedPair> fixedPairs;
    std::vector<std::uint32_t> firstFixedPair;  ///< indexed by body: its first contact in `fixedPairs`
    std::vector<std::uint32_t> seamBodies;      ///< bodies with several fixed pairs
    std::vector<std::uint32_t> endedAtSeams;    ///< contacts that lost their points in correctSeams()
    std::vector<std::int32_t> slots;            ///< indexed by body: its slot; -1 if it is not solved
    std::vector<std::uint32_t> bodyOf;          ///< indexed by slot: its body; kNone for idle slots
    std::vector<Float4> velocity;               ///< indexed by slot, like the following: see SolverBodies
    std::vector<Float4> deltaPosition;
    std::vector<Float4> drive;
    std::vector<Float4> keep;
    std::vector<Float4> ballisticDrift;
    std::vector<Float4> velocityBeforeImpulses;
    std::vector<Float4> statesWithoutRotation;  ///< BodiesWithoutRotation::velocity
    std::vector<SolveGroup> groups;
    Strips strips;
    std::vector<std::int32_t> cursors;  ///< indexed by group and key, see prepareConstraints()
    ContactLayout layout;               ///< assignment of contacts to the current lanes
    ContactStore<SolverBodies::TwoBlock, BodiesWithoutRotation::TwoBlock> two;
    ContactStore<SolverBodies::FixedBlock, BodiesWithoutRotation::FixedBlock> fixed;
    std::vector<ImpactPlace> impacts;  ///< contacts of a group that may propagate impacts
    std::vector<std::uint8_t> hits;    ///< indexed by slot: number of impacts of the body
    std::vector<AxisLock> locks;
    std::vector<ImpulseSum> impulseSums;  ///< sums of the group that is being solved
    std::vector<float> stepImpulses;      ///< N s, by contact: sum of all substeps, if it has an event
    JointWork joints;
    SoftSurroundings softSurroundings;
    SoftSoftContacts softSoftContacts;
    SmoothForces smooth;                        ///< used if there are fields
    std::vector<std::uint32_t> searchedFields;  ///< fields to search in fieldsNear(), ascending
    BoxProxies fieldBoxes;                      ///< indexed like `searchedFields`: bounds of the fields
    std::vector<std::uint32_t> solveOrder;      ///< awake bodies, sorted by group; empty for a single group
    std::vector<std::uint8_t> groupOf;          ///< indexed by body: index of its group, if there are several
    std::vector<std::uint8_t> needsRotation;    ///< indexed by root: 1 if its island needs rotation
    std::vector<std::uint32_t> bodyScratch;     ///< temporary values by body
    std::vector<BodyFindings> bodyFindings;     ///< per piece of work
    std::vector<std::uint32_t> fastBodies;      ///< bodies that may have tunneled in this step
    bool kinematicsAtRest = false;              ///< some kinematic bodies are not in fastBodies
    std::vector<SweptBody> swept;               ///< fast bodies, and bodies that they hit
    BoxProxies sweptProxies;                    ///< indexed like `swept`: bounds of paths that may meet
    std::vector<std::pair<float, std::uint32_t>> dueHits;   ///< heap: fraction of the step, index in `swept`
    std::vector<Contact> madeHits;                          ///< contacts of hits, in the order of the hits
    std::vector<std::pair<PairKey, std::size_t>> hitOrder;  ///< indices in `madeHits`
    std::vector<SweepFindings> sweepFindings;               ///< per piece of work
    std::vector<std::uint32_t> passedBodies;  ///< bodies that a fast kinematic body may have passed
    std::vector<std::uint32_t> candidates;    ///< result of the broad phase for the current query
    bool sleepy = false;                      ///< a body has been at rest for sleepTime
    DetectionCounts counts;
    std::array<std::uint64_t, kMaxStages> stageRuns{};   ///< indexed by stage: see runsOf()
    std::uint32_t effectsRun = 0;                        ///< bits of effects whose code ran in this step
    std::array<std::uint64_t, kEffects> effectRuns{};    ///< indexed by effect: steps in which its code ran
    std::vector<SubstepEstimate> estimate;               ///< indexed by root of an island
    bool rootsKnown = false;                             ///< findRoots() was called in this step
    std::vector<std::uint32_t> roots;                    ///< indexed by body: root of its island
    std::vector<EnergyAccount> accounts;                 ///< indexed by root of an island
    std::vector<std::uint32_t> openAccounts;             ///< roots of the accounts in use
    std::vector<std::uint32_t> bookedBodies;             ///< bodies of islands with an account
    std::vector<EnergySums> bookings;                    ///< indexed like `bookedBodies`
    std::vector<std::vector<std::uint32_t>> pieceLists;  ///< scratch of collect(), per piece of work
    std::vector<std::uint32_t> pieceFound;               ///< pieceLists, concatenated by collect()
    std::vector<std::uint32_t> gainers;  ///< bodies that gained energy from contacts in this step
    std::vector<IslandCase> cases;       ///< indexed by root, if there is a tolerance
};

/// Allocates a color that neither body uses; kOverflow if there is none. Pass kNone for bodies not dynamic.
std::uint8_t takeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB);
void freeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB, std::uint8_t colour);

/// Resizes Workspace::colourMasks to the world, and recomputes the masks after the world was overwritten.
void refreshColours(World& world, Workspace& work);

/// Adds the keys of contacts that came after the narrow phase, as of bodies that woke, for the solver.
inline void addKeys(const World& world, Workspace& work) {
    if (work.contactKeys.size() < world.contacts.size())
        work.layout.isCurrent = false;  // one of another group may have the index and key of a former one
    while (work.contactKeys.size() < world.contacts.size())
        work.contactKeys.push_back(keyOf(world.contacts[work.contactKeys.size()]));
}

}  // namespace plumb::physics
