#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/formulas.hpp"

namespace plumb::accuracy {

namespace {

constexpr Material kGhost{.group = -1};           // bodies of this group do not collide with each other
constexpr double kDisc = 0.1;                     // radius of a bob, m
constexpr double kInertia = 0.5 * kDisc * kDisc;  // moment of inertia of a disc per mass, m2

/// Hangs a disc at the end of a rigid arm of 1 m from the
/// origin, at an angle `amplitude` (rad) from the vertical.
BodyHandle hangBob(Trial& trial, double amplitude) {
    const Vec2 place{static_cast<float>(std::sin(amplitude)), static_cast<float>(-std::cos(amplitude))};
    const BodyHandle hook = trial.pin({});
    const BodyHandle bob = trial.add(scenes::circle(static_cast<float>(kDisc)), place, kGhost);
    trial.scene().addJoint({.a = hook, .b = bob, .anchorB = -place});
    return bob;
}

/// Records when a pendulum passes its lowest point; interpolates linearly between two steps.
class Passes {
public:
    void look(double time, double angle) {
        const bool passes = before_ * angle < 0.0 && std::fabs(angle) < 1.0;
        if (passes) {
            last_ = time - angle / (angle - before_) / 60.0;
            if (count_++ == 0) first_ = last_;
        }
        before_ = angle;
    }
    [[nodiscard]] double period() const { return 2.0 * (last_ - first_) / (count_ - 1); }

private:
    double before_ = 0.0, first_ = 0.0, last_ = 0.0;
    int count_ = 0;
};

void swingPeriod(Trial& trial, double degrees, double seconds) {
    const double amplitude = degrees * std::numbers::pi / 180.0;
    const BodyHandle bob = hangBob(trial, amplitude);
    Passes passes;
    trial.run(seconds, [&](double time) { passes.look(time, std::atan2(trial.x(bob), -trial.y(bob))); });
    // A disc on an arm swings like a point mass on a slightly longer arm.
    const double wanted = pendulumPeriod(amplitude, 1.0 + kInertia, kGravity);
    trial.report("period", std::fabs(passes.period() / wanted - 1.0) * 100.0, "%", 0.1);
}

}  // namespace

void pendulum(Trial& trial) {
    const BodyHandle bob = hangBob(trial, 0.5 * std::numbers::pi);
    // Maximum energy loss over the last second, expressed as a height.
    double lost = 0.0;
    trial.run(10.0, [&](double time) {
        if (time < 9.0) return;
        const double spin = trial.spin(bob);
        const double energy =
            0.5 * static_cast<double>(lengthSquared(trial.velocity(bob))) + 0.5 * kInertia * spin * spin;
        lost = std::max(lost, std::fabs(trial.y(bob) + energy / kGravity));
    });
    trial.report("height", lost * 100.0, "%", 0.05);
}

void pendulum90(Trial& trial) { swingPeriod(trial, 90.0, 10.0); }
void pendulum170(Trial& trial) { swingPeriod(trial, 170.0, 20.0); }

void doublePendulum(Trial& trial) {
    const PendulumForm form{.inertia = kInertia, .gravity = kGravity};
    const BodyHandle upper = hangBob(trial, 0.5 * std::numbers::pi);
    const BodyHandle lower = trial.add(scenes::circle(static_cast<float>(kDisc)), {2.0f, 0.0f}, kGhost);
    trial.scene().addJoint({.a = upper, .b = lower, .anchorB = {-1.0f, 0.0f}});
    trial.run(2.0);
    const double level = 0.5 * std::numbers::pi;
    const DoublePendulum end = swing({level, level, 0.0, 0.0}, form, 2.0);
    const double x = std::sin(end.angleA) + std::sin(end.angleB);
    const double y = -std::cos(end.angleA) - std::cos(end.angleB);
    trial.report("place", std::hypot(trial.x(lower) - x, trial.y(lower) - y) * 1000.0, "mm", 10.0);
    double energy = 0.0;  // total energy at the end, J; 0 at the start
    for (const BodyHandle body : {upper, lower}) {
        const double spin = trial.spin(body);
        energy += 0.5 * static_cast<double>(lengthSquared(trial.velocity(body))) +
                  0.5 * kInertia * spin * spin + kGravity * trial.y(body);
    }
    // Relative to the potential energy between start and lowest point: 3 m times the weight.
    trial.report("energy", std::fabs(energy) / (3.0 * kGravity) * 100.0, "%", 0.1);
}

}  // namespace plumb::accuracy
