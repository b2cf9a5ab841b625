#include "scene/systems/ghost_system.hpp"

#include <algorithm>
#include <utility>

#include "ecs/world.hpp"
#include "physics/simulation.hpp"
#include "scene/components/bodies/ghost.hpp"
#include "scene/lab.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/physics_threads.hpp"

namespace plumb {

namespace {

void choose(bool& setting, AsScene wanted) {
    if (wanted != AsScene::Same) setting = wanted == AsScene::On;
}

void setUp(physics::Settings& settings, const Ghost& ghost) {
    if (ghost.quality >= 0) settings.quality = qualityOf(ghost.quality);
    if (ghost.iterations > 0) settings.iterations = static_cast<std::uint8_t>(std::min(ghost.iterations, 64));
    if (ghost.integrator < physics::IntegratorKind::Count) settings.integrator = ghost.integrator;
    choose(settings.continuous, ghost.continuous);
    choose(settings.automaticQuality, ghost.automaticQuality);
    choose(settings.directJoints, ghost.jointTrees);
}

void nudge(physics::World& world, double metres) {
    for (const std::uint32_t body : world.awake) {
        if (world.bodies.info[body].kind != physics::BodyKind::Dynamic) continue;
        world.bodies.pose[body].centre.x += metres;
        return;
    }
}

/// Returns a hash of a ghost's settings and of Lab::run; the ghost restarts when the hash changes.
std::uint64_t madeFrom(const Ghost& ghost, std::uint64_t run) {
    Hasher hasher;
    const auto add = [&hasher](auto... values) { (hasher.add(values), ...); };
    add(run, static_cast<std::uint64_t>(ghost.quality), static_cast<std::uint64_t>(ghost.iterations));
    add(static_cast<std::uint64_t>(ghost.integrator), static_cast<std::uint64_t>(ghost.continuous));
    add(static_cast<std::uint64_t>(ghost.automaticQuality), static_cast<std::uint64_t>(ghost.jointTrees));
    add(ghost.nudge);
    return hasher.value() | 1;
}

void keep(GhostWorlds& ghosts, const World& world) {
    std::erase_if(ghosts.all, [&](const GhostWorlds::One& one) { return !world.has<Ghost>(one.ghost); });
}

GhostWorlds::One& worldOf(GhostWorlds& ghosts, EntityId entity) {
    for (GhostWorlds::One& one : ghosts.all) {
        if (one.ghost == entity) return one;
    }
    GhostWorlds::One& added = ghosts.all.emplace_back();
    added.ghost = entity;
    return added;
}

}  // namespace

void GhostSystem::update(World& world, float dt) {
    if (world.count<Ghost>() == 0) {
        if (auto* left = world.findResource<GhostWorlds>(); left != nullptr) left->all.clear();
        return;
    }
    const auto* state = world.findResource<PhysicsState>();
    if (state == nullptr) return;
    auto& ghosts = world.resource<GhostWorlds>();
    keep(ghosts, world);
    const auto* lab = world.findResource<Lab>();
    for (auto [entity, ghost] : std::as_const(world).query<const Ghost>()) {
        GhostWorlds::One& one = worldOf(ghosts, entity);
        const std::uint64_t made = madeFrom(ghost, lab != nullptr ? lab->run : 0);
        if (std::exchange(one.made, made) == made) {
            PhysicsThreads* threads = world.service<PhysicsThreads>();
            physics::step(one.world, dt, {threads != nullptr ? threads->of(one.world) : nullptr});
            continue;
        }
        one.world = state->world;
        setUp(one.world.settings, ghost);
        nudge(one.world, static_cast<double>(ghost.nudge * state->scale.metres));
    }
}

}  // namespace plumb
