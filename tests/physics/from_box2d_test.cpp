#include <algorithm>
#include <sstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/task_pool.hpp"
#include "physics/character/character_controller.hpp"
#include "physics/continuous/sweep.hpp"
#include "physics/debug_draw.hpp"
#include "physics/islands/island_report.hpp"
#include "physics/measure/snapshot.hpp"
#include "physics/model/fields.hpp"
#include "physics/model/shape_wind.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/queries/lists.hpp"
#include "physics/queries/overlap.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/queries/shape_cast.hpp"
#include "physics/shapes/hull.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/simulation.hpp"
#include "tests/physics/support/recording_canvas.hpp"
#include "tests/support/places.hpp"

// The examples of docs/from-box2d.md, verbatim between `// doc` and `// end`; the last test compares them
// with the file.

namespace plumb::physics {
namespace {

constexpr float kDt = 1.0f / 60.0f;  // s

struct Scene {
    World world;
    BodyId ground, crate;
    ShapeId floor, box;

    Scene() {
        ground = *createBody(world, {.kind = BodyKind::Static, .position = {0.0, 1.0}});
        floor = *createShape(world, ground, physics::box({50.0f, 1.0f}));
        crate = *createBody(world, {.position = {0.0, -0.5}});
        box = *createShape(world, crate, physics::box({0.5f, 0.5f}));
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) step(world, kDt);
    }
};

TEST(FromBox2d, worlds) {
    // doc
    World world;
    world.settings.gravity = {0.0f, -10.0f};  // y points up, as usual with Box2D
    world.settings.bounceSpeed = 1.0f;        // b2World_SetRestitutionThreshold
    const World before = world;               // a copy is a snapshot, and destroys itself
    step(world, 1.0f / 60.0f);
    world = before;
    // end
    EXPECT_EQ(hashOf(world), hashOf(before));
}

TEST(FromBox2d, bodies) {
    World world;
    // doc
    const BodyId body = *createBody(world, {.kind = BodyKind::Kinematic, .position = {0.0, 5.0}, .user = 42});
    const ShapeId shape = *createShape(world, body, box({0.5f, 0.5f}));
    (void)setKind(world, body, BodyKind::Dynamic);  // b2Body_SetType
    (void)setMassData(world, body, {.mass = 2.0f, .centre = {0.0f, 0.1f}, .inertia = 0.5f});
    (void)applyAngularImpulse(world, body, 1.0f);
    const Vec2 speed = velocityAt(world, body, worldPoint(world, body, {0.5f, 0.0f}));
    setEnabled(world, body, false);  // b2Body_Disable
    // end
    EXPECT_NEAR(speed.y, 1.0f, 1e-5f);
    EXPECT_TRUE(alive(world, shape));
    EXPECT_FALSE(isEnabled(world, body));
    EXPECT_EQ(massOf(world, body), 2.0f);
}

TEST(FromBox2d, shapes) {
    Scene scene;
    World& world = scene.world;
    const ShapeId shape = scene.box;
    // doc
    (void)setGeometry(world, shape, circle(0.5f));  // b2Shape_SetCircle
    (void)change(world, shape, [](ShapeDefinition& definition) {
        definition.density = 3.0f;  // b2Shape_SetDensity, and so on for everything in the definition
        definition.rollingResistance = 0.1f;
        definition.isTrigger = false;
    });
    // end
    EXPECT_EQ(definitionOf(world, shape).density, 3.0f);
    EXPECT_EQ(world.shapes.geometry[shape.index].kind, ShapeKind::Circle);
}

TEST(FromBox2d, chains) {
    World world;
    const BodyId ground = *createBody(world, {.kind = BodyKind::Static});
    // doc
    const Vec2 points[] = {{-9.0f, 0.0f}, {-8.0f, 0.0f}, {0.0f, 0.0f}, {8.0f, 1.0f}, {9.0f, 1.0f}};
    const ShapeDefinition materials[] = {{.friction = 0.6f}, {.friction = 0.05f}};  // one for each segment
    const ShapeId chain = *createChain(world, ground, points, false, materials);
    std::vector<ShapeId> segments;
    segmentsOf(world, chain, segments);
    (void)setFriction(world, segments[1], 0.3f);  // b2Chain_SetSurfaceMaterial
    destroyChain(world, chain);
    // end
    EXPECT_EQ(segments.size(), 2u);
    EXPECT_FALSE(alive(world, segments[1]));
}

TEST(FromBox2d, joints) {
    Scene scene;
    World& world = scene.world;
    const BodyId ground = scene.ground, crate = scene.crate;
    (void)setPosition(world, crate, {0.0, -5.0}, 0.0f);
    // doc
    const JointId hinge = *createJoint(world, {.kind = JointKind::Revolute,
                                               .a = ground,
                                               .b = crate,
                                               .anchorA = {0.0f, -6.0f},
                                               .motor = {true, 2.0f, 500.0f},  // rad/s, N m
                                               .reportForce = 1.0f});          // b2Joint_SetForceThreshold
    step(world, 1.0f / 60.0f);
    const JointReading now = readingOf(world, hinge);  // angle, speed, motor force, separations
    for (const JointId strained : world.strainedJoints) EXPECT_EQ(strained, hinge);
    (void)change(world, hinge, [](JointDefinition& joint) {
        joint.limit = {true, -0.5f, 0.5f};  // b2RevoluteJoint_EnableLimit, b2RevoluteJoint_SetLimits
        joint.motor.on = false;             // b2RevoluteJoint_EnableMotor
        joint.spring = {true, 2.0f, 0.7f};  // Hz, damping ratio
    });
    // end
    EXPECT_GT(now.value, 0.0f);
    EXPECT_EQ(world.strainedJoints.size(), 1u);
    scene.run(300);
    EXPECT_LT(readingOf(world, hinge).value, 0.51f);
}

TEST(FromBox2d, jointsOfEachType) {
    World world;
    const BodyId a = *createBody(world, {.kind = BodyKind::Static}), b = *createBody(world, {});
    // doc
    // A rope that is wound up: motor and range. Without motor, limit and spring it is a rod of `length`.
    (void)createJoint(world, {.kind = JointKind::Distance,
                              .a = a,
                              .b = b,
                              .limit = {true, 0.5f, 3.0f},
                              .motor = {true, -1.0f, 100.0f}});
    // A weld that is springy along, and differently in its angle.
    (void)createJoint(world, {.kind = JointKind::Weld,
                              .a = a,
                              .b = b,
                              .spring = {true, 2.0f, 0.5f},  // angular
                              .hertz = 8.0f,                 // linear
                              .dampingRatio = 0.7f});
    // A motor joint by velocity (b2MotorJoint_SetLinearVelocity) instead of by offset.
    (void)createJoint(world, {.kind = JointKind::Motor,
                              .a = a,
                              .b = b,
                              .velocity = {1.0f, 0.0f},
                              .motor = {.on = true, .speed = 0.5f},
                              .maxForce = 50.0f,
                              .maxTorque = 10.0f});
    (void)createJoint(world, {.kind = JointKind::Filter, .a = a, .b = b});
    // end
    EXPECT_EQ(world.joints.size(), 4u);
}

TEST(FromBox2d, events) {
    Scene scene;
    World& world = scene.world;
    (void)setPosition(world, scene.crate, {0.0, -5.0}, 0.0f);
    const ShapeId trigger =
        *createShape(world, scene.ground, box({1.0f, 5.0f}, {0.0f, -6.0f}), {.isTrigger = true});
    float hit = 0.0f;
    std::vector<BodyId> moved;
    std::vector<ShapeId> inside;
    std::vector<const Contact*> touching;
    for (int i = 0; i < 70; ++i) {
        // doc
        step(world, 1.0f / 60.0f);
        for (const ContactEvent& event : world.events) {
            const bool began = event.phase == ContactPhase::Began;
            if (began && !event.isTrigger && event.approachSpeed > 1.0f) hit = event.approachSpeed;
        }
        movedBodies(world, moved);           // b2World_GetBodyEvents; those in world.fellAsleep fell asleep
        overlapsOf(world, trigger, inside);  // b2Shape_GetSensorData
        contactsOf(world, scene.crate, touching);  // b2Body_GetContactData
        for (const Contact* contact : touching) EXPECT_EQ(contactPoints(world, *contact).size(), 2u);
        // end
        ASSERT_EQ(inside.size(), 1u);
    }
    EXPECT_NEAR(hit, 9.4868f, 0.2f);  // impact speed, sqrt(2 * 10 m/s2 * 4.5 m)
    EXPECT_EQ(touching.size(), 1u);
}

TEST(FromBox2d, callbacks) {
    Scene scene;
    World& world = scene.world;
    // doc
    struct Game {
        bool ghosts = false;
    } game;
    StepOptions options;
    options.hooks.context = &game;
    options.hooks.filter = [](void* context, const World&, ShapeId, ShapeId) {
        return !static_cast<Game*>(context)->ghosts;  // b2World_SetCustomFilterCallback
    };
    options.hooks.preSolve = [](void*, const World& now, const Contact& contact) {
        return contactPoints(now, contact)[0].separation < 0.1f;  // b2World_SetPreSolveCallback
    };
    options.hooks.friction = [](void*, const World& now, const Contact& contact) {
        return std::min(now.shapes.info[contact.shapeA].friction, now.shapes.info[contact.shapeB].friction);
    };
    step(world, 1.0f / 60.0f, options);
    // end
    scene.run(30);
    EXPECT_NEAR(positionOf(world, scene.crate).y, -0.5, 0.01);
}

TEST(FromBox2d, queries) {
    Scene scene;
    World& world = scene.world;
    std::vector<ShapeId> found;
    // doc
    const auto hit = castRay(world, {0.0, -5.0}, {0.0f, 10.0f});  // b2World_CastRayClosest
    const auto swept = castShape(world, {.geometry = circle(0.25f), .position = {0.0, -5.0}}, {0.0f, 10.0f});
    overlapBox(world, {-1.0, -1.0}, {1.0, 0.1}, {}, found);
    // end
    ASSERT_TRUE(hit && swept);
    EXPECT_NEAR(hit->point.y, -1.0, 1e-3);
    EXPECT_NEAR(swept->distance, 3.75f, 1e-3f);
    EXPECT_EQ(found.size(), 2u);
}

TEST(FromBox2d, geometry) {
    // doc
    const Vec2 points[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}};
    const Hull hull = *makeHull(points);  // b2ComputeHull
    const Geometry triangle = polygon(hull, 0);
    const std::span<const Corner> corners = hull.corners;
    const MassProperties mass = massProperties(triangle, corners, 2.0f);
    const Convex a = convexOf(triangle, corners), b = convexOf(circle(0.5f), {});
    const Distance gap = distanceBetween(a, b, {{3.0f, 0.0f}, {}});  // b2ShapeDistance
    const Sweep still{}, flight{.start = {3.0, 0.0}, .displacement = {-4.0f, 0.0f}};
    const float part = firstImpact({a, still}, {b, flight}, 0.001f);  // b2TimeOfImpact
    // end
    EXPECT_NEAR(mass.mass, 1.0f, 1e-6f);
    EXPECT_NEAR(gap.distance, 1.5f, 1e-5f);
    EXPECT_NEAR(part, 1.5f / 4.0f, 0.001f);
}

