#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "ecs/world.hpp"
#include "gameplay/register_components.hpp"
#include "gameplay/systems/timer_system.hpp"
#include "gameplay/systems/tween_system.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/transform.hpp"
#include "scene/register_components.hpp"
#include "scene/systems/physics_system.hpp"
#include "script/script_event.hpp"
#include "script/script_set.hpp"
#include "script/script_state.hpp"
#include "script/script_system.hpp"

namespace plumb {

inline TypeRegistry typesForScripts() {
    TypeRegistry types;
    registerSceneComponents(types);
    registerGameplayComponents(types);
    return types;
}

/// A world with scripts and the systems that they need. Lines of the log are collected.
class ScriptWorld : public ::testing::Test {
protected:
    using Texts = std::vector<std::pair<std::string, std::string>>;

    ScriptWorld() {
        before_ = setLogSink([this](const LogLine& line) { log.push_back(line.text); });
        world.provide(set);
        world.addSystem<TimerSystem>();
        world.addSystem<ScriptSystem>();
        world.addSystem<PhysicsSystem>();
        world.addSystem<ScriptEventSystem>();
        world.addSystem<TweenSystem>();
    }
    ~ScriptWorld() override { setLogSink(before_); }

    /// Makes these the scripts of the world, as a reload does.
    void use(const Texts& texts) {
        std::vector<std::pair<TypeInfo, TypeInfo>> changed;
        problems.clear();
        set.readTexts(texts, problems);
        for (const ScriptSet::File& file : set.files()) {
            if (!file.type) continue;
            const TypeInfo* known = types.find(file.type->name);
            if (known != nullptr) changed.emplace_back(*known, *file.type);
            updateComponentType(types.update(*file.type));
        }
        for (const auto& [old, now] : changed) world.convert(old, types.find(now.name));
    }
    /// Uses one script, `scripts/thing.lua`, whose functions are those of the table Thing, and adds it to an
    /// entity.
    EntityId thing(const std::string& functions, const std::string& properties = "") {
        use({{"thing", "local Thing = script {" + properties + "}\n" + functions + "\nreturn Thing"}});
        return add("Thing");
    }
    EntityId add(std::string_view script, Vec2 position = {}) {
        const EntityId entity = world.createEntity().id();
        world.add<Transform>(entity, position);
        world.add<Name>(entity, Name{world.texts().add("Anna")});
        const TypeInfo* type = types.find(script);
        EXPECT_NE(type, nullptr) << script;
        if (type != nullptr) world.add(*type, entity);
        return entity;
    }

    void run(int ticks = 1) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            world.update(1.0f / 60.0f);
        }
    }

    [[nodiscard]] std::string logText() const {
        std::string all;
        for (const std::string& line : log) all += line + "\n";
        return all;
    }
    template <class T>
    [[nodiscard]] T property(EntityId entity, std::string_view name,
                             std::string_view script = "Thing") const {
        const TypeInfo* type = types.find(script);
        T value{};
        std::memcpy(&value, type->find(name)->in(std::as_const(world).find(*type, entity)), sizeof value);
        return value;
    }
    [[nodiscard]] float x(EntityId entity) const { return world.get<Transform>(entity).position.x; }

    ScriptSet set;
    std::vector<Error> problems;
    TypeRegistry types = typesForScripts();
    World world{types};
    std::vector<std::string> log;

private:
    LogSink before_;
};

}  // namespace plumb
