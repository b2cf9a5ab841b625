#include <cmath>

#include "tests/box_physics/scene_of_bodies.hpp"

namespace plumb::box_physics {
namespace {

TileField floorOf(int width, int height, Vec2 cell) {
    TileField field{width, height, cell};
    for (int y = 1; y < height; ++y) {
        for (int x = 0; x < width; ++x) field.set(x, y, TileShape::Full);
    }
    return field;
}

struct Crossing {
    int began = 0;
    int ended = 0;
    float fastestUp = 0.0f;
    float speedLost = 0.0f;
};

Crossing slideOver(Stage60& s, BodyId body, int ticks) {
    Crossing crossing;
    const float start = s.velocity(body).x;
    for (int i = 0; i < ticks; ++i) {
        s.run(1);
        crossing.began += s.count(ContactPhase::Began, body);
        crossing.ended += s.count(ContactPhase::Ended, body);
        crossing.fastestUp = std::max(crossing.fastestUp, std::abs(s.velocity(body).y));
    }
    crossing.speedLost = (start - s.velocity(body).x) / start;
    return crossing;
}

TEST(Tiles, nothingTripsOverTheSeamsOfAField) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Stage60 s;
        s.tiles({-1, -0.25f}, floorOf(80, 3, {0.25f, 0.25f}));
        const float half = random.between(0.05f, 0.4f);
        const Vec2 start{random.between(0, 0.5f), -half};
        const Vec2 velocity{random.between(2, 40), 0};
        const BodyId body = seed % 2 == 0 ? s.box(BodyKind::Dynamic, start, {half, half}, velocity)
                                          : s.ball(start, half, velocity);
        const Crossing crossing =
            slideOver(s, body, std::min(60, static_cast<int>(17.0f / velocity.x * 60.0f)));
        EXPECT_EQ(crossing.began, 1);
        EXPECT_EQ(crossing.ended, 0);
        EXPECT_LE(crossing.fastestUp, 1e-3f);
        EXPECT_LE(crossing.speedLost, 1e-4f);
    }
}

TEST(Tiles, nothingTripsOverTheSeamsOfSeparateFloors) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Stage60 s;
        for (int i = 0; i < 40; ++i) {
            s.box(BodyKind::Static, {static_cast<float>(i) * 0.5f, 0.25f}, {0.25f, 0.25f});
        }
        const float half = random.between(0.05f, 0.4f);
        const BodyId body = s.box(BodyKind::Dynamic, {0.3f, -half}, {half, half}, {random.between(2, 20), 0});
        const Crossing crossing = slideOver(s, body, 50);
        EXPECT_LE(crossing.fastestUp, 1e-3f);
        EXPECT_LE(crossing.speedLost, 1e-4f);
    }
}

TEST(Tiles, wallsStopWhatRunsIntoThem) {
    for (const float speed : {1.0f, 10.0f, 200.0f}) {
        SCOPED_TRACE(speed);
        Stage60 s;
        TileField field = floorOf(40, 3, {0.25f, 0.25f});
        field.set(30, 0, TileShape::Full);
        s.tiles({0, -0.25f}, field);
        const BodyId box = s.box(BodyKind::Dynamic, {6.5f, -0.2f}, {0.2f, 0.2f}, {speed, 0});
        s.run(120);
        EXPECT_NEAR(s.position(box).x, 7.5f - 0.2f, 2e-3f);
        EXPECT_NEAR(s.position(box).y, -0.2f, 2e-3f);
    }
}

TEST(Tiles, slopesCarryAtTheirAngle) {
    Stage60 s;
    TileField field{20, 20, {1, 1}};
    for (int i = 0; i < 20; ++i) field.set(i, 19 - i, TileShape::SlopeUp);
    s.tiles({0, 0}, field);
    // Frictionless on 45 degrees: the box slides down with g sin 45.
    const BodyId box = s.box(BodyKind::Dynamic, {12.0f - 0.25f, 8.0f - 0.25f}, {0.25f, 0.25f});
    s.run(60);
    const float speed = length(s.velocity(box));
    EXPECT_NEAR(speed, 9.81f * 0.70710678f, 0.1f);
    EXPECT_TRUE(grounded(s.world, box));
}

TEST(Tiles, oneWaySurfacesHoldOnlyWhatComesFromAbove) {
    for (const bool asTile : {false, true}) {
        for (const float vx : {-2.0f, -0.5f, 0.0f, 2.0f}) {
            for (const float vy : {-9.0f, 9.0f}) {
                SCOPED_TRACE(testing::Message() << asTile << " " << vx << " " << vy);
                Stage60 s;
                if (asTile) {
                    TileField field{40, 1, {0.25f, 0.25f}};
                    for (int x = 0; x < 40; ++x) field.set(x, 0, TileShape::OneWay);
                    s.tiles({-5, 0}, field);
                } else {
                    BodyDefinition d;
                    d.kind = BodyKind::Static;
                    d.position = {0, 0.125f};
                    d.shape = Shape::box({5, 0.125f});
                    d.oneWay = true;
                    s.add(d);
                }
                const bool rising = vy < 0.0f;
                const BodyId box =
                    s.box(BodyKind::Dynamic, {0, rising ? 1.0f : -1.0f}, {0.2f, 0.2f}, {vx, vy});
                bool disturbed = false;
                for (int i = 0; i < 150; ++i) {
                    s.run(1);
                    const float t = static_cast<float>(i + 1) * kTick;
                    const float free = 1.0f + vy * t + 0.5f * 9.81f * t * t;
                    if (rising && t < 0.9f && std::abs(s.position(box).y - free) > 1e-3f) disturbed = true;
                }
                EXPECT_FALSE(disturbed) << "passing upwards must not disturb the flight";
                EXPECT_NEAR(s.position(box).y, -0.2f, 2e-3f);
            }
        }
    }
}

TEST(Tiles, polygonsMustBeConvexAndFinite) {
    TileField field{1, 1, {1, 1}};
    const Vec2 dent[4] = {{0, 0}, {1, 0}, {0.2f, 0.2f}, {0, 1}};
    const Vec2 line[3] = {{0, 0}, {1, 0}, {0.5f, 0}};
    const Vec2 good[3] = {{0, 1}, {0.5f, 0}, {1, 1}};
    EXPECT_FALSE(field.addPolygon(dent, 4).ok());
    EXPECT_FALSE(field.addPolygon(line, 3).ok());
    EXPECT_FALSE(field.addPolygon(good, 2).ok());
    EXPECT_TRUE(field.addPolygon(good, 3).ok());
}

}  // namespace
}  // namespace plumb::box_physics
