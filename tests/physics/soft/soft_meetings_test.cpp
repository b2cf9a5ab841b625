#include <cmath>

#include "core/random.hpp"
#include "core/task_pool.hpp"
#include "math/portable.hpp"
#include "physics/soft/soft_contacts.hpp"
#include "physics/soft/softbody.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/effect_worlds.hpp"
#include "tests/support/allocations.hpp"

// Contacts between soft bodies.

namespace plumb::physics {
namespace {

using namespace test;

std::vector<Vec2> ringOf(float radius, int points) {
    std::vector<Vec2> ring;
    for (int i = 0; i < points; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / static_cast<float>(points));
        ring.push_back({radius * at.cos, radius * at.sin});
    }
    return ring;
}

SoftMaterial firm(float mass, float damping = 0.5f) {
    SoftMaterial material;
    material.mass = mass;
    material.bendCompliance = 1.0e-4f;
    material.damping = damping;
    return material;
}

SoftBodyId addJelly(World& world, WorldPosition place, float radius, const SoftMaterial& material) {
    return *createJelly(world, place, ringOf(radius, 24), material);
}

void push(World& world, SoftBodyId body, Vec2 velocity) {
    const int count = static_cast<int>(particlesOf(world, body).size());
    for (int i = 0; i < count; ++i) EXPECT_TRUE(setParticleVelocity(world, body, i, velocity).ok());
}

Vec2 middleOf(const World& world, SoftBodyId body) {
    Vec2 sum;
    for (const SoftParticle& p : particlesOf(world, body)) sum += toVec2(p.place);
    return sum / static_cast<float>(particlesOf(world, body).size());
}

Vec2 meanVelocity(const World& world, SoftBodyId body) {
    Vec2 sum;
    for (const SoftParticle& p : particlesOf(world, body)) sum += p.velocity;
    return sum / static_cast<float>(particlesOf(world, body).size());
}

/// Distance from a position to the nearest edge of a soft body, m; negative inside its ring.
float gapTo(const SoftBody& other, WorldPosition place) {
    float nearest = 1.0e9f, winding = 0.0f;
    for (const SoftLink& link : other.links) {
        if (!link.isEdge) continue;
        const Vec2 a = other.particles[link.a].place - place, b = other.particles[link.b].place - place;
        const float t = std::clamp(-dot(a, b - a) / lengthSquared(b - a), 0.0f, 1.0f);
        nearest = std::min(nearest, length(lerp(a, b, t)));
        winding += angleOf(Rot{dot(a, b), cross(a, b)});
    }
    return !other.ring.empty() && std::fabs(winding) > kPi ? -nearest : nearest;
}

/// Minimum distance of any particle of one body to the other body, m.
float gapBetween(const World& world, SoftBodyId a, SoftBodyId b) {
    float gap = 1.0e9f;
    for (const SoftParticle& p : particlesOf(world, a))
        gap = std::min(gap, gapTo(softBodyOf(world, b), p.place));
    for (const SoftParticle& p : particlesOf(world, b))
        gap = std::min(gap, gapTo(softBodyOf(world, a), p.place));
    return gap;
}

constexpr float kApart = 0.1f;  // sum of both particle radii, m

struct Momentum {
    double x = 0.0, y = 0.0;
};
Momentum momentumOf(const World& world) {
    Momentum sum;
    for (const SoftBody& body : world.softBodies.all) {
        for (const SoftParticle& p : body.particles) {
            sum.x += static_cast<double>(p.mass) * static_cast<double>(p.velocity.x);
            sum.y += static_cast<double>(p.mass) * static_cast<double>(p.velocity.y);
        }
    }
    return sum;
}

TEST(SoftSoftContacts, aJellyRestsOnAnother) {
    World world = makeWorld();
    addFloor(world);
    const SoftBodyId below = addJelly(world, {0.0, -0.7}, 0.6f, firm(2.0f));
    const SoftBodyId above = addJelly(world, {0.05, -2.2}, 0.6f, firm(2.0f));
    addBody(world, BodyKind::Static, {-1.0, -2.0}, box({0.3f, 2.0f}));  // posts: nothing rolls off
    addBody(world, BodyKind::Static, {1.0, -2.0}, box({0.3f, 2.0f}));
    for (int i = 0; i < 600; ++i) {
        run(world, 1);
        ASSERT_GT(gapBetween(world, below, above), kApart - 0.01f) << i;
    }
    EXPECT_GT(gapBetween(world, below, above), kApart - 0.002f);
    EXPECT_LT(gapBetween(world, below, above), kApart + 0.002f);
    EXPECT_LT(middleOf(world, above).y, middleOf(world, below).y - 0.8f);
}

TEST(SoftSoftContacts, aRopeCarriesAJelly) {
    World world = makeWorld();
    const SoftBodyId rope = *createRope(world, {-1.5, 0.0}, {1.5, 0.0}, 40, firm(1.0f));
    ASSERT_TRUE(pinParticle(world, rope, 0, true).ok());
    ASSERT_TRUE(pinParticle(world, rope, 39, true).ok());
    const SoftBodyId jelly = addJelly(world, {0.1, -1.0}, 0.4f, firm(1.0f));
    run(world, 900);
    EXPECT_GT(gapBetween(world, rope, jelly), kApart - 0.005f);
    EXPECT_LT(gapBetween(world, rope, jelly), kApart + 0.005f);
    EXPECT_NEAR(middleOf(world, jelly).x, 0.0f, 0.5f);
}

TEST(SoftSoftContacts, aRopeHangsOverAnother) {
    World world = makeWorld();
    const SoftBodyId bar = *createRope(world, {0.0, -0.5}, {0.0, 0.5}, 2, firm(1.0f));
    for (const int end : {0, 1}) ASSERT_TRUE(pinParticle(world, bar, end, true).ok());
    const SoftBodyId rope = *createRope(world, {-1.0, -1.0}, {1.0, -1.0}, 41, firm(1.0f));
    run(world, 300);
    EXPECT_GT(gapBetween(world, bar, rope), kApart - 0.01f);
    EXPECT_LT(particlesOf(world, rope)[20].place.y, -0.55);
}

TEST(SoftSoftContacts, impactsConserveMomentum) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = makeWorld();
        world.settings.gravity = {};
        const SoftBodyId a = addJelly(world, {-1.5, 0.0}, 0.3f + 0.4f * random.unit(),
                                      firm(0.5f + 4.0f * random.unit(), 0.0f));
        const SoftBodyId b = seed % 3 == 0 ? *createRope(world, {1.0, -1.0}, {1.0, 1.0}, 20, firm(2.0f, 0.0f))
                             : seed % 3 == 1
                                 ? *createCloth(world, {1.0, -0.5}, {0.8f, 1.0f}, 6, 8, firm(1.0f, 0.0f))
                                 : addJelly(world, {1.2, 0.2}, 0.5f, firm(1.0f, 0.0f));
        push(world, a, {2.0f + 2.0f * random.unit(), random.unit() - 0.5f});
        push(world, b, {-1.0f, random.unit() - 0.5f});
        const Momentum before = momentumOf(world);
        const float closing = middleOf(world, a).x;
        double size = 0.0;
        for (const SoftBody& body : world.softBodies.all) {
            for (const SoftParticle& p : body.particles)
                size += static_cast<double>(p.mass * length(p.velocity));
        }
        float nearest = 1.0e9f;
        for (int i = 0; i < 120; ++i) {
            run(world, 1);
            nearest = std::min(nearest, gapBetween(world, a, b));
        }
        EXPECT_LT(nearest, kApart + 0.01f) << "the bodies never touched";
        EXPECT_GT(nearest, kApart - 0.03f);
        const Momentum after = momentumOf(world);
        EXPECT_NEAR(after.x, before.x, 1.0e-5 * size);
        EXPECT_NEAR(after.y, before.y, 1.0e-5 * size);
        EXPECT_GT(middleOf(world, a).x, closing);
    }
}

