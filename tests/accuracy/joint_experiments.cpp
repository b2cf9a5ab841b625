#include <algorithm>
#include <cmath>

#include "tests/accuracy/experiments.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;
constexpr Material kGhost{.group = -1};  // its bodies never meet

BodyHandle pin(Trial& trial, Vec2 place) {
    return trial.scene().createBody({.motion = scenes::Motion::Static, .position = place});
}

/// Twenty links that hang from a pin at the origin, and a ball `ratio` times as heavy as one.
void hangingChain(Trial& trial, float ratio, double target) {
    BodyHandle last = pin(trial, {});
    Vec2 hold;
    for (int i = 0; i < 20; ++i) {
        const BodyHandle link =
            trial.add(scenes::box({0.06f, 0.25f}), {0.0f, -0.25f - 0.5f * static_cast<float>(i)}, kGhost);
        trial.scene().addHinge({.a = last, .b = link, .anchorA = hold, .anchorB = {0.0f, 0.25f}});
        last = link;
        hold = {0.0f, -0.25f};
    }
    const BodyHandle ball = trial.add(scenes::circle(0.5f), {0.0f, -10.5f}, kGhost);
    trial.setMass(ball, ratio * 0.06f);
    trial.scene().addHinge({.a = last, .b = ball, .anchorA = hold, .anchorB = {0.0f, 0.5f}});
    trial.run(10.0);
    trial.report("", std::hypot(trial.x(ball), trial.y(ball) + 10.5) * kMillimetres, "mm", target);
}

/// Of the second half of the time, since that is what is seen.
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

void pendulum(Trial& trial) {
    const BodyHandle hook = pin(trial, {});
    const BodyHandle bob = trial.add(scenes::circle(0.1f), {1.0f, 0.0f}, kGhost);
    static_cast<void>(physics::createJoint(trial.world(), {.kind = physics::JointKind::Revolute,
                                                           .a = trial.scene().idOf(hook),
                                                           .b = trial.scene().idOf(bob),
                                                           .anchorB = {-1.0f, 0.0f}}));
    // Its energy, as a height: of the last second, in which it swings through all heights.
    double lost = 0.0;
    trial.run(10.0, [&](double time) {
        if (time < 9.0) return;
        const Vec2 v = trial.velocity(bob);
        const double spin =
            static_cast<double>(physics::angularVelocityOf(trial.world(), trial.scene().idOf(bob)));
        const double energy = 0.5 * static_cast<double>(lengthSquared(v)) + 0.25 * 0.01 * spin * spin;
        const double height = trial.y(bob) + energy / kGravity;
        lost = std::max(lost, std::fabs(height));
    });
    trial.report("height", lost * 100.0, "%", 0.05);
}

void chain100(Trial& trial) { hangingChain(trial, 100.0f, 10.0); }
void chain1000(Trial& trial) { hangingChain(trial, 1000.0f, 30.0); }

void ballAndChain(Trial& trial) {
    BodyHandle last = pin(trial, {});
    Vec2 hold;
    for (int i = 0; i < 40; ++i) {
        const BodyHandle link = trial.add(scenes::capsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.125f),
                                          {0.5f + static_cast<float>(i), 0.0f}, kGhost);
        trial.scene().addHinge({.a = last, .b = link, .anchorA = hold, .anchorB = {-0.5f, 0.0f}});
        last = link;
        hold = {0.5f, 0.0f};
    }
    const BodyHandle ball = trial.add(scenes::circle(4.0f), {44.0f, 0.0f}, kGhost);
    trial.setMass(ball, 500.0f * physics::massOf(trial.world(), trial.scene().idOf(last)));
    trial.scene().addHinge({.a = last, .b = ball, .anchorA = hold, .anchorB = {-4.0f, 0.0f}});
    reportJoints(trial, 20.0, 5.1, 0.0);
}

void bridge160(Trial& trial) {
    BodyHandle last = pin(trial, {-80.0f, 20.0f});
    Vec2 hold;
    for (int i = 0; i < 160; ++i) {
        const BodyHandle plank =
            trial.add(scenes::box({0.5f, 0.125f}), {-79.5f + static_cast<float>(i), 20.0f},
                      {.density = 20.0f, .group = -1});
        trial.scene().addHinge({.a = last, .b = plank, .anchorA = hold, .anchorB = {-0.5f, 0.0f}});
        last = plank;
        hold = {0.5f, 0.0f};
    }
    trial.scene().addHinge({.a = last, .b = pin(trial, {80.0f, 20.0f}), .anchorA = hold});
    reportJoints(trial, 20.0, 3.0, 0.0);
}

void jointGrid(Trial& trial) {
    const auto* const scene = scenes::findScene("jointgrid100");
    scene->build(trial.scene(), 100);
    reportJoints(trial, 4.0, 0.6, 19.0);
}

}  // namespace plumb::accuracy
