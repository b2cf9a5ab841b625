#include <algorithm>
#include <cmath>
#include <string>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/effect_worlds.hpp"

// Contacts between soft and rigid bodies.

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kDensity = 4.2f;  // kg/m2
constexpr float kSmall = 0.15f;   // radius of balls and half size of crates, m

SoftBodyId addJelly(World& world, WorldPosition place, float radius, const SoftMaterial& material) {
    std::vector<Vec2> ring;
    for (int i = 0; i < 36; ++i)
        ring.push_back(rotate(rotFromAngle(kTau * static_cast<float>(i) / 36.0f), {radius, 0.0f}));
    return *createJelly(world, place, ring, material);
}

SoftMaterial jelly(float mass, float damping) {
    SoftMaterial material;
    material.mass = mass;
    material.radius = 0.02f;
    material.stretchCompliance = 2.0e-5f;
    material.bendCompliance = 5.0e-5f;
    material.friction = 0.8f;
    material.damping = damping;
    return material;
}

BodyId addSmall(World& world, WorldPosition place, const Geometry& outline) {
    return addBody(world, BodyKind::Dynamic, place, outline, {.density = kDensity, .friction = 0.6f});
}
BodyId addBall(World& world, WorldPosition place) { return addSmall(world, place, circle(kSmall)); }
BodyId addCrate(World& world, WorldPosition place) { return addSmall(world, place, box({kSmall, kSmall})); }
void addPost(World& world, double x) { addBody(world, BodyKind::Static, {x, -0.5}, box({0.1f, 0.5f})); }

/// Sums over all soft and rigid bodies; the angular momentum is about the origin.
struct Motion {
    double x = 0.0, y = 0.0;       // momentum, kg m/s
    double angularMomentum = 0.0;  // kg m2/s
    double energy = 0.0;           // J
    double size = 0.0;             // sum of the magnitudes of all momenta, kg m/s
};

void add(Motion& sum, float mass, WorldPosition place, Vec2 velocity) {
    const double m = mass, x = velocity.x, y = velocity.y;
    sum.x += m * x, sum.y += m * y;
    sum.angularMomentum += m * (place.x * y - place.y * x);
    sum.energy += 0.5 * m * (x * x + y * y);
    sum.size += m * std::sqrt(x * x + y * y);
}

Motion motionOf(const World& world) {
    Motion sum;
    for (const SoftBody& body : world.softBodies.all) {
        for (const SoftParticle& p : body.particles) add(sum, p.mass, p.place, p.velocity);
    }
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const BodyMass& mass = world.bodies.mass[i];
        const BodyMotion& motion = world.bodies.motion[i];
        if (mass.inverseMass == 0.0f) continue;
        add(sum, mass.mass, world.bodies.pose[i].centre, motion.velocity);
        const double spin = motion.angularVelocity, inertia = mass.inertia;
        sum.angularMomentum += inertia * spin;
        sum.energy += 0.5 * inertia * spin * spin;
    }
    return sum;
}

/// Maximum speed of any body within the next two seconds, m/s. Damped motion decays, motion driven by an
/// error does not.
float fastestPoint(World& world) {
    float most = 0.0f;
    for (int i = 0; i < 120; ++i) {
        run(world, 1);
        for (const std::uint32_t body : world.awake) {
            const BodyMotion& motion = world.bodies.motion[body];
            most = std::max(most, length(motion.velocity) + kSmall * std::fabs(motion.angularVelocity));
        }
    }
    return most;
}

/// Builds a random scene in which a ball or crate hits a jelly, without gravity and damping.
World makeBlow(std::uint64_t seed) {
    Random random = Random::seeded(seed);
    World world = makeWorld();
    world.settings.gravity = {};
    const SoftBodyId soft = addJelly(world, {0.0, 0.0}, 0.5f, jelly(1.0f + 40.0f * random.unit(), 0.0f));
    const float off = random.unit() - 0.5f;
    const BodyId body = seed % 2 == 0 ? addBall(world, {1.0, off}) : addCrate(world, {1.0, off});
    EXPECT_TRUE(setVelocity(world, body, {-3.0f * random.unit(), 0.5f * (random.unit() - 0.5f)}).ok());
    EXPECT_TRUE(setAngularVelocity(world, body, 20.0f * (random.unit() - 0.5f)).ok());
    const Vec2 pushed{1.0f + random.unit(), 0.0f};
    for (int i = 0; i < 36; ++i) EXPECT_TRUE(setParticleVelocity(world, soft, i, pushed).ok());
    return world;
}

