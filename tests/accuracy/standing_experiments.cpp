#include <algorithm>
#include <cmath>

#include "tests/accuracy/experiments.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;
const scenes::Outline kCrate = scenes::box({0.5f, 0.5f});

std::vector<BodyHandle> stackUp(Trial& trial, int count) {
    trial.floor();
    std::vector<BodyHandle> crates;
    for (int i = 0; i < count; ++i) crates.push_back(trial.add(kCrate, {0.0f, 0.5f + static_cast<float>(i)}));
    return crates;
}

void heavyBox(Trial& trial, float mass, double target) {
    const std::vector<BodyHandle> crates = stackUp(trial, 3);
    trial.setMass(crates.back(), mass);
    trial.run(10.0);
    trial.report("", std::fabs(trial.y(crates.back()) - 2.5) * kMillimetres, "mm", target);
}

/// Builds a pyramid of crates with `base` crates in the lowest row; each row above has one less.
std::vector<BodyHandle> pileUp(Trial& trial, int base, Vec2 corner, float size, float topDensity = 1.0f) {
    std::vector<BodyHandle> crates;
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            const Vec2 place{static_cast<float>(i) + 0.5f * static_cast<float>(row),
                             static_cast<float>(row) + 0.5f};
            crates.push_back(trial.add(scenes::box({0.5f * size, 0.5f * size}), corner + size * place,
                                       {.density = row + 1 == base ? topDensity : 1.0f}));
        }
    }
    return crates;
}

double largestMove(Trial& trial, const std::vector<BodyHandle>& bodies,
                   const std::vector<scenes::Pose>& starts) {
    double most = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        most = std::max(most, std::hypot(trial.x(bodies[i]) - starts[i].x, trial.y(bodies[i]) - starts[i].y));
    }
    return most;
}

std::vector<scenes::Pose> posesOf(Trial& trial, const std::vector<BodyHandle>& bodies) {
    std::vector<scenes::Pose> poses;
    for (const BodyHandle body : bodies) poses.push_back(trial.scene().poseOf(body));
    return poses;
}

void tallStack(Trial& trial, int count, double pressed) {
    const std::vector<BodyHandle> crates = stackUp(trial, count);
    trial.run(15.0);
    double lean = 0.0;
    for (const BodyHandle crate : crates) lean = std::max(lean, std::fabs(trial.x(crate)));
    trial.report("lean", lean, "m", 0.05);
    trial.report("bottom", (0.5 - trial.y(crates.front())) * kMillimetres, "mm", pressed);
}

}  // namespace

void stackOf20(Trial& trial) {
    const std::vector<BodyHandle> crates = stackUp(trial, 20);
    trial.run(10.0);
    trial.report("", std::fabs(trial.y(crates.back()) - 19.5) * kMillimetres, "mm", 5.0);
    // Each contact must carry the weight of all crates above it.
    double worst = 0.0;
    for (std::size_t level = 1; level < crates.size(); ++level) {
        const auto push = trial.pushBetween(crates[level - 1], crates[level]);
        if (!push) return;
        // Weight of the crates above the contact, N; each crate has a mass of 1 kg.
        const double weight = static_cast<double>(crates.size() - level) * kGravity;
        worst = std::max(worst, std::fabs(*push - weight) / weight);
    }
    trial.report("force", worst * 100.0, "%", 1.0);
}

void heavyBox100(Trial& trial) { heavyBox(trial, 100.0f, 2.0); }
void heavyBox1000(Trial& trial) { heavyBox(trial, 1000.0f, 15.0); }

void pyramidOf465(Trial& trial) {
    trial.floor();
    const std::vector<BodyHandle> crates = pileUp(trial, 30, {-15.0f, 0.0f}, 1.0f);
    const std::vector<scenes::Pose> starts = posesOf(trial, crates);
    trial.run(10.0);
    trial.report("drift", largestMove(trial, crates, starts) * kMillimetres, "mm", 4.0);
}

void heavyOnTwo(Trial& trial) {
    trial.floor();
    for (const float x : {-9.0f, 9.0f}) trial.add(kCrate, {x, 0.5f});
    trial.add(scenes::box({10.0f, 10.0f}), {0.0f, 26.0f});  // falls 15 m
    double peak = 0.0;
    trial.run(10.0, [&](double) { peak = std::max(peak, scenes::errorOf(trial.scene()).maxPenetration); });
    trial.report("peak", peak * kMillimetres, "mm", 10.0);
    trial.report("end", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 4.8);
}

void heavyOnTen(Trial& trial) {
    const std::vector<BodyHandle> crates = stackUp(trial, 11);
    trial.setMass(crates.back(), 100.0f);
    trial.run(10.0);
    trial.report("end", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 4.8);
    trial.report("height", std::fabs(10.5 - trial.y(crates.back())), "m", 0.1);
}

void heavyTops(Trial& trial) {
    trial.floor();
    std::vector<BodyHandle> crates;
    for (int i = 0; i < 3; ++i) {
        const float density = 100.0f * static_cast<float>(i + 1);
        const std::vector<BodyHandle> more =
            pileUp(trial, 10, {-40.0f + 30.0f * static_cast<float>(i), 0.0f}, 2.0f, density);
        crates.insert(crates.end(), more.begin(), more.end());
    }
    const std::vector<scenes::Pose> starts = posesOf(trial, crates);
    trial.run(10.0);
    trial.report("end", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 8.1);
    trial.report("drift", largestMove(trial, crates, starts), "m", 0.1);
}

void stackOf15(Trial& trial) { tallStack(trial, 15, 4.3); }
void stackOf50(Trial& trial) { tallStack(trial, 50, 4.3); }
void stackOf100(Trial& trial) { tallStack(trial, 100, 4.3); }

void farPyramid(Trial& trial) {
    constexpr double kFar = 1.0e5;  // distance from the origin, m
    const BodyHandle ground = trial.floor();
    std::vector<BodyHandle> all = pileUp(trial, 10, {-5.0f, 0.0f}, 1.0f);
    all.push_back(ground);
    for (const BodyHandle body : all) {
        static_cast<void>(physics::setPosition(trial.world(), trial.id(body),
                                               {trial.x(body) + kFar, trial.y(body) + kFar}, 0.0f));
    }
    trial.run(10.0);
    trial.report("end", scenes::errorOf(trial.scene()).maxPenetration * kMillimetres, "mm", 3.6);
    trial.report("residual", trial.fastest() * kMillimetres, "mm/s", 0.5);
}

}  // namespace plumb::accuracy
