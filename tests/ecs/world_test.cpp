#include "ecs/world.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace plumb {
namespace {

struct Position {
    float x = 0, y = 0;
    Position() = default;
    Position(float px, float py) : x{px}, y{py} {}
};
struct Velocity {
    float x = 0, y = 0;
};
struct Frozen {};

TEST(World, storesAndRemovesComponents) {
    World world;
    Entity e = world.createEntity();

    e.addComponent<Position>(10, 20);
    EXPECT_TRUE(e.hasComponent<Position>());
    EXPECT_FLOAT_EQ(e.get<Position>().x, 10.0f);

    e.removeComponent<Position>();
    EXPECT_FALSE(e.hasComponent<Position>());
}

TEST(World, queryVisitsThoseThatHaveAll) {
    World world;
    Entity e1 = world.createEntity();
    Entity e2 = world.createEntity();
    e1.addComponent<Position>();
    e1.addComponent<Velocity>(1.0f, 2.0f);
    e2.addComponent<Position>();
    e2.addComponent<Frozen>();

    int count = 0;
    for (auto [entity, position, velocity] : world.query<Position, Velocity>()) {
        count++;
    }
    EXPECT_EQ(count, 1);
    for (auto [entity, position, velocity] : world.query<Position, const Velocity>()) {
        position.x += velocity.x;
        EXPECT_EQ(entity, e1);
    }
    EXPECT_EQ(e1.get<Position>().x, 1.0f);
    EXPECT_EQ(world.query<const Position>(without<Frozen>).count(), 1u);
    EXPECT_EQ(world.query<const Position>(with<Frozen>).first(), e2);
    world.each<const Position, const Frozen>(
        [&](Entity entity, const Position&, const Frozen&) { EXPECT_EQ(entity, e2); });
    world.each<Position>([](Position& p) { p.x += 1; });
    EXPECT_EQ(e2.get<Position>().x, 1.0f);
    world.chunks<Position>([](std::size_t n, Position* p) {
        for (std::size_t i = 0; i < n; ++i) p[i].x = 7;
    });
    EXPECT_EQ(e2.get<Position>().x, 7.0f);
}

}  // namespace
}  // namespace plumb
