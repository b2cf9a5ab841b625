#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "physics/simulation.hpp"

// A plank that rolls on a round shape: the contact point moves, and the normal rotates with it.

namespace plumb::physics {
namespace {

constexpr float kTick = 1.0f / 60.0f;
constexpr float kTilt = 0.2f;  // rad, initial tilt
constexpr ShapeDefinition kRough{.friction = 10.0f};

/// Rocking motion of a plank on a shape whose top is a circle of radius 1 m around the origin: maximum tilts
/// within every two seconds, rad, and the mean period.
struct Rocking {
    std::vector<float> tilts;
    float period = 0.0f;  // mean period, s

    Rocking(const Geometry& under, Quality quality) {
        World world;
        world.settings.gravity = {0.0f, -10.0f};
        world.settings.sleeping = false;
        world.settings.quality = quality;
        const BodyId ground = *createBody(world, {.kind = BodyKind::Static});
        EXPECT_TRUE(createShape(world, ground, under, kRough).ok());
        // Start pose after rolling without slip from the middle to the initial tilt.
        const float sine = std::sin(kTilt), cosine = std::cos(kTilt);
        const BodyId plank = *createBody(
            world,
            {.position = Vec2{1.1f * sine - kTilt * cosine, 1.1f * cosine + kTilt * sine}, .angle = -kTilt});
        EXPECT_TRUE(createShape(world, plank, box({1.0f, 0.1f}), kRough).ok());
        swing(world, plank);
    }

private:
    void swing(World& world, BodyId plank) {
        float before = -kTilt, first = 0.0f, last = 0.0f, largest = 0.0f;
        int swings = -1;
        for (int i = 1; i <= 600; ++i) {
            step(world, kTick);
            const float now = angleOf(rotationOf(world, plank));
            if (before < 0.0f && now >= 0.0f) {
                last = kTick * (static_cast<float>(i) - now / (now - before));
                if (++swings == 0) first = last;
            }
            before = now;
            largest = std::max(largest, std::fabs(now));
            if (i % 120 == 0) tilts.push_back(std::exchange(largest, 0.0f));
        }
        period = (last - first) / static_cast<float>(swings);
    }
};

struct Under {
    const char* name;
    Geometry outline;
};

constexpr float kHalfRoot = 0.70710678f;
const Under kUnder[] = {
    {"circle", circle(1.0f)},
    {"capsule", capsule({0.0f, -2.0f}, {0.0f, 0.0f}, 1.0f)},
    {"round corner", box({0.5f, 0.5f}, {0.0f, -kHalfRoot}, {kHalfRoot, kHalfRoot}, 1.0f)}};

TEST(Rocking, neverExceedsItsInitialTilt) {
    for (const Under& under : kUnder) {
        for (Quality quality = 1; quality <= 5; ++quality) {
            SCOPED_TRACE(under.name);
            SCOPED_TRACE(int{quality});
            const Rocking rocking{under.outline, quality};
            for (const float tilt : rocking.tilts) EXPECT_LE(tilt, 1.02f * kTilt);
            EXPECT_GE(rocking.tilts.back(), (quality < 2 ? 0.5f : 0.7f) * kTilt);
        }
    }
}

TEST(Rocking, hasThePeriodOfTheFormula) {
    // Period for small amplitudes; at 0.2 rad it is slightly longer. It depends on the moment of inertia
    // about the contact point and on the restoring torque, both per mass.
    const float inertia = (1.0f + 0.01f) / 3.0f + 0.01f;  // moment of inertia per mass, m2
    const float period = 6.2831853f * std::sqrt(inertia / (10.0f * (1.0f - 0.1f)));
    for (const Under& under : kUnder) {
        SCOPED_TRACE(under.name);
        const Rocking rocking{under.outline, 4};
        EXPECT_GT(rocking.period, period);
        EXPECT_LT(rocking.period, 1.05f * period);
    }
}

}  // namespace
}  // namespace plumb::physics
