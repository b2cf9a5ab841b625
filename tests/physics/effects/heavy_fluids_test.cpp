#include <cmath>

#include "core/random.hpp"
#include "physics/model/fields.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

/// A fluid that is much denser than a body; its drag on the submerged body is `fluid.linearDrag` times
/// `ratio`.
struct HeavyFluid {
    FieldDefinition fluid;
    float ratio = 0.0f;  // density of the fluid / density of the body, 1.5 to 10^5
    Geometry outline;    // outline of the body
    float size = 0.0f;   // size of the body, m
};

/// Adds a random heavy fluid to a world and sets a random quality and integrator.
HeavyFluid heavyFluid(Random& random, World& world) {
    HeavyFluid made{
        fieldOf(FieldKind::Buoyancy), 1.5f * std::pow(10.0f, random.between(0.0f, 4.8f)), {}, 0.0f};
    made.size = std::pow(10.0f, random.between(-1.3f, 1.0f));
    made.outline = random.below(2) == 0 ? circle(made.size) : box({2.0f * made.size, made.size});
    world.settings.quality = static_cast<Quality>(random.below(5));
    world.settings.integrator = static_cast<IntegratorKind>(1 + random.below(3));
    made.fluid.density = made.ratio;
    made.fluid.linearDrag = std::pow(10.0f, random.between(-1.0f, 5.0f));
    made.fluid.angularDrag = made.fluid.linearDrag;
    EXPECT_TRUE(createField(world, made.fluid).ok());
    return made;
}

TEST(HeavyFluids, ofAnyDensityAndDragThrowsNoBodyHigherThanItFell) {
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        const HeavyFluid made = heavyFluid(random, world);
        SCOPED_TRACE(testing::Message() << seed << " ratio " << made.ratio << " size " << made.size);
        const double height = static_cast<double>(made.size) * (1.5 + random.between(0.0f, 2.0f));
        const BodyId buoy = addBody(world, BodyKind::Dynamic, {0.0, -height}, made.outline);
        double top = -height, bottom = 0.0;
        for (int i = 0; i < 600; ++i) {
            step(world, kStep);
            top = std::min(top, positionOf(world, buoy).y);
            bottom = std::max(bottom, positionOf(world, buoy).y);
        }
        EXPECT_GE(top, -1.05 * height - 0.01);
        EXPECT_GT(bottom, -static_cast<double>(made.size));  // the body reached the fluid
    }
}

TEST(HeavyFluids, ofAnyDensityAndDragFloatsBodiesAtTheirDepth) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        HeavyFluid made = heavyFluid(random, world);
        SCOPED_TRACE(testing::Message() << seed << " ratio " << made.ratio << " size " << made.size
                                        << " drag " << made.fluid.linearDrag);
        made.outline = box({2.0f * made.size, made.size});
        // With less drag the raft oscillates for longer than this minute, with more it sinks for longer.
        if (made.fluid.linearDrag < 1.0f || made.fluid.linearDrag > 30.0f) continue;
        const double depth = static_cast<double>(made.size) * (2.0 / static_cast<double>(made.ratio) - 1.0);
        const BodyId raft = addBody(world, BodyKind::Dynamic, {0.0, depth - 0.3 * made.size}, made.outline);
        run(world, 3600);
        EXPECT_NEAR(positionOf(world, raft).y, depth, 0.01 * made.size + 2.0 * 10.0 * kStep * kStep);
    }
}

TEST(HeavyFluids, ofAnyDensityAndDragLiftsAtTheTerminalVelocity) {
    int judged = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        const HeavyFluid made = heavyFluid(random, world);
        SCOPED_TRACE(testing::Message() << seed << " ratio " << made.ratio << " size " << made.size
                                        << " drag " << made.fluid.linearDrag);
        const float expected = (made.ratio - 1.0f) * length(world.settings.gravity) /
                               (made.ratio * made.fluid.linearDrag);  // m/s
        if (made.ratio * made.fluid.linearDrag < 10.0f || expected > 10.0f) continue;
        ++judged;
        const BodyId bubble = addBody(world, BodyKind::Dynamic, {0.0, 100.0}, made.outline);
        run(world, 120);
        EXPECT_NEAR(velocityOf(world, bubble).y, -expected, 0.02f * expected);
    }
    EXPECT_GT(judged, 200);
}

}  // namespace
}  // namespace plumb::physics
