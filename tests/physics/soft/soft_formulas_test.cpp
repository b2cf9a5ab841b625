#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/random_shapes.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Compares the construction and single substeps of soft bodies with formulas.

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr float kStep = 0.01f;  // s

/// A material with one substep per step, no damping and no bending links.
SoftMaterial bare() {
    SoftMaterial material;
    material.damping = 0.0f;
    material.substeps = 1;
    material.bendCompliance = -1.0f;
    return material;
}

World weightless() {
    World world;
    world.settings.gravity = {};
    return world;
}

Vec2 placeOf(const World& world, SoftBodyId body, std::size_t particle) {
    return toVec2(particlesOf(world, body)[particle].place);
}

using Links = std::set<std::tuple<std::uint32_t, std::uint32_t, float, bool>>;

Links linksOf(const World& world, SoftBodyId body) {
    Links links;
    for (const SoftLink& link : softBodyOf(world, body).links) {
        links.insert({std::min(link.a, link.b), std::max(link.a, link.b), link.compliance, link.isEdge});
        EXPECT_NEAR(link.length, length(placeOf(world, body, link.a) - placeOf(world, body, link.b)), 1e-5f);
    }
    EXPECT_EQ(links.size(), softBodyOf(world, body).links.size());
    return links;
}

}  // namespace

