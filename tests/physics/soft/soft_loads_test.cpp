#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/effect_worlds.hpp"

// Soft bodies under or on top of bodies that are much heavier or lighter.

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kGravity = 10.0f;     // m/s2
constexpr int kTenSeconds = 600;      // number of steps in ten seconds
constexpr float kNearRest = 4.0e-3f;  // maximum speed of crates, m/s; they rock on round jellies for a while
constexpr float kAtRest = 1.0e-3f;    // maximum speed of bodies at rest, m/s

/// A jelly of 1 kg between two posts, and crates on it or a crate below it.
struct Load {
    float radius = 0.5f;      // radius of the jelly, m
    float crate = 0.2f;       // half the side length of a crate, m
    float mass = 1.0f;        // total mass of the crates, kg
    float compliance = 0.0f;  // compliance of the jelly's links, m/N
    int crates = 1;           // number of crates
    bool below = false;       // true: the crate is below the jelly
};

/// Creates a random load of 1/1000 to 1000 times the mass of the jelly. Links stretch by at most 1 cm under
/// the whole load.
Load randomLoad(std::uint64_t seed) {
    Random random = Random::seeded(seed);
    Load load;
    load.radius = random.between(0.4f, 0.6f);
    load.crate = load.radius * random.between(0.3f, 0.45f);
    load.mass = std::pow(10.0f, random.between(-3.0f, 3.0f));
    load.compliance = random.unit() * std::min(2.0e-5f, 0.01f / (load.mass * kGravity));
    load.below = seed % 3 == 2;
    return load;
}

struct Loaded {
    World world;
    SoftBodyId jelly;
    std::vector<BodyId> crates;
};

constexpr float kParticle = 0.02f;  // radius of a particle, m

Loaded build(const Load& load) {
    Loaded made{makeWorld(), {}, {}};
    World& world = made.world;
    addFloor(world);
    const float wall = load.radius + kParticle;
    for (const float side : {-1.0f, 1.0f}) {
        const auto x = static_cast<double>(side * (wall + 0.1f));
        addBody(world, BodyKind::Static, {x, -3.0}, box({0.1f, 3.0f}));
    }
    SoftMaterial material;
    material.radius = kParticle;
    material.stretchCompliance = material.areaCompliance = load.compliance;
    material.bendCompliance = 5.0e-5f;
    material.friction = 0.6f;
    material.damping = 4.0f;
    std::vector<Vec2> ring;
    for (int i = 0; i < 36; ++i)
        ring.push_back(rotate(rotFromAngle(kTau * static_cast<float>(i) / 36.0f), {load.radius, 0.0f}));
    const float lowest = load.below ? 2.0f * load.crate : 0.0f;
    made.jelly = *createJelly(world, {0.0, static_cast<double>(-lowest - load.radius - 1.5f * kParticle)},
                              ring, material);
    const float side = 2.0f * load.crate;
    const float density = load.mass / (static_cast<float>(load.crates) * side * side);
    const float bottom = load.below ? 0.0f : 2.0f * load.radius + 3.0f * kParticle;
    for (int i = 0; i < load.crates; ++i) {
        const float height = bottom + (static_cast<float>(i) + 0.5f) * side;
        made.crates.push_back(addBody(world, BodyKind::Dynamic, {0.0, static_cast<double>(-height)},
                                      box({load.crate, load.crate}), {.density = density, .friction = 0.6f}));
    }
    return made;
}

/// Maximum speed of a crate, m/s.
float fastest(const Loaded& made) {
    float most = 0.0f;
    for (const BodyId body : made.crates) most = std::max(most, length(velocityOf(made.world, body)));
    return most;
}

