#include "scene/effects.hpp"

#include <algorithm>

#include "core/log.hpp"
#include "physics/simulation.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {
namespace {

bool isOfPhysics(const EffectRow& row) { return row.physics != physics::Effect::Count; }

}  // namespace

Effects::Effects(const EffectTable& table, World& world) : table_{table} {
    makeGates();
    world.provide(*this);
    world.provide(gates_);
    world.provide(table);
}

void Effects::makeGates() {
    program_ = scenes_ = measured_ = pins_ = std::vector<Pin>(table_.rows().size(), Pin::Auto);
    pinnedBy_.assign(table_.rows().size(), {});
    counted_.assign(table_.rows().size(), 0);
    gates_ = {};
    gateOf_.clear();
    for (const EffectSystem& system : table_.systems()) {
        const std::size_t row = system.effect.empty() ? EffectTable::kNone : table_.find(system.effect);
        PLUMB_ASSERT(system.effect.empty() || row != EffectTable::kNone, "a system names an unknown effect");
        gateOf_.push_back(row == EffectTable::kNone ? row
                                                    : gates_.add(system.key, table_.rows()[row].isRequired));
    }
}

void Effects::tableChanged() {
    makeGates();
    sceneContents_.clear();  // followScenes() reads the pins of the scenes again
    resolvePins();
}

void Effects::followScenes(World& world) {
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    const std::size_t count = loaded == nullptr ? 0 : loaded->scenes.size();
    const bool same =
        count == sceneContents_.size() &&
        std::equal(sceneContents_.begin(), sceneContents_.end(),
                   loaded == nullptr ? nullptr : loaded->scenes.data(),
                   [](const auto& rest, const LoadedScene& scene) { return rest == scene.rest; });
    if (same) return;
    sceneContents_.clear();
    std::fill(scenes_.begin(), scenes_.end(), Pin::Auto);
    std::fill(pinnedBy_.begin(), pinnedBy_.end(), std::string{});
    if (loaded != nullptr) readScenes(*loaded);
    resolvePins();
    if (count < 2) return;
    // An overlay may need effects that the scenes below pin off, which loading its file alone cannot detect.
    std::vector<Error> problems;
    for (const LoadedScene& scene : loaded->scenes) {
        std::vector<Pin> others = pins_;
        for (std::size_t i = 0; i < others.size(); ++i) {
            if (pinnedBy_[i] == scene.path) others[i] = Pin::Auto;  // reported when the scene was loaded
        }
        table_.checkNeeds(world, scene.id, scene.path, others, problems);
    }
    for (const Error& problem : problems) logWarning("Scene", problem);
}

/// Reads the pins of scenes from bottom to top, so that the topmost scene that names an effect has priority.
void Effects::readScenes(const LoadedScenes& loaded) {
    for (const LoadedScene& scene : loaded.scenes) {
        sceneContents_.push_back(scene.rest);
        if (!scene.effects.is_object() || scene.effects.empty()) continue;
        const std::vector<Pin> pins = table_.readPins(scene.effects, scene.path, nullptr);
        for (const auto& [key, value] : scene.effects.items()) {
            const std::size_t row = table_.find(key);
            if (row == EffectTable::kNone) continue;
            scenes_[row] = pins[row];
            pinnedBy_[row] = pins[row] == Pin::Auto ? std::string{} : scene.path;
        }
    }
}

void Effects::resolvePins() {
    physicsOn_ = physicsOff_ = 0;
    for (std::size_t i = 0; i < pins_.size(); ++i) {
        pins_[i] = measured_[i] != Pin::Auto ? measured_[i]
                   : scenes_[i] != Pin::Auto ? scenes_[i]
                                             : program_[i];
        const EffectRow& row = table_.rows()[i];
        if (!isOfPhysics(row)) continue;
        if (pins_[i] == Pin::On) physicsOn_ |= physics::Manifest::bit(row.physics);
        if (pins_[i] == Pin::Off) physicsOff_ |= physics::Manifest::bit(row.physics);
    }
    for (std::size_t i = 0; i < gateOf_.size(); ++i) {
        if (gateOf_[i] != EffectTable::kNone)
            gates_.setPin(gateOf_[i], pins_[table_.find(table_.systems()[i].effect)]);
    }
}

bool Effects::isRequired(const World& world, std::size_t row) const {
    const EffectRow& effect = table_.rows()[row];
    if (!isOfPhysics(effect)) return effect.isRequired(world);
    const auto* state = world.findResource<PhysicsState>();
    return state != nullptr && state->world.manifest.requesters[static_cast<std::size_t>(effect.physics)] > 0;
}

std::uint64_t Effects::runsOf(World& world, std::size_t row) const {
    const EffectRow& effect = table_.rows()[row];
    if (isOfPhysics(effect)) {
        auto* state = world.findResource<PhysicsState>();
        return state == nullptr ? 0 : physics::runsOf(state->world, effect.physics);
    }
    std::uint64_t runs = counted_[row];
    for (std::size_t i = 0; i < gateOf_.size(); ++i) {
        if (gateOf_[i] != EffectTable::kNone && table_.systems()[i].effect == effect.name)
            runs += gates_.gate(gateOf_[i]).runs;
    }
    return runs;
}

void Effects::setProgramPin(std::string_view name, Pin pin) {
    program_[table_.find(name)] = pin;
    resolvePins();
}

void Effects::setMeasuredPin(std::size_t row, Pin pin) {
    measured_[row] = pin;
    resolvePins();
}

}  // namespace plumb
