#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/experiments.hpp"

namespace plumb::accuracy {

namespace {

constexpr Material kElastic{.friction = 0.0f, .bounciness = 1.0f};

/// Measures the heights of `count` bounces of a ball that falls 2 m and keeps `kept` of its speed per bounce.
void bounceTrain(Trial& trial, double kept, int count, double seconds, double target) {
    constexpr double kHeight = 2.0;  // initial height of the ball's lowest point, m
    // The floor has the same bounciness: some engines use the larger value, some the product.
    const Material material{.friction = 0.0f, .bounciness = static_cast<float>(kept)};
    trial.floor(material);
    const BodyHandle ball = trial.add(scenes::circle(0.5f), {0.0f, 2.5f}, material);
    int bounces = 0;
    double before = 0.0, wanted = 1.0, worst = 0.0;
    trial.run(seconds, [&](double) {
        const auto speed = static_cast<double>(trial.velocity(ball).y);
        const bool bounced = before < 0.0 && speed > 0.0;
        before = speed;
        if (!bounced || ++bounces > count) return;
        wanted *= kept * kept;
        const double height = trial.y(ball) - 0.5 + speed * speed / (2.0 * kGravity);
        const double error = height / (wanted * kHeight) - 1.0;
        worst = std::fabs(error) > std::fabs(worst) ? error : worst;
    });
    // A ball that did not bounce `count` times has an error of 100 %.
    trial.report("height", bounces < count ? 100.0 : std::fabs(worst) * 100.0, "%", target);
    if (kept == 1.0) trial.report("gained", std::max(worst, 0.0) * 100.0, "%", 0.005);
}

}  // namespace

void tenBounces(Trial& trial) { bounceTrain(trial, 1.0, 10, 16.0, 0.5); }
void bounces09(Trial& trial) { bounceTrain(trial, 0.9, 10, 12.0, 1.0); }
// Three bounces only: the fourth would be slower than Settings::bounceSpeed.
void bounces05(Trial& trial) { bounceTrain(trial, 0.5, 3, 4.0, 1.0); }

void bullet(Trial& trial) {
    constexpr std::array kSpeeds{10.0, 30.0, 100.0, 300.0, 1000.0};  // m/s
    constexpr double kRadius = 0.05, kThin = 0.005, kEnd = 1.0;  // bullet, half the wall (m), end time (s)
    std::array<BodyHandle, kSpeeds.size()> bullets;
    const auto hitTime = [](std::size_t i) { return 0.5 + (0.37 + 0.13 * static_cast<double>(i)) / 60.0; };
    for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
        const float y = 3.0f * static_cast<float>(i);
        trial.addFixed(scenes::box({static_cast<float>(kThin), 1.0f}), {0.0f, y}, kElastic);
        const double x = -kThin - kRadius - kSpeeds[i] * hitTime(i);
        bullets[i] =
            trial.add(scenes::circle(static_cast<float>(kRadius)), {static_cast<float>(x), y}, kElastic);
        trial.setVelocity(bullets[i], {static_cast<float>(kSpeeds[i]), 0.0f});
    }
    trial.run(kEnd);
    double late = 0.0, passed = 0.0;
    for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
        // A bullet flies back with the same speed, so its position gives the time of the hit.
        const double hit = kEnd + (trial.x(bullets[i]) + kThin + kRadius) / kSpeeds[i];
        late = std::max(late, std::fabs(hit - hitTime(i)));
        if (trial.x(bullets[i]) > 0.0) passed += 1.0;
    }
    trial.report("time", late * 1.0e3, "ms", 0.1);
    trial.report("passed", passed, "bullets", 0.0);
}

}  // namespace plumb::accuracy
