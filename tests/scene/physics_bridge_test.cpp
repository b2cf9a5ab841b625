#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "core/log.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "physics/model/bodies.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/bodies/static_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/contact_events.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_queries.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/physics_units.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {
namespace {

constexpr float kTick = 1.0f / 60.0f;  // s

void run(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        world.beginTick();
        world.update(kTick);
    }
}

Entity falling(World& world, Vec2 at, float size = 10) {
    Entity entity = world.createEntity();
    entity.addComponent<Transform>(at.x, at.y);
    entity.addComponent<RigidBody>();
    entity.addComponent<BoxCollider>(size, size);
    return entity;
}

Entity ground(World& world, Vec2 at, float width, float height) {
    Entity entity = world.createEntity();
    entity.addComponent<Transform>(at.x, at.y);
    entity.addComponent<BoxCollider>(width, height);
    entity.addComponent<StaticBody>();
    return entity;
}

TEST(PhysicsBridge, aBodyFallsOntoTheGround) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity ball = falling(world, {100, 0});
    ground(world, {0, 500}, 1000, 20);
    run(world, 300);
    EXPECT_NEAR(ball.get<Transform>().position.y, 490.0f, 0.1f);
    EXPECT_TRUE(ball.get<RigidBody>().grounded);
    EXPECT_EQ(ball.get<RigidBody>().velocity, (Vec2{}));
}

TEST(PhysicsBridge, theThreeSystemsOfTheSampleAreOneStep) {
    World world;
    world.addSystem<GravitySystem>();
    world.addSystem<MovementSystem>();
    world.addSystem<CollisionSystem>();
    const Entity ball = falling(world, {100, 0});
    ground(world, {0, 500}, 1000, 20);
    run(world, 30);
    EXPECT_NEAR(ball.get<RigidBody>().velocity.y, PhysicsSettings::kGravity.y * 0.5f, 0.5f);
    run(world, 240);
    EXPECT_TRUE(ball.get<RigidBody>().grounded);
}

TEST(PhysicsBridge, gravityWithoutMotionIsThatOfTheScene) {
    World world;
    world.addSystem<GravitySystem>();
    Entity rules = world.createEntity();
    rules.addComponent<ScenePhysics>().gravity = {30, 300};
    const Entity ball = falling(world, {100, 0});
    run(world, 60);
    EXPECT_NEAR(ball.get<RigidBody>().velocity.x, 30.0f, 0.01f);
    EXPECT_NEAR(ball.get<RigidBody>().velocity.y, 300.0f, 0.1f);
    EXPECT_EQ(ball.get<Transform>().position, (Vec2{100, 0}));
}

TEST(PhysicsBridge, effectsThatAreNotRequiredDoNotRun) {
    World world;
    world.addSystem<MovementSystem>();
    const Entity ball = falling(world, {100, 0});
    ball.get<RigidBody>().velocity = {60, 0};
    ground(world, {105, -50}, 20, 100);
    run(world, 60);
    EXPECT_FLOAT_EQ(ball.get<Transform>().position.x, 160.0f) << "without contacts it passes the wall";
    EXPECT_FLOAT_EQ(ball.get<Transform>().position.y, 0.0f) << "no gravity";
    EXPECT_TRUE(world.resource<PhysicsState>().world.contacts.empty());
}

TEST(PhysicsBridge, pixelPositionsAreConvertedExactly) {
    World world;
    world.addSystem<PhysicsSystem>();
    Random random = Random::seeded(4);
    std::vector<std::pair<Entity, Vec2>> still;
    for (int i = 0; i < 500; ++i) {
        const Vec2 at{random.between(-5000, 5000), random.between(-5000, 5000)};
        Entity entity = falling(world, at, 1);
        entity.get<RigidBody>().gravityScale = 0;
        entity.get<BoxCollider>().mask = 0;
        still.emplace_back(entity, at);
    }
    run(world, 10);
    for (const auto& [entity, at] : still) EXPECT_EQ(entity.get<Transform>().position, at);
}

