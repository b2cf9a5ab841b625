#include "physics/simulation.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include "core/profile.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// One chapter of the step. It is run when any of its effects is called for; 0 for always.
struct Stage {
    std::string_view name;  // also the profiler's
    std::uint32_t effects;
    void (*run)(StepContext& step);
};

template <class... Effects>
constexpr std::uint32_t any(Effects... effects) {
    return (Manifest::bit(effects) | ...);
}

constexpr std::uint32_t kContacts = any(Effect::Contacts, Effect::Triggers);
constexpr std::uint32_t kMeeting = kContacts | any(Effect::SoftBodies);
constexpr std::uint32_t kSmooth =
    any(Effect::AreaGravity, Effect::Wind, Effect::Buoyancy, Effect::Attractor, Effect::Springs);

constexpr Stage kStages[] = {
    {"broad phase", kMeeting, findPairs},
    {"narrow phase", kMeeting, updateContacts},
    {"filter contacts", any(Effect::OneWay), filterContacts},
    {"new joints", any(Effect::Joints), colourJoints},
    {"explosions", any(Effect::Explosion), explode},
    {"prepare fields", kSmooth, prepareFields},
    {"soft bodies", any(Effect::SoftBodies), moveSoftBodies},
    {"gather bodies", 0, gatherBodies},
    {"fields", kSmooth, applyFields},
    {"prepare constraints", any(Effect::Contacts, Effect::Joints), prepareConstraints},
    {"solve", 0, solve},
    {"integrators", kSmooth, integrateFlyers},
    {"finish bodies", 0, finishBodies},
    {"continuous", any(Effect::Continuous), sweepFastBodies},
    {"events", any(Effect::ContactEvents, Effect::Triggers), publishEvents},
    {"sleep", any(Effect::Sleep), putToSleep},
};

static_assert(std::size(kStages) <= kMaxStages);

/// Contacts of what is gone have to end, though nobody calls for contacts any more.
bool hasRemains(const World& world) {
    return !world.shapes.dying.empty() || !world.bodies.dying.empty() || !world.contacts.empty();
}

bool isCalledFor(const Stage& stage, const World& world, const ContactHooks& hooks) {
    if (stage.effects == 0) return true;
    if (stage.run == filterContacts && hooks.preSolve != nullptr) return true;
    if ((stage.effects & kContacts) != 0 && hasRemains(world)) return true;
    const Manifest& manifest = world.manifest;
    for (std::size_t i = 0; i < kEffects; ++i) {
        const auto effect = static_cast<Effect>(i);
        if ((stage.effects & Manifest::bit(effect)) != 0 && manifest.runs(effect)) return true;
    }
    return false;
}

/// Nothing moves and nothing came: a world at rest costs nothing.
bool nothingToDo(const World& world) {
    return world.awake.empty() && world.moved.empty() && !hasRemains(world) &&
           !world.manifest.runs(Effect::Explosion) && !world.manifest.runs(Effect::SoftBodies);
}

}  // namespace

std::span<const StageInfo> stages() {
    static const auto kInfos = [] {
        std::array<StageInfo, std::size(kStages)> infos;
        for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = {kStages[i].name, kStages[i].effects};
        return infos;
    }();
    return kInfos;
}

std::uint64_t runsOf(World& world, std::string_view stage) {
    for (std::size_t i = 0; i < std::size(kStages); ++i) {
        if (kStages[i].name == stage) return world.work.get().stageRuns[i];
    }
    return 0;
}

// A world at rest is not stepped: what is left is of the last step in which something moved.
DetectionCounts detectionOf(World& world) {
    return world.awake.empty() || world.work.stale() ? DetectionCounts{} : world.work.get().counts;
}

void step(World& world, float dt, const StepOptions& options) {
    world.events.clear();
    world.brokenJoints.clear();
    world.quarantined.clear();
    if (!(dt > 0.0f) || !std::isfinite(dt)) return;
    ++world.steps;
    if (nothingToDo(world)) return;
    StepContext context{world, world.work.get(), dt, options.pool, options.hooks};
    for (const Stage& stage : kStages) {
        const bool seamsLeft = stage.run == publishEvents && !context.work.surfaceChanges.empty();
        if (!seamsLeft && !isCalledFor(stage, world, options.hooks)) continue;
        const ProfileScope scope{options.profile, stage.name};
        ++context.work.stageRuns[static_cast<std::size_t>(&stage - kStages)];
        stage.run(context);
    }
}

}  // namespace plumb::physics
