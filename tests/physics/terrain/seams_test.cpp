#include <cmath>
#include <cstdlib>
#include <string>

#include "core/random.hpp"
#include "physics/terrain/terrain_body.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// Number of random runs of a test: the environment variable PLUMB_SEAMS if set, otherwise `usual`.
int runsToTry(int usual) {
    const char* wanted = std::getenv("PLUMB_SEAMS");
    return wanted != nullptr ? std::max(std::atoi(wanted), 1) : usual;
}

enum class Slider { Box, Circle, Capsule, RoundedBox, Count };

Geometry outlineOf(Slider slider, float half) {
    switch (slider) {
        case Slider::Circle: return circle(half);
        case Slider::Capsule: return capsule({-half, 0.0f}, {half, 0.0f}, half);
        case Slider::RoundedBox: return box({0.7f * half, 0.7f * half}, {}, {}, 0.3f * half);
        default: return box({half, half});
    }
}

/// Terrain in a world with y down, with seams between chunks of 8 cells and between two materials.
struct Ground {
    World world;
    TerrainOutlines terrain;
    TerrainBody body;

    Ground(TileMask mask, Vec2 cell, WorldPosition position = {}) : terrain{std::move(mask), 8} {
        world.settings.sleeping = false;
        const auto changed = terrain.update();
        auto made = TerrainBody::create(world, terrain, {.position = position, .cellSize = cell});
        EXPECT_TRUE(made.ok());
        body = std::move(*made);
        EXPECT_TRUE(body.update(world, terrain, changed).ok());
    }

    BodyId slider(const Geometry& outline, WorldPosition place, float angle,
                  const ShapeDefinition& definition) {
        const BodyId made = *createBody(world, {.position = place, .angle = angle});
        EXPECT_TRUE(createShape(world, made, outline, definition).ok());
        return made;
    }
};

/// Builds a floor whose top cells have a form and begin at row `top`; for SlopeDown the row increases with x.
TileMask floorMask(int width, int height, TileForm form, int top) {
    TileMask mask{width, height};
    const std::uint8_t other = *mask.palette.addMaterial({.friction = 0.0f});
    for (int x = 0; x < width; ++x) {
        const int row = form == TileForm::SlopeDown ? top + x : top;
        const auto material = static_cast<std::uint8_t>(x / 5 % 2 == 0 ? 0 : other);
        for (int y = row; y < height; ++y) {
            mask.set(x, y, {y == row ? form : TileForm::Full, material, 0});
        }
    }
    return mask;
}

struct Heard {
    int began = 0;
    int ended = 0;

    void add(const World& world) {
        for (const ContactEvent& event : world.events) {
            began += event.phase == ContactPhase::Began ? 1 : 0;
            ended += event.phase == ContactPhase::Ended ? 1 : 0;
        }
    }
};

constexpr ShapeDefinition kSmooth{.friction = 0.0f};

TEST(Seams, doNotDisturbBodiesSlidingOnAFlatFloor) {
    for (int run = 0; run < runsToTry(100); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run) + 1);
        const float cell = random.between(0.3f, 1.5f), half = random.between(0.15f, 0.8f);
        const float speed = random.between(2.0f, 40.0f);
        const auto kind = static_cast<Slider>(run % static_cast<int>(Slider::Count));
        const WorldPosition far = run % 5 == 4 ? WorldPosition{1.0e6, -1.0e6} : WorldPosition{};
        Ground ground{floorMask(120, 4, TileForm::Full, 2), {cell, cell}, far};
        const WorldPosition start{far.x + static_cast<double>(4.0f * cell),
                                  far.y + 2.0 * static_cast<double>(cell)};
        const BodyId body = ground.slider(outlineOf(kind, half),
                                          {start.x, start.y - static_cast<double>(half)}, 0.0f, kSmooth);
        Heard heard;
        for (int i = 0; i < 60; ++i) step(ground.world, kTick), heard.add(ground.world);
        ASSERT_TRUE(setVelocity(ground.world, body, {speed, 0.0f}).ok());
        const double end = far.x + static_cast<double>(112.0f * cell);
        float bump = 0.0f;
        while (centreOf(ground.world, body).x < end) {
            step(ground.world, kTick);
            heard.add(ground.world);
            bump = std::max(bump, std::fabs(velocityOf(ground.world, body).y));
            ASSERT_GT(velocityOf(ground.world, body).x, 0.5f * speed);
        }
        EXPECT_LE(bump, 1.0e-3f);
        EXPECT_NEAR(velocityOf(ground.world, body).x, speed, 1.0e-4f * speed);
        EXPECT_EQ(heard.began, 1);
        EXPECT_EQ(heard.ended, 0);
    }
}

