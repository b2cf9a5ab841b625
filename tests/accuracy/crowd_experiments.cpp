#include <algorithm>

#include "tests/accuracy/experiments.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;

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
    constexpr float kApart = 0.75f;  // m: of crates 1 m wide
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

}  // namespace plumb::accuracy
