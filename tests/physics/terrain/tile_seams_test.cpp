#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "tests/physics/support/world_of_bodies.hpp"

// Adjacent static shapes act like one: bodies slide, roll and rest on them as on a single shape.

namespace plumb::physics {
namespace {

int membersToTry(int usual) {
    const char* wanted = std::getenv("PLUMB_SEAMS");
    return wanted != nullptr ? std::max(std::atoi(wanted), 1) : usual;
}

enum class Rider { Box, Ball, Pentagon, Capsule, Count };

/// A body and its tiled floor, in a frame in which the floor is y = 0 along x.
struct Ride {
    Rider rider = Rider::Box;
    float half = 0.5f;   // half size of the body, m
    float speed = 1.0f;  // initial speed, m/s
    float friction = 0.0f;
    float tile = 1.0f;     // maximum width of a tile, m
    float unlike = 0.0f;   // tiles are narrower than the maximum by up to this fraction
    float slant = 0.0f;    // horizontal offset of the slanted sides of polygon tiles, m
    float overlap = 0.0f;  // overlap of neighboring tiles, m
    float uneven = 0.0f;   // height differences of the tops, m
    float slope = 0.0f;    // rotation of the whole scene including gravity, rad
    bool inRows = false;   // true: more rows of tiles below
    bool oneBody = false;  // all tiles belong to one body
    BodyKind kind = BodyKind::Static;
    std::uint64_t seed = 0;

    [[nodiscard]] float top() const {
        switch (rider) {
            case Rider::Box: return 0.8f * half;
            case Rider::Capsule: return 0.5f * half;
            case Rider::Pentagon: return half * std::cos(0.1f * kTau);
            default: return half;
        }
    }
    [[nodiscard]] bool rolls() const { return rider == Rider::Ball && friction > 0.0f; }
    [[nodiscard]] int steps() const {
        float seconds = 2.0f;
        if (friction > 0.0f && !rolls()) seconds = std::min(seconds, 0.5f * speed / (friction * 10.0f));
        seconds = std::min(seconds, 60.0f * tile / speed);
        return std::max(static_cast<int>(seconds / kTick), 2);
    }
    [[nodiscard]] std::string text() const {
        return "seed " + std::to_string(seed) + " rider " + std::to_string(static_cast<int>(rider)) +
               " half " + std::to_string(half) + " speed " + std::to_string(speed) + " friction " +
               std::to_string(friction) + " tile " + std::to_string(tile) + " unlike " +
               std::to_string(unlike) + " slant " + std::to_string(slant) + " overlap " +
               std::to_string(overlap) + " uneven " + std::to_string(uneven) + " slope " +
               std::to_string(slope) + (inRows ? " rows" : "") + (oneBody ? " one body" : "");
    }
};

Ride randomRide(std::uint64_t seed) {
    Random random = Random::seeded(seed + 1);
    Ride ride;
    ride.seed = seed;
    ride.rider = static_cast<Rider>(seed % static_cast<int>(Rider::Count));
    ride.half = 0.02f * std::pow(250.0f, random.unit());
    ride.speed = 0.5f * std::pow(40.0f, random.unit());
    if (random.below(2) != 0) ride.friction = random.between(0.05f, 0.5f);
    ride.tile = std::max(ride.half * std::pow(10.0f, random.between(-0.3f, 1.0f)), 0.03f);
    ride.unlike = random.between(0.0f, 0.7f);
    if (random.below(3) == 0) ride.slant = random.between(-0.1f, 0.1f) * ride.tile;
    if (random.below(3) == 0) ride.overlap = random.between(0.0f, 0.2f) * ride.tile;
    if (random.below(3) == 0) ride.uneven = 1.0e-5f;
    if (random.below(2) == 0) ride.slope = random.between(-kPi, kPi);
    ride.inRows = random.below(3) == 0;
    ride.oneBody = random.below(2) == 0;
    if (random.below(4) == 0) ride.kind = BodyKind::Kinematic;
    return ride;
}

struct Track {
    Playground ground;
    Rot rotation;
    BodyId body;

