#include "physics/terrain/terrain_body.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tests/physics/support/random_terrain.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

using namespace test;

std::vector<std::uint32_t> shapesOf(const World& world, BodyId body) {
    std::vector<std::uint32_t> shapes;
    for (std::uint32_t s = world.bodies.info[body.index].firstShape; s != kNone;
         s = world.shapes.info[s].next)
        shapes.push_back(s);
    return shapes;
}

TEST(TerrainBody, hasTheSegmentsOfTheOutlinesInTheWorld) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        TerrainOutlines terrain = built(randomMask(20, 13, random), 8);
        World world;
        const WorldPosition corner{1e6, -300.0};
        const Vec2 cell{0.5f, 0.25f};
        auto made = TerrainBody::create(world, terrain, {.position = corner, .cellSize = cell, .user = 42});
        ASSERT_TRUE(made.ok());
        std::vector<std::uint32_t> all(terrain.chunks().size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        ASSERT_TRUE(made->update(world, terrain, all).ok());
        ASSERT_EQ(world.bodies.size(), terrain.chunks().size());
        std::set<std::uint32_t> surfaces;
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            const BodyId body{i, world.bodies.info[i].generation};
            const CellRect cells = terrain.cellsOf(i);
            EXPECT_EQ(world.bodies.info[body.index].kind, BodyKind::Static);
            EXPECT_EQ(world.bodies.info[body.index].user, 42u);
            EXPECT_EQ(positionOf(world, body),
                      (WorldPosition{corner.x + cells.x0 * 0.5, corner.y + cells.y0 * 0.25}));
            const auto& segments = terrain.chunks()[i];
            const auto shapes = shapesOf(world, body);
            ASSERT_EQ(shapes.size(), segments.size());
            const auto matches = [&](std::uint32_t shape, const TerrainSegment& segment) {
                const Geometry& geometry = world.shapes.geometry[shape];
                const auto isAt = [&](Vec2 point, GridPoint grid) {
                    const WorldPosition wanted{corner.x + grid.x * 0.5 / kCellUnits,
                                               corner.y + grid.y * 0.25 / kCellUnits};
                    return length(worldPoint(world, body, point) - wanted) < 1e-5f;
                };
                return isAt(geometry.a, segment.a) && isAt(geometry.b, segment.b) &&
                       isAt(beforeOf(geometry), segment.before) && isAt(geometry.after, segment.after);
            };
            for (const TerrainSegment& segment : segments) {
                const auto found = std::find_if(shapes.begin(), shapes.end(),
                                                [&](std::uint32_t s) { return matches(s, segment); });
                ASSERT_NE(found, shapes.end());
                const ShapeDefinition shape =
                    definitionOf(world, ShapeId{*found, world.shapes.info[*found].generation});
                const TilePalette& palette = terrain.mask().palette;
                const TileMaterial& material = palette.material(segment.kind.material);
                EXPECT_EQ(shape.friction, material.friction);
                EXPECT_EQ(shape.bounciness, material.bounciness);
                EXPECT_EQ(shape.surfaceSpeed, material.surfaceSpeed);
                EXPECT_EQ(shape.oneWay, segment.kind.oneWay != OneWay::No);
                EXPECT_EQ(shape.density, 0.0f);
                EXPECT_EQ(shape.user, 42u);
                EXPECT_TRUE(shape.reportsContacts);
                surfaces.insert(world.shapes.info[*found].surface);
                // If several segments coincide, their layers differ: one of them must match.
                const TileLayers& layers = palette.layers(segment.kind.layers);
                EXPECT_TRUE(std::any_of(shapes.begin(), shapes.end(), [&](std::uint32_t s) {
                    const ShapeDefinition one =
                        definitionOf(world, ShapeId{s, world.shapes.info[s].generation});
                    const bool front = segment.kind.isInner();
                    const TileLayers& before = palette.layers(
                        front ? static_cast<std::uint8_t>(segment.kind.behind - 1) : std::uint8_t{0});
                    return matches(s, segment) && one.layers == layers.layers && one.mask == layers.mask &&
                           one.frontLayers == (front ? before.layers : 0u) &&
                           one.frontMask == (front ? before.mask : 0u);
                }));
            }
        }
        EXPECT_LE(surfaces.size(), 1u) << "all segments must belong to one surface";
        addBody(world, BodyKind::Static, {});
        made->destroy(world);
        EXPECT_EQ(bodyCount(world), 1u);
    }
}

