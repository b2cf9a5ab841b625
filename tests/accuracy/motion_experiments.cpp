#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/experiments.hpp"

namespace plumb::accuracy {

namespace {

constexpr Material kElastic{.friction = 0.0f, .bounciness = 1.0f};

}  // namespace

void freeFall(Trial& trial) {
    const BodyHandle ball = trial.add(scenes::circle(0.5f), {0.0f, 100.0f});
    trial.run(2.0);
    // The goal is 0.1 mm, because smaller errors are rounding errors of floats.
    trial.report("", std::fabs(trial.y(ball) - (100.0 - 0.5 * kGravity * 4.0)) * 1000.0, "mm", 0.1);
}

void projectile(Trial& trial) {
    const BodyHandle ball = trial.add(scenes::circle(0.5f), {0.0f, 0.0f});
    trial.setVelocity(ball, {12.0f, 9.0f});
    trial.run(2.0);
    const double x = trial.x(ball) - 24.0;
    const double y = trial.y(ball) - (18.0 - 0.5 * kGravity * 4.0);
    trial.report("", std::sqrt(x * x + y * y) * 1000.0, "mm", 0.1);
}

void incline(Trial& trial) {
    constexpr double kSlope = 0.5;  // angle of the incline, rad
    constexpr double kFriction = 0.2;
    const Material rough{.friction = static_cast<float>(kFriction)};
    const auto angle = static_cast<float>(-kSlope);
    const auto sine = static_cast<float>(std::sin(kSlope));
    const auto cosine = static_cast<float>(std::cos(kSlope));
    trial.addFixed(scenes::box({100.0f, 1.0f}), {}, rough, angle);
    const BodyHandle crate = trial.add(scenes::box({0.5f, 0.5f}), {1.5f * sine, 1.5f * cosine}, rough, angle);
    const double x = trial.x(crate);
    const double y = trial.y(crate);
    trial.run(3.0);
    const double way = 0.5 * kGravity * (std::sin(kSlope) - kFriction * std::cos(kSlope)) * 9.0;
    const double gone = (trial.x(crate) - x) * std::cos(kSlope) - (trial.y(crate) - y) * std::sin(kSlope);
    trial.report("", std::fabs(gone - way) / way * 100.0, "%", 0.05);
}

void rollingDisc(Trial& trial) {
    constexpr double kFriction = 0.2;
    constexpr double kSpeed = 6.0;  // initial speed, m/s; the disc rolls without sliding from t = 1 s on
    const Material rough{.friction = static_cast<float>(kFriction)};
    trial.floor(rough);
    const BodyHandle disc = trial.add(scenes::circle(0.5f), {-20.0f, 0.5f}, rough);
    trial.setVelocity(disc, {static_cast<float>(kSpeed), 0.0f});
    trial.run(1.5);
    const double speed = kSpeed * 2.0 / 3.0;
    const double way = kSpeed - 0.5 * kFriction * kGravity + speed * 0.5;
    trial.report("speed", std::fabs(static_cast<double>(trial.velocity(disc).x) - speed) / speed * 100.0, "%",
                 0.1);
    trial.report("way", std::fabs(trial.x(disc) + 20.0 - way) / way * 100.0, "%", 0.1);
}

/// A plank that rocks on a cylinder of radius 1 m without sliding keeps its amplitude.
void rockingPlank(Trial& trial) {
    constexpr double kTilt = 0.2;  // initial tilt, rad
    // Height of the plank's center above the cylinder's axis, and distance rolled at the initial tilt, m.
    constexpr double kReach = 1.1, kSwung = 0.2;
    constexpr Material kRough{.friction = 10.0f};
    trial.addFixed(scenes::circle(1.0f), {}, kRough);
    const double sine = std::sin(kTilt), cosine = std::cos(kTilt);
    const Vec2 centre{static_cast<float>(sine * kReach - kSwung * cosine),
                      static_cast<float>(cosine * kReach + kSwung * sine)};
    const BodyHandle plank = trial.add(scenes::box({1.0f, 0.1f}), centre, kRough, static_cast<float>(-kTilt));
    double tilt = 0.0;  // maximum over the last 2 s, which is more than a period
    trial.run(10.0, [&](double time) {
        if (time > 8.0) tilt = std::max(tilt, std::fabs(trial.angle(plank)));
    });
    trial.report("lost", std::max(1.0 - tilt / kTilt, 0.0) * 100.0, "%", 20.0);
    trial.report("gained", std::max(tilt / kTilt - 1.0, 0.0) * 100.0, "%", 0.5);
}

void elasticPairs(Trial& trial) {
    struct Pair {
        double massA, massB, speedA, speedB;
    };
    constexpr std::array<Pair, 5> kPairs{{{1.0, 1.0, 4.0, 0.0},
                                          {1.0, 3.0, 5.0, -2.0},
                                          {1.0, 100.0, 3.0, 0.0},
                                          {50.0, 1.0, 2.0, 0.0},
                                          {2.0, 7.0, 9.0, 1.5}}};
    std::array<BodyHandle, 2 * kPairs.size()> bodies;
    for (std::size_t i = 0; i < kPairs.size(); ++i) {
        const float y = 3.0f * static_cast<float>(i);
        bodies[2 * i] = trial.add(scenes::circle(0.5f), {-2.0f, y}, kElastic);
        bodies[2 * i + 1] = trial.add(scenes::circle(0.5f), {0.0f, y}, kElastic);
        trial.setMass(bodies[2 * i], static_cast<float>(kPairs[i].massA));
        trial.setMass(bodies[2 * i + 1], static_cast<float>(kPairs[i].massB));
        trial.setVelocity(bodies[2 * i], {static_cast<float>(kPairs[i].speedA), 0.0f});
        trial.setVelocity(bodies[2 * i + 1], {static_cast<float>(kPairs[i].speedB), 0.0f});
    }
    trial.run(1.0);
    double worst = 0.0, drift = 0.0;
    for (std::size_t i = 0; i < kPairs.size(); ++i) {
        const auto [a, b, u, v] = kPairs[i];
        const auto x = static_cast<double>(trial.velocity(bodies[2 * i]).x);
        const auto y = static_cast<double>(trial.velocity(bodies[2 * i + 1]).x);
        const double common = (a * u + b * v) / (a + b);
        worst = std::max({worst, std::fabs(x - (2.0 * common - u)) / (u - v),
                          std::fabs(y - (2.0 * common - v)) / (u - v)});
        drift = std::max(drift,
                         std::fabs(a * x + b * y - (a * u + b * v)) / (a * std::fabs(u) + b * std::fabs(v)));
    }
    trial.report("speed", worst * 100.0, "%", 0.01);
    trial.report("momentum", drift, "ratio", 1.0e-6);
}

void newtonsCradle(Trial& trial) {
    std::array<BodyHandle, 5> balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls[i] =
            trial.add(scenes::circle(0.5f), {static_cast<float>(i) - (i == 0 ? 2.0f : 0.0f), 0.0f}, kElastic);
    }
    trial.setVelocity(balls[0], {4.0f, 0.0f});
    trial.run(2.0);
    double worst = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double wanted = i + 1 == balls.size() ? 4.0 : 0.0;
        worst = std::max(worst, std::fabs(static_cast<double>(trial.velocity(balls[i]).x) - wanted));
    }
    trial.report("speed", worst / 4.0 * 100.0, "%", 1.0);
}