TEST(PhysicsBridge, bodiesAreCreatedAndDestroyedWithTheirComponents) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity ball = falling(world, {0, 0});
    const Entity floor = ground(world, {-50, 20}, 100, 10);
    run(world, 30);
    EXPECT_EQ(physics::bodyCount(world.resource<PhysicsState>().world), 2u);
    floor.removeComponent<BoxCollider>();
    run(world, 30);
    EXPECT_GT(ball.get<Transform>().position.y, 20.0f);
    EXPECT_EQ(physics::bodyCount(world.resource<PhysicsState>().world), 1u);
    ball.destroy();
    run(world, 1);
    EXPECT_EQ(physics::bodyCount(world.resource<PhysicsState>().world), 0u);
}

TEST(PhysicsBridge, aColliderWithoutABodyIsStatic) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity ball = falling(world, {0, 0});
    Entity wall = world.createEntity();
    wall.addComponent<Transform>(-50.0f, 50.0f);
    wall.addComponent<BoxCollider>(100, 10);
    run(world, 120);
    EXPECT_NEAR(ball.get<Transform>().position.y, 40.0f, 0.1f);
}

TEST(PhysicsBridge, movingATransformMovesTheBody) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity ball = falling(world, {0, 0});
    const Entity floor = ground(world, {-50, 20}, 100, 10);
    run(world, 60);
    teleport(ball.get<Transform>(), {0, -200});
    run(world, 1);
    EXPECT_NEAR(ball.get<Transform>().position.y, -200.0f, 1.0f);
    floor.get<Transform>().position.y = -100;
    run(world, 120);
    EXPECT_NEAR(ball.get<Transform>().position.y, -110.0f, 0.1f);
}

TEST(PhysicsBridge, contactsBeginOnceStayAndEnd) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity ball = falling(world, {0, 0});
    ball.get<RigidBody>().canSleep = false;  // a sleeping body repeats no events
    const Entity floor = ground(world, {-50, 20}, 100, 10);
    int began = 0;
    int stayed = 0;
    for (int i = 0; i < 60; ++i) {
        run(world, 1);
        for (const ContactBegan& event : world.events<ContactBegan>()) {
            ++began;
            const bool ballFirst = event.a == ball.id();
            EXPECT_EQ(ballFirst ? event.b : event.a, floor.id());
            EXPECT_NEAR(event.normal.y, ballFirst ? 1.0f : -1.0f, 1e-5f);
            EXPECT_NEAR(event.point.y, 20.0f, 0.1f);
        }
        stayed += static_cast<int>(world.events<ContactStayed>().size());
    }
    EXPECT_EQ(began, 1);
    EXPECT_GT(stayed, 30);
    floor.destroy();
    run(world, 1);
    EXPECT_EQ(world.events<ContactEnded>().size(), 1u);
}

TEST(PhysicsBridge, triggersReportEnterAndExit) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity ball = falling(world, {0, 0});
    Entity coin = world.createEntity();
    coin.addComponent<Transform>(5.0f, 50.0f);
    coin.addComponent<CircleCollider>(4.0f).isTrigger = true;
    int entered = 0;
    int left = 0;
    for (int i = 0; i < 60; ++i) {
        run(world, 1);
        for (const TriggerEntered& event : world.events<TriggerEntered>()) {
            ++entered;
            EXPECT_EQ(event.trigger, coin.id());
            EXPECT_EQ(event.other, ball.id());
        }
        left += static_cast<int>(world.events<TriggerLeft>().size());
    }
    EXPECT_EQ(entered, 1);
    EXPECT_EQ(left, 1);
}

