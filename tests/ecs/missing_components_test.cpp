#include <array>
#include <initializer_list>
#include <string_view>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "tests/ecs/parts.hpp"
#include "tests/support/faults.hpp"

// What is reported when get() is called for a component that the entity does not have.

namespace plumb {
namespace {

TEST(MissingComponents, aMissingComponentIsReportedWithItsNameTheEntityAndTheRemedy) {
    test::Faults faults;
    World world;
    Entity e = world.createEntity();
    const auto expect = [&](std::initializer_list<std::string_view> texts) {
        world.beginTick();  // builds without assertions report then
        for (const std::string_view text : texts)
            EXPECT_TRUE(faults.mention(text))
                << text << " is not in: " << testing::PrintToString(faults.lines());
        EXPECT_EQ(faults.lines().size(), 1u);
        faults.clear();
        world.reports().forget();
    };
    e.get<Numbered<8>>();
    expect({"Numbered<8> was requested from entity 1 (generation 1)", "an entity that has none",
            "all its fields are 0", "hasComponent<Numbered<8>>()", "find<Numbered<8>>()"});
    Entity{}.get<Position>();
    expect({"Position was requested from the empty handle", "if (entity)", "find<Position>()"});
    Entity{}.addComponent<Frozen>();
    expect({"Frozen was requested from the empty handle"});
    world.get<Position>(EntityId{});
    expect({"Position was requested from the empty handle"});
    e.destroy();
    e.get<Position>();
    expect({"entity 1 (generation 1)", "a stale handle", "check alive()", "find<Position>()"});
}

struct Idle {
    void update(World&, float) const {}
};
/// Requests components that are missing, in every tick.
struct Asker {
    std::array<EntityId, 2> entities;

    void update(World& world, float) const {
        for (int i = 0; i < 3; ++i) {
            for (const EntityId entity : entities) world.get<Numbered<8>>(entity);
            world.get<Numbered<9>>(entities[1]);
        }
    }
};
struct OtherAsker {
    void update(World&, float) const { Entity{}.get<Numbered<8>>(); }
};

TEST(MissingComponents, eachSystemReportsAMissingComponentOnceWithTheFirstEntity) {
    test::Faults faults;
    World world;
    world.addSystem<Asker>().entities = {world.createEntity().id(), world.createEntity().id()};
    world.addSystem<OtherAsker>();
    const auto run = [&] {
        for (int tick = 0; tick < 5; ++tick) {
            world.beginTick();
            world.update(0.0f);
        }
        ASSERT_EQ(faults.lines().size(), 3u) << testing::PrintToString(faults.lines());
        for (const char* line : {"Asker: Numbered<8> was requested from entity 1 ",
                                 "Asker: Numbered<9> was requested from entity 2 ",
                                 "OtherAsker: Numbered<8> was requested from the empty handle"})
            EXPECT_TRUE(faults.mention(line)) << line << ": " << testing::PrintToString(faults.lines());
    };
    run();
    faults.clear();
    world.reports().forget();  // as when another scene begins
    run();
}

TEST(MissingComponents, theReportsOfAWorldDoNotDependOnThoseOfAnother) {
    test::Faults faults;
    World world;
    const auto play = [](World& played) {
        if (!played.hasSystem<Asker>())
            played.addSystem<Asker>().entities = {played.createEntity().id(), played.createEntity().id()};
        played.addSystem<OtherAsker>();
        played.beginTick();
        played.update(0.0f);
    };
    play(world);
    EXPECT_EQ(faults.lines().size(), 3u);
    World ghost;  // as the editor plays one beside the game
    play(ghost);
    EXPECT_EQ(faults.lines().size(), 6u) << "its own, though the same were reported in the game";
    ghost.reports().forget();
    play(world);
    EXPECT_EQ(faults.lines().size(), 6u) << "those of the game stay reported";
}

TEST(MissingComponents, whatCodeBeforeTheSystemsMissesIsNotBlamedOnTheFirst) {
    test::Faults faults;
    World world;
    world.addSystem<Idle>();
    world.beginTick();
    world.get<Position>(world.createEntity());  // as onUpdate() of a game in code
    world.update(0.0f);
    ASSERT_EQ(faults.lines().size(), 1u);
    EXPECT_TRUE(startsWith(faults.lines()[0], "entity handle: Position was requested")) << faults.lines()[0];
}

}  // namespace
}  // namespace plumb
