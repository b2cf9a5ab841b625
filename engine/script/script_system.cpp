#include "script/script_system.hpp"

#include "ecs/world.hpp"
#include "script/script_runner.hpp"
#include "script/script_set.hpp"
#include "script/script_state.hpp"

namespace plumb {

bool hasScripts(const World& world) {
    const auto* set = world.service<ScriptSet>();
    if (set == nullptr) return false;
    for (const ScriptSet::File& file : set->files()) {
        if (file.type && world.count(*file.type) != 0) return true;
    }
    const auto* state = world.findResource<ScriptState>();
    return state != nullptr && state->hasInstances();
}

void ScriptSystem::update(World& world, float dt) {
    if (hasScripts(world)) ScriptRunner{world}.tick(dt);
}

void ScriptEventSystem::update(World& world, float) {
    if (hasScripts(world)) ScriptRunner{world}.handleEvents();
}

}  // namespace plumb