TEST(SoftSoftContacts, bodiesFarAwayOrInAnotherLayerAreIgnored) {
    const auto makeA = [](World& world) {
        world = makeWorld();
        SoftMaterial material = firm(1.0f);
        material.layers = 2;
        material.mask = ~4u;
        return addJelly(world, {0.0, -1.0}, 0.5f, material);
    };
    World alone, stranger, far;
    const SoftBodyId a = makeA(alone);
    makeA(stranger), makeA(far);
    SoftMaterial other = firm(3.0f);
    other.layers = 4;
    static_cast<void>(addJelly(stranger, {0.2, -0.8}, 0.5f, other));
    static_cast<void>(addJelly(far, {5.0, -1.0}, 0.5f, firm(3.0f)));
    for (World* world : {&alone, &stranger, &far}) run(*world, 60);
    EXPECT_TRUE(sameBytes(softBodyOf(alone, a).particles, softBodyOf(stranger, a).particles));
    EXPECT_TRUE(sameBytes(softBodyOf(alone, a).particles, softBodyOf(far, a).particles));
}

TEST(SoftSoftContacts, overlappingBodiesArePushedApartSlowly) {
    World world = makeWorld();
    world.settings.gravity = {};
    const SoftBodyId a = addJelly(world, {0.0, 0.0}, 0.6f, firm(1.0f)),
                     b = addJelly(world, {0.7, 0.1}, 0.5f, firm(1.0f));
    ASSERT_LT(gapBetween(world, a, b), 0.0f);
    for (int i = 0; i < 180; ++i) {
        run(world, 1);
        for (const SoftBodyId body : {a, b})
            // Compressed links add some speed.
            ASSERT_LT(length(meanVelocity(world, body)), 1.5f * world.settings.pushSpeed) << i;
    }
    EXPECT_GT(gapBetween(world, a, b), kApart - 0.002f);
}