    Track(const Ride& ride, bool tiled) : rotation{rotFromAngle(ride.slope)} {
        ground.world.settings.gravity = rotate(rotation, {0.0f, -10.0f});
        const float depth = std::max(ride.half, 0.1f);
        const ShapeDefinition stuff{.friction = ride.friction};
        const float start = -3.0f * ride.half - 0.5f, end = ride.speed * 2.2f + 3.0f * ride.half + 0.5f;
        if (tiled) {
            Random random = Random::seeded(ride.seed + 77);
            const BodyId all = ground.body(ride.kind, {}, ride.slope);
            for (float edge = start; edge < end;) {
                const bool near = edge > -ride.half - ride.tile && edge < 62.0f * ride.tile;
                const float width = near ? ride.tile * (1.0f - ride.unlike * random.unit()) : end;
                const float y = random.between(-ride.uneven, 0.0f);
                for (int row = 0; row < (ride.inRows ? 3 : 1); ++row)
                    tile(ride, all, edge, width, y - static_cast<float>(row) * depth, depth, stuff);
                edge += width;
            }
        } else {
            const Vec2 middle = rotate(rotation, {0.5f * (start + end), -0.5f * depth});
            const BodyId floor = ground.body(BodyKind::Static, middle, ride.slope);
            ground.shape(floor, box({0.5f * (end - start), 0.5f * depth}), stuff);
        }
        body = ground.body(BodyKind::Dynamic, rotate(rotation, {0.0f, ride.top()}), ride.slope);
        addRider(ride, {.friction = ride.friction});
        ground.run(30);
        EXPECT_TRUE(setVelocity(ground.world, body, rotate(rotation, {ride.speed, 0.0f})).ok());
        const float spin = ride.rolls() ? -ride.speed / ride.half : 0.0f;
        EXPECT_TRUE(setAngularVelocity(ground.world, body, spin).ok());
    }

    void tile(const Ride& ride, BodyId all, float edge, float width, float y, float depth,
              const ShapeDefinition& stuff) {
        const Vec2 middle{edge + 0.5f * (width + ride.overlap), y - 0.5f * depth};
        const Vec2 half{0.5f * (width + ride.overlap), 0.5f * depth};
        const BodyId own = ride.oneBody ? all : ground.body(ride.kind, rotate(rotation, middle), ride.slope);
        const Vec2 at = ride.oneBody ? middle : Vec2{};
        if (ride.slant == 0.0f) {
            ground.shape(own, box(half, at), stuff);
            return;
        }
        const std::array<Vec2, 4> corners{at + Vec2{-half.x - ride.slant, -half.y},
                                          at + Vec2{half.x - ride.slant, -half.y}, at + half,
                                          at + Vec2{-half.x, half.y}};
        EXPECT_TRUE(createPolygon(ground.world, own, corners, 0.0f, stuff).ok());
    }

    void addRider(const Ride& ride, const ShapeDefinition& stuff) {
        const float half = ride.half;
        if (ride.rider == Rider::Box) ground.shape(body, box({half, 0.8f * half}), stuff);
        if (ride.rider == Rider::Ball) ground.shape(body, circle(half), stuff);
        if (ride.rider == Rider::Capsule)
            ground.shape(body, capsule({-0.5f * half, 0.0f}, {0.5f * half, 0.0f}, 0.5f * half), stuff);
        if (ride.rider != Rider::Pentagon) return;
        std::array<Vec2, 5> corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const SinCos at = sinCos(kTau * (static_cast<float>(i) + 0.25f) / 5.0f);
            corners[i] = half * Vec2{at.cos, at.sin};
        }
        EXPECT_TRUE(createPolygon(ground.world, body, corners, 0.0f, stuff).ok());
    }

