#include "script/script_archive.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <lua.hpp>

#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/component_type.hpp"
#include "ecs/saved_type.hpp"
#include "ecs/world.hpp"
#include "script/script_entity.hpp"
#include "script/script_errors.hpp"
#include "script/script_handlers.hpp"
#include "script/script_loader.hpp"
#include "script/script_state.hpp"
#include "script/values/self.hpp"
#include "script/values/value_archive.hpp"

// The scripts of a saved game: first the instances, then what each file has returned, and all values that are
// reached from it, i.e. the upvalues of its functions, which are its local variables and the table of its
// global ones. Last those of the `self` tables: tables that both contain are found by their places in the
// files.

namespace plumb {
namespace {

using script::ValueReader;
using script::ValueWriter;

/// Visits what each file has returned, in the order of their names: calls visit(name) with it on top of the
/// stack.
template <class Visit>
void eachResult(lua_State* state, Visit visit) {
    std::vector<std::string> names;
    script::pushFileResults(state);
    for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1))
        names.push_back(script::textAt(state, -2));
    std::sort(names.begin(), names.end());
    for (std::string& name : names) {
        lua_getfield(state, -1, name.c_str());
        visit(name);
        lua_pop(state, 1);
    }
    lua_pop(state, 1);
}

void writeScripts(lua_State* state, StateArchive& out, std::vector<ScriptState::Loaded> loaded) {
    std::erase_if(loaded, [](const ScriptState::Loaded& script) { return script.table == 0; });
    std::string bytes;
    StateArchive archive = StateArchive::writer(bytes);
    lua_newtable(state);
    ValueWriter values{state, archive, lua_gettop(state)};
    archive.count(loaded.size());
    for (ScriptState::Loaded& script : loaded) {
        archiveKey(archive, script.type);
        archive.count(script.instances.size());
        for (const ScriptState::Instance& instance : script.instances) {
            EntityId entity = instance.entity;
            std::uint32_t scene = instance.scene;
            archive.value(entity);
            archive.number(scene);
            lua_rawgeti(state, LUA_REGISTRYINDEX, instance.self);
            values.name(-1);
            lua_pop(state, 1);
        }
    }
    const std::uint32_t selves = values.count();
    eachResult(state, [&](std::string& name) {
        archive.text(name);
        values.write(-1);
    });
    std::string none;
    archive.text(none);
    values.writeContents(selves);
    const std::uint32_t ofFiles = values.count();
    if (selves > 0) values.writeContents(0, selves);
    values.writeContents(ofFiles);
    out.count(values.places().size());
    for (std::string place : values.places()) out.text(place);
    out.text(bytes);
}

/// Writes the scripts. That needs memory of Lua, of a copy of the state: World::toBytes() copies resources.
/// @return false, which is logged, if there is none left
bool writeProtected(ScriptMemory& memory, StateArchive& archive,
                    const std::vector<ScriptState::Loaded>& loaded) {
    const ScriptAccess access{memory};
    lua_State* state = access.state();
    const std::function<void()> write = [&] { writeScripts(state, archive, loaded); };
    const int top = lua_gettop(state);
    const bool written = script::callProtected(state, write);
    if (!written)
        logError("Script", Error{"saved game", script::textAt(state, -1),
                                 "keep fewer values in scripts: 64 MiB are available"});
    lua_settop(state, top);
    return written;
}

/// Names the scripts whose handlers wait at the moment and will not go on after loading.
void warnOfWaits(ScriptState& scripts) {
    std::vector<TypeKey> named;
    for (const ScriptState::Wait& wait : scripts.waits) {
        const ScriptState::Loaded* script = scripts.find(wait.type);
        if (script == nullptr || (script->handlers & kOnLoad) != 0 ||
            std::find(named.begin(), named.end(), wait.type) != named.end())
            continue;
        named.push_back(wait.type);
        const std::string_view name = findComponentType(wait.type)->info.name;
        logWarning("Script",
                   Error{"saved game",
                         format("{} waits, and functions that wait are not saved: it will not go on", name),
                         format("add {}:onLoad(), which begins again what it needs", name)});
    }
}

}  // namespace

