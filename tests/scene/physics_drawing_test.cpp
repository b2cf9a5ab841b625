#include "scene/drawing/physics_drawing.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "physics/simulation.hpp"
#include "render/recording_device.hpp"
#include "scene/components.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/physics_times.hpp"
#include "scene/systems/physics_system.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr float kTick = 1.0f / 60.0f;  // s
constexpr Vec2 kPicture{640.0f, 360.0f};

void run(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        world.beginTick();
        world.update(kTick);
    }
}

/// Adds objects for every layer: boxes that fall on a floor, a lift, a trigger, a pendulum.
void fill(World& world) {
    world.addSystem<PhysicsSystem>();
    Entity floor = world.createEntity();
    floor.addComponent<Transform>(100.0f, 300.0f);
    floor.addComponent<BoxCollider>(400.0f, 20.0f);
    Entity lift = world.createEntity();
    lift.addComponent<Transform>(520.0f, 300.0f);
    lift.addComponent<KinematicBody>().velocity = {0.0f, -20.0f};
    lift.addComponent<BoxCollider>(40.0f, 8.0f);
    Entity trigger = world.createEntity();
    trigger.addComponent<Transform>(560.0f, 20.0f);
    trigger.addComponent<BoxCollider>(30.0f, 30.0f).isTrigger = true;
    for (int i = 0; i < 4; ++i) {
        Entity box = world.createEntity();
        box.addComponent<Transform>(200.0f + static_cast<float>(i % 2) * 100.0f,
                                    280.0f - 30.0f * static_cast<float>(i));
        box.addComponent<RigidBody>();
        box.addComponent<BoxCollider>(20.0f, 20.0f);
    }
    Entity ball = world.createEntity();
    ball.addComponent<Transform>(480.0f, 100.0f);
    ball.addComponent<RigidBody>();
    ball.addComponent<CircleCollider>(10.0f);
    ball.addComponent<RevoluteJoint>().anchor = {-40.0f, -20.0f};
    Entity wind = world.createEntity();
    wind.addComponent<Transform>(400.0f, 40.0f);
    wind.addComponent<WindField>().velocity = {100.0f, 0.0f};
}

/// Adds a body that is fast enough for continuous collision detection (a sweep).
void shoot(World& world) {
    Entity shot = world.createEntity();
    shot.addComponent<Transform>(150.0f, 290.0f);
    shot.addComponent<RigidBody>().velocity = {0.0f, 9000.0f};
    shot.addComponent<CircleCollider>(2.0f);
}

bool hasColor(const DrawList& list, Color color) {
    const auto sprites = list.instances();
    const auto vertices = list.vertices();
    return std::any_of(sprites.begin(), sprites.end(), [&](const auto& one) { return one.tint == color; }) ||
           std::any_of(vertices.begin(), vertices.end(), [&](const auto& one) { return one.color == color; });
}

DrawList drawn(World& world, const PhysicsShown& shown, Vec2 center = kPicture * 0.5f) {
    DrawList list;
    list.begin({center, kPicture});
    PhysicsDrawing drawing;
    drawing.draw(world, shown, 0.0f, 1.0f, list);
    return list;
}

const PhysicsLayer& layerNamed(std::string_view name) {
    const auto layers = physicsLayers();
    return *std::find_if(layers.begin(), layers.end(), [&](const auto& layer) { return layer.name == name; });
}

