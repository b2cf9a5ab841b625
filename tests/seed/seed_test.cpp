#include <plumb.hpp>
using namespace plumb;
#include <gtest/gtest.h>

// Test AABB intersection
TEST(Collision, AABBIntersection) {
    AABB a{0, 0, 10, 10};
    AABB b{5, 5, 15, 15};
    AABB c{20, 20, 30, 30};

    EXPECT_TRUE(intersects(a, b));
    EXPECT_TRUE(intersects(b, a));
    EXPECT_FALSE(intersects(a, c));
}

// Test component storage
TEST(ECS, ComponentStorage) {
    World world;
    Entity e = world.createEntity();

    e.addComponent<Transform>(10.0f, 20.0f);
    EXPECT_TRUE(e.hasComponent<Transform>());
    EXPECT_FLOAT_EQ(e.get<Transform>().position.x, 10.0f);

    e.removeComponent<Transform>();
    EXPECT_FALSE(e.hasComponent<Transform>());
}

// Test entity queries
TEST(ECS, SystemQuery) {
    World world;
    Entity e1 = world.createEntity();
    Entity e2 = world.createEntity();

    e1.addComponent<Transform>();
    e1.addComponent<Sprite>();
    e2.addComponent<Transform>();
    // e2 has no Sprite

    int count = 0;
    for (auto [entity, transform, sprite] :
         world.query<Transform, Sprite>()) {
        count++;
    }
    EXPECT_EQ(count, 1);
}

// Test physics simulation
TEST(Physics, GravityAndCollision) {
    Engine engine;
    World& world = engine.getWorld();

    // Create falling entity
    Entity ball = world.createEntity();
    ball.addComponent<Transform>(100.0f, 0.0f);
    ball.addComponent<RigidBody>();
    ball.addComponent<BoxCollider>(10, 10);

    // Create ground
    Entity ground = world.createEntity();
    ground.addComponent<Transform>(0.0f, 500.0f);
    ground.addComponent<BoxCollider>(1000, 20);
    ground.addComponent<StaticBody>();

    // Simulate 5 seconds
    for (int i = 0; i < 300; i++) {
        engine.fixedUpdate(1.0f / 60.0f);
    }

    // Ball should have fallen and stopped on ground
    auto& t = ball.get<Transform>();
    EXPECT_GT(t.position.y, 400.0f);
    EXPECT_LT(t.position.y, 510.0f);
    EXPECT_TRUE(ball.get<RigidBody>().grounded);
}
