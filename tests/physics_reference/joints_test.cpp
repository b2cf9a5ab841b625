#include <numbers>

#include "tests/physics_reference/solved.hpp"

namespace plumb::reference {
namespace {

using physics::JointKind;

// Bodies with this negative group do not collide with each other.
constexpr physics::ShapeDefinition kGhost{.group = -1};

void join(Playground& scene, const physics::JointDefinition& definition) {
    const auto made = physics::createJoint(scene.world, definition);
    ASSERT_TRUE(made.ok()) << made.error().text();
}

/// Complete elliptic integral of the first kind, by the arithmetic-geometric mean.
double ellipticK(double k) {
    double a = 1.0, b = std::sqrt(1.0 - k * k);
    for (int i = 0; i < 40; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return std::numbers::pi / (2.0 * a);
}

TEST(ReferenceJoints, aPendulumHasThePeriodOfTheFormula) {
    Playground scene;
    const BodyId pin = scene.body(BodyKind::Static, {}), bob = scene.ball({0.0, -1.0}, 0.125f, kGhost);
    join(scene, {.kind = JointKind::Revolute, .a = pin, .b = bob, .anchorB = {0.0f, 1.0f}});
    const double mass = static_cast<double>(physics::massOf(scene.world, bob));
    const double inertia = static_cast<double>(scene.world.bodies.mass[bob.index].inertia) + mass;
    const double omega = std::sqrt(10.0 * mass / inertia);  // rad/s, for small amplitudes
    const float spin = 4.0f;  // rad/s at the bottom, for an amplitude of about 78 degrees
    ASSERT_TRUE(physics::setVelocity(scene.world, bob, {spin, 0.0f}).ok());
    ASSERT_TRUE(physics::setAngularVelocity(scene.world, bob, spin).ok());
    const double period = 4.0 * ellipticK(static_cast<double>(spin) / (2.0 * omega)) / omega;
    const Answer answer = solved(scene.world, period, {.mostRuns = 9, .wantedError = 4.0e-6});
    const double off = farFrom(of(answer, bob), 0.0, -1.0);
    EXPECT_LT(off / (static_cast<double>(spin) * period), 1.0e-6);  // relative to the period
    expectHonest(off, answer.error);
    EXPECT_NEAR(answer.order, 2.0, 0.1);
}

TEST(ReferenceJoints, aChainCarriesAThousandTimesTheMassOfALink) {
    Playground scene;
    BodyId last = scene.body(BodyKind::Static, {});
    Vec2 hold;
    for (int i = 0; i < 20; ++i) {
        const BodyId link = scene.crate({0.0, -0.25 - 0.5 * i}, {0.0625f, 0.25f}, kGhost);
        join(scene, {.a = last, .b = link, .anchorA = hold, .anchorB = {0.0f, 0.25f}});
        last = link;
        hold = {0.0f, -0.25f};
    }
    const BodyId ball = scene.ball({0.0, -10.5}, 0.5f, kGhost);
    ASSERT_TRUE(physics::setMass(scene.world, ball, 62.5f).ok());
    join(scene, {.a = last, .b = ball, .anchorA = hold, .anchorB = {0.0f, 0.5f}});
    const Answer answer = solved(scene.world, 2.0);
    EXPECT_LT(farFrom(of(answer, ball), 0.0, -10.5), 1.0e-9);
    ASSERT_EQ(answer.joints.size(), 21u);
    EXPECT_NEAR(answer.joints.front().forceY, 10.0 * (62.5 + 20.0 * 0.0625), 1.0e-4);
    EXPECT_NEAR(answer.joints.back().forceY, 625.0, 1.0e-4);
    expectHonest(farFrom(of(answer, ball), 0.0, -10.5), answer.error);
}

/// Rods that hang between two posts. The slope of each rod is that of the force at its center, so the whole
/// shape is known; with many rods it approaches y = a cosh(x / a).
TEST(ReferenceJoints, aChainBetweenTwoPostsIsACatenary) {
    constexpr int kRods = 40;
    constexpr double kLength = 0.25, kPull = 10.0;  // of a rod, m; horizontal tension, N
    Playground scene;
    const float halfWidth = 0.5f * static_cast<float>(kLength);
    std::vector<BodyId> rods;
    double weight = 0.0, x = 0.0, y = 0.0;
    std::vector<physics::WorldPosition> ends{{0.0, 0.0}};
    const double one = 10.0 * kLength * 0.125;  // weight of a rod with a height of 1/8 m, N
    std::vector<double> slopes;
    for (int i = 0; i < kRods; ++i) {
        slopes.push_back(std::atan(one * (i - 0.5 * (kRods - 1)) / kPull));
        x += kLength * std::cos(slopes.back());
        y += kLength * std::sin(slopes.back());
        ends.push_back({x, y});
    }
    BodyId last = scene.body(BodyKind::Static, {});
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const physics::WorldPosition middle{0.5 * (ends[i].x + ends[i + 1].x),
                                            0.5 * (ends[i].y + ends[i + 1].y)};
        const BodyId rod = scene.body(BodyKind::Dynamic, middle, static_cast<float>(slopes[i]));
        scene.shape(rod, physics::box({halfWidth, 0.0625f}), kGhost);
        join(scene, {.a = last,
                     .b = rod,
                     .anchorA = i == 0 ? Vec2{} : Vec2{halfWidth, 0.0f},
                     .anchorB = {-halfWidth, 0.0f}});
        rods.push_back(rod);
        last = rod;
        weight += one;
    }
    join(scene, {.a = last, .b = scene.body(BodyKind::Static, {x, y}), .anchorA = {halfWidth, 0.0f}});
    const physics::World before = scene.world;
    const Answer answer = solved(scene.world, 0.5);
    EXPECT_LT(compare(before, answer).position, 1.0e-5);
    ASSERT_EQ(answer.joints.size(), slopes.size() + 1);
    EXPECT_NEAR(std::fabs(answer.joints.front().forceX), kPull, 1.0e-3);
    EXPECT_NEAR(answer.joints.front().forceY, 0.5 * weight, 1.0e-3);
    const double a = kPull / (one / kLength);
    const BodyAnswer lowest = of(answer, rods[kRods / 2]);
    EXPECT_NEAR(lowest.centre.y, a * (1.0 - std::cosh(0.5 * x / a)), 2.0e-3);
}

TEST(ReferenceJoints, aSpringSwingsWithItsFrequencyAndOrderTwo) {
    Playground scene;
    scene.world.settings.gravity = {};
    const BodyId wall = scene.body(BodyKind::Static, {}), ball = scene.ball({1.5, 0.0}, 0.5f, kGhost);
    join(scene, {.kind = JointKind::Distance,
                 .a = wall,
                 .b = ball,
                 .spring = {.on = true, .hertz = 2.0f, .dampingRatio = 0.0f, .rest = 1.0f}});
    const Answer answer = solved(scene.world, 1.1, {.mostRuns = 8, .wantedError = 1.0e-5});
    const double end = 1.0 + 0.5 * std::cos(2.0 * std::numbers::pi * 2.0 * 1.1);
    expectHonest(farFrom(of(answer, ball), end, 0.0), answer.error);
    EXPECT_NEAR(answer.order, 2.0, 0.1);
}

TEST(ReferenceJoints, aDampedSpringAndAMotorAndASlider) {
    Playground scene;
    const BodyId wall = scene.body(BodyKind::Static, {});
    scene.world.settings.gravity = {0.0f, -10.0f};
    // A slider whose axis is the hypotenuse of a 3-4-5 triangle.
    const BodyId sled = scene.crate({20.0, 0.0}, {0.5f, 0.5f}, kGhost);
    join(scene, {.kind = JointKind::Prismatic,
                 .a = wall,
                 .b = sled,
                 .anchorA = {20.0f, 0.0f},
                 .axis = {4.0f, -3.0f}});
    // A wheel driven by a motor with at most 2 N m.
    const BodyId wheel = scene.ball({-20.0, 0.0}, 0.5f, kGhost);
    join(scene, {.a = wall,
                 .b = wheel,
                 .anchorA = {-20.0f, 0.0f},
                 .motor = {.on = true, .speed = 1000.0f, .maxForce = 2.0f}});
    // A rope of 1 m, from which a weight hangs.
    const BodyId weight = scene.ball({0.0, -1.0}, 0.5f, kGhost);
    join(scene, {.kind = JointKind::Distance,
                 .a = wall,
                 .b = weight,
                 .limit = {.on = true, .lower = 0.0f, .upper = 1.0f}});
    // A crate welded to a wall stays there.
    const BodyId sign = scene.crate({-39.0, 0.0}, {0.5f, 0.5f}, kGhost);
    join(
        scene,
        {.kind = JointKind::Weld, .a = wall, .b = sign, .anchorA = {-40.0f, 0.0f}, .anchorB = {-1.0f, 0.0f}});
    const Answer answer = solved(scene.world, 1.0);
    EXPECT_LT(farFrom(of(answer, sled), 20.0 + 0.8 * 3.0, -0.6 * 3.0), 1.0e-6);
    const auto inertia = static_cast<double>(scene.world.bodies.mass[wheel.index].inertia);
    EXPECT_NEAR(of(answer, wheel).angularVelocity, 2.0 / inertia, 1.0e-6);
    EXPECT_LT(farFrom(of(answer, weight), 0.0, -1.0), 1.0e-9);
    EXPECT_LT(farFrom(of(answer, sign), -39.0, 0.0), 1.0e-9);
    EXPECT_NEAR(answer.joints[3].forceY, 10.0, 1.0e-6);
    EXPECT_NEAR(answer.joints[3].torque, 10.0, 1.0e-5);
    EXPECT_NEAR(answer.joints[2].forceY, 10.0 * static_cast<double>(physics::massOf(scene.world, weight)),
                1.0e-5);
}

}  // namespace
}  // namespace plumb::reference