TEST(FromBox2d, tree) {
    // doc
    std::vector<AABB> bounds{{{0.0f, 0.0f}, {1.0f, 1.0f}}, {{5.0f, 0.0f}, {6.0f, 1.0f}}};
    std::vector<Filter> filters(2);
    std::vector<ProxyMotion> motions(2, ProxyMotion::Awake);
    const auto tree = makeBroadPhase(BroadPhaseKind::Tree);  // b2DynamicTree_Create
    tree->rebuild({bounds, filters, motions});
    bounds[1] = {{0.5f, 0.0f}, {1.5f, 1.0f}};  // b2DynamicTree_MoveProxy
    const std::uint32_t changed[] = {1};
    tree->update({bounds, filters, motions}, changed);
    std::vector<std::uint32_t> found;
    tree->query({{0.0f, 0.0f}, {2.0f, 2.0f}}, 0xffffffffu, found);
    // end
    EXPECT_EQ(found.size(), 2u);
}

TEST(FromBox2d, characters) {
    Scene scene;
    World& world = scene.world;
    // doc
    auto hero = *CharacterController::create({.outline = capsule({0, -0.5f}, {0, 0.5f}, 0.4f)}, {3.0, -2.0});
    (void)hero.setVelocity({2.0f, 0.0f});
    (void)hero.update(world, 1.0f / 60.0f);
    step(world, 1.0f / 60.0f);
    // end
    EXPECT_GT(hero.position().x, 3.0);
}

