#include "physics/simulation.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

#include "physics/islands/sleeping.hpp"
#include "physics/ranges.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

template <class... Effects>
constexpr std::uint32_t any(Effects... effects) {
    return (Manifest::bit(effects) | ...);
}

constexpr std::uint32_t kMeeting = any(Effect::Contacts, Effect::Triggers, Effect::SoftBodies);
constexpr std::uint32_t kSmooth =
    any(Effect::AreaGravity, Effect::Wind, Effect::Buoyancy, Effect::Attractor, Effect::Springs);

/// True if contacts of destroyed shapes or bodies must end, even if no effect requires contacts any more.
bool hasRemains(const StepContext& step) {
    const World& world = step.world;
    return !world.shapes.dying.empty() || !world.bodies.dying.empty() || !world.contacts.empty();
}
/// True if the solver's blocks of former contacts must be cleared.
bool hasBlocks(const StepContext& step) {
    return !step.work.two.lanes.empty() || !step.work.fixed.lanes.empty();
}
bool hasHook(const StepContext& step) {
    return step.hooks.preSolve != nullptr || step.hooks.friction != nullptr ||
           step.hooks.bounciness != nullptr;
}
bool hasSeams(const StepContext& step) { return !step.work.chainChanges.empty(); }

constexpr StageInfo kStages[] = {
    {"broad phase", kMeeting, findPairs, hasRemains},
    {"narrow phase", kMeeting, updateContacts, hasRemains},
    {"filter contacts", any(Effect::OneWay), filterContacts, hasHook},
    {"new joints", any(Effect::Joints), colourJoints},
    {"explosions", any(Effect::Explosion), explode},
    {"prepare fields", kSmooth, prepareFields},
    {"soft bodies", any(Effect::SoftBodies), moveSoftBodies},
    {"gather bodies", 0, gatherBodies},
    {"fields", kSmooth, applyFields},
    {"prepare constraints", any(Effect::Contacts, Effect::Joints), prepareConstraints, hasBlocks},
    {"solve", 0, solve},
    {"integrators", kSmooth, integrateFreeBodies},
    {"keep energy", any(Effect::Joints, Effect::Contacts), keepEnergy},
    {"finish bodies", 0, finishBodies},
    {"continuous", any(Effect::Continuous), sweepFastBodies},
    {"events", any(Effect::ContactEvents, Effect::Triggers), publishEvents, hasSeams},
    {"sleep", any(Effect::Sleep), putToSleep},
};

static_assert(std::size(kStages) <= kMaxStages);

/// True if no object moves and none was added or removed: a step of a world at rest costs no time.
bool nothingToDo(const World& world) {
    return world.awake.empty() && world.moved.empty() && world.contacts.empty() &&
           world.shapes.dying.empty() && world.bodies.dying.empty() &&
           !world.manifest.runs(Effect::Explosion) && !world.manifest.runs(Effect::SoftBodies);
}

/// Wakes all bodies if gravity changed (resting bodies may begin to move) or if sleeping is disabled.
void wakeForSettings(World& world) {
    const bool gravityChanged = world.steps > 1 && world.gravityOfLastStep != world.settings.gravity;
    if (gravityChanged || !world.settings.sleeping) wakeAll(world);
    world.gravityOfLastStep = world.settings.gravity;
}

std::uint32_t effectsOf(const World& world, const ContactHooks& hooks) {
    std::uint32_t effects = world.manifest.running();
    if (hooks.friction != nullptr) effects |= Manifest::bit(Effect::Friction);
    if (hooks.bounciness != nullptr) effects |= Manifest::bit(Effect::Restitution);
    // After the last shape that requires contacts was destroyed, its contacts must still end.
    constexpr std::uint32_t kEnding = any(Effect::Contacts, Effect::Triggers, Effect::ContactEvents);
    if (!world.shapes.dying.empty() && !world.contacts.empty())
        effects |= kEnding & ~world.manifest.pinnedOff;
    if (!world.settings.continuous) effects &= ~Manifest::bit(Effect::Continuous);
    if (!world.settings.sleeping) effects &= ~Manifest::bit(Effect::Sleep);
    return effects;
}

/// Measures the time of a stage on this thread and on each thread of the pool.
class StageScope {
public:
    StageScope(const StepOptions& options, std::string_view name)
        : pool_{options.profile != nullptr && options.profile->on ? options.pool : nullptr},
          profile_{options.profile},
          name_{name},
          before_{pool_ != nullptr ? pool_->times() : TaskPool::Times{}},
          scope_{options.profile, name} {
        if (options.pool != nullptr) options.pool->isTimed = pool_ != nullptr;
    }
    ~StageScope() {
        if (pool_ != nullptr) profile_->addThreads(name_, before_, pool_->times());
    }
    StageScope(const StageScope&) = delete;
    StageScope& operator=(const StageScope&) = delete;

private:
    TaskPool* pool_;
    Profile* profile_;
    std::string_view name_;
    TaskPool::Times before_;
    ProfileScope scope_;
};

}  // namespace

void WorkspaceHolder::Delete::operator()(Workspace* workspace) const { delete workspace; }

Workspace& WorkspaceHolder::get() {
    if (workspace_ == nullptr) workspace_.reset(new Workspace);
    return *workspace_;
}

std::span<const StageInfo> stages() { return kStages; }

std::uint64_t runsOf(World& world, std::string_view stage) {
    for (std::size_t i = 0; i < std::size(kStages); ++i) {
        if (kStages[i].name == stage) return world.work.get().stageRuns[i];
    }
    return 0;
}

// For a world at rest step() returns early, and the stored counts are those of an earlier step.
DetectionCounts detectionOf(World& world) {
    const Workspace* work = world.work.lastStep();
    return world.awake.empty() || work == nullptr ? DetectionCounts{} : work->counts;
}

std::uint64_t runsOf(World& world, Effect effect) {
    return world.work.get().effectRuns[static_cast<std::size_t>(effect)];
}

void step(World& world, float dt, const StepOptions& options) {
    if (world.work.isInCallback) return;  // called by a callback
    world.events.clear();
    world.brokenJoints.clear();
    world.strainedJoints.clear();
    world.fellAsleep.clear();
    world.quarantined.clear();
    world.quarantinedSoft.clear();
    if (!(dt > 0.0f) || !std::isfinite(dt)) return;
    dt = std::clamp(dt, kShortestStep, kLongestStep);
    bringIntoRange(world.settings);
    ++world.steps;
    wakeForSettings(world);
    if (nothingToDo(world)) return;
    world.stepLength = dt;
    StepOptions own = options;
    if (!isWorthThreads(world, options)) own.pool = nullptr;
    StepContext context{world, world.work.get(), dt, own.pool, own.hooks, effectsOf(world, own.hooks)};
    context.work.effectsRun = 0;
    context.work.rootsKnown = false;
    for (const StageInfo& stage : kStages) {
        const bool isCalled = stage.effects == 0 || (stage.effects & context.effects) != 0;
        if (!isCalled && (stage.also == nullptr || !stage.also(context))) continue;
        const StageScope scope{own, stage.name};
        ++context.work.stageRuns[static_cast<std::size_t>(&stage - kStages)];
        // An effect that is only a part of a stage is counted by StepContext::starts().
        context.work.effectsRun |= stage.effects & context.effects;
        stage.run(context);
    }
    for (std::uint32_t left = context.work.effectsRun; left != 0; left &= left - 1)
        ++context.work.effectRuns[static_cast<std::size_t>(std::countr_zero(left))];
    world.work.noteStep();
}

}  // namespace plumb::physics
