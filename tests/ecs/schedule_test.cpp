#include "ecs/schedule.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/profile.hpp"
#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

struct Diary {
    std::string text;
};

struct GravitySystem {
    void update(World& world, float) { world.resource<Diary>().text += 'g'; }
};
struct MoveSystem {
    float factor = 1.0f;
    void update(World& world, float dt) {
        world.resource<Diary>().text += 'm';
        for (auto [entity, position, velocity] : world.query<Position, const Velocity>()) {
            position.x += velocity.x * dt * factor;
        }
    }
};
struct NamedOne {
    static constexpr std::string_view kName = "draw";
    void update(World& world, float) { world.resource<Diary>().text += 'd'; }
};
struct Reaper {
    void update(World& world, float) {
        for (auto [entity, position] : world.query<const Position>()) world.commands().destroy(entity);
        EXPECT_GT(world.entityCount(), 0u) << "commands are applied after the system";
    }
};
struct Mourner {
    void update(World& world, float) { EXPECT_EQ(world.entityCount(), 0u); }
};

TEST(ScheduleTest, systemsRunInTheOrderOfAdding) {
    World world;
    world.addSystem<GravitySystem>();
    world.addSystem<MoveSystem>(2.0f);
    world.addSystem<NamedOne>();
    fillWithMovers(world, 1);

    world.update(0.5f);

    EXPECT_EQ(world.resource<Diary>().text, "gmd");
    EXPECT_EQ(world.query<Position>().first().get<Position>().x, 1.0f);
    EXPECT_TRUE(world.hasSystem<MoveSystem>());
    EXPECT_FALSE(world.hasSystem<Reaper>());
    EXPECT_EQ(world.findSystem<MoveSystem>()->factor, 2.0f);
}

TEST(ScheduleTest, aListOfNamesDeterminesTheOrder) {
    World world;
    constexpr std::array<std::string_view, 3> kOrder = {"draw", "NoSuchSystem", "MoveSystem"};
    world.addSystem<GravitySystem>();
    world.setSystemOrder(kOrder);
    world.addSystem<MoveSystem>();
    world.addSystem<NamedOne>();
    EXPECT_EQ(world.systemNames(), (std::vector<std::string_view>{"draw", "MoveSystem", "GravitySystem"}));
    world.update(1.0f);
    EXPECT_EQ(world.resource<Diary>().text, "dmg");
}

TEST(ScheduleTest, aSystemIsAddedOnce) {
    World world;
    MoveSystem& first = world.addSystem<MoveSystem>(3.0f);
    EXPECT_EQ(&world.addSystem<MoveSystem>(), &first);
    EXPECT_EQ(first.factor, 3.0f);
    EXPECT_EQ(world.systemNames().size(), 1u);
}

TEST(ScheduleTest, commandsAreAppliedAfterEachSystem) {
    World world;
    world.addSystem<Reaper>();
    world.addSystem<Mourner>();
    fillWithMovers(world, 7);
    world.update(1.0f);
    EXPECT_EQ(world.entityCount(), 0u);
}

TEST(CommandBufferTest, appliesCommandsInOrderAndSkipsDestroyedEntities) {
    World world;
    Entity a = world.createEntity();
    Entity b = world.createEntity();
    CommandBuffer commands;
    commands.add(a, Position{1.0f, 0.0f});
    commands.add(a, Position{2.0f, 0.0f});
    commands.add<Frozen>(a);
    commands.remove<Frozen>(a);
    commands.destroy(b);
    commands.add(b, Position{});
    EXPECT_FALSE(a.hasComponent<Position>());

    commands.flush(world);

    EXPECT_EQ(a.get<Position>().x, 2.0f);
    EXPECT_FALSE(a.hasComponent<Frozen>());
    EXPECT_FALSE(b.alive());
    EXPECT_TRUE(commands.empty());
}

struct Hit {
    int damage = 0;
};
struct Saved {};

TEST(EventsTest, existForOneTick) {
    World world;
    EXPECT_TRUE(world.events<Hit>().empty());
    world.beginTick();
    world.emit(Hit{3});
    world.emit(Hit{4});
    world.emit(Saved{});
    ASSERT_EQ(world.events<Hit>().size(), 2u);
    EXPECT_EQ(world.events<Hit>()[1].damage, 4);
    EXPECT_EQ(world.events<Saved>().size(), 1u);

    world.beginTick();
    EXPECT_TRUE(world.events<Hit>().empty());
    EXPECT_EQ(world.tick, 2u);
}