TEST(FromBox2d, tasks) {
    Scene scene;
    World& world = scene.world;
    // doc
    // Another scheduler: calls task(context, part, thread) for each part, on any thread, and waits for all.
    TaskPool pool{2,
                  [](void*, int count, TaskPool::Call task, void* context) {
                      std::thread other{[&] {
                          for (int part = 0; part < count; part += 2) task(context, part, 1);
                      }};
                      for (int part = 1; part < count; part += 2) task(context, part, 0);
                      other.join();
                  },
                  nullptr};
    step(world, 1.0f / 60.0f, {.pool = &pool, .minimumWork = 0});  // by default, small worlds do without
    // end
    EXPECT_EQ(pool.threads(), 2);
}

TEST(FromBox2d, recording) {
    Scene scene;
    World& world = scene.world;
    // doc
    WorldRecording recording{world};  // b2World_StartRecording
    for (int i = 0; i < 30; ++i) {
        if (i == 10) (void)applyImpulse(world, scene.crate, {3.0f, -5.0f});
        recording.step(world, 1.0f / 60.0f);
    }
    const std::vector<std::uint8_t> file = recording.toBytes();
    const Result<World> again =
        WorldRecording::from(file)->replay(30);              // b2ValidateReplay: an error tells where
    const Result<World> loaded = worldFrom(toBytes(world));  // b2World_Snapshot
    // end
    ASSERT_TRUE(again.ok() && loaded.ok());
    EXPECT_EQ(hashOf(*again), hashOf(world));
    EXPECT_EQ(hashOf(*loaded), hashOf(world));
}

