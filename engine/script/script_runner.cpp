#include "script/script_runner.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <lua.hpp>

#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/paused.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/game_random.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/scene_stack.hpp"
#include "script/library/work.hpp"
#include "script/script_archive.hpp"
#include "script/script_entity.hpp"
#include "script/script_errors.hpp"
#include "script/script_handlers.hpp"
#include "script/script_loader.hpp"
#include "script/script_observer.hpp"
#include "script/script_set.hpp"
#include "script/script_values.hpp"
#include "script/values/function_places.hpp"
#include "script/values/self.hpp"

namespace plumb {
namespace {

ScriptSet& setOf(World& world) {
    auto* set = world.service<ScriptSet>();
    PLUMB_ASSERT(set != nullptr, "scripts need a world with the service ScriptSet");
    return *set;
}

/// Returns the bits of the handlers that the table on top of the stack has.
std::uint32_t handlersOf(lua_State* state) {
    std::uint32_t handlers = 0;
    for (std::size_t i = 0; i < kScriptHandlers.size(); ++i) {
        if (lua_getfield(state, -1, kScriptHandlers[i].data()) == LUA_TFUNCTION) handlers |= 1u << i;
        lua_pop(state, 1);
    }
    return handlers;
}

}  // namespace

ScriptRunner::ScriptRunner(World& world)
    : world_{world},
      set_{setOf(world)},
      scripts_{world.resource<ScriptState>()},
      observer_{world.service<ScriptObserver>()},
      access_{scripts_.memory},
      state_{access_.state()},
      context_{world_, set_, scripts_},
      contextScope_{context_},
      hostScope_{*this} {
    if (access_.isNew()) protect([&] { script::openScripts(state_); });
    if (scripts_.typesVersion != set_.version()) protect([&] { load(); });
    if (scripts_.saved.empty()) return;
    tookSaved_ = false;
    protect([&] { takeSaved(); });
}

Random& ScriptRunner::random() { return world_.resource<GameRandom>().random; }
void ScriptRunner::print(std::string_view text) { logNote("Script", "{}", text); }

/// Calls `body` so that the lack of memory outside of handlers is an error, not the end of the program.
void ScriptRunner::protect(const std::function<void()>& body) {
    if (script::callProtected(state_, body)) return;
    logError("Script", Error{"scripts", script::textAt(state_, -1),
                             "keep fewer values in scripts: 64 MiB are available"});
    lua_settop(state_, 0);
    lua_gc(state_, LUA_GCCOLLECT);
}

void ScriptRunner::tick(float dt) {
    protect([&] {
        callOnLoad();
        endWaits();
        for (Loaded& script : scripts_.loaded) endInstances(script);
        resumeWaits();
        beginInstances();
        callTicks(dt);
    });
    failures_.logOthers();
}

/// After a saved game was loaded: scripts have their values again.
void ScriptRunner::takeSaved() {
    script::Work::end();  // the memory is the limit, not the work of one handler
    tookSaved_ = script::takeSaved(state_, world_, scripts_);
    for (Loaded& script : scripts_.loaded) {
        for (Instance& instance : script.instances) instance.isLoaded = true;
    }
    scripts_.hasLoaded = true;
}

/// After a saved game was loaded, as soon as a script may run: onLoad begins again what handlers were waiting
/// for.
void ScriptRunner::callOnLoad() {
    if (!std::exchange(scripts_.hasLoaded, false)) return;
    for (std::size_t i = 0; i < scripts_.loaded.size(); ++i) {
        Loaded& script = scripts_.loaded[i];
        for (std::size_t k = 0; k < script.instances.size(); ++k) {
            Instance& instance = script.instances[k];
            if (!instance.isLoaded) continue;
            instance.isLoaded = (script.handlers & kOnLoad) != 0 && !mayRun(script, instance);
            if (instance.isLoaded) {
                scripts_.hasLoaded = true;
            } else if ((script.handlers & kOnLoad) != 0) {
                call(script, instance, nameOf(kOnLoad), 0);
            }
        }
    }
}

// ---- files

void ScriptRunner::load() {
    script::followTypes(state_, *world_.types());
    set_.addTexts(world_);
    std::vector<Loaded> former = std::exchange(scripts_.loaded, {});
    bool moduleChanged = false;
    for (const ScriptSet::File& file : set_.files()) {
        const std::uint64_t hash = hashText(file.name);
        const auto known = std::find_if(former.begin(), former.end(),
                                        [hash](const Loaded& script) { return script.nameHash == hash; });
        Loaded& script = scripts_.loaded.emplace_back();
        if (known != former.end()) script = std::exchange(*known, {});
        script.nameHash = hash;
        if (!file.type && script.textHash != 0 && script.textHash != file.textHash) moduleChanged = true;
    }
    for (std::size_t i = 0; i < scripts_.loaded.size(); ++i) {
        if (moduleChanged || scripts_.loaded[i].textHash != set_.files()[i].textHash)
            script::forgetFile(state_, set_.files()[i].name);
    }
    std::vector<std::size_t> reloaded;
    for (std::size_t i = 0; i < scripts_.loaded.size(); ++i) {
        Loaded& script = scripts_.loaded[i];
        const bool isReload = script.table != 0;
        if (moduleChanged || script.textHash != set_.files()[i].textHash) {
            loadFile(i);
            if (isReload) reloaded.push_back(i);
        }
        const TypeInfo* type = script.table == 0 ? nullptr : world_.types()->find(script.type);
        if (type == nullptr) continue;
        lua_rawgeti(state_, LUA_REGISTRYINDEX, script.table);
        script::defineSelf(state_, *type);
    }
    script::noteFunctions(state_);
    for (const std::size_t i : reloaded) reset(scripts_.loaded[i]);
    scripts_.typesVersion = set_.version();
}

void ScriptRunner::loadFile(std::size_t index) {
    const ScriptSet::File& file = set_.files()[index];
    script::resetBudget(state_);
    const bool ran = script::runFile(state_, set_, file.name);
    Loaded& script = scripts_.loaded[index];
    script.textHash = file.textHash;
    if (!ran) {
        logError("Script", Error{file.path, script::textAt(state_, -1), "change the file"});
        lua_pop(state_, 1);
        return;
    }
    const TypeInfo* type = file.type ? world_.types()->find(file.type->name) : nullptr;
    if (type == nullptr || !lua_istable(state_, -1)) {
        lua_pop(state_, 1);
        return;
    }
    script.type = type->key;
    script.handlers = handlersOf(state_);
    for (const Error& warning : file.warnings) logWarning("Script", warning);
    if (script.table == 0)
        script.table = luaL_ref(state_, LUA_REGISTRYINDEX);
    else
        lua_rawseti(state_, LUA_REGISTRYINDEX, script.table);
}

/// After a changed file was loaded: scripts that an error has stopped go on.
void ScriptRunner::reset(Loaded& script) {
    for (Instance& instance : script.instances) {
        const ComponentType* type = typeOf(script.type);
        if (void* component = type == nullptr ? nullptr : world_.find(type->info, instance.entity))
            *static_cast<bool*>(component) = false;
        if ((script.handlers & kOnReload) != 0) call(script, instance, "onReload", 0);
    }
}

// ---- instances

void ScriptRunner::beginInstances() {
    for (std::size_t i = 0; i < scripts_.loaded.size(); ++i) {
        Loaded& script = scripts_.loaded[i];
        const ComponentType* type = script.table == 0 ? nullptr : typeOf(script.type);
        if (type == nullptr || script.memberships == world_.memberships(type->info)) continue;
        script.memberships = world_.memberships(type->info);
        std::vector<EntityId> fresh;
        world_.eachOf(type->info, [&](EntityId entity, const void*) {
            if (script.find(entity) == nullptr) fresh.push_back(entity);
        });
        for (const EntityId entity : fresh) begin(script, entity);
    }
}

void ScriptRunner::begin(Loaded& script, EntityId entity) {
    const ComponentType* type = typeOf(script.type);
    if (!world_.has(type->info, entity)) return;  // removed by onCreate of another
    lua_newtable(state_);
    script::pushEntity(state_, entity);
    lua_setfield(state_, -2, "entity");
    script::becomeSelf(state_, script.type);
    Instance instance;
    instance.entity = entity;
    instance.self = luaL_ref(state_, LUA_REGISTRYINDEX);
    instance.scene = loadingOf(world_, entity);
    script.add(instance);
    if ((script.handlers & kOnCreate) != 0) call(script, script.instances.back(), "onCreate", 0);
}

void ScriptRunner::endInstances(Loaded& script) {
    const ComponentType* type = script.table == 0 ? nullptr : typeOf(script.type);
    if (type == nullptr || script.memberships == world_.memberships(type->info)) return;
    std::vector<Instance> gone;
    script.removeIf([&](const Instance& instance) {
        if (world_.has(type->info, instance.entity)) return false;
        if ((script.handlers & kOnDestroy) != 0 && !isOver(instance.scene)) {
            gone.push_back(instance);
        } else {
            script::endSelf(state_, instance.self);
        }
        return true;
    });
    callOnDestroy(script, gone);
}

void ScriptRunner::callOnDestroy(Loaded& script, std::vector<Instance>& gone) {
    for (Instance& instance : gone) {
        call(script, instance, nameOf(kOnDestroy), 0);
        script::endSelf(state_, instance.self);
    }
}

/// True if a scene has ended. What is destroyed with it is no event for the next one.
bool ScriptRunner::isOver(std::uint32_t scene) const {
    const auto* loaded = std::as_const(world_).findResource<LoadedScenes>();
    return scene != 0 && (loaded == nullptr ||
                          std::none_of(loaded->scenes.begin(), loaded->scenes.end(),
                                       [scene](const LoadedScene& other) { return other.loading == scene; }));
}

/// Ends the handlers that wait for components that are gone.
void ScriptRunner::endWaits() {
    std::erase_if(scripts_.waits, [&](const Wait& wait) {
        const ComponentType* type = typeOf(wait.type);
        if (type != nullptr && world_.has(type->info, wait.entity)) return false;
        lua_resetthread(threadOf(wait.thread));
        scripts_.idle.push_back(wait.thread);
        return true;
    });
}

/// Returns the component type with this key; null if there is none. Finding it locks and searches all types,
/// so the last one is kept: neighboring calls are mostly for the same script.
const ComponentType* ScriptRunner::typeOf(TypeKey key) const {
    if (lastType_ == nullptr || lastType_->info.key != key) lastType_ = findComponentType(key);
    return lastType_;
}

bool ScriptRunner::isStopped(TypeKey type, EntityId entity) const {
    const ComponentType* known = typeOf(type);
    const void* component = known == nullptr ? nullptr : std::as_const(world_).find(known->info, entity);
    return component == nullptr || *static_cast<const bool*>(component);
}

bool ScriptRunner::mayRun(const Loaded& script, const Instance& instance) const {
    return !isStopped(script.type, instance.entity) && !world_.has<Paused>(instance.entity);
}

// ---- handlers

void ScriptRunner::callTicks(float dt) {
    for (std::size_t i = 0; i < scripts_.loaded.size(); ++i) {
        Loaded& script = scripts_.loaded[i];
        if ((script.handlers & kOnTick) == 0) continue;
        for (Instance& instance : script.instances) {
            if (instance.ticking || !mayRun(script, instance)) continue;
            lua_pushnumber(state_, dt);
            call(script, instance, "onTick", 1, true);
        }
    }
}

void ScriptRunner::call(Loaded& script, Instance& instance, std::string_view handler, int values,
                        bool isTick) {
    const int thread = takeThread();
    lua_State* coroutine = threadOf(thread);
    lua_rawgeti(state_, LUA_REGISTRYINDEX, script.table);
    lua_pushlstring(state_, handler.data(), handler.size());
    lua_gettable(state_, -2);
    lua_remove(state_, -2);
    lua_rawgeti(state_, LUA_REGISTRYINDEX, instance.self);
    lua_xmove(state_, coroutine, 2);
    lua_xmove(state_, coroutine, values);
    Wait wait;
    wait.entity = instance.entity;
    wait.type = script.type;
    wait.thread = thread;
    wait.isTick = isTick;
    resume(thread, coroutine, values + 1, wait);
}

/// Runs a coroutine until it ends, waits or fails.
void ScriptRunner::resume(int thread, lua_State* coroutine, int values, const Wait& wait) {
    script::resetBudget(state_);
    context_.request = {};
    lua_State* const outer = std::exchange(context_.handler, coroutine);
    const EntityId outerEntity = std::exchange(context_.entity, wait.entity);
    int results = 0;
    const int status =
        script::resumeHandler(observer_, coroutine, state_, values, results, wait.entity, wait.type);
    context_.handler = outer;
    context_.entity = outerEntity;
    if (status == LUA_YIELD) {
        lua_pop(coroutine, results);
        Wait next = wait;
        next.ticks = context_.request.ticks;
        next.event = context_.request.event;
        scripts_.waits.push_back(next);
        Loaded* script = wait.isTick ? scripts_.find(wait.type) : nullptr;
        if (Instance* instance = script == nullptr ? nullptr : script->find(wait.entity))
            instance->ticking = true;
        return;
    }
    if (status == LUA_OK) {
        lua_settop(coroutine, 0);
    } else {
        if (status != script::kAbandoned) report(coroutine, status, wait);
        lua_resetthread(coroutine);
    }
    scripts_.idle.push_back(thread);
}

void ScriptRunner::report(lua_State* coroutine, int status, const Wait& wait) {
    const ComponentType* type = typeOf(wait.type);
    if (void* component = type == nullptr ? nullptr : world_.find(type->info, wait.entity))
        *static_cast<bool*>(component) = true;
    if (!failures_.isFirst(script::placeOf(coroutine))) return;
    // To describe variables takes work, and the handler may have used up all of it. After the end of the
    // memory none are described, but that there is no work left is part of the message.
    if (status != LUA_ERRMEM) script::resetBudget(state_);
    logError("Script", script::handlerError(coroutine, status, world_, wait.entity));
}

int ScriptRunner::takeThread() {
    if (scripts_.idle.empty()) {
        lua_newthread(state_);
        return luaL_ref(state_, LUA_REGISTRYINDEX);
    }
    const int thread = scripts_.idle.back();
    scripts_.idle.pop_back();
    return thread;
}

lua_State* ScriptRunner::threadOf(int ref) {
    lua_rawgeti(state_, LUA_REGISTRYINDEX, ref);
    lua_State* thread = lua_tothread(state_, -1);
    lua_pop(state_, 1);
    return thread;
}

// ---- waiting

void ScriptRunner::resumeWaits() {
    // Handlers that go on may wait again: they are added behind those of this tick.
    const std::size_t count = scripts_.waits.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Wait wait = scripts_.waits[i];
        const bool counts =
            wait.ticks > 0 && !world_.has<Paused>(wait.entity) && !isStopped(wait.type, wait.entity);
        if (!counts || --wait.ticks > 0) {
            scripts_.waits[kept++] = wait;
        } else {
            resumeWait(wait, 0);
        }
    }
    scripts_.waits.erase(scripts_.waits.begin() + static_cast<std::ptrdiff_t>(kept),
                         scripts_.waits.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Goes on with a handler; `values` results of its wait are on top of its own stack.
void ScriptRunner::resumeWait(const Wait& wait, int values) {
    Loaded* script = wait.isTick ? scripts_.find(wait.type) : nullptr;
    if (Instance* instance = script == nullptr ? nullptr : script->find(wait.entity))
        instance->ticking = false;
    resume(wait.thread, threadOf(wait.thread), values, wait);
}

}  // namespace plumb
