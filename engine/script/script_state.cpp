#include "script/script_state.hpp"

#include <algorithm>

namespace plumb {

ScriptState::Instance* ScriptState::Loaded::find(EntityId entity) {
    if (entity.index >= byEntity.size() || byEntity[entity.index] == 0) return nullptr;
    Instance& instance = instances[byEntity[entity.index] - 1];
    return instance.entity == entity ? &instance : nullptr;
}

void ScriptState::Loaded::add(Instance instance) {
    if (instance.entity.index >= byEntity.size()) byEntity.resize(instance.entity.index + 1);
    instances.push_back(instance);
    byEntity[instance.entity.index] = static_cast<std::uint32_t>(instances.size());
}

ScriptState::Loaded* ScriptState::find(TypeKey type) {
    const auto found = std::find_if(loaded.begin(), loaded.end(), [type](const Loaded& script) {
        return script.table != 0 && script.type == type;
    });
    return found == loaded.end() ? nullptr : &*found;
}

int ScriptState::selfOf(TypeKey type, EntityId entity) {
    Loaded* script = find(type);
    const Instance* instance = script == nullptr ? nullptr : script->find(entity);
    return instance == nullptr ? 0 : instance->self;
}

bool ScriptState::hasInstances() const {
    return std::any_of(loaded.begin(), loaded.end(),
                       [](const Loaded& script) { return !script.instances.empty(); });
}

void ScriptState::addTo(Hasher& hasher) const {
    for (const Loaded& script : loaded) {
        hasher.add(script.nameHash);
        hasher.add(std::uint64_t{script.instances.size()});
    }
    for (const Wait& wait : waits) {
        hasher.add(std::uint64_t{wait.entity.index} << 32 | wait.entity.generation);
        hasher.add(std::uint64_t{wait.ticks} << 1 | (wait.isTick ? 1 : 0));
        hasher.add(wait.event.value);
    }
}

}  // namespace plumb