TEST(ServiceTest, isProvidedAndReplaceable) {
    World world;
    Diary one;
    Diary two;
    EXPECT_EQ(world.service<Diary>(), nullptr);
    world.provide(one);
    EXPECT_EQ(world.service<Diary>(), &one);
    world.provide(two);
    EXPECT_EQ(world.service<Diary>(), &two);
}

TEST(ScheduleTest, everyOrderOfNamesAndOfAddingGivesTheNamedOnesFirst) {
    std::vector<std::string_view> names{"GravitySystem", "MoveSystem", "draw"};
    const auto add = [](World& world, std::string_view name) {
        if (name == "draw") {
            world.addSystem<NamedOne>();
        } else if (name == "MoveSystem") {
            world.addSystem<MoveSystem>();
        } else {
            world.addSystem<GravitySystem>();
        }
    };
    std::vector<std::string_view> added = names;
    do {
        do {
            for (std::size_t listed = 0; listed <= names.size(); ++listed) {
                World world;
                for (const std::string_view name : added) add(world, name);
                const std::span<const std::string_view> order{names.data(), listed};
                world.setSystemOrder(order);
                std::vector<std::string_view> expected{order.begin(), order.end()};
                for (const std::string_view name : added) {
                    if (std::find(order.begin(), order.end(), name) == order.end()) expected.push_back(name);
                }
                ASSERT_EQ(world.systemNames(), expected);
            }
        } while (std::next_permutation(names.begin(), names.end()));
    } while (std::next_permutation(added.begin(), added.end()));
}

TEST(ScheduleTest, aRemovedSystemIsGoneAndComesBackAsTheLastOne) {
    World world;
    world.addSystem<GravitySystem>();
    world.addSystem<MoveSystem>();
    world.addSystem<NamedOne>();
    world.removeSystem(typeKey<MoveSystem>());
    world.removeSystem(typeKey<Reaper>());  // there is none
    EXPECT_EQ(world.findSystem<MoveSystem>(), nullptr);
    EXPECT_EQ(world.systemNames(), (std::vector<std::string_view>{"GravitySystem", "draw"}));
    world.update(1.0f);
    EXPECT_EQ(world.resource<Diary>().text, "gd");
    world.addSystem<MoveSystem>();
    EXPECT_EQ(world.systemNames(), (std::vector<std::string_view>{"GravitySystem", "draw", "MoveSystem"}));
}

TEST(ScheduleTest, everyRunOfASystemIsMeasured) {
    World world;
    Profile profile;
    world.provide(profile);
    world.addSystem<GravitySystem>();
    world.addSystem<NamedOne>();
    for (int i = 0; i < 3; ++i) world.update(1.0f);
    ASSERT_EQ(profile.zones().size(), 2u);
    EXPECT_EQ(profile.zones()[0].name, "GravitySystem");
    EXPECT_EQ(profile.zones()[1].name, "draw");
    EXPECT_EQ(profile.zones()[0].calls, 3);
    EXPECT_EQ(profile.zones()[1].calls, 3);
}

TEST(CommandBufferTest, componentsOfAnySizeKeepTheirValues) {
    World world;
    std::vector<Entity> entities;
    CommandBuffer commands;
    for (int i = 0; i < 20; ++i) {
        entities.push_back(world.createEntity());
        const float value = static_cast<float>(i);
        if (i % 3 == 0) commands.add(entities.back(), Numbered<1>{i});
        commands.add(entities.back(), Position{value, -value});
        if (i % 2 == 0) commands.add(entities.back(), Health{i, i + 1, i + 2});
        commands.add<Frozen>(entities.back());
    }
    EXPECT_FALSE(commands.empty());
    commands.flush(world);
    for (int i = 0; i < 20; ++i) {
        const Entity entity = entities[static_cast<std::size_t>(i)];
        EXPECT_EQ(entity.get<Position>().y, -static_cast<float>(i));
        ASSERT_EQ(entity.hasComponent<Health>(), i % 2 == 0);
        ASSERT_EQ(entity.hasComponent<Numbered<1>>(), i % 3 == 0);
        if (i % 2 == 0) {
            EXPECT_EQ(entity.get<Health>().shield, i + 2);
        }
        if (i % 3 == 0) {
            EXPECT_EQ(entity.get<Numbered<1>>().value, i);
        }
        EXPECT_TRUE(entity.hasComponent<Frozen>());
    }
}

}  // namespace
}  // namespace plumb
