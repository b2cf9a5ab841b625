#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <lua.hpp>

#include "assets/asset_store.hpp"
#include "core/log.hpp"
#include "ecs/world.hpp"
#include "gameplay/register_components.hpp"
#include "gameplay/systems/timer_system.hpp"
#include "gameplay/systems/tween_system.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"
#include "scene/register_components.hpp"
#include "script/script_set.hpp"
#include "script/script_state.hpp"
#include "script/script_system.hpp"

namespace plumb::bench {

/// Lua as Debian's package has it, with its allocator and library.
class PlainLua {
public:
    /// @param text  defines global functions
    explicit PlainLua(const std::string& text) : state_{luaL_newstate()} {
        luaL_openlibs(state_);
        run(text);
    }
    ~PlainLua() { lua_close(state_); }
    PlainLua(const PlainLua&) = delete;
    PlainLua& operator=(const PlainLua&) = delete;

    void run(const std::string& text) { check(luaL_dostring(state_, text.c_str())); }
    void call(const char* function) {
        lua_getglobal(state_, function);
        check(lua_pcall(state_, 0, 0, 0));
    }

private:
    void check(int status) {
        if (status == LUA_OK) return;
        std::fprintf(stderr, "%s\n", lua_tostring(state_, -1));
        std::exit(1);
    }

    lua_State* state_;
};

/// A world with scripts and the systems that they need, as in a game; without the physics. Lines of the log
/// are counted instead of printed.
class ScriptStage {
public:
    using Texts = std::vector<std::pair<std::string, std::string>>;

    explicit ScriptStage(const Texts& texts = {}) {
        registerSceneComponents(types_);
        registerGameplayComponents(types_);
        before_ = setLogSink([this](const LogLine&) { ++complaints_; });
        world_.provide(set_);
        world_.provide(assets_);
        world_.provide(prefabs_);
        world_.addSystem<TimerSystem>();
        world_.addSystem<ScriptSystem>();
        world_.addSystem<ScriptEventSystem>();
        world_.addSystem<TweenSystem>();
        if (texts.empty()) return;
        std::vector<Error> problems;
        set_.readTexts(texts, problems);
        follow(problems);
    }
    ~ScriptStage() { setLogSink(before_); }
    ScriptStage(const ScriptStage&) = delete;
    ScriptStage& operator=(const ScriptStage&) = delete;

    /// Reads the files of the folder, as a game does at its start and when one was changed.
    void read(const Path& folder) {
        std::vector<Error> problems;
        set_.read(folder, problems);
        follow(problems);
    }

    /// Adds entities with a Transform and a script.
    void add(std::string_view script, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const EntityId entity = world_.createEntity().id();
            world_.add<Transform>(entity, Vec2{static_cast<float>(i % 100), 0.0f});
            world_.add(type(script), entity);
        }
    }
    void tick() {
        world_.beginTick();
        world_.update(1.0f / 60.0f);
    }

    [[nodiscard]] const TypeInfo& type(std::string_view name) const {
        const TypeInfo* found = types_.find(name);
        if (found == nullptr) std::fprintf(stderr, "no script %s\n", std::string{name}.c_str()), std::exit(1);
        return *found;
    }
    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] const ScriptSet& set() const { return set_; }
    [[nodiscard]] PrefabLibrary& prefabs() { return prefabs_; }
    [[nodiscard]] std::size_t stateBytes() const {
        return world_.findResource<ScriptState>()->memory.bytes();
    }
    [[nodiscard]] int complaints() const { return complaints_; }

private:
    /// The component types of the world become those that the scripts declare.
    void follow(const std::vector<Error>& problems) {
        for (const Error& problem : problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
        std::vector<std::pair<TypeInfo, TypeInfo>> changed;
        for (const ScriptSet::File& file : set_.files()) {
            if (!file.type) continue;
            const TypeInfo* known = types_.find(file.type->name);
            if (known != nullptr) changed.emplace_back(*known, *file.type);
            updateComponentType(types_.update(*file.type));
        }
        for (const auto& [old, now] : changed) world_.convert(old, types_.find(now.name));
    }

    int complaints_ = 0;
    LogSink before_;
    ScriptSet set_;
    AssetStore assets_;
    TypeRegistry types_;
    PrefabLibrary prefabs_{types_};
    World world_{types_};
};

}  // namespace plumb::bench