float thrownOf(const World& world) { return world.bodies.motion[0].velocity.x; }

TEST(SoftContacts, impactsConserveMomentumAndAddNoEnergy) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        World world = makeBlow(seed);
        const Motion before = motionOf(world);
        const float thrown = thrownOf(world);
        for (int i = 0; i < 120; ++i) {
            run(world, 1);
            const Motion now = motionOf(world);
            ASSERT_NEAR(now.x, before.x, 1.0e-5 * before.size) << i;
            ASSERT_NEAR(now.y, before.y, 1.0e-5 * before.size) << i;
            ASSERT_LT(now.energy, before.energy * (1.0 + 1.0e-4)) << i;
        }
        EXPECT_GT(thrownOf(world), thrown) << "the ball or crate never hit the jelly";
    }
}

TEST(SoftContacts, impactsConserveAngularMomentum) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        World world = makeBlow(seed);
        const Motion before = motionOf(world);
        run(world, 120);
        EXPECT_NEAR(motionOf(world).angularMomentum, before.angularMomentum, 0.03 * before.size);
    }
}

/// Scene with a jelly on the floor between two posts, and rigid bodies on, under or beside the jelly.
struct Leaning {
    const char* name;
    double post;  // x of the right post, m; the left one is at x = -0.8 m
    void (*add)(World& world);
};

constexpr Leaning kLeanings[] = {
    {"a ball on the jelly", 0.8,
     [](World& world) {
         addBall(world, {0.03, -1.6});
     }},
    {"a ball under the jelly", 0.8,
     [](World& world) {
         addBall(world, {0.45, -0.15});
     }},
    {"a crate beside the jelly", 1.1,
     [](World& world) {
         addCrate(world, {0.75, -0.2});
     }},
    {"a ball between jelly and post", 0.9,
     [](World& world) {
         addBall(world, {0.6, -1.4});
     }},
    {"a crate between jelly and ball", 1.15,
     [](World& world) {
         addCrate(world, {0.62, -1.2}), addBall(world, {0.85, -1.6});
     }},
};

World makeLeaning(const Leaning& leaning, float mass) {
    World world = makeWorld();
    addFloor(world);
    addPost(world, -0.8);
    addPost(world, leaning.post);
    addJelly(world, {0.0, -0.6}, 0.55f, jelly(mass, 1.5f));
    leaning.add(world);
    return world;
}

TEST(SoftContacts, bodiesThatLeanOnAJellyComeToRest) {
    const float slow = BodyDefinition{}.sleepSpeed;
    for (const Leaning& leaning : kLeanings) {
        for (const float mass : {20.0f, 60.0f}) {
            SCOPED_TRACE(std::string{leaning.name} + ", " + std::to_string(mass) + " kg");
            World world = makeLeaning(leaning, mass);
            run(world, 1080);
            EXPECT_LT(fastestPoint(world), slow);
        }
    }
}

TEST(SoftContacts, bodiesOnAJellyFallAsleep) {
    World world = makeLeaning(kLeanings[4], 20.0f);
    world.settings.sleeping = true;
    run(world, 1200);
    EXPECT_TRUE(world.awake.empty());
}

TEST(SoftContacts, sleepingBodiesFallWhenTheirJellyIsDestroyed) {
    World world = makeLeaning(kLeanings[0], 20.0f);
    world.settings.sleeping = true;
    run(world, 1200);
    ASSERT_TRUE(world.awake.empty());
    for (std::uint32_t i = 0; i < world.softBodies.all.size(); ++i)
        destroySoftBody(world, {i, world.softBodies.all[i].generation});
    EXPECT_FALSE(world.awake.empty());
    run(world, 60);
    EXPECT_GT(world.bodies.pose.back().centre.y, -0.5) << "it lies on the floor";
}

}  // namespace
}  // namespace plumb::physics