TEST(SoftFormulas, aRopeLinksNeighboursAndSecondNeighbours) {
    for (const int count : {2, 3, 7}) {
        World world;
        SoftMaterial material;
        material.mass = 3.0f;
        material.stretchCompliance = 0.5f;
        material.bendCompliance = 0.25f;
        const SoftBodyId rope = *createRope(world, {1e5, 1.0}, {1e5 + 3.0, 5.0}, count, material);
        const auto particles = particlesOf(world, rope);
        ASSERT_EQ(particles.size(), static_cast<std::size_t>(count));
        Links wanted;
        for (std::uint32_t i = 0; i < particles.size(); ++i) {
            const double t = static_cast<double>(i) / (count - 1);
            EXPECT_NEAR(particles[i].place.x, 1e5 + 3.0 * t, 1e-9);
            EXPECT_NEAR(particles[i].place.y, 1.0 + 4.0 * t, 1e-9);
            EXPECT_FLOAT_EQ(particles[i].mass, 3.0f / static_cast<float>(count));
            EXPECT_FLOAT_EQ(particles[i].inverseMass, static_cast<float>(count) / 3.0f);
            if (i + 1 < particles.size()) wanted.insert({i, i + 1, 0.5f, true});
            if (i + 2 < particles.size()) wanted.insert({i, i + 2, 0.25f, false});
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> found;
        for (const SoftLink& link : softBodyOf(world, rope).links) {
            EXPECT_TRUE(wanted.contains({link.a, link.b, link.compliance, link.isEdge}));
            EXPECT_NEAR(link.length,
                        5.0f / static_cast<float>(count - 1) * static_cast<float>(link.b - link.a), 1e-5f);
            found.insert({link.a, link.b});
        }
        EXPECT_EQ(found.size(), wanted.size());
    }
}

TEST(SoftFormulas, aClothLinksRowsColumnsAndDiagonals) {
    World world;
    SoftMaterial material;
    material.stretchCompliance = 0.5f;
    material.bendCompliance = 0.25f;
    const SoftBodyId cloth = *createCloth(world, {1.0, 2.0}, {3.0f, -4.0f}, 4, 3, material);
    const auto number = [](std::uint32_t column, std::uint32_t row) { return row * 4 + column; };
    Links wanted;
    for (std::uint32_t row = 0; row < 3; ++row) {
        for (std::uint32_t column = 0; column < 4; ++column) {
            const Vec2 place = placeOf(world, cloth, number(column, row));
            EXPECT_NEAR(place.x, 1.0f + static_cast<float>(column), 1e-5f);
            EXPECT_NEAR(place.y, 2.0f - 2.0f * static_cast<float>(row), 1e-5f);
            EXPECT_FLOAT_EQ(particlesOf(world, cloth)[number(column, row)].mass, 1.0f / 12.0f);
            if (column < 3) wanted.insert({number(column, row), number(column + 1, row), 0.5f, true});
            if (row < 2) wanted.insert({number(column, row), number(column, row + 1), 0.5f, true});
            if (column < 3 && row < 2) {
                wanted.insert({number(column, row), number(column + 1, row + 1), 0.25f, false});
                wanted.insert({number(column + 1, row), number(column, row + 1), 0.25f, false});
            }
        }
    }
    EXPECT_EQ(linksOf(world, cloth), wanted);
}

TEST(SoftFormulas, aJellyLinksItsRingAndStoresItsArea) {
    for (const int count : {3, 4, 5, 8}) {
        for (const bool reversed : {false, true}) {
            World world;
            std::vector<Vec2> outline;
            for (int i = 0; i < count; ++i) {
                const float angle = kTau * static_cast<float>(reversed ? -i : i) / static_cast<float>(count);
                outline.push_back(2.0f * Vec2{std::cos(angle), std::sin(angle)});
            }
            SoftMaterial material;
            material.stretchCompliance = 0.5f;
            material.bendCompliance = 0.25f;
            const SoftBodyId jelly = *createJelly(world, {5.0, 6.0}, outline, material);
            const float wanted =
                2.0f * static_cast<float>(count) * std::sin(kTau / static_cast<float>(count));
            EXPECT_NEAR(softBodyOf(world, jelly).area, reversed ? -wanted : wanted, 1e-4f);
            std::size_t edges = 0, bends = 0;
            for (const SoftLink& link : softBodyOf(world, jelly).links) {
                const std::uint32_t apart =
                    (link.b + static_cast<std::uint32_t>(count) - link.a) % static_cast<std::uint32_t>(count);
                EXPECT_EQ(apart, link.isEdge ? 1u : 2u);
                EXPECT_EQ(link.compliance, link.isEdge ? 0.5f : 0.25f);
                ++(link.isEdge ? edges : bends);
            }
            EXPECT_EQ(edges, static_cast<std::size_t>(count));
            EXPECT_EQ(bends, count > 4 ? static_cast<std::size_t>(count) : 0u);
        }
    }
}

TEST(SoftFormulas, noTwoNeighbouringLinksOfTheListShareAParticle) {
    World world;
    const SoftBodyId cloth = *createCloth(world, {}, {3.0f, 3.0f}, 9, 8);
    const auto& links = softBodyOf(world, cloth).links;
    std::size_t shared = 0;
    for (std::size_t i = 1; i < links.size(); ++i) {
        const SoftLink &a = links[i - 1], &b = links[i];
        shared += a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b ? 1 : 0;
    }
    EXPECT_LE(shared, 8u) << "only links at the border of two colors may share a particle";
}

TEST(SoftFormulas, rangesOfCountsAreExact) {
    World world;
    EXPECT_FALSE(createRope(world, {}, {1.0, 0.0}, 1).ok());
    EXPECT_FALSE(createRope(world, {1.0, 2.0}, {1.0, 2.0}, 5).ok()) << "a rope of length 0";
    EXPECT_TRUE(createRope(world, {}, {1.0, 0.0}, 2).ok());
    EXPECT_TRUE(createRope(world, {}, {1.0, 0.0}, 10000).ok());
    EXPECT_FALSE(createRope(world, {}, {1.0, 0.0}, 10001).ok());
    EXPECT_FALSE(createCloth(world, {}, {1.0f, 1.0f}, 1, 2).ok());
    EXPECT_FALSE(createCloth(world, {}, {1.0f, 1.0f}, 2, 1).ok());
    EXPECT_TRUE(createCloth(world, {}, {1.0f, 1.0f}, 2, 2).ok());
    EXPECT_FALSE(createCloth(world, {}, {1.0f, 1.0f}, 201, 2).ok());
    EXPECT_FALSE(createCloth(world, {}, {1.0f, 1.0f}, 2, 201).ok());
    const std::vector<Vec2> triangle{{0, 0}, {1, 0}, {0, 1}};
    EXPECT_FALSE(createJelly(world, {}, {triangle.data(), 2}).ok());
    EXPECT_TRUE(createJelly(world, {}, triangle).ok());
    EXPECT_FALSE(createJelly(world, {}, std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}}).ok());
    const SoftBodyId rope = *createRope(world, {}, {1.0, 0.0}, 3);
    for (const int particle : {-1, 3}) {
        EXPECT_FALSE(pinParticle(world, rope, particle, true).ok());
        EXPECT_FALSE(moveParticle(world, rope, particle, {}).ok());
        EXPECT_FALSE(setParticleVelocity(world, rope, particle, {}).ok());
    }
    for (const int particle : {0, 2}) EXPECT_TRUE(pinParticle(world, rope, particle, true).ok());
}