TEST(Seams, doNotDisturbBodiesSlidingDownASlope) {
    const float root = std::sqrt(0.5f);
    for (int run = 0; run < runsToTry(40); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run) + 1);
        const float cell = random.between(0.5f, 1.5f), half = random.between(0.15f, 0.5f);
        const float speed = random.between(2.0f, 40.0f);
        const auto kind = static_cast<Slider>(run % static_cast<int>(Slider::Count));
        Ground ground{floorMask(80, 84, TileForm::SlopeDown, 1), {cell, cell}};
        // The surface passes through (0, cell) at 45 degrees downwards; its normal is (root, -root).
        const Vec2 start = Vec2{4.0f * cell, 5.0f * cell} + half * Vec2{root, -root};
        const BodyId body = ground.slider(outlineOf(kind, half), start, 0.25f * kPi, kSmooth);
        ASSERT_TRUE(setVelocity(ground.world, body, speed * Vec2{root, root}).ok());
        Heard heard;
        float bump = 0.0f, wanted = speed;
        for (int i = 0; centreOf(ground.world, body).x < static_cast<double>(74.0f * cell); ++i) {
            step(ground.world, kTick);
            heard.add(ground.world);
            wanted += root * 10.0f * kTick;
            const Vec2 velocity = velocityOf(ground.world, body);
            if (i > 5) bump = std::max(bump, std::fabs(dot(velocity, {root, -root})));
            ASSERT_NEAR(dot(velocity, {root, root}), wanted, 1.0e-4f * wanted);
        }
        EXPECT_LE(bump, 2.0e-3f);
        EXPECT_EQ(heard.began, 1);
        EXPECT_EQ(heard.ended, 0);
    }
}

TEST(Seams, stairsDoNotSlowBodiesThatMoveDownThem) {
    for (int run = 0; run < runsToTry(40); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run) + 1);
        const float speed = random.between(4.0f, 40.0f), half = random.between(0.15f, 0.4f);
        TileMask mask{96, 24};
        for (int x = 0; x < 96; ++x) {
            for (int y = 2 + x / 6; y < 24; ++y) mask.set(x, y, {TileForm::Full});
        }
        Ground ground{std::move(mask), {1.0f, 1.0f}};
        const BodyId body =
            ground.slider(box({half, half}), {2.0, 2.0 - static_cast<double>(half)}, 0.0f, kSmooth);
        setFixedRotation(ground.world, body, true);
        ASSERT_TRUE(setVelocity(ground.world, body, {speed, 0.0f}).ok());
        while (centreOf(ground.world, body).x < 90.0) {
            step(ground.world, kTick);
            ASSERT_NEAR(velocityOf(ground.world, body).x, speed, 1.0e-4f * speed);
        }
    }
}

TEST(Seams, anEditUnderABodyWakesItAndDropsIt) {
    Ground ground{floorMask(20, 4, TileForm::Full, 2), {1.0f, 1.0f}};
    ground.world.settings.sleeping = true;
    const BodyId body = ground.slider(box({0.25f, 0.25f}), {10.5, 1.75}, 0.0f, {});
    Heard heard;
    for (int i = 0; i < 120; ++i) step(ground.world, kTick), heard.add(ground.world);
    ASSERT_FALSE(isAwake(ground.world, body));
    // An edit elsewhere in the chunk: the body stays on the floor, without events.
    ground.terrain.set(14, 2, {});
    ASSERT_TRUE(ground.body.update(ground.world, ground.terrain, ground.terrain.update()).ok());
    for (int i = 0; i < 30; ++i) step(ground.world, kTick), heard.add(ground.world);
    EXPECT_EQ(heard.began, 1);
    EXPECT_EQ(heard.ended, 0);
    for (int y = 2; y < 4; ++y) ground.terrain.set(10, y, {});
    ASSERT_TRUE(ground.body.update(ground.world, ground.terrain, ground.terrain.update()).ok());
    for (int i = 0; i < 60; ++i) step(ground.world, kTick), heard.add(ground.world);
    EXPECT_GT(centreOf(ground.world, body).y, 4.0);
    EXPECT_EQ(heard.ended, 1);
}

TEST(Seams, anInnerEdgeOfATerrainStopsOnlyBodiesThatDoNotCollideWithTheTileBeforeIt) {
    // Upper ground on layer bit 4 only, which one of the bodies ignores; below it ordinary ground.
    TileMask mask{8, 4};
    const std::uint8_t soft = *mask.palette.addLayers({.layers = 4});
    for (int x = 0; x < 8; ++x) {
        mask.set(x, 1, {TileForm::Full, 0, soft});
        for (int y = 2; y < 4; ++y) mask.set(x, y, {TileForm::Full});
    }
    Ground ground{std::move(mask), {1.0f, 1.0f}};
    const BodyId both = ground.slider(box({0.25f, 0.25f}), {2.0, 0.5}, 0.0f, {});
    const BodyId one = ground.slider(box({0.25f, 0.25f}), {6.0, 0.5}, 0.0f, {.mask = ~4u});
    for (int i = 0; i < 120; ++i) step(ground.world, kTick);
    EXPECT_NEAR(centreOf(ground.world, both).y, 0.75, 0.01);
    EXPECT_NEAR(centreOf(ground.world, one).y, 1.75, 0.01);
}

}  // namespace
}  // namespace plumb::physics
