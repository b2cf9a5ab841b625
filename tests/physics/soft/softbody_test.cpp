#include "physics/soft/softbody.hpp"

#include <cmath>
#include <limits>

#include "physics/model/fields.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

Vec2 wayOf(const World& world, SoftBodyId body, std::size_t from, std::size_t to) {
    const std::span<const SoftParticle> particles = particlesOf(world, body);
    return particles[to].place - particles[from].place;
}

TEST(SoftBody, aRopeFallsFreely) {
    World world = makeWorld();
    SoftMaterial material;
    material.damping = 0.0f;
    const SoftBodyId rope = *createRope(world, {0.0, 0.0}, {2.0, 0.0}, 20, material);
    run(world, 60);
    for (const SoftParticle& p : particlesOf(world, rope)) EXPECT_NEAR(p.place.y, 5.0, 0.02);
}

TEST(SoftBody, aRopeHangsAtItsLengthFromItsPin) {
    World world = makeWorld();
    SoftMaterial material;
    material.damping = 2.0f;
    const SoftBodyId rope = *createRope(world, {0.0, 0.0}, {2.0, 0.0}, 20, material);
    ASSERT_TRUE(pinParticle(world, rope, 0, true).ok());
    run(world, 900);
    EXPECT_EQ(particlesOf(world, rope)[0].place, WorldPosition(0.0, 0.0));
    EXPECT_NEAR(wayOf(world, rope, 0, 19).x, 0.0f, 0.05f);
    EXPECT_NEAR(wayOf(world, rope, 0, 19).y, 2.0f, 0.06f);  // it stretches slightly
}

TEST(SoftBody, aClothLiesOnTheFloor) {
    World world = makeWorld();
    addFloor(world);
    const SoftBodyId cloth = *createCloth(world, {-1.0, -2.0}, {2.0f, 1.0f}, 12, 8);
    run(world, 300);
    for (const SoftParticle& p : particlesOf(world, cloth)) EXPECT_LT(p.place.y, -0.05 + 0.01);
    EXPECT_EQ(runsOf(world, "soft bodies"), 300u);
}

TEST(SoftBody, windMovesARopeOnlyInsideItsRegion) {
    const auto asideIn = [](Vec2 half) {
        World world = makeWorld();
        const SoftBodyId rope = *createRope(world, {0.0, 0.0}, {0.0, 2.0}, 20);
        EXPECT_TRUE(pinParticle(world, rope, 0, true).ok());
        FieldDefinition wind;
        wind.kind = FieldKind::Wind;
        wind.region = RegionKind::Box;
        wind.half = half;
        wind.velocity = {5.0f, 0.0f};
        EXPECT_TRUE(createField(world, wind).ok());
        run(world, 300);
        return wayOf(world, rope, 0, 19).x;
    };
    EXPECT_GT(asideIn({10.0f, 10.0f}), 0.5f);
    EXPECT_EQ(asideIn({0.5f, 0.01f}), 0.0f) << "only the pinned particle is in the wind";
}

TEST(SoftBody, aJellyKeepsItsArea) {
    World world = makeWorld();
    addFloor(world);
    std::vector<Vec2> outline;
    for (int i = 0; i < 24; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / 24.0f);
        outline.push_back({at.cos, at.sin});
    }
    SoftMaterial material;
    material.bendCompliance = 0.001f;
    const SoftBodyId jelly = *createJelly(world, {0.0, -3.0}, outline, material);
    run(world, 300);
    float area = 0.0f;
    double lowest = -1e9;
    const std::span<const SoftParticle> particles = particlesOf(world, jelly);
    for (std::size_t i = 0; i < 24; ++i) {
        const WorldPosition middle{0.0, -1.0};
        area += 0.5f * cross(particles[i].place - middle, particles[(i + 1) % 24].place - middle);
        lowest = std::max(lowest, particles[i].place.y);
    }
    EXPECT_NEAR(area, softBodyOf(world, jelly).area, 0.03f * std::fabs(area));
    EXPECT_NEAR(lowest, -0.05, 0.02);
}