    [[nodiscard]] float height() const { return unrotate(rotation, toVec2(centreOf(ground.world, body))).y; }
    [[nodiscard]] float speed() const { return unrotate(rotation, velocityOf(ground.world, body)).x; }
};

struct Loss {            // what the seams between tiles do to a body that slides or rolls over them
    float speed = 0.0f;  // largest difference of the speeds on tiles and on a single floor / initial speed
    float hop = 0.0f;    // largest deviation from the height at the start, m
};

Loss lossOf(const Ride& ride) {
    Track tiles{ride, true}, single{ride, false};
    Loss loss;
    const float rest = tiles.height();
    for (int i = 0; i < ride.steps(); ++i) {
        tiles.ground.run(1);
        single.ground.run(1);
        loss.hop = std::max(loss.hop, std::fabs(tiles.height() - rest));
        loss.speed = std::max(loss.speed, std::fabs(tiles.speed() - single.speed()) / ride.speed);
    }
    return loss;
}

TEST(TileSeams, haveNoEffectOnFlushFloors) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        const Ride ride = randomRide(static_cast<std::uint64_t>(i));
        const Loss loss = lossOf(ride);
        EXPECT_LE(loss.speed, 0.01f) << ride.text();
        EXPECT_LE(loss.hop, 0.001f) << ride.text();
    }
}

// Steps lower than the tolerance of 1 mm are ignored.
TEST(TileSeams, stepsBelowTheToleranceStopNothing) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        Ride ride = randomRide(static_cast<std::uint64_t>(i));
        ride.uneven = 8.0e-4f;
        const Loss loss = lossOf(ride);
        EXPECT_LE(loss.speed, 0.02f) << ride.text();
        EXPECT_LE(loss.hop, 0.001f + 4.0f * ride.uneven) << ride.text();
    }
}

/// A floor that ends at x = `end` at a wall or an edge, built of tiles and of a single shape for comparison.
struct Ends {
    float half = 0.2f;  // half size of the body, m
    float speed = 1.0f;
    float end = 1.0f;
    float tile = 0.5f;
    float wall = 0.0f;  // height of the wall at the end, m; 0: an edge
    bool turns = true;
    std::uint64_t seed = 0;

    [[nodiscard]] BodyId build(Playground& ground, bool tiled) const {
        Random random = Random::seeded(seed);
        const ShapeDefinition stuff{.friction = 0.3f};
        const BodyId fixed = ground.body(BodyKind::Static, {});
        const float start = -3.0f - tile;
        if (!tiled)
            ground.shape(fixed, box({0.5f * (end - start), 0.5f}, {0.5f * (end + start), -0.5f}), stuff);
        for (float edge = start; tiled && edge < end - 0.001f;) {
            float width = tile * random.between(0.5f, 1.0f);
            if (edge + 1.2f * width > end) width = end - edge;
            ground.shape(fixed, box({0.5f * width, 0.5f}, {edge + 0.5f * width, -0.5f}), stuff);
            edge += width;
        }
        if (wall > 0.0f) {
            if (!tiled)
                ground.shape(fixed, box({0.5f, 0.5f * (wall + 1.0f)}, {end + 0.5f, 0.5f * (wall - 1.0f)}),
                             stuff);
            for (float edge = wall; tiled && edge > -0.999f;) {
                float height = tile * random.between(0.5f, 1.0f);
                if (edge - 1.2f * height < -1.0f) height = edge + 1.0f;
                ground.shape(fixed, box({0.5f, 0.5f * height}, {end + 0.5f, edge - 0.5f * height}), stuff);
                edge -= height;
            }
        }
        const BodyId body = ground.crate({-2.0, static_cast<double>(half)}, {half, half}, stuff);
        if (!turns) setFixedRotation(ground.world, body, true);
        ground.run(20);
        EXPECT_TRUE(setVelocity(ground.world, body, {speed, 0.0f}).ok());
        return body;
    }
};

Ends randomEnds(std::uint64_t seed) {
    Random random = Random::seeded(seed + 5);
    Ends ends;
    ends.seed = seed;
    ends.half = 0.02f * std::pow(50.0f, random.unit());
    ends.speed = random.between(4.0f, 12.0f);
    ends.end = random.between(0.1f, 0.8f);
    ends.tile = random.between(0.1f, 1.0f);
    ends.turns = seed % 2 == 0;
    return ends;
}

// At the end of the floor, bodies leave and tip over like on a single shape.
TEST(TileSeams, realEdgesActAsEdges) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        const Ends ends = randomEnds(static_cast<std::uint64_t>(i));
        Playground tiles, single;
        const BodyId a = ends.build(tiles, true), b = ends.build(single, false);
        for (int tick = 0; tick < 90; ++tick) {
            tiles.run(1);
            single.run(1);
            ASSERT_NEAR(tiles.x(a), single.x(b), 0.2) << i << " half " << ends.half << " tick " << tick;
            ASSERT_NEAR(tiles.y(a), single.y(b), 0.2) << i << " half " << ends.half << " tick " << tick;
        }
    }
}