/// Returns the maximum depth of a particle's center inside a crate, m.
float entered(const Loaded& made, float crate) {
    float most = 0.0f;
    for (const BodyId body : made.crates) {
        const BodyPose& pose = made.world.bodies.pose[body.index];
        for (const SoftParticle& p : particlesOf(made.world, made.jelly)) {
            const Vec2 at = unrotate(pose.rotation, p.place - pose.centre);
            most = std::max(most, crate - std::max(std::fabs(at.x), std::fabs(at.y)));
        }
    }
    return most;
}

/// Kinetic and potential energy, J. Springs start at rest, so they contain no energy.
double energyOf(const Loaded& made) {
    const auto g = static_cast<double>(kGravity);
    double sum = 0.0;
    for (const SoftParticle& p : particlesOf(made.world, made.jelly))
        sum += static_cast<double>(p.mass) *
               (0.5 * static_cast<double>(lengthSquared(p.velocity)) - g * p.place.y);
    for (const BodyId body : made.crates) {
        const BodyMotion& motion = made.world.bodies.motion[body.index];
        const BodyMass& mass = made.world.bodies.mass[body.index];
        const float turning = mass.inertia * motion.angularVelocity * motion.angularVelocity;
        sum += static_cast<double>(mass.mass) * (0.5 * static_cast<double>(lengthSquared(motion.velocity)) -
                                                 g * made.world.bodies.pose[body.index].centre.y) +
               0.5 * static_cast<double>(turning);
    }
    return sum;
}

TEST(SoftLoads, ofAnyMassComeToRestOnOrUnderAJelly) {
    for (std::uint64_t seed = 0; seed < 45; ++seed) {
        const Load load = randomLoad(seed);
        Loaded made = build(load);
        SCOPED_TRACE(testing::Message()
                     << seed << ": " << load.mass << " kg" << (load.below ? " below" : ""));
        const double start = energyOf(made);
        for (int i = 0; i < kTenSeconds; ++i) {
            run(made.world, 1);
            ASSERT_LT(energyOf(made), start * (start > 0.0 ? 1.001 : 0.999)) << i;
        }
        EXPECT_LT(fastest(made), kNearRest);
        run(made.world, kTenSeconds);
        EXPECT_LT(fastest(made), kAtRest);
        EXPECT_LE(entered(made, load.crate), 0.0f);
        const double height = heightOf(made.world, made.crates[0]);
        EXPECT_GT(height, static_cast<double>(load.below ? 0.9f * load.crate : load.radius));
    }
}

// Regression: crates of less than 1/150 of the mass of the jelly trembled below it at 3 to 20 cm/s.
TEST(SoftLoads, lightCratesComeToRestBelowAJelly) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Load load = randomLoad(seed);
        Random random = Random::seeded(seed + 100);
        load.mass = std::pow(10.0f, random.between(-2.7f, -1.7f));
        load.below = true;
        SCOPED_TRACE(testing::Message() << seed << ": " << load.mass << " kg");
        Loaded made = build(load);
        run(made.world, 2 * kTenSeconds);
        EXPECT_LT(fastest(made), kAtRest);
        EXPECT_LE(entered(made, load.crate), 0.0f);
    }
}

TEST(SoftLoads, stacksOfCratesStayOnAJelly) {
    for (const float mass : {0.003f, 0.03f, 0.3f, 3.0f, 30.0f}) {
        SCOPED_TRACE(mass);
        const Load load{.mass = mass, .crates = 3};
        Loaded made = build(load);
        run(made.world, 2 * kTenSeconds);
        EXPECT_LT(fastest(made), 0.05f);
        EXPECT_LE(entered(made, load.crate), 0.0f);
        for (std::size_t i = 0; i < made.crates.size(); ++i) {
            const auto lowest =
                static_cast<double>(1.8f * load.radius + 2.0f * load.crate * static_cast<float>(i));
            EXPECT_GT(heightOf(made.world, made.crates[i]), lowest) << i;
        }
    }
}