TEST(SoftBody, pushesABodyThatItFallsOn) {
    World world = makeWorld();
    world.settings.gravity = {};
    ShapeDefinition light;
    light.density = 0.1f;
    const BodyId ball = addBody(world, BodyKind::Dynamic, {0.0, 0.0}, circle(0.5f), light);
    SoftMaterial heavy;
    heavy.mass = 5.0f;
    heavy.damping = 0.0f;
    const SoftBodyId rope = *createRope(world, {-1.0, -1.0}, {1.0, -1.0}, 30, heavy);
    for (SoftParticle& p : world.softBodies.all[rope.index].particles) p.velocity = {0.0f, 3.0f};
    run(world, 60);
    const auto momentum = [&] {
        float sum = massOf(world, ball) * velocityOf(world, ball).y;
        for (const SoftParticle& p : particlesOf(world, rope)) sum += p.mass * p.velocity.y;
        return sum;
    };
    EXPECT_GT(velocityOf(world, ball).y, 1.0f);
    EXPECT_NEAR(momentum(), 15.0f, 0.3f);
}

TEST(SoftBody, aCopyOfTheWorldContinuesWithTheSameBits) {
    World world = makeWorld();
    addFloor(world);
    addBody(world, BodyKind::Dynamic, {0.2, -0.5}, circle(0.5f));
    static_cast<void>(*createCloth(world, {-1.0, -3.0}, {2.0f, 1.0f}, 10, 6));
    run(world, 50);
    World copy = world;
    run(world, 100);
    run(copy, 100);
    EXPECT_EQ(hashOf(world), hashOf(copy));
    EXPECT_TRUE(sameState(world, copy));
}

TEST(SoftBody, isNeitherSimulatedNorStoredOnceDestroyed) {
    World world = makeWorld();
    const SoftBodyId rope = *createRope(world, {0.0, 0.0}, {2.0, 0.0}, 20);
    destroySoftBody(world, rope);
    destroySoftBody(world, rope);
    EXPECT_FALSE(alive(world, rope));
    addBody(world, BodyKind::Dynamic, {0.0, 0.0}, circle(0.5f));
    run(world, 10);
    EXPECT_EQ(runsOf(world, "soft bodies"), 0u);
    EXPECT_FALSE(pinParticle(world, rope, 0, true).ok());
}

TEST(SoftBody, rejectsInvalidDefinitions) {
    World world = makeWorld();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {nan, 0.0f, -1.0f, std::numeric_limits<float>::infinity()}) {
        SoftMaterial material;
        material.mass = bad;
        EXPECT_FALSE(createRope(world, {}, {1.0, 0.0}, 5, material).ok());
    }
    EXPECT_FALSE(createRope(world, {}, {1.0, 0.0}, 1).ok());
    EXPECT_FALSE(createCloth(world, {}, {1.0f, nan}, 5, 5).ok());
    const Vec2 line[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}};
    EXPECT_FALSE(createJelly(world, {}, line).ok());
    const SoftBodyId rope = *createRope(world, {}, {1.0, 0.0}, 5);
    EXPECT_FALSE(pinParticle(world, rope, 5, true).ok());
    EXPECT_FALSE(moveParticle(world, rope, -1, {}).ok());
}

TEST(SoftBody, impulsesMoveParticlesUnlessPinnedOrInvalid) {
    World world;
    const SoftBodyId rope = *createRope(world, {0.0, 0.0}, {0.0, 1.0}, 5);
    ASSERT_TRUE(pinParticle(world, rope, 0, true).ok());
    for (const int particle : {0, 4})
        ASSERT_TRUE(setParticleVelocity(world, rope, particle, {3.0f, 0.0f}).ok());
    EXPECT_EQ(particlesOf(world, rope)[0].velocity, Vec2{});
    EXPECT_EQ(particlesOf(world, rope)[4].velocity, (Vec2{3.0f, 0.0f}));
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(setParticleVelocity(world, rope, 4, {kNan, 0.0f}).ok());
    EXPECT_FALSE(setParticleVelocity(world, rope, 5, {}).ok());
    EXPECT_FALSE(setParticleVelocity(world, rope, -1, {}).ok());
    destroySoftBody(world, rope);
    EXPECT_FALSE(setParticleVelocity(world, rope, 0, {}).ok());
}

}  // namespace
}  // namespace plumb::physics
