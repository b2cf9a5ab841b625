#include <cmath>

#include "tests/box_physics/scene_of_bodies.hpp"
#include "tests/support/allocations.hpp"

namespace plumb::box_physics {
namespace {

/// A closed box full of bouncing shapes.
void fill(Stage60& s, std::uint64_t seed, int count) {
    Random random = Random::seeded(seed);
    s.box(BodyKind::Static, {0, 10.5f}, {12, 0.5f});
    s.box(BodyKind::Static, {0, -10.5f}, {12, 0.5f});
    s.box(BodyKind::Static, {-10.5f, 0}, {0.5f, 12});
    s.box(BodyKind::Static, {10.5f, 0}, {0.5f, 12});
    for (int i = 0; i < count; ++i) {
        BodyDefinition d;
        const float half = random.between(0.05f, 0.2f);
        d.shape = i % 3 == 0 ? Shape::circle(half) : Shape::box({half, half});
        d.position = {random.between(-9, 9), random.between(-9, 9)};
        d.velocity = {random.between(-6, 6), random.between(-6, 6)};
        d.bounciness = random.unit();
        d.mass = random.between(0.5f, 2);
        s.add(d);
    }
}

TEST(Determinism, twoRunsOfOneWorldGiveOneHash) {
    Stage60 first;
    Stage60 second;
    fill(first, 7, 300);
    fill(second, 7, 300);
    std::size_t contacts = 0;
    for (int i = 0; i < 120; ++i) {
        first.run(1);
        second.run(1);
        contacts += first.world.touching.size();
        ASSERT_EQ(hashOf(first.world), hashOf(second.world)) << i;
    }
    EXPECT_GT(contacts, 1000u);
}

TEST(Determinism, aRestoredCopyRepeatsWhatFollowed) {
    Stage60 s;
    fill(s, 3, 200);
    s.run(40);
    const World saved = s.world;
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 40; ++i) s.run(1), hashes.push_back(hashOf(s.world));
    s.box(BodyKind::Static, {0, 0}, {1, 1});  // what came later must leave no trace
    s.run(5);
    s.world = saved;
    for (int i = 0; i < 40; ++i) {
        s.run(1);
        ASSERT_EQ(hashOf(s.world), hashes[static_cast<std::size_t>(i)]) << i;
    }
}

TEST(Determinism, theHashSeesEveryBody) {
    Stage60 s;
    fill(s, 1, 20);
    const std::uint64_t before = hashOf(s.world);
    s.world.bodies.velocity[13].x += 1e-3f;
    EXPECT_NE(hashOf(s.world), before);
}

TEST(Determinism, aSteadyStepAllocatesNothing) {
    Stage60 s;
    fill(s, 5, 500);
    s.run(300);
    const std::size_t before = test::allocations().made;
    s.run(60);
    EXPECT_EQ(test::allocations().made, before);
}

TEST(Determinism, wildScenesStayFinite) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const auto wild = [&random](float low, float high) {  // even over the powers of ten
            float value = low;
            for (float range = high / low, part = random.unit(); range > 10.0f; range /= 10.0f) {
                value *= part < 0.5f ? 1.0f : 10.0f * random.unit() + 0.1f;
                part = random.unit();
            }
            return value;
        };
        Stage60 s;
        for (int i = 0; i < 30; ++i) {
            BodyDefinition d;
            d.kind = i % 5 == 0 ? BodyKind::Static : i % 7 == 0 ? BodyKind::Kinematic : BodyKind::Dynamic;
            d.shape = i % 2 == 0 ? Shape::circle(wild(1e-3f, 1e3f))
                                 : Shape::box({wild(1e-3f, 1e3f), wild(1e-3f, 1e3f)});
            d.position = {random.between(-5, 5), random.between(-5, 5)};
            d.velocity = Vec2{random.between(-1, 1), random.between(-1, 1)} * wild(1, 1e4f);
            d.mass = wild(1e-4f, 1e4f);
            d.bounciness = random.unit();
            d.friction = random.unit();
            s.add(d);
        }
        for (int i = 0; i < 20; ++i) {
            s.run(1);
            for (std::size_t k = 0; k < s.world.bodies.size(); ++k) {
                ASSERT_TRUE(isFinite(s.world.bodies.position[k]) && isFinite(s.world.bodies.velocity[k]));
            }
        }
    }
}

TEST(Determinism, bodiesStayFiniteAndInside) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Stage60 s;
        fill(s, seed, 150);
        s.run(120);
        for (std::size_t i = 4; i < s.world.bodies.size(); ++i) {
            const Vec2 at = s.world.bodies.position[i];
            ASSERT_TRUE(isFinite(at));
            ASSERT_LT(std::abs(at.x), 10.2f);
            ASSERT_LT(std::abs(at.y), 10.2f);
        }
    }
}

}  // namespace
}  // namespace plumb::box_physics
