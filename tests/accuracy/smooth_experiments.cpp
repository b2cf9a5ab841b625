#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/model/fields.hpp"
#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/formulas.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;
constexpr Material kNoCollision{.mask = 0};  // material without collisions

/// Adds a mass of 1 kg, 1 m from the fixed end of a spring with this natural frequency.
BodyHandle hang(Trial& trial, double hertz, double damping) {
    const double omega = 2.0 * std::numbers::pi * hertz;
    const BodyHandle ball = trial.add(scenes::circle(0.1f), {1.0f, 0.0f}, kNoCollision);
    trial.setMass(ball, 1.0f);
    static_cast<void>(
        physics::createField(trial.world(), {.kind = physics::FieldKind::Spring,
                                             .strength = static_cast<float>(omega * omega),
                                             .damping = static_cast<float>(2.0 * damping * omega),
                                             .a = trial.id(ball)}));
    return ball;
}

void undamped(Trial& trial, double hertz) {
    const double omega = 2.0 * std::numbers::pi * hertz;
    const BodyHandle ball = hang(trial, hertz, 0.0);
    double place = 0.0, energy = 0.0;
    trial.run(10.0, [&](double time) {
        const double x = trial.x(ball), v = static_cast<double>(trial.velocity(ball).x) / omega;
        place = std::max(place, std::fabs(x - std::cos(omega * time)));
        energy = std::max(energy, std::fabs(x * x + v * v - 1.0));
    });
    trial.report("place", place * kMillimetres, "mm", 1.0);
    trial.report("energy", energy * 100.0, "%", 1.0);
}

void damped(Trial& trial, double damping) {
    const double omega = 2.0 * std::numbers::pi;  // angular frequency of 1 Hz, rad/s
    const BodyHandle ball = hang(trial, 1.0, damping);
    double place = 0.0;
    trial.run(5.0, [&](double time) {
        place = std::max(place, std::fabs(trial.x(ball) - springPlace(time, omega, damping)));
    });
    trial.report("place", place * kMillimetres, "mm", 1.0);
}

}  // namespace

void drag(Trial& trial) {
    constexpr double kDrag = 0.8, kTime = 2.0;  // drag (1/s), duration (s)
    const BodyHandle ball = trial.scene().createBody({.velocity = {12.0f, 9.0f}, .drag = 0.8f});
    trial.scene().addShape(ball, scenes::circle(0.5f));
    trial.run(kTime);
    const double left = (1.0 - std::exp(-kDrag * kTime)) / kDrag;  // s, travelled distance over initial speed
    const double x = trial.x(ball) - 12.0 * left;
    const double y = trial.y(ball) - ((9.0 + kGravity / kDrag) * left - kGravity / kDrag * kTime);
    trial.report("", std::hypot(x, y) * kMillimetres, "mm", 0.1);
}

void spring05(Trial& trial) { undamped(trial, 0.5); }
void spring2(Trial& trial) { undamped(trial, 2.0); }
void spring5(Trial& trial) { undamped(trial, 5.0); }
void spring10(Trial& trial) { undamped(trial, 10.0); }
void underdamped(Trial& trial) { damped(trial, 0.1); }
void criticallyDamped(Trial& trial) { damped(trial, 1.0); }
void overdamped(Trial& trial) { damped(trial, 3.0); }

void resonance(Trial& trial) {
    constexpr double kDamping = 0.05, kForce = 1.0, kTime = 40.0,
                     kLook = 5.0;  // damping ratio, N, s, s (whole periods)
    const double omega = 2.0 * std::numbers::pi;
    const BodyHandle ball = trial.add(scenes::circle(0.1f), {}, kNoCollision);
    trial.setMass(ball, 1.0f);
    static_cast<void>(
        physics::createField(trial.world(), {.kind = physics::FieldKind::Spring,
                                             .strength = static_cast<float>(omega * omega),
                                             .damping = static_cast<float>(2.0 * kDamping * omega),
                                             .a = trial.id(ball)}));
    // The force is constant during a step; its value at the middle of the step is the best choice.
    const double half = 0.5 / 60.0;
    trial.drive([&](double time) {
        const auto force = static_cast<float>(kForce * std::cos(omega * (time + half)));
        static_cast<void>(physics::applyForce(trial.world(), trial.id(ball), {force, 0.0f}));
    });
    double cosine = 0.0, sine = 0.0;
    trial.run(kTime, [&](double time) {
        if (time <= kTime - kLook + half) return;
        cosine += trial.x(ball) * std::cos(omega * time) * 2.0 / (60.0 * kLook);
        sine += trial.x(ball) * std::sin(omega * time) * 2.0 / (60.0 * kLook);
    });
    trial.drive({});
    // A force that is constant during each step has a slightly smaller first harmonic than the smooth force.
    const double held = std::sin(omega * half) / (omega * half);
    const double wanted = held * kForce / (2.0 * kDamping * omega * omega);
    trial.report("swing", std::fabs(std::hypot(cosine, sine) / wanted - 1.0) * 100.0, "%", 1.0);
}

void orbit(Trial& trial) {
    constexpr double kTurn = 2.0, kLong = 2.0, kOval = 0.3;  // period (s), semi-major axis (m), eccentricity
    const double pull = 4.0 * std::numbers::pi * std::numbers::pi * kLong * kLong * kLong / (kTurn * kTurn);
    const double near = kLong * (1.0 - kOval), speed = std::sqrt(pull * (1.0 + kOval) / near);
    const BodyHandle a =
        trial.add(scenes::circle(0.1f), {static_cast<float>(-0.5 * near), 0.0f}, kNoCollision);
    const BodyHandle b =
        trial.add(scenes::circle(0.1f), {static_cast<float>(0.5 * near), 0.0f}, kNoCollision);
    for (const BodyHandle body : {a, b}) {
        trial.setVelocity(body,
                          {0.0f, static_cast<float>(body.index == b.index ? 0.5 * speed : -0.5 * speed)});
        static_cast<void>(physics::createField(trial.world(), {.kind = physics::FieldKind::Attractor,
                                                               .strength = static_cast<float>(0.5 * pull),
                                                               .a = trial.id(body)}));
    }
    const double energy = 0.5 * speed * speed - pull / near, turning = near * speed;
    double mostEnergy = 0.0, mostTurning = 0.0;
    trial.run(100.0 * kTurn, [&](double) {
        const double x = trial.x(b) - trial.x(a), y = trial.y(b) - trial.y(a);
        const Vec2 v = trial.velocity(b) - trial.velocity(a);
        const double now = 0.5 * static_cast<double>(lengthSquared(v)) - pull / std::hypot(x, y);
        const double turns = x * static_cast<double>(v.y) - y * static_cast<double>(v.x);
        mostEnergy = std::max(mostEnergy, std::fabs(now / energy - 1.0));
        mostTurning = std::max(mostTurning, std::fabs(turns / turning - 1.0));
    });
    const double x = trial.x(b) - trial.x(a) - near, y = trial.y(b) - trial.y(a);
    trial.report("place", std::hypot(x, y) * kMillimetres, "mm", 10.0);
    trial.report("energy", mostEnergy * 100.0, "%", 1.0);
    trial.report("momentum", mostTurning * 100.0, "%", 0.1);
}

}  // namespace plumb::accuracy
