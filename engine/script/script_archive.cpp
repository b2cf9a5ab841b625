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

// The scripts of a saved game: first the instances, then for each file the upvalues of its functions, i.e.
// its local variables and the table of its global ones, by name, then the pairs of the `self` tables and of
// all tables that these or upvalues contain.

namespace plumb {
namespace {

using script::ValueReader;
using script::ValueWriter;

/// Writes the upvalues of the functions of the table on top of the stack.
void writeFunctions(lua_State* state, StateArchive& archive, ValueWriter& values) {
    std::vector<std::string> names = script::functionNames(state);
    archive.count(names.size());
    for (std::string& name : names) {
        archive.text(name);
        lua_getfield(state, -1, name.c_str());
        for (int i = 1; const char* upvalue = lua_getupvalue(state, -1, i); ++i) {
            std::string text = values.canWrite(-1) ? upvalue : "";
            if (!text.empty()) {
                archive.text(text);
                values.write(-1);
            }
            lua_pop(state, 1);
        }
        std::string none;
        archive.text(none);
        lua_pop(state, 1);
    }
}

/// Finds an upvalue of the function on top of the stack and pushes it. @return 0 if there is none
int upvalueNamed(lua_State* state, const std::string& name) {
    for (int i = 1; const char* upvalue = lua_getupvalue(state, -1, i); ++i) {
        if (name == upvalue) return i;
        lua_pop(state, 1);
    }
    return 0;
}

/// Reads upvalues of functions of the table on top of the stack.
void readFunctions(lua_State* state, StateArchive& archive, ValueReader& values) {
    const std::size_t count = archive.count(0);
    for (std::size_t i = 0; i < count && archive.ok(); ++i) {
        std::string function, name;
        archive.text(function);
        const bool exists = lua_getfield(state, -1, function.c_str()) == LUA_TFUNCTION;
        for (archive.text(name); !name.empty() && archive.ok(); archive.text(name)) {
            const int place = exists ? upvalueNamed(state, name) : 0;
            const bool fills = place != 0 && lua_istable(state, -1) != 0;
            values.read(fills ? lua_gettop(state) : 0);
            if (place == 0) {
                lua_pop(state, 1);
                continue;
            }
            lua_remove(state, -2);
            if (lua_setupvalue(state, -2, place) == nullptr) lua_pop(state, 1);
        }
        lua_pop(state, 1);
    }
}

/// Writes the scripts, without files that have no component: what others have of them are values of theirs.
void writeScripts(lua_State* state, StateArchive& archive, std::vector<ScriptState::Loaded> loaded) {
    std::erase_if(loaded, [](const ScriptState::Loaded& script) { return script.table == 0; });
    archive.count(loaded.size());
    for (ScriptState::Loaded& script : loaded) {
        archiveKey(archive, script.type);
        archive.count(script.instances.size());
        for (const ScriptState::Instance& instance : script.instances) {
            EntityId entity = instance.entity;
            std::uint32_t scene = instance.scene;
            archive.value(entity);
            archive.number(scene);
        }
    }
    lua_newtable(state);
    ValueWriter values{state, archive, lua_gettop(state)};
    const auto eachTable = [&](auto visit) {
        for (const ScriptState::Loaded& script : loaded) visit(script.table);
    };
    const auto eachSelf = [&](auto visit) {
        for (const ScriptState::Loaded& script : loaded) {
            for (const ScriptState::Instance& instance : script.instances) visit(instance.self);
        }
    };
    const auto with = [&](int ref, auto visit) {
        lua_rawgeti(state, LUA_REGISTRYINDEX, ref);
        visit();
        lua_pop(state, 1);
    };
    eachTable([&](int ref) { with(ref, [&] { values.name(-1); }); });
    const std::uint32_t firstSelf = values.count();
    eachSelf([&](int ref) { with(ref, [&] { values.name(-1); }); });
    eachTable([&](int ref) { with(ref, [&] { writeFunctions(state, archive, values); }); });
    values.writeTables(firstSelf);
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

void read(lua_State* state, World& world, ScriptState& scripts, StateArchive& archive) {
    const std::vector<SavedScript> saved = readInstances(archive, scripts);
    if (!archive.ok()) return;
    lua_newtable(state);
    ValueReader values{state, archive, lua_gettop(state)};
    const auto eachTable = [&](auto visit) {
        for (const SavedScript& each : saved) {
            if (each.script != nullptr) {
                lua_rawgeti(state, LUA_REGISTRYINDEX, each.script->table);
            } else {
                lua_newtable(state);
            }
            visit();
            lua_pop(state, 1);
        }
    };
    eachTable([&] { values.name(-1); });
    const std::uint32_t firstSelf = values.count();
    for (const SavedScript& each : saved) {
        for (const ScriptState::Instance& instance : each.instances) {
            pushSelf(state, world, each, instance);
            values.name(-1);
            lua_pop(state, 1);
        }
    }
    eachTable([&] { readFunctions(state, archive, values); });
    values.readTables(firstSelf);
}

}  // namespace

bool takeSaved(lua_State* state, World& world, ScriptState& scripts) {
    const std::string bytes = std::exchange(scripts.saved, {});
    StateArchive archive = StateArchive::reader(bytes);
    const int top = lua_gettop(state);
    read(state, world, scripts, archive);
    lua_settop(state, top);
    return archive.ok();
}

}  // namespace script
}  // namespace plumb
