#include <algorithm>
#include <cmath>

#include "tests/accuracy/stability/lab.hpp"
#include "tests/accuracy/stability/maps.hpp"

// Scenes of the stability map with bodies on joints: joint errors are measured, and energy must not grow.

namespace plumb::stability {

namespace {

constexpr double kSeconds = 10.0;
constexpr double kLink = 0.5;            // length of a link, m
constexpr int kTwenty = 20;              // default number of links
constexpr Material kGhost{.group = -1};  // bodies of this group do not collide

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Simulates links that hang from a pin at the origin and,
/// if `ratio` > 0, a ball of `ratio` times a link's mass.
Figures hangingChain(const Terms& terms, int count, double ratio) {
    constexpr double kBall = 0.5;  // radius of the ball, m
    const double length = count * kLink + (ratio > 0.0 ? 2.0 * kBall : 0.0);
    Lab lab{terms, {.size = kLink, .extent = length}};
    lab.countHeightFrom(-length);
    BodyHandle last = lab.addFixed(scenes::circle(0.05f), {}, kGhost);
    Vec2 hold;
    for (int i = 0; i < count; ++i) {
        const BodyHandle link = lab.add(scenes::box({0.06f, 0.25f}), at(0.0, -(i + 0.5) * kLink), kGhost);
        lab.hinge(last, link, hold, {0.0f, 0.25f});
        last = link;
        hold = {0.0f, -0.25f};
    }
    if (ratio > 0.0) {
        const BodyHandle ball = lab.add(scenes::circle(0.5f), at(0.0, -count * kLink - kBall), kGhost);
        lab.setMass(ball, ratio * 0.06);
        lab.hinge(last, ball, hold, {0.0f, 0.5f});
    }
    lab.run(kSeconds);
    return lab.figures();
}

}  // namespace

Figures chainOf(double quality, double count) {
    return hangingChain({.quality = quality}, static_cast<int>(count), 0.0);
}

Figures ballOnChain(double quality, double ratio) {
    return hangingChain({.quality = quality}, kTwenty, ratio);
}

Figures ballOnChainOf(double count, double ratio) {
    return hangingChain({.quality = -1.0}, static_cast<int>(count), ratio);
}

Figures chainAtStep(double quality, double step) {
    return hangingChain({.quality = quality, .step = step}, kTwenty, 100.0);
}

/// A chain that is released horizontally. Its motion is chaotic, so only joint errors and energy are scored.
Figures swingingChain(double quality, double count) {
    const int links = static_cast<int>(count);
    const double length = links * kLink;
    Lab lab{{.quality = quality}, {.size = kLink, .extent = length, .rests = false}};
    lab.countHeightFrom(-length);
    BodyHandle last = lab.addFixed(scenes::circle(0.05f), {}, kGhost);
    Vec2 hold;
    for (int i = 0; i < links; ++i) {
        const BodyHandle link = lab.add(scenes::box({0.25f, 0.06f}), at((i + 0.5) * kLink, 0.0), kGhost);
        lab.hinge(last, link, hold, {-0.25f, 0.0f});
        last = link;
        hold = {0.25f, 0.0f};
    }
    lab.run(kSeconds);
    return lab.figures();
}

/// A bridge of planks between two posts, and a crate that falls onto its middle.
Figures loadedBridge(double quality, double ratio) {
    constexpr int kPlanks = 20;
    Lab lab{{.quality = quality}, {.size = 1.0, .extent = kPlanks, .rests = false}};
    lab.countHeightFrom(-kPlanks);
    const double half = 0.5 * kPlanks;
    std::vector<BodyHandle> planks;
    BodyHandle last = lab.addFixed(scenes::circle(0.05f), at(-half, 0.0), kGhost);
    Vec2 hold;
    for (int i = 0; i < kPlanks; ++i) {
        const BodyHandle plank = lab.add(scenes::box({0.5f, 0.1f}), at(i + 0.5 - half, 0.0));
        lab.hinge(last, plank, hold, {-0.5f, 0.0f});
        last = plank;
        planks.push_back(plank);
        hold = {0.5f, 0.0f};
    }
    lab.hinge(last, lab.addFixed(scenes::circle(0.05f), at(half, 0.0), kGhost), hold, {});
    const BodyHandle crate = lab.add(scenes::box({0.5f, 0.5f}), at(0.0, 0.65));
    lab.setMass(crate, ratio * 0.2);
    lab.run(kSeconds);
    const auto isLower = [&](BodyHandle a, BodyHandle b) { return lab.y(a) < lab.y(b); };
    const BodyHandle lowest = *std::min_element(planks.begin(), planks.end(), isLower);
    lab.setOff(isLower(crate, lowest) ? 1.0 : 0.0);  // an error of 1 if the crate fell through
    return lab.figures();
}

/// A pendulum with a rigid arm of 1 m, released horizontally, which must return to the same height.
Figures pendulumAtStep(double quality, double step) {
    Lab lab{{.quality = quality, .step = step}, {.size = 1.0, .extent = 1.0, .rests = false}};
    lab.countHeightFrom(-1.1);
    const BodyHandle hook = lab.addFixed(scenes::circle(0.05f), {}, kGhost);
    const BodyHandle bob = lab.add(scenes::circle(0.1f), {1.0f, 0.0f}, kGhost);
    lab.hinge(hook, bob, {}, {-1.0f, 0.0f});
    double lost = 0.0;
    lab.run(kSeconds, [&](double time) {
        if (time < kSeconds - 1.0) return;
        const Vec2 v = lab.velocity(bob);
        const auto spin = static_cast<double>(physics::angularVelocityOf(lab.world(), lab.idOf(bob)));
        const double energy = 0.5 * static_cast<double>(lengthSquared(v)) + 0.25 * 0.01 * spin * spin;
        lost = std::max(lost, std::fabs(lab.y(bob) + energy / kGravity));
    });
    lab.setOff(lost);
    return lab.figures();
}

/// An arm that a motor drives against its joint limit.
Figures motorAtLimit(double quality, double torque) {
    constexpr double kSpeed = 10.0, kLimit = 0.5;  // rad/s, rad
    Lab lab{{.quality = quality},
            {.size = 1.0, .extent = 1.0, .mostSpeed = 2.0 * kSpeed, .driven = true, .rests = false}};
    const BodyHandle hook = lab.addFixed(scenes::circle(0.05f), {}, kGhost);
    const BodyHandle arm = lab.add(scenes::box({0.5f, 0.05f}), {0.5f, 0.0f}, kGhost);
    lab.drivenHinge(hook, arm, {-0.5f, 0.0f}, kLimit, kSpeed, torque);
    double over = 0.0;
    lab.run(5.0, [&](double time) {
        if (time > 1.0) over = std::max(over, std::fabs(lab.angle(arm) - kLimit));
    });
    lab.setOff(over);
    return lab.figures();
}

}  // namespace plumb::stability