/// A crate on the floor between a jelly and a wall. Two walls close in on the jelly, then stop.
struct Squeeze {
    float size = 1.0f;   // half the side length of the jelly, m; a quarter of it is half that of the crate
    float speed = 1.0f;  // speed of the walls, half lengths per second
    float room = 0.5f;   // final distance between the walls, sides of the jelly
    float ratio = 1.0f;  // mass of the jelly / mass of the crate
    float place = 1.5f;  // x of the crate, half lengths; the walls begin at 2
    int substeps = 8;    // of the jelly
    int quality = 2;
};

Squeeze randomSqueeze(std::uint64_t seed) {
    Random random = Random::seeded(seed);
    Squeeze squeeze;
    squeeze.size = std::pow(10.0f, random.between(-1.0f, 0.5f));
    squeeze.speed = std::pow(10.0f, random.between(-0.6f, 0.3f));
    squeeze.room = random.between(0.3f, 0.8f);
    squeeze.ratio = std::pow(10.0f, random.between(0.0f, 3.0f));
    squeeze.place = random.between(1.3f, 1.7f);
    squeeze.substeps = seed % 2 == 0 ? 8 : 32;
    squeeze.quality = static_cast<int>(seed / 2 % 5);
    return squeeze;
}

/// Returns the maximum speed of the crate until it has had time to fall asleep, m/s.
float fastestOf(const Squeeze& squeeze) {
    const float size = squeeze.size, side = 0.25f * size;  // half lengths of jelly and crate, m
    World world;
    world.settings.quality = static_cast<Quality>(squeeze.quality);
    addFloor(world);
    BodyId walls[2];
    for (const int i : {0, 1}) {
        const auto x = static_cast<double>(i == 0 ? -3.0f * size : 3.0f * size);
        walls[i] = addBody(world, BodyKind::Kinematic, {x, -2.0 * static_cast<double>(size)},
                           box({size, 2.0f * size}));
    }
    std::vector<Vec2> ring;
    for (int i = 0; i < 32; ++i) {
        const Vec2 onTop{-size + 0.25f * size * static_cast<float>(i % 8), -size};
        ring.push_back(rotate(rotFromAngle(0.25f * kTau * static_cast<float>(i / 8)), onTop));
    }
    SoftMaterial material;
    material.mass = 10.0f;
    material.radius = 0.06f * size;
    material.substeps = static_cast<std::uint8_t>(squeeze.substeps);
    (void)*createJelly(world, {0.0, -1.06 * static_cast<double>(size)}, ring, material);
    const BodyId crate =
        addBody(world, BodyKind::Dynamic,
                {static_cast<double>(squeeze.place * size), -0.3 * static_cast<double>(size)},
                box({side, side}), {.density = material.mass / (squeeze.ratio * 4.0f * side * side)});
    run(world, 60);
    const int closing = static_cast<int>((2.0f - squeeze.room) / (squeeze.speed * kStep));
    float most = 0.0f;
    for (int i = 0; i < closing + 120; ++i) {
        const float speed = i < closing ? squeeze.speed * size : 0.0f;
        EXPECT_TRUE(setVelocity(world, walls[0], {speed, 0.0f}).ok());
        EXPECT_TRUE(setVelocity(world, walls[1], {-speed, 0.0f}).ok());
        run(world, 1);
        most = std::max(most, length(velocityOf(world, crate)));
    }
    return most;
}

// Regression: a crate that turned within a step, fell asleep or woke while a jelly pressed it against a wall
// was shot away at up to 4000 m/s: 2 of these, 21 of 1000 seeds. Now none of 1000 is.
TEST(SoftLoads, cratesBetweenAJellyAndAWallAreNotShotAway) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Squeeze squeeze = randomSqueeze(seed);
        const float size = squeeze.size;
        const float fall = std::sqrt(2.0f * kGravity * 4.0f * size);  // m/s
        EXPECT_LT(fastestOf(squeeze), 3.0f * (2.0f * squeeze.speed * size + fall))
            << seed << ": ratio " << squeeze.ratio << ", quality " << squeeze.quality;
    }
}