TEST(TerrainBody, ignoresUnknownChunksAndRejectsInvalidCellSizes) {
    Random random = Random::seeded(1);
    TerrainOutlines small = built(randomMask(8, 8, random), 8), large = built(randomMask(16, 8, random), 8);
    World world;
    TerrainBody body = *TerrainBody::create(world, small, {});
    ASSERT_EQ(bodyCount(world), 1u);
    for (const std::uint32_t chunk : {0u, 1u}) EXPECT_TRUE(body.update(world, large, {&chunk, 1}).ok());
    EXPECT_EQ(shapesOf(world, {0, world.bodies.info[0].generation}).size(), large.chunks()[0].size());
    for (const float bad : {0.0f, -1.0f, 0.9e-4f, 1.1e6f}) {
        EXPECT_FALSE(TerrainBody::create(world, small, {.cellSize = {bad, 1.0f}}).ok());
        EXPECT_FALSE(TerrainBody::create(world, small, {.cellSize = {1.0f, bad}}).ok());
    }
    EXPECT_EQ(bodyCount(world), 1u);
}

TEST(PolygonStore, reusesTheBlocksOfDestroyedPolygons) {
    World world;
    const BodyId body = addBody(world, BodyKind::Static, {});
    const auto add = [&](int corners) {
        std::vector<Vec2> points;
        for (int i = 0; i < corners; ++i) {
            const SinCos at = sinCos(kTau * static_cast<float>(i) / static_cast<float>(corners));
            points.push_back({at.cos, at.sin});
        }
        return *createPolygon(world, body, points);
    };
    // Corners are stored in blocks of 4, 8, 16 or 32.
    constexpr std::pair<int, std::size_t> kBlocks[] = {{3, 4},  {4, 4},   {5, 8},   {8, 8},
                                                       {9, 16}, {16, 16}, {17, 32}, {32, 32}};
    for (const auto& [corners, block] : kBlocks) {
        SCOPED_TRACE(corners);
        const std::size_t before = world.shapes.corners.size();
        const ShapeId shape = add(corners);
        EXPECT_EQ(world.shapes.corners.size(), before + block);
        const Geometry first = world.shapes.geometry[shape.index];
        const std::vector<Corner> outline{world.shapes.corners.begin() + first.first,
                                          world.shapes.corners.begin() + first.first + first.count};
        destroyShape(world, shape);
        step(world, kTick);
        const std::size_t after = world.shapes.corners.size();
        const ShapeId again = add(corners);
        EXPECT_EQ(world.shapes.corners.size(), after) << "the freed corner block must be reused";
        const Geometry second = world.shapes.geometry[again.index];
        EXPECT_EQ(second.first, first.first);
        EXPECT_TRUE(std::equal(outline.begin(), outline.end(), world.shapes.corners.begin() + second.first));
    }
}

/// Values returned by the material callbacks.
struct Answer {
    float friction, bounciness;
};

TEST(ContactHooks, materialsAreClamped) {
    const auto landed = [](Answer answer, Vec2 velocity) {
        Playground scene;
        scene.floor();
        const BodyId crate = scene.crate({0.0, 0.51}, {0.5f, 0.5f}, {.friction = 0.0f});
        EXPECT_TRUE(setVelocity(scene.world, crate, velocity).ok());
        StepOptions options;
        options.hooks.context = &answer;
        options.hooks.friction = [](void* a, const World&, const Contact&) {
            return static_cast<Answer*>(a)->friction;
        };
        options.hooks.bounciness = [](void* a, const World&, const Contact&) {
            return static_cast<Answer*>(a)->bounciness;
        };
        scene.run(6, options);
        return scene.velocity(crate);
    };
    const Vec2 fall{0.0f, -6.0f}, slide{3.0f, 0.0f};
    EXPECT_NEAR(landed({0.0f, 0.0f}, fall).y, 0.0f, 0.1f);
    EXPECT_NEAR(landed({0.0f, -1.0f}, fall).y, 0.0f, 0.1f);
    EXPECT_NEAR(landed({0.0f, std::nanf("")}, fall).y, 0.0f, 0.1f);
    const float half = landed({0.0f, 0.5f}, fall).y, full = landed({0.0f, 1.0f}, fall).y;
    EXPECT_NEAR(half, 3.0f - 5.0f / 6.0f, 0.4f);
    EXPECT_NEAR(full, 6.0f - 5.0f / 6.0f, 0.4f);
    EXPECT_EQ(landed({0.0f, 7.0f}, fall).y, full) << "no more than all";
    EXPECT_NEAR(landed({0.0f, 0.0f}, slide).x, 3.0f, 1e-3f);
    EXPECT_NEAR(landed({-1.0f, 0.0f}, slide).x, 3.0f, 1e-3f);
    EXPECT_LT(landed({0.5f, 0.0f}, slide).x, 2.8f);
    EXPECT_EQ(landed({100.0f, 0.0f}, slide).x, landed({1e9f, 0.0f}, slide).x);
}

}  // namespace
}  // namespace plumb::physics