/// Bounding box of everything drawn, px.
AABB boundsOf(const DrawList& list) {
    AABB box{{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (const GeometryVertex& vertex : list.vertices())
        box = merged(box, {vertex.position, vertex.position});
    return box;
}

TEST(PhysicsDrawing, eachLayerDrawsWhatItIsForAndNothingIsDrawnWhenAllAreOff) {
    World world;
    fill(world);
    run(world, 40);
    shoot(world);
    run(world, 1);
    EXPECT_EQ(drawn(world, {}).items().size(), 0u);
    for (const PhysicsLayer& layer : physicsLayers()) {
        SCOPED_TRACE(layer.name);
        const DrawList list = drawn(world, {layer.bit});
        EXPECT_EQ(list.items().size() > 0, layer.ofBodies);  // the other layers are shown as text
        for (const PhysicsColor& row : physicsColors()) {
            const bool comesLater =
                row.label == "asleep" || row.label == "island" || row.label == "near sleep";
            if ((row.layer & layer.bit) != 0 && !comesLater) {
                EXPECT_TRUE(hasColor(list, row.color)) << row.label;
            }
        }
    }
}

TEST(PhysicsDrawing, everyLayerOfBodiesHasARowInTheLegend) {
    unsigned explained = 0;
    for (const PhysicsColor& row : physicsColors()) explained |= row.layer;
    for (const PhysicsLayer& layer : physicsLayers()) EXPECT_EQ((explained & layer.bit) != 0, layer.ofBodies);
}

TEST(PhysicsDrawing, sleepingBodiesChangeTheirColour) {
    World world;
    fill(world);
    const PhysicsLayer& shapes = physicsLayers().front();
    const auto asleep = std::find_if(physicsColors().begin(), physicsColors().end(),
                                     [](const PhysicsColor& row) { return row.label == "asleep"; });
    run(world, 5);
    EXPECT_FALSE(hasColor(drawn(world, {shapes.bit}), asleep->color));
    run(world, 240);
    EXPECT_TRUE(hasColor(drawn(world, {shapes.bit}), asleep->color));
}

TEST(PhysicsDrawing, shapesMatchTheCollidersInAnyView) {
    World world;
    Entity floor = world.createEntity();
    floor.addComponent<Transform>(100.0f, 300.0f);
    floor.addComponent<BoxCollider>(400.0f, 20.0f);
    previewPhysics(world);
    for (const Vec2 center : {Vec2{300.0f, 310.0f}, Vec2{200.0f, 250.0f}}) {
        const DrawList list = drawn(world, {physicsLayers().front().bit}, center);
        const AABB box = boundsOf(list);
        EXPECT_NEAR(box.min.x, 100.0f, 1e-3f);
        EXPECT_NEAR(box.min.y, 300.0f, 1e-3f);
        EXPECT_NEAR(box.max.x, 500.0f, 1e-3f);
        EXPECT_NEAR(box.max.y, 320.0f, 1e-3f);
    }
}

TEST(PhysicsDrawing, thePreviewFollowsEdits) {
    World world;
    Entity crate = world.createEntity();
    crate.addComponent<Transform>(100.0f, 100.0f);
    crate.addComponent<RigidBody>();
    crate.addComponent<BoxCollider>(20.0f, 20.0f);
    const auto left = [&] {
        previewPhysics(world);
        return boundsOf(drawn(world, {physicsLayers().front().bit})).min.x;
    };
    EXPECT_NEAR(left(), 100.0f, 1e-3f);
    crate.get<Transform>().position.x = 140.0f;
    EXPECT_NEAR(left(), 140.0f, 1e-3f);
    crate.get<BoxCollider>().offset.x = 7.0f;
    EXPECT_NEAR(left(), 147.0f, 1e-3f);
    EXPECT_EQ(crate.get<Transform>().position, (Vec2{140.0f, 100.0f}));
    crate.destroy();
    EXPECT_EQ(left(), 1e9f);
}

TEST(PhysicsDrawing, drawingDoesNotChangeTheSimulation) {
    World watched, alone;
    fill(watched), fill(alone);
    AssetStore assets{{}, test::sourceFolder() / "assets"};
    RecordingDevice device;
    SceneRenderer renderer{device, assets};
    unsigned all = 0;
    for (const PhysicsLayer& layer : physicsLayers()) all |= layer.bit;
    for (int i = 0; i < 200; ++i) {
        run(watched, 1), run(alone, 1);
        renderer.drawPhysics(watched, {all}, {.view = {kPicture * 0.5f, kPicture}, .alpha = 0.3f},
                             {.width = 640, .height = 360});
        ASSERT_EQ(watched.hash(), alone.hash()) << i;
    }
    EXPECT_GT(device.spriteDraws.size(), 0u);
    device.clearDraws();
    renderer.drawPhysics(watched, {}, {.view = {kPicture * 0.5f, kPicture}}, {.width = 640, .height = 360});
    EXPECT_EQ(device.spriteDraws.size(), 0u);
}

TEST(PhysicsDrawing, layersAreNamedInLists) {
    EXPECT_EQ(*physicsLayersNamed("shapes,contacts"), physicsLayers()[0].bit | physicsLayers()[1].bit);
    unsigned all = 0;
    for (const PhysicsLayer& layer : physicsLayers()) {
        EXPECT_EQ(*physicsLayersNamed(layer.name), layer.bit);
        EXPECT_EQ(all & layer.bit, 0u) << "two layers have the same bit";
        all |= layer.bit;
    }
    EXPECT_EQ(*physicsLayersNamed("all"), all);
    const auto wrong = physicsLayersNamed("shapes,joint");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().remedy, "did you mean \"joints\"?");
}

TEST(PhysicsDrawing, anEnabledLayerIsShownAtOnce) {
    PhysicsView view;
    EXPECT_EQ(view.shown().any(), 0u);
    const PhysicsLayer& shapes = physicsLayers().front();
    view.toggle(shapes);
    EXPECT_EQ(view.reachOf(shapes), PhysicsReach::All);
    view.toggle(shapes);
    EXPECT_EQ(view.reachOf(shapes), PhysicsReach::Off);
    view.on = false;
    view.layers = 0;
    view.toggle(physicsLayers().back());
    EXPECT_EQ(view.shown().any(), physicsLayers().back().bit);
}

TEST(PhysicsDrawing, aLayerIsShownForAllOrSelectedEntitiesOrOff) {
    PhysicsView view;
    for (const PhysicsLayer& layer : physicsLayers()) {
        for (const PhysicsReach reach : {PhysicsReach::Selected, PhysicsReach::All, PhysicsReach::Off}) {
            view.setReach(layer, reach);
            EXPECT_EQ(view.reachOf(layer), reach);
            EXPECT_EQ((view.shown().layers & layer.bit) != 0, reach == PhysicsReach::All);
            EXPECT_EQ((view.shown().ofSelected & layer.bit) != 0, reach == PhysicsReach::Selected);
        }
    }
}

TEST(PhysicsDrawing, keysToggleTheViewAndItsLayersWhileItIsVisible) {
    PhysicsView view;
    const unsigned first = view.layers;
    const auto press = [&](Key key, bool control, bool shift) {
        Event event{.kind = EventKind::KeyDown};
        event.key = key;
        event.modifiers = {shift, control, false};
        view.handle(event);
    };
    for (const PhysicsLayer& layer : physicsLayers()) press(layer.key, true, layer.withShift);
    EXPECT_FALSE(view.on);
    EXPECT_EQ(view.layers, first);
    press(Key::F3, false, false);
    EXPECT_EQ(view.shown().layers, first);
    for (const PhysicsLayer& layer : physicsLayers()) {
        const unsigned before = view.shown().layers;
        press(layer.key, false, layer.withShift);
        EXPECT_EQ(view.shown().layers, before) << "without Ctrl the key belongs to the game";
        press(layer.key, true, layer.withShift);
        EXPECT_EQ(view.shown().layers, before ^ layer.bit) << layer.name;
    }
    press(Key::F3, false, false);
    EXPECT_EQ(view.shown().any(), 0u);
}

TEST(PhysicsDrawing, onlySelectedEntitiesAreDrawn) {
    World world;
    fill(world);
    Entity crate = world.createEntity();
    crate.addComponent<Transform>(300.0f, 100.0f);
    crate.addComponent<RigidBody>().gravityScale = 0.0f;
    crate.addComponent<BoxCollider>(20.0f, 30.0f);
    run(world, 1);
    const unsigned shapes = layerNamed("shapes").bit;
    const std::vector<EntityId> selected{crate.id()};
    const AABB box = boundsOf(drawn(world, {0, shapes, selected}));
    EXPECT_NEAR(box.min.x, 300.0f, 0.1f);
    EXPECT_NEAR(box.min.y, 100.0f, 0.1f);
    EXPECT_NEAR(box.max.x, 320.0f, 0.1f);
    EXPECT_NEAR(box.max.y, 130.0f, 0.1f);
    EXPECT_EQ(drawn(world, {0, shapes, {}}).items().size(), 0u);
}

TEST(PhysicsDrawing, aSoftBodyIsDrawnWithTheEntityThatIsSelected) {
    World world;
    fill(world);
    std::vector<EntityId> selected;
    for (const float x : {300.0f, 400.0f}) {
        Entity rope = world.createEntity();
        rope.addComponent<Transform>(x, 40.0f);
        rope.addComponent<Rope>().to = {0.0f, 100.0f};
        selected.assign(1, rope.id());
    }
    run(world, 1);
    const DrawList list = drawn(world, {0, layerNamed("shapes").bit, selected});
    EXPECT_GT(list.instances().size(), 20u);
    for (const SpriteInstance& line : list.instances()) {
        EXPECT_NEAR(line.center.x, 400.0f, 2.0f);
        EXPECT_NEAR(line.center.y, 90.0f, 50.0f);
    }
}

DrawList drawnFrom(World& world, Vec2 center, float zoom) {
    DrawList list;
    list.begin({.center = center, .size = kPicture, .zoom = zoom});
    PhysicsDrawing drawing;
    drawing.draw(world, {layerNamed("shapes").bit}, 0.0f, 1.0f, list);
    return list;
}

TEST(PhysicsDrawing, onlyShapesThatOverlapTheViewAreDrawn) {
    World world;
    for (int i = 0; i < 50; ++i) {
        Entity box = world.createEntity();
        box.addComponent<Transform>(static_cast<float>(i) * 100.0f, 0.0f);
        box.addComponent<BoxCollider>(40.0f, 40.0f);
    }
    previewPhysics(world);
    const Vec2 between{1050.0f, 0.0f};
    EXPECT_LT(drawnFrom(world, between, 1.0f).culledCount(), 40u) << "most are skipped before culling";
    EXPECT_GT(drawnFrom(world, between, 1.0f).items().size(), 20u);
    EXPECT_EQ(drawnFrom(world, {1050.0f, 900.0f}, 1.0f).items().size(), 0u);
    // The border of the view crosses a box.
    const float half = kPicture.x * 0.5f;
    EXPECT_GT(drawnFrom(world, {-half + 15.0f, 0.0f}, 1.0f).items().size(), 0u);
}

TEST(PhysicsDrawing, shapesSmallerThanTheirLinesAreDots) {
    World world;
    Entity box = world.createEntity();
    box.addComponent<Transform>(0.0f, 0.0f);
    box.addComponent<BoxCollider>(40.0f, 40.0f);
    previewPhysics(world);
    EXPECT_GT(drawnFrom(world, {}, 1.0f).items().size(), 4u);
    const DrawList far = drawnFrom(world, {}, 0.05f);
    ASSERT_EQ(far.items().size(), 1u);
    EXPECT_EQ(far.instances()[0].tint, drawnFrom(world, {}, 1.0f).instances().back().tint);
    EXPECT_GE(far.instances()[0].half.x, 20.0f);
    EXPECT_LE(far.instances()[0].half.x, 40.0f);
}

TEST(PhysicsDrawing, linesHaveTheSameWidthOnScreenAtAnyZoom) {
    World world;
    fill(world);
    run(world, 1);
    for (const float zoom : {0.25f, 1.0f, 4.0f}) {
        DrawList list;
        list.begin({.center = {300.0f, 310.0f}, .size = kPicture, .zoom = zoom});
        PhysicsDrawing drawing;
        drawing.draw(world, {layerNamed("shapes").bit}, 0.0f, 1.0f, list);
        float thinnest = 1e9f;
        for (const SpriteInstance& line : list.instances())
            thinnest = std::min({thinnest, line.half.x * 2.0f * zoom, line.half.y * 2.0f * zoom});
        EXPECT_NEAR(thinnest, 1.5f, 1e-3f) << zoom;
    }
}

TEST(PhysicsDrawing, timesIncludeAllStagesThatRan) {
    World world;
    PhysicsTimes times;
    fill(world);
    run(world, 60);
    EXPECT_TRUE(times.rows().empty());
    times.watch(world, true);
    run(world, 29);
    EXPECT_TRUE(times.rows().empty());
    run(world, 1);
    ASSERT_FALSE(times.rows().empty());
    EXPECT_EQ(times.rows().front().stage, kPhysicsSync);
    std::size_t found = 0;
    for (const physics::StageInfo& stage : physics::stages()) {
        const auto row = std::find_if(times.rows().begin(), times.rows().end(),
                                      [&](const PhysicsTimes::Row& one) { return one.stage == stage.name; });
        if (row == times.rows().end()) continue;
        ++found;
        EXPECT_GE(row->milliseconds, 0.0f);
        EXPECT_LT(row->milliseconds, 100.0f);
        EXPECT_GT(physics::runsOf(world.resource<PhysicsState>().world, stage.name), 0u) << stage.name;
    }
    EXPECT_EQ(found + 1, times.rows().size());
    EXPECT_GE(found, 5u);
    const float before = times.rows().front().milliseconds;
    times.watch(world, false);
    run(world, 60);
    EXPECT_EQ(times.profile(), nullptr);
    EXPECT_EQ(times.rows().front().milliseconds, before) << "no times are measured while hidden";
}

TEST(PhysicsDrawing, legendAndNumbersAreVisibleAndDoNotOverlap) {
    World world;
    fill(world);
    run(world, 10);
    RecordingDevice device;
    AssetStore assets;
    LabelDrawing labels{device, assets};
    unsigned all = 0;
    for (const PhysicsLayer& layer : physicsLayers()) all |= layer.bit;
    for (const unsigned layers : {all, all & ~kPhysicsTimes, PhysicsView{}.layers}) {
        for (const Vec2 screen : {Vec2{640, 360}, {780, 465}, {1280, 720}, {1920, 1080}, {3840, 2160}}) {
            SCOPED_TRACE(screen.x);
            DrawList list;
            list.begin({screen * 0.5f, screen});
            drawPhysicsPanel(world, {layers}, labels, list);
            std::vector<AABB> boards;
            for (const SpriteInstance& one : list.instances()) {
                if (one.tint == Color{16, 18, 22, 205})
                    boards.push_back({one.center - one.half, one.center + one.half});
            }
            ASSERT_EQ(boards.size(), (layers & (kPhysicsTimes | kPhysicsCounts)) != 0 ? 2u : 1u);
            EXPECT_FALSE(boards.size() == 2 && intersects(boards[0], boards[1]));
            for (const AABB& board : boards) EXPECT_EQ(merged(board, {{}, screen}), (AABB{{}, screen}));
            EXPECT_LT(boards[0].size().y, 0.45f * screen.y);
        }
    }
}

}  // namespace
}  // namespace plumb