TEST(PhysicsBridge, destroyingTouchedEntitiesInTheEventLoopIsSafe) {
    World world;
    world.addSystem<PhysicsSystem>();
    for (int i = 0; i < 50; ++i) falling(world, {static_cast<float>(i) * 12.0f, 0});
    ground(world, {-50, 20}, 1000, 10);
    run(world, 30);
    std::size_t killed = 0;
    for (int i = 0; i < 60; ++i) {
        run(world, 1);
        for (const ContactStayed& event : world.events<ContactStayed>()) {
            const EntityId body = world.has<RigidBody>(event.a) ? event.a : event.b;
            if (killed < 50 && world.alive(body)) world.destroy(body), ++killed;
        }
    }
    EXPECT_EQ(killed, 50u);
    EXPECT_EQ(physics::bodyCount(world.resource<PhysicsState>().world), 1u);
}

TEST(PhysicsBridge, childrenCollideWhereTheyAreInTheWorld) {
    World world;
    world.addSystem<PhysicsSystem>();
    Entity parent = world.createEntity();
    parent.addComponent<Transform>(0.0f, 100.0f);
    const Entity child = ground(world, {-50, 20}, 100, 10);
    setParent(world, child, parent);
    const Entity ball = falling(world, {0, 0});
    run(world, 120);
    EXPECT_NEAR(ball.get<Transform>().position.y, 110.0f, 0.1f);
}

/// Position of the entity's body, px.
Vec2 bodyPlace(World& world, Entity entity) {
    const auto& state = world.resource<PhysicsState>();
    return positionInPixels(physics::positionOf(state.world, bodyOf(state, entity.id())), state.scale);
}

void expectWhereItIs(World& world, Entity entity) {
    const Vec2 place = worldPose(world, entity.id()).position;
    EXPECT_NEAR(bodyPlace(world, entity).x, place.x, 0.01f);
    EXPECT_NEAR(bodyPlace(world, entity).y, place.y, 0.01f);
}

// Of a thousand entities with parents, exactly the descendants of a moved entity are updated, at any depth;
// all of them if it is the ancestor of all.
TEST(PhysicsBridge, bodiesMoveWithAnyAncestor) {
    World world;
    world.addSystem<PhysicsSystem>();
    const auto place = [&](Entity parent, Vec2 at) {
        Entity made = world.createEntity();
        made.addComponent<Transform>(at);
        if (parent) setParent(world, made, parent);
        return made;
    };
    Entity whole = place({}, {10, 10});
    std::vector<Entity> arms;
    std::vector<Entity> hands;
    for (int i = 0; i < 1000; ++i) {
        arms.push_back(place(whole, {static_cast<float>(i) * 50.0f, 0.0f}));
        const Entity elbow = place(arms.back(), {0.0f, 20.0f});
        hands.push_back(ground(world, {0, 20}, 10, 10));
        setParent(world, hands.back(), elbow);
    }
    run(world, 2);
    for (const std::size_t i : {3u, 600u, 999u}) {
        arms[i].get<Transform>().position.y = 500.0f;
        run(world, 1);
        expectWhereItIs(world, hands[i]);
        EXPECT_NEAR(bodyPlace(world, hands[i]).y, 550.0f, 0.01f);
    }
    expectWhereItIs(world, hands[4]);
    whole.get<Transform>().position.x = 7.0f;
    run(world, 1);
    for (const Entity hand : hands) expectWhereItIs(world, hand);
}

TEST(PhysicsBridge, bodiesMoveWithAFallingParent) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity body = falling(world, {0, 0});
    Entity sign = world.createEntity();
    sign.addComponent<Transform>(100.0f, 0.0f);
    sign.addComponent<BoxCollider>(10.0f, 10.0f);
    setParent(world, sign, body);
    for (int i = 0; i < 30; ++i) {
        const Vec2 before = worldPose(world, sign.id()).position;
        run(world, 1);
        if (i > 0) {
            EXPECT_NEAR(bodyPlace(world, sign).y, before.y, 0.01f) << "follows by one tick";
        }
    }
    EXPECT_GT(bodyPlace(world, sign).y, 50.0f);
}

