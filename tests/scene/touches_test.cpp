#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/physics/contact_events.hpp"
#include "scene/physics/physics_queries.hpp"
#include "tests/scene/physics_scene.hpp"

// Which entities an entity touches at present.

namespace plumb {
namespace {

std::vector<EntityId> touches(const PhysicsScene& scene, Entity entity) {
    std::vector<EntityId> found{EntityId{99, 1}};  // is replaced
    touchesOf(scene.world, entity, found);
    return found;
}

TEST(Touches, areThoseOfTheLastStepAlsoWhileBothSleep) {
    PhysicsScene scene;
    const Entity floor = scene.floor({-100, 20}, {200, 20});
    const Entity crate = scene.crate({0, 0});
    EXPECT_TRUE(touches(scene, crate).empty());
    scene.run(600);
    EXPECT_EQ(touches(scene, crate), std::vector<EntityId>{floor.id()});
    EXPECT_EQ(touches(scene, floor), std::vector<EntityId>{crate.id()});
    EXPECT_TRUE(isTouching(scene.world, floor, crate) && isTouching(scene.world, crate, floor));
    crate.get<Transform>().position.y = -200.0f;
    scene.run(2);
    EXPECT_TRUE(touches(scene, crate).empty());
    EXPECT_FALSE(isTouching(scene.world, floor, crate));
}

TEST(Touches, includeTriggersAndWhatIsInThem) {
    PhysicsScene scene;
    const Entity zone = scene.floor({-50, -50}, {100, 100});
    zone.get<BoxCollider>().isTrigger = true;
    const Entity ball = scene.ball({0, 0});
    scene.run(2);
    EXPECT_EQ(touches(scene, zone), std::vector<EntityId>{ball.id()});
    EXPECT_EQ(touches(scene, ball), std::vector<EntityId>{zone.id()});
}

TEST(Touches, areNotWhatABodyPassesThrough) {
    PhysicsScene scene;
    const Entity platform = scene.floor({-100, 0}, {200, 4});
    platform.get<BoxCollider>().oneWay = true;
    const Entity ball = scene.ball({0, 30});
    ball.get<RigidBody>().velocity = {0.0f, -400.0f};
    bool crossed = false;
    for (int i = 0; i < 12; ++i) {
        scene.run(1);
        crossed = crossed || std::abs(ball.get<Transform>().position.y - 2.0f) < 4.0f;
        EXPECT_TRUE(touches(scene, ball).empty()) << i;
        EXPECT_FALSE(isTouching(scene.world, platform, ball)) << i;
    }
    EXPECT_TRUE(crossed);
}

TEST(Touches, ofTileLayersAreThoseOfTheirTiles) {
    PhysicsScene scene;
    TileGrid grid{20, 4};
    for (int x = 0; x < 20; ++x) grid.set(x, 3, cellOf(0));
    const Entity level = scene.at({0, 0});
    level.addComponent<TileLayer>().cells = scene.world.tiles().add(grid);
    level.addComponent<TileCollider>();
    const Entity ball = scene.ball({40, 30});
    scene.run(60);
    EXPECT_EQ(touches(scene, level), std::vector<EntityId>{ball.id()});
    EXPECT_EQ(touches(scene, ball), std::vector<EntityId>{level.id()});
    EXPECT_TRUE(isTouching(scene.world, level, ball) && isTouching(scene.world, ball, level));
}

TEST(Touches, areNotOfDestroyedEntities) {
    PhysicsScene scene;
    const Entity floor = scene.floor({-100, 16}, {200, 20});
    const Entity crate = scene.crate({0, 0});
    scene.run(30);
    crate.destroy();
    EXPECT_TRUE(touches(scene, floor).empty());
    EXPECT_TRUE(touches(scene, crate).empty());
}

TEST(Touches, agreeWithTheEventsOfAPileInEveryTick) {
    PhysicsScene scene;
    scene.floor({-200, 200}, {400, 20});
    std::vector<Entity> bodies;
    for (int i = 0; i < 24; ++i)
        bodies.push_back(scene.ball({static_cast<float>(i % 5) * 11.0f, static_cast<float>(i) * -9.0f}));
    using Pair = std::pair<EntityId, EntityId>;
    std::vector<Pair> known;
    std::size_t most = 0;
    for (int tick = 0; tick < 200; ++tick) {
        scene.run(1);
        for (const ContactBegan& contact : scene.world.events<ContactBegan>())
            known.emplace_back(std::min(contact.a, contact.b), std::max(contact.a, contact.b));
        for (const ContactEnded& contact : scene.world.events<ContactEnded>())
            std::erase(known, Pair{std::min(contact.a, contact.b), std::max(contact.a, contact.b)});
        std::vector<Pair> found;
        for (const Entity body : bodies) {
            for (const EntityId other : touches(scene, body))
                found.emplace_back(std::min(body.id(), other), std::max(body.id(), other));
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        std::sort(known.begin(), known.end());
        ASSERT_EQ(found, known) << tick;
        most = std::max(most, found.size());
    }
    EXPECT_GT(most, 20u);
}

}  // namespace
}  // namespace plumb
