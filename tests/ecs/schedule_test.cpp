#include "ecs/schedule.hpp"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace plumb