TEST(PhysicsBridge, tileLayersAreSolidAndFollowChanges) {
    World world;
    world.addSystem<PhysicsSystem>();
    TileGrid grid{20, 4};
    for (int x = 0; x < 20; ++x) grid.set(x, 3, cellOf(0));
    Entity level = world.createEntity();
    level.addComponent<Transform>(0.0f, 0.0f);
    level.addComponent<TileLayer>().cells = world.tiles().add(grid);
    level.addComponent<TileCollider>();
    const Entity ball = falling(world, {40, 0});
    run(world, 60);
    EXPECT_NEAR(ball.get<Transform>().position.y, 38.0f, 0.1f);
    const auto* before = world.resource<PhysicsState>().terrains[0].outlines.get();
    run(world, 10);
    EXPECT_EQ(world.resource<PhysicsState>().terrains[0].outlines.get(), before)
        << "outlines of an unchanged grid are kept";
    TileGrid& edited = *world.tiles().edit(level.get<TileLayer>().cells);
    for (int x = 0; x < 20; ++x) edited.set(x, 3, 0);
    run(world, 30);
    EXPECT_GT(ball.get<Transform>().position.y, 60.0f);
}

TEST(PhysicsBridge, concaveTilesAndTilesOfSeveralPolygonsHoldWhatFallsIntoThem) {
    World world;
    AssetStore assets{"."};
    world.provide(assets);
    world.addSystem<PhysicsSystem>();
    Tileset tileset;
    tileset.count = 3;
    const std::vector<std::vector<Vec2>> cup{
        {{0, 0}, {3, 0}, {3, 12}, {13, 12}, {13, 0}, {16, 0}, {16, 16}, {0, 16}}};
    const std::vector<std::vector<Vec2>> parts{{{0, 0}, {3, 0}, {3, 14}, {0, 14}},
                                               {{13, 0}, {16, 0}, {16, 14}, {13, 14}},
                                               {{0, 12}, {16, 12}, {16, 16}, {0, 16}}};
    const std::vector<std::vector<Vec2>> outside{{{0, 0}, {40, 0}, {0, 16}}};
    for (const auto& polygons : {cup, parts, outside}) {
        Tile tile;
        tile.id = static_cast<int>(tileset.tiles.size());
        tile.shape = TileShape::Polygon;
        tile.polygons = polygons;
        tileset.tiles.push_back(tile);
    }
    TileGrid grid{20, 4};
    grid.set(2, 3, cellOf(0));
    grid.set(5, 3, cellOf(1));
    grid.set(8, 3, cellOf(0, kTileFlipY));
    Entity level = world.createEntity();
    level.addComponent<Transform>(0.0f, 0.0f);
    TileLayer& layer = level.addComponent<TileLayer>();
    layer.tileset = assets.addTileset("test", tileset);
    layer.cells = world.tiles().add(grid);
    const TilesId cells = layer.cells;
    level.addComponent<TileCollider>();
    const Entity inCup = falling(world, {40, 30}, 4);
    const Entity inParts = falling(world, {88, 30}, 4);
    const Entity onTop = falling(world, {136, 30}, 4);
    run(world, 60);
    EXPECT_NEAR(inCup.get<Transform>().position.y, 56.0f, 0.1f);
    EXPECT_NEAR(inParts.get<Transform>().position.y, 56.0f, 0.1f);
    EXPECT_NEAR(onTop.get<Transform>().position.y, 44.0f, 0.1f);
    EXPECT_EQ(world.reports().count(), 0u);

    world.tiles().edit(cells)->set(11, 3, cellOf(2));
    run(world, 1);
    EXPECT_EQ(world.reports().count(), 1u) << "a tile whose polygon leaves the cell is reported";
}

TEST(PhysicsBridge, aSnapshotReplaysEqually) {
    World world;
    world.addSystem<PhysicsSystem>();
    Random random = Random::seeded(9);
    for (int i = 0; i < 60; ++i) {
        Entity e = falling(world, {random.between(0, 300), random.between(-300, 0)}, random.between(5, 20));
        e.get<RigidBody>().bounciness = random.unit();
    }
    ground(world, {-50, 20}, 500, 10);
    run(world, 40);
    const Snapshot saved = world.save();
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 60; ++i) run(world, 1), hashes.push_back(world.hash());
    world.restore(saved);
    for (int i = 0; i < 60; ++i) {
        run(world, 1);
        ASSERT_EQ(world.hash(), hashes[static_cast<std::size_t>(i)]) << i;
    }
}

