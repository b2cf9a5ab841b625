#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "tests/accuracy/experiments.hpp"
#include "tests/bench/physics/ragdoll.hpp"
#include "tests/bench/physics/scene_error.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;

/// Drops `count` circles and boxes, `row` per row, into a pit; its walls' centers are `wide` m apart.
void pour(Trial& trial, int count, int row, float wide) {
    trial.floor();
    for (const float x : {-0.5f * wide, 0.5f * wide}) trial.addFixed(scenes::box({1.0f, 60.0f}), {x, 60.0f});
    for (int i = 0; i < count; ++i) {
        const Vec2 place{static_cast<float>(i % row) - 0.5f * static_cast<float>(row - 1),
                         static_cast<float>(i / row)};
        const float aside = i / row % 2 == 0 ? 0.15f : -0.15f;
        trial.add(i % 3 == 0 ? scenes::circle(0.5f) : scenes::box({0.5f, 0.4f}),
                  {1.2f * place.x + aside, 0.7f + 1.1f * place.y});
    }
}

/// Builds a small scene at the origin: stacked crates and a ball that falls on them.
std::vector<BodyHandle> smallScene(Trial& trial) {
    std::vector<BodyHandle> bodies{trial.addFixed(scenes::box({10.0f, 1.0f}), {0.0f, -1.0f})};
    for (int i = 0; i < 5; ++i)
        bodies.push_back(trial.add(scenes::box({0.5f, 0.5f}),
                                   {0.1f * static_cast<float>(i), 0.6f + 1.1f * static_cast<float>(i)}));
    bodies.push_back(trial.add(scenes::circle(0.4f), {-3.0f, 4.0f}, {.bounciness = 0.5f}));
    return bodies;
}

}  // namespace

void pileOf500(Trial& trial) {
    trial.floor();
    for (const float x : {-8.0f, 8.0f}) trial.addFixed(scenes::box({1.0f, 30.0f}), {x, 30.0f});
    for (int i = 0; i < 500; ++i) {
        const int row = i / 10;
        const Vec2 centre{-5.4f + 1.2f * static_cast<float>(i % 10) + (row % 2 == 0 ? 0.15f : -0.15f),
                          0.7f + 1.1f * static_cast<float>(row)};
        trial.add(i % 3 == 0 ? scenes::circle(0.5f) : scenes::box({0.5f, 0.4f}), centre);
    }
    trial.run(20.0);
    trial.report("overlap", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 5.3);
    trial.report("residual", trial.fastest() * kMillimetres, "mm/s", 0.4);
}

void overlapRecovery(Trial& trial) {
    constexpr int kBase = 4;
    constexpr float kApart = 0.75f;  // distance between the centers of crates 1 m wide, m
    trial.floor();
    for (int row = 0; row < kBase; ++row) {
        for (int i = 0; i < kBase - row; ++i) {
            const float x = static_cast<float>(i) + 0.5f * static_cast<float>(row - kBase);
            trial.add(scenes::box({0.5f, 0.5f}), {kApart * x, 0.5f + kApart * static_cast<float>(row)});
        }
    }
    double peak = 0.0;
    trial.run(3.0, [&](double) { peak = std::max(peak, trial.fastest()); });
    trial.report("peak", peak, "m/s", 1.0);
    trial.report("left", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 5.0);
}

void crampedCircles(Trial& trial) {
    constexpr int kSide = 25;
    for (const float x : {-10.5f, 10.5f}) trial.addFixed(scenes::capsule({x, 0.0f}, {x, 20.5f}, 0.5f), {});
    for (const float y : {0.0f, 20.5f}) trial.addFixed(scenes::capsule({-10.5f, y}, {10.5f, y}, 0.5f), {});
    for (int i = 0; i < kSide * kSide; ++i) {
        const float column = static_cast<float>(i % kSide), row = static_cast<float>(i / kSide);
        trial.add(scenes::circle(0.5f), {-8.75f + column * 18.0f / kSide, 1.5f + row * 18.0f / kSide});
    }
    trial.run(10.0);
    trial.report("overlap", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 260.0);
}

void pit1000(Trial& trial) {
    pour(trial, 1000, 20, 30.0f);
    trial.run(20.0);
    trial.report("overlap", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", kNoTarget);
    trial.report("residual", trial.fastest() * kMillimetres, "mm/s", 50.0);
}

void ragdollPile(Trial& trial) {
    constexpr int kFigures = 20;
    trial.floor();
    for (const float x : {-3.0f, 3.0f}) trial.addFixed(scenes::box({0.5f, 20.0f}), {x, 20.0f});
    for (int i = 0; i < kFigures; ++i) {
        const float aside = i % 2 == 0 ? -0.6f : 0.5f;
        scenes::addRagdoll(trial.scene(), {aside, 0.5f + 1.0f * static_cast<float>(i)}, -(i + 1));
    }
    trial.run(15.0);
    const scenes::SceneError error = scenes::errorOf(trial.scene());
    trial.report("joints", error.maxJointError * kMillimetres, "mm", kNoTarget);
    trial.report("overlap", error.maxPenetration * kMillimetres, "mm", kNoTarget);
    trial.report("residual", trial.fastest() * kMillimetres, "mm/s", 50.0);
}

void farAway(Trial& trial) {
    const std::vector<BodyHandle> home = smallScene(trial);
    constexpr std::array kAway{1.0e6, 1.0e5, 1.0e4, 1.0e3};  // distances from the origin, m
    std::array<std::vector<BodyHandle>, kAway.size()> copies;
    for (std::size_t i = 0; i < kAway.size(); ++i) {
        copies[i] = smallScene(trial);
        for (const BodyHandle body : copies[i]) {
            static_cast<void>(physics::setPosition(
                trial.world(), trial.id(body), {trial.x(body) + kAway[i], trial.y(body) + kAway[i]}, 0.0f));
        }
    }
    trial.run(5.0);
    for (std::size_t i = 0; i < kAway.size(); ++i) {
        double apart = 0.0;
        for (std::size_t b = 0; b < home.size(); ++b) {
            apart = std::max(apart, std::hypot(trial.x(copies[i][b]) - kAway[i] - trial.x(home[b]),
                                               trial.y(copies[i][b]) - kAway[i] - trial.y(home[b])));
        }
        trial.report(format("{}km", static_cast<int>(kAway[i] / 1000.0)), apart * kMillimetres, "mm", 1.0);
    }
}

}  // namespace plumb::accuracy