/// Builds a heap of ropes, a cloth and jellies on a floor, with a ball.
World makeHeap() {
    World world = makeWorld();
    addFloor(world);
    addBody(world, BodyKind::Dynamic, {0.3, -0.5}, circle(0.4f));
    for (int i = 0; i < 4; ++i)
        static_cast<void>(addJelly(world, {0.3 * i - 0.5, -1.5 - 1.2 * i}, 0.5f, firm(1.0f)));
    static_cast<void>(*createCloth(world, {-1.0, -7.0}, {1.5f, 0.8f}, 10, 6));
    static_cast<void>(*createRope(world, {-2.0, -8.0}, {2.0, -8.2}, 40));
    return world;
}

TEST(SoftSoftContacts, haveTheSameBitsFromASnapshotAndWithThreads) {
    World world = makeHeap();
    run(world, 60);
    World copy = world;
    TaskPool pool{3};
    const SoftSoftContacts& meetings = world.work.get().softSoftContacts;
    bool met = false;
    for (int i = 0; i < 120; ++i) {
        step(world, kStep);
        step(copy, kStep, {.pool = &pool, .minimumWork = 0});
        ASSERT_EQ(hashOf(world), hashOf(copy)) << i;
        for (const std::uint32_t body : meetings.order) met = met || meetings.leaders[body] != body;
    }
    EXPECT_TRUE(met);
}

TEST(SoftSoftContacts, makeNoAllocationsInASteadyStep) {
    World world = makeHeap();
    run(world, 60);
    const World saved = world;
    run(world, 120);
    world = saved;
    run(world, 1);
    const std::size_t before = plumb::test::allocations().made;
    run(world, 119);
    EXPECT_EQ(plumb::test::allocations().made, before);
}

// Regression: coinciding jellies moved at 12 to 40 m/s for minutes.
TEST(SoftSoftContacts, coincidingJelliesSeparateAndComeToRest) {
    for (const int count : {2, 3, 6}) {
        for (const float apart : {0.0f, 0.1f, 0.4f}) {
            SCOPED_TRACE(testing::Message() << count << " jellies, " << apart << " m apart");
            World world = makeWorld();
            addFloor(world);
            std::vector<SoftBodyId> jellies;
            for (int i = 0; i < count; ++i)
                jellies.push_back(*createJelly(
                    world, {static_cast<double>(i) * static_cast<double>(apart), -2.0}, ringOf(0.7f, 14)));
            run(world, 900);
            for (std::size_t i = 0; i < jellies.size(); ++i) {
                for (const SoftParticle& p : particlesOf(world, jellies[i]))
                    EXPECT_LT(length(p.velocity), 0.5f);
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_GT(gapBetween(world, jellies[j], jellies[i]), kApart - 0.02f);
            }
        }
    }
}

TEST(SoftSoftContacts, separationConservesMomentum) {
    World world = makeSpace();
    const SoftBodyId a = addJelly(world, {0.0, 0.0}, 0.6f, firm(2.0f)),
                     b = addJelly(world, {0.3, 0.1}, 0.6f, firm(1.0f));
    push(world, a, {0.4f, 0.0f});
    push(world, b, {0.4f, 0.0f});
    const Momentum before = momentumOf(world);
    run(world, 60);
    const double kept = 1.0 - 0.5 / 60.0;  // approximate effect of the damping in one step
    EXPECT_NEAR(momentumOf(world).x, before.x * std::pow(kept, 60), 0.01 * before.x);
    EXPECT_NEAR(momentumOf(world).y, 0.0, 0.01 * before.x);
}

}  // namespace
}  // namespace plumb::physics