// Steps higher than the resting overlap, and walls, stop sliding bodies.
TEST(TileSeams, realStepsStopBodies) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        Ends ends = randomEnds(static_cast<std::uint64_t>(i));
        Random random = Random::seeded(static_cast<std::uint64_t>(i) + 9);
        // A body that can rotate would tip over a step below its center.
        ends.wall = ends.turns ? random.between(1.2f, 3.0f) * ends.half : random.between(0.01f, 1.0f);
        Playground tiles, single;
        const BodyId a = ends.build(tiles, true), b = ends.build(single, false);
        double far = static_cast<double>(ends.end - ends.half);
        for (int tick = 0; tick < 90; ++tick) {
            tiles.run(1);
            single.run(1);
            far = std::max(far, single.x(b));
            ASSERT_LE(tiles.x(a), far + 0.01)
                << i << " half " << ends.half << " wall " << ends.wall << " speed " << ends.speed;
        }
    }
}

// The corner of an overlapping floor and wall holds a body on both sides, at any angle and load.
TEST(TileSeams, cornersOfOverlappingShapesHoldOnBothSides) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        Random random = Random::seeded(static_cast<std::uint64_t>(i) + 21);
        const float half = 0.05f * std::pow(20.0f, random.unit()), lean = random.between(0.0f, 0.8f);
        const float load = random.between(10.0f, 60.0f);  // m/s2
        Playground ground;
        // The load is too steep to push the body up along the wall.
        const float side = random.between(0.2f, 0.8f) * std::min(1.0f, std::cos(lean) / std::sin(lean));
        ground.world.settings.gravity = load * normalized(Vec2{-side, -1.0f});
        const BodyId fixed = ground.body(BodyKind::Static, {});
        ground.shape(fixed, box({5.0f, 0.5f}, {4.0f, -0.5f}));
        const std::array<Vec2, 4> wall{Vec2{-3.0f, -1.0f}, Vec2{std::sin(lean), -1.0f},
                                       Vec2{-4.0f * std::sin(lean), 4.0f * std::cos(lean)},
                                       Vec2{-3.0f - 4.0f * std::sin(lean), 4.0f * std::cos(lean)}};
        ASSERT_TRUE(createPolygon(ground.world, fixed, wall).ok());
        const BodyId body =
            ground.body(BodyKind::Dynamic, {3.0 * static_cast<double>(half), 1.5 * static_cast<double>(half)},
                        random.between(-3.0f, 3.0f));
        const std::array<Vec2, 3> corners{Vec2{-half, -half}, Vec2{half, -half}, Vec2{0.0f, half}};
        ASSERT_TRUE(createPolygon(ground.world, body, corners, 0.0f, {.friction = 0.0f}).ok());
        ground.run(150);
        float low = 1.0f, deep = 1.0f;
        for (const Vec2 corner : corners) {
            const BodyPose& pose = ground.world.bodies.pose[body.index];
            const Vec2 at = toVec2(pose.centre + rotate(pose.rotation, corner - pose.localCentre));
            low = std::min(low, at.y);
            const Vec2 along = normalized(wall[2] - wall[1]);
            deep = std::min(deep, cross(at - wall[1], along));
        }
        EXPECT_GE(low, -0.02f) << i << " half " << half << " lean " << lean << " load " << load;
        EXPECT_GE(deep, -0.02f) << i << " half " << half << " lean " << lean << " load " << load;
    }
}