TEST(FromBox2d, counters) {
    Scene scene;
    World& world = scene.world;
    step(world, kDt);
    // doc
    const std::size_t bytes = stateBytes(world), bodies = bodyCount(world),
                      islands = reportIslands(world).size();
    const DetectionCounts counts = detectionOf(world);
    const AABB bounds = boundsOf(world);  // b2World_GetBounds
    // end
    EXPECT_EQ(bodies, 2u);
    EXPECT_EQ(islands, 1u);
    EXPECT_GT(bytes, sizeof(World));
    EXPECT_EQ(counts.pairs, 1u);
    EXPECT_NEAR(bounds.max.x, 50.0f, 0.1f);
}

TEST(FromBox2d, wind) {
    Scene scene;
    World& world = scene.world;
    // doc
    (void)applyWind(world, scene.box, {5.0f, 0.0f}, 0.6f, 0.3f);  // b2Shape_ApplyWind, before each step
    (void)createField(world,
                      {.kind = FieldKind::Explosion, .place = {-2.0, 0.0}, .radius = 5.0f, .strength = 3.0f});
    // end
    EXPECT_GT(world.bodies.driveOf(scene.crate.index).force.x, 0.0f);
    scene.run(2);
    EXPECT_GT(velocityOf(world, scene.crate).x, 0.1f);
}

TEST(FromBox2d, drawing) {
    Scene scene;
    const World& world = scene.world;
    Recording canvas;
    // doc
    debugDraw(world, canvas, {.parts = kDrawShapes | kDrawContacts});  // b2World_Draw
    // end
    EXPECT_TRUE(alive(world, scene.crate));
}

/// Returns the text with all indentation removed.
std::string plain(const std::string& text) {
    std::istringstream lines{text};
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, line.find_first_not_of(' '));
        result += line + "\n";
    }
    return result;
}

std::vector<std::string> blocksOf(const std::string& text, const std::string& begin, const std::string& end) {
    std::vector<std::string> blocks;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        at += begin.size();
        blocks.push_back(plain(text.substr(at, text.find(end, at) - at)));
    }
    return blocks;
}

TEST(FromBox2d, everyExampleOfTheDocumentIsCompiledHere) {
    const auto document = readFile(test::sourceFolder() / "docs/from-box2d.md");
    const auto self = readFile(test::sourceFolder() / "tests/physics/from_box2d_test.cpp");
    ASSERT_TRUE(document.ok() && self.ok());

    std::vector<std::string> here;
    for (std::string& block : blocksOf(plain(*self), "\n// doc\n", "// end\n"))
        here.push_back(std::move(block));
    const std::vector<std::string> shown = blocksOf(*document, "```cpp\n", "```");

    EXPECT_GE(shown.size(), 15u);
    EXPECT_EQ(shown.size(), here.size());
    for (const std::string& block : shown) EXPECT_EQ(std::count(here.begin(), here.end(), block), 1) << block;
}

}  // namespace
}  // namespace plumb::physics
