#include "box_physics/simulation.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include "core/assert.hpp"
#include "core/profile.hpp"
#include "box_physics/stage_names.hpp"
#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

/// One chapter of the step. It is run when any of its effects is called for.
struct Stage {
    std::string_view name;  // also the profiler's
    unsigned effects;
    void (*run)(StepContext& step);
};

constexpr Stage kStages[] = {
    {"forces", kAllEffects, applyForces},
    {"broad phase", kContacts | kTriggers, findPairs},
    {"narrow phase", kContacts | kTriggers, updateContacts},
    {"solver", kContacts, solveContacts},
    {"motion", kMotion | kContacts, moveBodies},
    {"contact events", kContacts | kTriggers, publishEvents},
};

}  // namespace

std::span<const StageName> stageNames() {
    static const auto kNames = [] {
        std::array<StageName, std::size(kStages)> names;
        for (std::size_t i = 0; i < names.size(); ++i) names[i] = {kStages[i].name, kStages[i].effects};
        return names;
    }();
    return kNames;
}

Vec2 upOf(const Settings& settings) {
    const Vec2 up = normalized(-settings.gravity);
    return up == Vec2{} ? Vec2{0.0f, -1.0f} : up;
}

void step(World& world, const Settings& settings, float dt, unsigned effects, Profile* profile) {
    PLUMB_ASSERT(std::isfinite(dt) && dt >= 0.0f, "a physics step must move time forward");
    world.events.clear();
    if (dt == 0.0f) return;
    StepContext context{world, settings, dt, effects, upOf(settings)};
    for (const Stage& stage : kStages) {
        if ((stage.effects & effects) == 0) continue;
        const ProfileScope scope{profile, stage.name};
        stage.run(context);
    }
    ++world.steps;
}

}  // namespace plumb::box_physics