// A row of polygons must act on bodies like a chain, whose joints are smooth due to ghost vertices.
TEST(TileSeams, slopesOfPolygonsActLikeChains) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        Random random = Random::seeded(static_cast<std::uint64_t>(i) + 3);
        std::vector<Vec2> line{{-2.0f, 0.0f}, {0.0f, 0.0f}};
        const float half = 0.05f * std::pow(10.0f, random.unit()), bend = random.between(0.0f, 0.1f);
        for (float slope = 0.0f; line.size() < 30;) {
            slope = std::clamp(slope + random.between(-bend, bend), -0.6f, 0.6f);
            const float width = random.between(0.3f, 1.5f);
            line.push_back(line.back() + Vec2{width, slope * width});
        }
        Playground tiles, chain;
        const ShapeDefinition smooth{.friction = 0.0f};
        const BodyId a = tiles.body(BodyKind::Static, {}), b = chain.body(BodyKind::Static, {});
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const Vec2 down{0.0f, 1.0f};
            const std::array<Vec2, 4> corners{line[k] - down, line[k + 1] - down, line[k + 1], line[k]};
            ASSERT_TRUE(createPolygon(tiles.world, a, corners, 0.0f, smooth).ok());
            const Vec2 before = k > 0 ? line[k - 1] : line[k],
                       after = k + 2 < line.size() ? line[k + 2] : line[k + 1];
            chain.shape(b, chainSegment(after, line[k + 1], line[k], before), smooth);
        }
        const float speed = random.between(2.0f, 10.0f);
        for (Playground* ground : {&tiles, &chain}) {
            const BodyId ball = ground->ball({-1.0, static_cast<double>(half)}, half, smooth);
            EXPECT_TRUE(setVelocity(ground->world, ball, {speed, 0.0f}).ok());
        }
        const BodyId ball{1, 0};
        for (int tick = 0; tick < 120 && tiles.x(ball) < 15.0 && tiles.x(ball) > -1.5; ++tick) {
            tiles.run(1);
            chain.run(1);
            ASSERT_NEAR(tiles.x(ball), chain.x(ball), 0.05 + 0.005 * chain.x(ball))
                << i << " half " << half << " speed " << speed << " tick " << tick;
            ASSERT_NEAR(tiles.y(ball), chain.y(ball), 0.05)
                << i << " half " << half << " speed " << speed << " tick " << tick;
        }
    }
}

// A swept body must hit the floor, not the edges between its tiles.
TEST(TileSeams, fastBodiesBounceAsOffASingleFloor) {
    for (int i = 0; i < membersToTry(1000); ++i) {
        Random random = Random::seeded(static_cast<std::uint64_t>(i) + 11);
        const float half = 0.02f * std::pow(25.0f, random.unit()), tile = half * random.between(0.5f, 4.0f);
        const Vec2 velocity{random.between(5.0f, 100.0f), -random.between(2.0f, 100.0f)};
        const ShapeDefinition stuff{.friction = 0.0f, .bounciness = random.below(2) == 0 ? 0.0f : 0.5f};
        const bool isBullet = random.below(2) == 0, isBall = random.below(2) == 0;
        const float height = half + random.between(0.1f, 1.0f) * -velocity.y * kTick;
        Playground grounds[2];
        Vec2 after[2];
        for (int tiled = 0; tiled < 2; ++tiled) {
            Playground& ground = grounds[tiled];
            ground.world.settings.gravity = {};
            const BodyId fixed = ground.body(BodyKind::Static, {});
            if (tiled == 0) ground.shape(fixed, box({40.0f, 0.5f}, {0.0f, -0.5f}), stuff);
            for (float edge = -1.0f; tiled == 1 && edge < 7.0f; edge += tile)
                ground.shape(fixed, box({0.5f * tile, 0.5f}, {edge + 0.5f * tile, -0.5f}), stuff);
            const BodyId body = *createBody(
                ground.world,
                {.position = {0.0, static_cast<double>(height)}, .velocity = velocity, .bullet = isBullet});
            ground.shape(body, isBall ? circle(half) : box({half, half}), stuff);
            ground.run(3);
            after[tiled] = ground.velocity(body);
        }
        EXPECT_LE(length(after[1] - after[0]), 0.1f * length(velocity))
            << i << (isBullet ? " bullet" : "") << (isBall ? " ball " : " box ") << half << " tile " << tile
            << " " << velocity.x << " " << velocity.y << " after " << after[0].x << " " << after[0].y << ", "
            << after[1].x << " " << after[1].y;
    }
}

}  // namespace
}  // namespace plumb::physics
