#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "render/recording_device.hpp"
#include "scene/components.hpp"
#include "scene/components/bodies/cloth.hpp"
#include "scene/components/bodies/jelly.hpp"
#include "scene/components/bodies/rope.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/soft_sync.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb {
namespace {

struct Soft {
    World world;

    Soft() { world.addSystem<PhysicsSystem>(); }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            world.update(1.0f / 60.0f);
        }
    }
    Entity at(Vec2 place) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(place.x, place.y);
        return entity;
    }
    std::vector<Vec2> particles(Entity entity) {
        PhysicsState& state = world.resource<PhysicsState>();
        std::vector<Vec2> places;
        for (const SoftLinkage& linkage : state.softBodies) {
            if (!(linkage.entity == entity.id()) || !physics::alive(state.world, linkage.body)) continue;
            for (const auto& particle : physics::particlesOf(state.world, linkage.body))
                places.push_back(positionInPixels(particle.place, state.scale));
        }
        return places;
    }
    std::size_t bodies() { return world.resource<PhysicsState>().softBodies.size(); }
};

TEST(SoftComponents, aRopeHangsFromItsStartAndKeepsItsLength) {
    Soft scene;
    Entity entity = scene.at({100, 50});
    Rope& rope = entity.addComponent<Rope>();
    rope.to = {120.0f, 0.0f};
    rope.points = 13;
    scene.run(600);
    const std::vector<Vec2> now = scene.particles(entity);
    ASSERT_EQ(now.size(), 13u);
    EXPECT_EQ(now.front(), (Vec2{100, 50}));
    float whole = 0.0f;
    for (std::size_t i = 1; i < now.size(); ++i) whole += length(now[i] - now[i - 1]);
    EXPECT_NEAR(whole, 120.0f, 3.0f);
    EXPECT_GT(now.back().y, 150.0f) << "the rope's end must hang down";
}

TEST(SoftComponents, aClothStaysAtAnyOfItsPins) {
    for (const auto& [pins, held] :
         {std::pair{ClothPins::None, 0u}, {ClothPins::TopCorners, 2u}, {ClothPins::TopEdge, 8u}}) {
        Soft scene;
        Entity entity = scene.at({0, 0});
        Cloth& cloth = entity.addComponent<Cloth>();
        cloth.columns = 8;
        cloth.rows = 5;
        cloth.pinned = pins;
        scene.run(1);
        const std::vector<Vec2> before = scene.particles(entity);
        ASSERT_EQ(before.size(), 40u);
        scene.run(120);
        const std::vector<Vec2> after = scene.particles(entity);
        unsigned still = 0;
        for (std::size_t i = 0; i < 40; ++i) still += before[i] == after[i] ? 1 : 0;
        EXPECT_EQ(still, held);
    }
}

TEST(SoftComponents, aJellyFallsRestsOnTheGroundAndKeepsItsArea) {
    Soft scene;
    Entity ground = scene.at({-500, 200});
    ground.addComponent<BoxCollider>(1000, 50);
    Entity entity = scene.at({0, 0});
    entity.addComponent<Jelly>();
    const auto area = [&] {
        const std::vector<Vec2> skin = scene.particles(entity);
        float sum = 0.0f;
        for (std::size_t i = 0; i < skin.size(); ++i)
            sum += 0.5f * cross(skin[i], skin[(i + 1) % skin.size()]);
        return std::abs(sum);
    };
    scene.run(1);
    const float full = area();
    scene.run(300);
    EXPECT_NEAR(area() / full, 1.0f, 0.05f);
    for (const Vec2 place : scene.particles(entity)) EXPECT_LT(place.y, 201.0f);
}

TEST(SoftComponents, changedSoftBodiesAreRecreatedAndRemovedOnesDestroyed) {
    Soft scene;
    Entity entity = scene.at({0, 0});
    entity.addComponent<Rope>();
    scene.run(30);
    EXPECT_GT(scene.particles(entity).back().y, 0.0f);
    entity.get<Rope>().points = 5;
    scene.run(1);
    EXPECT_EQ(scene.particles(entity).size(), 5u);
    entity.get<Transform>().position = {300, 0};
    scene.run(1);
    EXPECT_EQ(scene.particles(entity).front(), (Vec2{300, 0}));
    scene.world.remove<Rope>(entity.id());
    scene.run(1);
    EXPECT_EQ(scene.bodies(), 0u);
}

TEST(SoftComponents, invalidNumbersAreRejected) {
    Soft scene;
    Entity entity = scene.at({0, 0});
    entity.addComponent<Jelly>().radius = std::numeric_limits<float>::quiet_NaN();
    scene.at({50, 0}).addComponent<Rope>().mass = -1.0f;
    scene.run(10);
    EXPECT_TRUE(scene.particles(entity).empty());
    EXPECT_EQ(scene.world.reports().count(), 2u);
}

TEST(SoftComponents, allAreDrawnAsSurfaces) {
    Soft scene;
    scene.at({20, 20}).addComponent<Cloth>();
    scene.at({200, 20}).addComponent<Rope>();
    scene.at({300, 100}).addComponent<Jelly>();
    scene.run(5);
    RecordingDevice device;
    AssetStore assets;
    SceneRenderer renderer{device, assets};
    DrawList list;
    list.begin({{320, 180}, {640, 360}});
    renderer.collect(scene.world, {{{320, 180}, {640, 360}}}, list);
    EXPECT_GT(list.items().size(), 20u * 19u);
}

}  // namespace
}  // namespace plumb