// Regression: in the step in which it woke, it had no contacts, and was pushed into the floor at 1.8 m/s.
TEST(SoftLoads, aCrateThatAJellyWakesStaysOnTheFloor) {
    Loaded made = build({.mass = 0.01f, .below = true});
    World& world = made.world;
    world.settings.sleeping = true;
    for (int i = 0; i < 36; ++i) {  // lifts the jelly, which then falls on the sleeping crate
        const WorldPosition place = particlesOf(world, made.jelly)[static_cast<std::size_t>(i)].place;
        ASSERT_TRUE(moveParticle(world, made.jelly, i, {place.x, place.y - 1.5}).ok());
    }
    bool slept = false;
    for (int i = 0; i < 60; ++i) {
        run(world, 1);
        slept = slept || world.awake.empty();
        ASSERT_LT(fastest(made), 0.5f) << i;
    }
    EXPECT_TRUE(slept && !world.awake.empty());
}

TEST(SoftLoads, aRopeCarriesBodies) {
    for (const float mass : {0.01f, 1.0f, 20.0f}) {
        SCOPED_TRACE(mass);
        World world = makeWorld();
        SoftMaterial material;
        material.damping = 3.0f;
        const SoftBodyId rope = *createRope(world, {-1.0, 0.0}, {1.0, 0.0}, 21, material);
        for (const int end : {0, 20}) ASSERT_TRUE(pinParticle(world, rope, end, true).ok());
        const BodyId ball =
            addBody(world, BodyKind::Dynamic, {0.0, -0.4}, circle(0.2f), {.density = mass / (kPi * 0.04f)});
        run(world, 2 * kTenSeconds);
        EXPECT_LT(length(velocityOf(world, ball)), 0.01f);
        EXPECT_GT(heightOf(world, ball), -1.0) << "it did not fall through";
    }
}

TEST(SoftLoads, aJellyInFreeFlightStopsDeforming) {
    for (const float compliance : {0.0f, 2.0e-5f, 1.0e-3f}) {
        SCOPED_TRACE(compliance);
        Loaded made = build({.compliance = compliance});
        World& world = made.world;
        world.settings.gravity = {};
        run(world, kTenSeconds);
        for (const SoftParticle& p : particlesOf(world, made.jelly))
            ASSERT_LT(length(p.velocity), kAtRest) << "solver errors must not travel around the ring";
    }
}

TEST(SoftLoads, islandsThatShareASoftBodyAreSolvedTogether) {
    World world = makeWorld();
    world.settings.gravity = {};
    SoftMaterial material;
    material.damping = 0.0f;
    const SoftBodyId rope = *createRope(world, {-1.0, 0.0}, {1.0, 0.0}, 21, material);
    const BodyId fine = addBody(world, BodyKind::Dynamic, {-0.7, -0.5}, circle(0.2f), {}, {.quality = 5});
    const BodyId coarse = addBody(world, BodyKind::Dynamic, {0.7, -0.5}, circle(0.2f));
    for (const BodyId ball : {fine, coarse}) ASSERT_TRUE(setVelocity(world, ball, {0.0f, 2.0f}).ok());
    run(world, 60);
    double momentum = 0.0;
    for (const SoftParticle& p : particlesOf(world, rope))
        momentum += static_cast<double>(p.mass) * static_cast<double>(p.velocity.y);
    double before = 0.0;
    for (const BodyId ball : {fine, coarse}) {
        momentum += static_cast<double>(massOf(world, ball) * velocityOf(world, ball).y);
        before += static_cast<double>(massOf(world, ball) * 2.0f);
        EXPECT_LT(velocityOf(world, ball).y, 1.99f) << "the ball must have hit the rope";
    }
    EXPECT_NEAR(momentum, before, 1.0e-5 * before);
}

}  // namespace
}  // namespace plumb::physics
