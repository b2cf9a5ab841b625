#include <cmath>

#include "physics/model/fields.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

struct Swing {
    World world;
    BodyId body;
    double stiffness = 0.0;  // stiffness of the spring, N/m

    [[nodiscard]] double energy() const {
        const double x = positionOf(world, body).x, v = velocityOf(world, body).x;
        return 0.5 * stiffness * x * x + 0.5 * static_cast<double>(massOf(world, body)) * v * v;
    }
};

/// A body of 1 kg on a spring of zero length to the origin, released at 1 m.
Swing makeSwing(IntegratorKind kind, double hertz, Quality quality) {
    Swing swing;
    swing.world = makeWorld();
    swing.world.settings.gravity = {};
    swing.world.settings.integrator = kind;
    swing.world.settings.quality = quality;
    swing.body = addBody(swing.world, BodyKind::Dynamic, {1.0, 0.0}, circle(0.1f));
    EXPECT_TRUE(setMass(swing.world, swing.body, 1.0f).ok());
    const double omega = static_cast<double>(kTau) * hertz;
    FieldDefinition spring;
    spring.kind = FieldKind::Spring;
    spring.a = swing.body;
    spring.strength = static_cast<float>(omega * omega);
    swing.stiffness = static_cast<double>(spring.strength);
    EXPECT_TRUE(createField(swing.world, spring).ok());
    return swing;
}

/// Maximum relative error of the energy in 10 s of steps of 1/60 s.
double worstError(IntegratorKind kind, double hertz, Quality quality = 0) {
    Swing swing = makeSwing(kind, hertz, quality);
    const double start = swing.energy();
    double worst = 0.0;
    for (int i = 0; i < 600; ++i) {
        step(swing.world, kStep);
        worst = std::max(worst, std::fabs(swing.energy() / start - 1.0));
    }
    return worst;
}

// The expected values are those of a correct implementation of each scheme with one substep.

TEST(Integrators, showTheErrorsOfTheirSchemesOnASlowSpring) {
    EXPECT_NEAR(worstError(IntegratorKind::ExplicitEuler, 0.5), 4.2, 0.05);
    EXPECT_NEAR(worstError(IntegratorKind::SemiImplicitEuler, 0.5), 0.027, 0.001);
    EXPECT_NEAR(worstError(IntegratorKind::Verlet, 0.5), 7.0e-4, 0.2e-4);
    // In exact arithmetic the error is 1.7e-7, but velocities are stored as floats.
    EXPECT_LT(worstError(IntegratorKind::Rk4, 0.5), 2.0e-6);
}

TEST(Integrators, showTheErrorsOfTheirSchemesOnAStiffSpring) {
    EXPECT_GT(worstError(IntegratorKind::ExplicitEuler, 10.0), 1.0e3);  // limited only by Settings::maxSpeed
    EXPECT_NEAR(worstError(IntegratorKind::SemiImplicitEuler, 10.0), 1.1, 0.05);
    EXPECT_NEAR(worstError(IntegratorKind::Verlet, 10.0), 0.27, 0.02);
    EXPECT_NEAR(worstError(IntegratorKind::Rk4, 10.0), 1.0, 0.02);  // all energy is lost
}

TEST(Integrators, ofSecondOrderHaveAQuarterOfTheErrorPerQualityLevel) {
    for (Quality quality = 0; quality < 3; ++quality) {
        const double coarse = worstError(IntegratorKind::Verlet, 2.0, quality);
        const double fine = worstError(IntegratorKind::Verlet, 2.0, static_cast<Quality>(quality + 1));
        EXPECT_NEAR(coarse / fine, 4.0, 0.3) << static_cast<int>(quality);
    }
}

/// Two bodies of 1 and 3 kg orbit each other with a period of 4 s.
TEST(Integrators, keepAnOrbitOfTwoBodiesForAHundredRevolutions) {
    for (const IntegratorKind kind :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::Verlet, IntegratorKind::Rk4}) {
        SCOPED_TRACE(static_cast<int>(kind));
        World world = makeWorld();
        world.settings.gravity = {};
        world.settings.integrator = kind;
        const double distance = 4.0, period = 4.0, pi = static_cast<double>(kPi);
        const double strength = 4.0 * pi * pi * distance * distance * distance / (period * period);
        const double speed = 2.0 * pi * distance / period;
        BodyId ids[2];
        const double share[2] = {0.75, -0.25}, mass[2] = {1.0, 3.0};
        for (int i = 0; i < 2; ++i) {
            BodyDefinition body;
            body.velocity = {0.0f, static_cast<float>(share[i] * speed)};
            ids[i] = addBody(world, BodyKind::Dynamic, {share[i] * distance, 0.0}, circle(0.1f), {}, body);
            ASSERT_TRUE(setMass(world, ids[i], static_cast<float>(mass[i])).ok());
        }
        for (int i = 0; i < 2; ++i) {
            FieldDefinition pull;
            pull.kind = FieldKind::Attractor;
            pull.a = ids[i];
            pull.strength = static_cast<float>(strength * mass[i] / 4.0);
            ASSERT_TRUE(createField(world, pull).ok());
        }
        const auto apart = [&] { return positionOf(world, ids[0]) - positionOf(world, ids[1]); };
        double nearest = 1e9, farthest = 0.0;
        for (int i = 0; i < 100 * 240; ++i) {
            step(world, kStep);
            const double now = static_cast<double>(length(apart()));
            nearest = std::min(nearest, now);
            farthest = std::max(farthest, now);
        }
        EXPECT_NEAR(nearest, distance, 0.02 * distance);
        EXPECT_NEAR(farthest, distance, 0.02 * distance);
        const Vec2 momentum = velocityOf(world, ids[0]) + 3.0f * velocityOf(world, ids[1]);
        EXPECT_NEAR(length(momentum), 0.0f, 0.002f);
    }
}

TEST(Integrators, solveDragWithAConstantForceAccurately) {
    for (int kind = 0; kind < 4; ++kind) {
        World world = makeWorld();
        world.settings.integrator = static_cast<IntegratorKind>(kind);
        FieldDefinition field;
        field.kind = FieldKind::AreaGravity;
        field.acceleration = {3.0f, 0.0f};
        ASSERT_TRUE(createField(world, field).ok());
        BodyDefinition body;
        body.linearDrag = 2.0f;
        const BodyId falling = addBody(world, BodyKind::Dynamic, {}, circle(0.5f), {}, body);
        run(world, 60);
        const double left = 1.0 - std::exp(-2.0);
        EXPECT_NEAR(velocityOf(world, falling).x, 1.5 * left, 1e-4) << kind;
        EXPECT_NEAR(velocityOf(world, falling).y, 5.0 * left, 1e-3) << kind;
    }
}

TEST(Integrators, doNotAffectFreeFlightWithoutFields) {
    World world = makeWorld();
    world.settings.integrator = IntegratorKind::ExplicitEuler;
    const BodyId falling = addBody(world, BodyKind::Dynamic, {}, circle(0.5f));
    run(world, 120);
    EXPECT_NEAR(positionOf(world, falling).y, 20.0, 1e-4);
    EXPECT_EQ(runsOf(world, "integrators"), 0u);
}

}  // namespace
}  // namespace plumb::physics
