#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "physics/bounds.hpp"
#include "physics/shapes/hull.hpp"
#include "physics/simulation.hpp"

// Fast bodies with joints: the solver stops them at static bodies, together with the bodies joined to them.

namespace plumb::physics {
namespace {

constexpr float kDt = 1.0f / 60.0f;

struct FallingChain {
    World world;
    std::vector<BodyId> links;
    std::vector<JointId> joints;

    /// Creates rods of 1 m, joined in a line from `start` at `angle`, that fall at `speed`.
    FallingChain(Random& random, WorldPosition start, float angle, float speed) {
        const int count = 2 + static_cast<int>(random.below(5));
        const SinCos direction = sinCos(angle);
        for (int i = 0; i < count; ++i) {
            BodyDefinition definition;
            definition.position = start + static_cast<float>(i) * Vec2{direction.cos, direction.sin};
            definition.angle = angle;
            definition.velocity = {0.0f, -speed};
            links.push_back(*createBody(world, definition));
            ShapeDefinition shape;
            shape.density = random.between(0.5f, 2.0f);
            EXPECT_TRUE(createShape(world, links.back(), box({0.48f, 0.1f}), shape));
            if (i > 0) {
                JointDefinition hinge;
                hinge.a = links[links.size() - 2];
                hinge.b = links.back();
                hinge.anchorA = {0.5f, 0.0f};
                hinge.anchorB = {-0.5f, 0.0f};
                joints.push_back(*createJoint(world, hinge));
            }
        }
        world.settings.gravity = {0.0f, -10.0f};
    }
    void addStatic(Vec2 middle, Vec2 halfSize) {
        BodyDefinition definition;
        definition.kind = BodyKind::Static;
        definition.position = middle;
        EXPECT_TRUE(createShape(world, *createBody(world, definition), box(halfSize), {}));
    }
};

TEST(JointedImpacts, openJointsLittle) {
    float sum = 0.0f;
    constexpr int kSeeds = 40;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        FallingChain chain{random, {0.0, 10.0}, random.between(-1.5f, 1.5f), 20.0f};
        chain.addStatic({0.0f, -1.0f}, {50.0f, 1.0f});
        float opened = 0.0f;
        for (int i = 0; i < 60; ++i) {
            step(chain.world, kDt);
            for (const JointId joint : chain.joints)
                opened = std::max(opened, readingOf(chain.world, joint).separation);
            for (const BodyId link : chain.links) ASSERT_GT(positionOf(chain.world, link).y, 0.0);
        }
        sum += opened;
    }
    // A step's path is 0.33 m long; stopped by the sweep, links opened their joints by 0.21 m.
    EXPECT_LT(sum / kSeeds, 0.1f);
}

TEST(JointedImpacts, doNotHappenBesideAnEdge) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        FallingChain chain{random, {1.2, 10.0}, random.between(-1.4f, 1.4f), random.between(5.0f, 60.0f)};
        // The nearest corner of the chain passes the platform at just more than
        // Settings::speculativeDistance.
        double left = 1.0e9;
        for (std::uint32_t shape = 0; shape < chain.world.shapes.size(); ++shape)
            left = std::min<double>(left, tightBounds(chain.world, shape).min.x);
        chain.addStatic({static_cast<float>(left) - 2.021f, 0.0f}, {2.0f, 0.5f});
        const float before = velocityOf(chain.world, chain.links[0]).y;
        for (int i = 0; i < 60; ++i) {
            step(chain.world, kDt);
            for (const BodyId link : chain.links) {
                const float expected = before - 10.0f * kDt * static_cast<float>(i + 1);
                ASSERT_NEAR(velocityOf(chain.world, link).y, expected, 1.0e-3f) << i;
                ASSERT_NEAR(angularVelocityOf(chain.world, link), 0.0f, 1.0e-3f) << i;
            }
        }
    }
}

}  // namespace
}  // namespace plumb::physics