void ScriptState::archive(StateArchive& archive) {
    if (!archive.reading() && memory.exists()) {
        warnOfWaits(*this);
        saved.clear();
        StateArchive inner = StateArchive::writer(saved);
        if (!writeProtected(memory, inner, loaded)) archive.fail();
    }
    archive.text(saved);
    if (archive.reading()) {
        std::string kept = std::move(saved);
        *this = {};
        saved = std::move(kept);
    }
}

namespace script {
namespace {

/// A script file of the saved game.
struct SavedScript {
    ScriptState::Loaded* script = nullptr;  ///< null: this version of the game does not have it
    std::vector<ScriptState::Instance> instances;
};

std::vector<SavedScript> readInstances(StateArchive& archive, ScriptState& scripts) {
    std::vector<SavedScript> saved(archive.count(0));
    for (SavedScript& each : saved) {
        TypeKey type = kMaxTypes;
        archiveKey(archive, type);
        if (type < kMaxTypes) each.script = scripts.find(type);
        if (each.script != nullptr && each.script->table == 0) each.script = nullptr;
        each.instances.resize(archive.count(0));
        for (ScriptState::Instance& instance : each.instances) {
            archive.value(instance.entity);
            archive.number(instance.scene);
        }
    }
    return saved;
}

/// Pushes the `self` of an instance, which is added to its script if the entity has the component.
void pushSelf(lua_State* state, World& world, const SavedScript& saved, ScriptState::Instance instance) {
    lua_newtable(state);
    const ComponentType* type = saved.script == nullptr ? nullptr : findComponentType(saved.script->type);
    if (type == nullptr || !world.has(type->info, instance.entity) ||
        saved.script->find(instance.entity) != nullptr)
        return;
    pushEntity(state, instance.entity);
    lua_setfield(state, -2, "entity");
    becomeSelf(state, saved.script->type);
    lua_pushvalue(state, -1);
    instance.self = luaL_ref(state, LUA_REGISTRYINDEX);
    saved.script->add(instance);
}

/// Reads what the files have returned, into what they return in this version of the game.
void readResults(lua_State* state, StateArchive& archive, ValueReader& values) {
    pushFileResults(state);
    std::string name;
    for (archive.text(name); !name.empty() && archive.ok(); archive.text(name)) {
        lua_getfield(state, -1, name.c_str());
        values.read(lua_gettop(state));
        lua_pop(state, 2);
    }
    lua_pop(state, 1);
}

/// @return false if the archive is damaged
bool read(lua_State* state, World& world, ScriptState& scripts, StateArchive& in) {
    std::vector<std::string> places(in.count(0));
    for (std::string& place : places) in.text(place);
    std::string bytes;
    in.text(bytes);
    StateArchive archive = StateArchive::reader(bytes);
    const std::vector<SavedScript> saved = readInstances(archive, scripts);
    if (!in.ok() || !archive.ok()) return false;
    ValueReader values{state, archive, places};
    for (const SavedScript& each : saved) {
        for (const ScriptState::Instance& instance : each.instances) {
            pushSelf(state, world, each, instance);
            values.name(-1);
            lua_pop(state, 1);
        }
    }
    const std::uint32_t selves = values.count();
    readResults(state, archive, values);
    values.readContents(selves);
    const std::uint32_t ofFiles = values.count();
    if (selves > 0) values.readContents(0, selves);
    values.readContents(ofFiles);
    values.setMetatables();
    return archive.ok();
}

}  // namespace

bool takeSaved(lua_State* state, World& world, ScriptState& scripts) {
    const std::string bytes = std::exchange(scripts.saved, {});
    StateArchive archive = StateArchive::reader(bytes);
    const int top = lua_gettop(state);
    const bool isRead = read(state, world, scripts, archive);
    lua_settop(state, top);
    return isRead;
}

}  // namespace script
}  // namespace plumb
