#include <algorithm>
#include <cmath>

#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/formulas.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;
constexpr Material kGhost{.group = -1};  // bodies of this group do not collide with each other

/// Hangs 20 links from a pin at the origin, and at their end a ball of `ratio` times the mass of a link.
void hangingChain(Trial& trial, float ratio, double target) {
    BodyHandle last = trial.pin({});
    Vec2 hold;
    for (int i = 0; i < 20; ++i) {
        const BodyHandle link =
            trial.add(scenes::box({0.06f, 0.25f}), {0.0f, -0.25f - 0.5f * static_cast<float>(i)}, kGhost);
        trial.scene().addJoint({.a = last, .b = link, .anchorA = hold, .anchorB = {0.0f, 0.25f}});
        last = link;
        hold = {0.0f, -0.25f};
    }
    const BodyHandle ball = trial.add(scenes::circle(0.5f), {0.0f, -10.5f}, kGhost);
    trial.setMass(ball, ratio * 0.06f);
    trial.scene().addJoint({.a = last, .b = ball, .anchorA = hold, .anchorB = {0.0f, 0.5f}});
    trial.run(10.0);
    trial.report("", std::hypot(trial.x(ball), trial.y(ball) + 10.5) * kMillimetres, "mm", target);
}

/// Reports mean and maximum joint errors in the second half of the run, when the initial motion has ended.
void reportJoints(Trial& trial, double seconds, double mean, double most) {
    double sum = 0.0, largest = 0.0;
    int count = 0;
    trial.run(seconds, [&](double time) {
        if (time < 0.5 * seconds) return;
        const scenes::SceneError error = scenes::errorOf(trial.scene());
        sum += error.finite ? error.meanJointError : std::numeric_limits<double>::infinity();
        largest = std::max(largest, error.maxJointError);
        ++count;
    });
    trial.report("mean", sum / count * kMillimetres, "mm", mean);
    if (most > 0.0) trial.report("max", largest * kMillimetres, "mm", most);
}

}  // namespace

void chain100(Trial& trial) { hangingChain(trial, 100.0f, 10.0); }
void chain1000(Trial& trial) { hangingChain(trial, 1000.0f, 30.0); }

void catenary(Trial& trial) {
    constexpr int kRods = 40;
    constexpr double kLength = 0.25, kSpan = 8.0;  // length of a rod, distance of the posts, m
    const auto link = static_cast<float>(kLength);
    // The chain starts as a V of the same length, and drag slows it down until it hangs still.
    const double steep = std::acos(kSpan / (kRods * kLength));
    BodyHandle last = trial.pin({});
    Vec2 hold;
    std::vector<BodyHandle> rods;
    double x = 0.0, y = 0.0;
    for (int i = 0; i < kRods; ++i) {
        const double angle = 2 * i < kRods ? -steep : steep;
        const double stepX = kLength * std::cos(angle), stepY = kLength * std::sin(angle);
        const BodyHandle rod = trial.scene().createBody(
            {.position = {static_cast<float>(x + 0.5 * stepX), static_cast<float>(y + 0.5 * stepY)},
             .angle = static_cast<float>(angle),
             .drag = 2.0f});
        trial.scene().addShape(rod, scenes::box({0.5f * link, 0.02f}), kGhost);
        trial.scene().addJoint({.a = last, .b = rod, .anchorA = hold, .anchorB = {-0.5f * link, 0.0f}});
        rods.push_back(rod);
        last = rod;
        hold = {0.5f * link, 0.0f};
        x += stepX;
        y += stepY;
    }
    trial.scene().addJoint({.a = last, .b = trial.pin({static_cast<float>(kSpan), 0.0f}), .anchorA = hold});
    trial.run(30.0);
    const std::vector<double> angles = chainAngles(kRods, kLength, kSpan);
    const double a = catenaryOf(kRods * kLength, kSpan), low = a * (1.0 - std::cosh(0.5 * kSpan / a));
    double place = 0.0, curve = 0.0;
    x = y = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double stepX = kLength * std::cos(angles[i]), stepY = kLength * std::sin(angles[i]);
        const double isX = trial.x(rods[i]), isY = trial.y(rods[i]);
        place = std::max(place, std::hypot(isX - (x + 0.5 * stepX), isY - (y + 0.5 * stepY)));
        curve = std::max(curve, std::fabs(isY - (low + a * (std::cosh((isX - 0.5 * kSpan) / a) - 1.0))));
        x += stepX;
        y += stepY;
    }
    trial.report("place", place * kMillimetres, "mm", 1.0);
    // Error relative to the sag. The goal allows for rods, whose curve differs slightly from a rope's.
    trial.report("curve", curve / -low * 100.0, "%", 1.0);
}

void ballAndChain(Trial& trial) {
    BodyHandle last = trial.pin({});
    Vec2 hold;
    for (int i = 0; i < 40; ++i) {
        const BodyHandle link = trial.add(scenes::capsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.125f),
                                          {0.5f + static_cast<float>(i), 0.0f}, kGhost);
        trial.scene().addJoint({.a = last, .b = link, .anchorA = hold, .anchorB = {-0.5f, 0.0f}});
        last = link;
        hold = {0.5f, 0.0f};
    }
    const BodyHandle ball = trial.add(scenes::circle(4.0f), {44.0f, 0.0f}, kGhost);
    trial.setMass(ball, 500.0f * physics::massOf(trial.world(), trial.id(last)));
    trial.scene().addJoint({.a = last, .b = ball, .anchorA = hold, .anchorB = {-4.0f, 0.0f}});
    reportJoints(trial, 20.0, 5.1, 0.0);
}

void bridge160(Trial& trial) {
    BodyHandle last = trial.pin({-80.0f, 20.0f});
    Vec2 hold;
    for (int i = 0; i < 160; ++i) {
        const BodyHandle plank =
            trial.add(scenes::box({0.5f, 0.125f}), {-79.5f + static_cast<float>(i), 20.0f},
                      {.density = 20.0f, .group = -1});
        trial.scene().addJoint({.a = last, .b = plank, .anchorA = hold, .anchorB = {-0.5f, 0.0f}});
        last = plank;
        hold = {0.5f, 0.0f};
    }
    trial.scene().addJoint({.a = last, .b = trial.pin({80.0f, 20.0f}), .anchorA = hold});
    reportJoints(trial, 20.0, 3.0, 0.0);
}

void jointGrid(Trial& trial) {
    scenes::buildJointGrid(trial.scene(), 100);
    reportJoints(trial, 4.0, 0.6, 19.0);
}

}  // namespace plumb::accuracy