TEST(PhysicsBridge, invalidNumbersAreReportedOnceAndStopNothing) {
    std::vector<LogLine> lines;
    const LogSink before = setLogSink([&](const LogLine& line) { lines.push_back(line); });
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity good = falling(world, {0, 0});
    const Entity bad = falling(world, {0, 0});
    bad.get<BoxCollider>().mask = 0;
    run(world, 1);
    bad.get<Transform>().position.x = std::numeric_limits<float>::quiet_NaN();
    bad.get<RigidBody>().velocity.x = std::numeric_limits<float>::infinity();
    const Entity born = falling(world, {std::numeric_limits<float>::infinity(), 0});
    run(world, 30);
    setLogSink(before);
    // One for the place and one for the velocity of `bad`, and one for the place of `born`.
    ASSERT_EQ(lines.size(), 3u);
    const auto mentions = [&](const Entity& entity, std::string_view field) {
        const std::string start = format("entity {}: {}", entity.id().index, field);
        return std::count_if(lines.begin(), lines.end(),
                             [&](const LogLine& line) { return line.text.starts_with(start); });
    };
    EXPECT_EQ(mentions(bad, "Transform.position"), 1);
    EXPECT_EQ(mentions(bad, "velocity"), 1);
    EXPECT_EQ(mentions(born, "Transform.position"), 1);
    EXPECT_TRUE(isFinite(bad.get<Transform>().position));
    EXPECT_TRUE(isFinite(bad.get<RigidBody>().velocity));
    EXPECT_TRUE(isFinite(good.get<Transform>().position));
    EXPECT_TRUE(born.alive());
}

TEST(PhysicsBridge, queriesUsePixels) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity wall = ground(world, {100, -50}, 20, 100);
    run(world, 1);
    syncBodies(world, kTick);
    const auto ray = castRay(world, {0, 0}, {200, 0});
    ASSERT_TRUE(ray.has_value());
    EXPECT_EQ(ray->entity, wall.id());
    EXPECT_NEAR(ray->point.x, 100.0f, 0.01f);
    const auto box = castBox(world, {{0, -5}, {10, 5}}, {200, 0});
    ASSERT_TRUE(box.has_value());
    EXPECT_NEAR(box->fraction, 0.45f, 1e-3f);
    std::vector<EntityId> found;
    overlapBox(world, {{90, 0}, {110, 5}}, {}, found);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], wall.id());
}

TEST(PhysicsBridge, boxesOfEverySizeAreSearched) {
    World world;
    world.addSystem<PhysicsSystem>();
    const Entity wall = ground(world, {100, -50}, 20, 100);
    run(world, 1);
    syncBodies(world, kTick);
    const std::vector<EntityId> all{wall.id()}, none;
    std::vector<EntityId> found;
    for (const float size : {1e3f, 1e6f, 1e8f, 1e10f, 1e12f, 3e38f}) {
        overlapBox(world, {{-size, -size}, {size, size}}, {}, found);
        EXPECT_EQ(found, all) << size;
        overlapBox(world, {{1000, -size}, {size + 1000, size}}, {}, found);
        EXPECT_EQ(found, none) << size;
    }
    overlapBox(world, {{110, -10}, {110, -10}}, {}, found);
    EXPECT_EQ(found, all) << "a point";
    overlapBox(world, {{0, 0}, {200, 0}}, {}, found);
    EXPECT_EQ(found, all) << "a line";
    overlapBox(world, {{0, 0}, {90, 0}}, {}, found);
    EXPECT_EQ(found, none);
    overlapBox(world, {{200, 0}, {0, 10}}, {}, found);
    EXPECT_EQ(found, none) << "a box without a size";
}

}  // namespace
}  // namespace plumb