TEST(SoftFormulas, aLinkYieldsByItsCompliance) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = weightless();
        SoftMaterial material = bare();
        material.mass = random.between(0.5f, 4.0f);
        material.stretchCompliance = seed % 3 == 0 ? 0.0f : random.between(1e-5f, 1e-3f);
        const SoftBodyId rope = *createRope(world, {0.0, 0.0}, {2.0, 0.0}, 2, material);
        const Vec2 end = Vec2{2.0f, 0.0f} + test::randomPoint(random, 1.0f);
        ASSERT_TRUE(moveParticle(world, rope, 1, WorldPosition{end}));
        const bool pinned = seed % 2 == 0;
        ASSERT_TRUE(pinParticle(world, rope, 0, pinned));
        step(world, kStep);
        // XPBD: the multiplier is C / (w + compliance / h2), and each end moves in proportion to its inverse
        // mass.
        const float inverse = 2.0f / material.mass, weight = pinned ? inverse : 2.0f * inverse;
        const float push = (length(end) - 2.0f) / (weight + material.stretchCompliance / (kStep * kStep));
        const Vec2 along = normalized(end);
        const Vec2 first = placeOf(world, rope, 0), second = placeOf(world, rope, 1);
        const Vec2 wanted = end - inverse * push * along;
        EXPECT_NEAR(length(second - wanted), 0.0f, 1e-5f);
        EXPECT_NEAR(length(first - (pinned ? Vec2{} : inverse * push * along)), 0.0f, 1e-5f);
        EXPECT_NEAR(length(particlesOf(world, rope)[1].velocity - (wanted - end) / kStep), 0.0f, 2e-3f);
    }
}

TEST(SoftFormulas, aRigidJellyCorrectsItsAreaInOneStep) {
    for (const float compliance : {0.0f, 1e-3f}) {
        for (const float scale : {0.95f, 1.05f}) {
            World world = weightless();
            SoftMaterial material = bare();
            material.stretchCompliance = 1e6f;  // so soft that edges have no effect
            material.areaCompliance = compliance;
            const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            const SoftBodyId jelly = *createJelly(world, {}, square, material);
            for (int i = 0; i < 4; ++i)
                ASSERT_TRUE(moveParticle(world, jelly, i,
                                         WorldPosition{scale * square[static_cast<std::size_t>(i)]}));
            step(world, kStep);
            // C = 4 s2 - 4; four gradients, each half a diagonal, sqrt(2) s; particle masses of 1/4 kg.
            const float weight = 4.0f * 4.0f * 2.0f * scale * scale + compliance / (kStep * kStep);
            const float push = -(4.0f * scale * scale - 4.0f) / weight;
            const float wanted = scale + push * 4.0f * scale;  // each coordinate; the gradient is (s, s)
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(length(placeOf(world, jelly, i) - wanted * square[i]), 0.0f, 1e-4f);
        }
    }
}

TEST(SoftFormulas, particlesFallAreDampedAndHaveAMaximumSpeed) {
    World world;
    world.settings.gravity = {1.0f, 10.0f};
    world.settings.maxSpeed = 20.0f;
    SoftMaterial material = bare();
    material.damping = 2.0f;
    const SoftBodyId rope = *createRope(world, {}, {1.0, 0.0}, 2, material);
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(setParticleVelocity(world, rope, i, {3.0f, -1.0f}));
    step(world, kStep);
    const float kept = std::exp(-2.0f * kStep);
    const Vec2 velocity = kept * (Vec2{3.0f, -1.0f} + kStep * Vec2{1.0f, 10.0f});
    EXPECT_NEAR(length(particlesOf(world, rope)[0].velocity - velocity), 0.0f, 1e-3f);
    EXPECT_NEAR(length(placeOf(world, rope, 0) - kStep * velocity), 0.0f, 1e-5f);
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(setParticleVelocity(world, rope, i, {300.0f, -400.0f}));
    step(world, kStep);
    EXPECT_NEAR(length(particlesOf(world, rope)[1].velocity), 20.0f, 1e-2f);
}

TEST(SoftFormulas, windPushesParticlesByTheWidthOfALink) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = weightless();
        SoftMaterial material = bare();
        material.layers = 2;
        const SoftBodyId rope = *createRope(world, {}, {0.5, 0.0}, 2, material);
        const Vec2 velocity = test::randomPoint(random, 2.0f);
        for (int i = 0; i < 2; ++i) ASSERT_TRUE(setParticleVelocity(world, rope, i, velocity));
        FieldDefinition wind{.kind = FieldKind::Wind, .layers = seed % 4 == 0 ? 1u : 3u};
        wind.velocity = test::randomPoint(random, 5.0f);
        wind.density = random.between(0.1f, 3.0f);
        ASSERT_TRUE(createField(world, wind));
        step(world, kStep);
        const Vec2 felt = wind.velocity - velocity;
        const float rate = wind.density * 0.5f * length(felt) * 2.0f;  // particles of 1/2 kg
        const Vec2 wanted = velocity + (seed % 4 == 0 ? 0.0f : std::min(rate * kStep, 1.0f)) * felt;
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(length(particlesOf(world, rope)[i].velocity - wanted), 0.0f, 1e-3f);
    }
}