void obliqueDiscs(Trial& trial) {
    const double offset = 0.6;  // of the centers, perpendicular to the velocity, m: sine of the normal is 0.6
    const BodyHandle a = trial.add(scenes::circle(0.5f), {-3.0f, static_cast<float>(-offset)}, kElastic);
    const BodyHandle b = trial.add(scenes::circle(0.5f), {0.0f, 0.0f}, kElastic);
    trial.setVelocity(a, {4.0f, 0.0f});
    trial.run(2.0);
    // Velocity components along the normal are exchanged, tangential components stay.
    const double along = 4.0 * 0.8;
    const Vec2 va = trial.velocity(a), vb = trial.velocity(b);
    const double ax = static_cast<double>(va.x) - (4.0 - along * 0.8),
                 ay = static_cast<double>(va.y) + along * 0.6;
    const double bx = static_cast<double>(vb.x) - along * 0.8, by = static_cast<double>(vb.y) - along * 0.6;
    trial.report("speed", std::max(std::hypot(ax, ay), std::hypot(bx, by)) / 4.0 * 100.0, "%", 1.0);
    trial.report("momentum",
                 std::hypot(static_cast<double>(va.x + vb.x) - 4.0, static_cast<double>(va.y + vb.y)) / 4.0,
                 "ratio", 1.0e-6);
    const double energy = static_cast<double>(lengthSquared(va) + lengthSquared(vb)) / 16.0;
    trial.report("energy", std::fabs(energy - 1.0) * 100.0, "%", 0.01);
}

}  // namespace plumb::accuracy
