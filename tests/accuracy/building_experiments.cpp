#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/experiments.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kWide = 5.0;   // half the span of the arch, m
constexpr double kSteep = 2.0;  // parameter a of the arch's axis y = top - a (cosh(x / a) - 1), m
constexpr double kThick = 0.9;  // half the thickness of the arch, m

/// Returns the point of the arch at the arc length `along` (m) from its
/// crown and the distance `out` (m, positive: outside) from its center line.
Vec2 archPoint(double along, double out) {
    const double x = kSteep * std::asinh(along / kSteep);
    const double top = kSteep * (std::cosh(kWide / kSteep) - 1.0);
    const double y = top - kSteep * (std::cosh(x / kSteep) - 1.0);
    const double slope = std::sinh(x / kSteep), size = std::sqrt(1.0 + slope * slope);
    return {static_cast<float>(x + out * slope / size), static_cast<float>(y + out / size)};
}

Vec2 onGround(Vec2 point) { return {point.x, 0.0f}; }

double movedBy(Trial& trial, BodyHandle body, const scenes::Pose& start) {
    return std::hypot(trial.x(body) - start.x, trial.y(body) - start.y);
}

}  // namespace

void arch(Trial& trial) {
    constexpr int kStones = 17;
    trial.floor();
    const double half = kSteep * std::sinh(kWide / kSteep);
    std::vector<BodyHandle> bodies;
    for (int i = 0; i < kStones; ++i) {
        const double begin = half * (2.0 * i / kStones - 1.0), end = half * (2.0 * (i + 1) / kStones - 1.0);
        std::array<Vec2, 4> corners{archPoint(begin, -kThick), archPoint(begin, kThick),
                                    archPoint(end, kThick), archPoint(end, -kThick)};
        if (i == 0) corners[0] = onGround(corners[0]), corners[1] = onGround(corners[1]);
        if (i + 1 == kStones) corners[2] = onGround(corners[2]), corners[3] = onGround(corners[3]);
        bodies.push_back(trial.add(scenes::polygon(corners), {}));
    }
    const float top = archPoint(half / kStones, kThick).y;
    for (int i = 0; i < 4; ++i) {
        bodies.push_back(trial.add(scenes::box({2.0f, 0.5f}), {0.0f, top + 0.5f + static_cast<float>(i)}));
    }
    std::vector<scenes::Pose> starts;
    for (const BodyHandle body : bodies) starts.push_back(trial.scene().poseOf(body));
    trial.run(10.0);
    double drift = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        drift = std::max(drift, movedBy(trial, bodies[i], starts[i]));
    trial.report("drift", drift * 1000.0, "mm", 20.0);
}

void cardHouse(Trial& trial) {
    constexpr int kLevels = 5;
    constexpr float kHalf = 0.2f, kThin = 0.0005f, kLean = 0.436f;  // half length, half thickness (m), rad
    const Material paper{.friction = 0.7f};
    trial.floor(paper);
    const float sine = std::sin(kLean), cosine = std::cos(kLean);
    const float rise = kHalf * cosine + kThin * sine,
                reach = kHalf * sine + kThin * cosine;  // height, distance from the pair's middle, m
    const float pitch = 4.0f * reach + 0.004f;
    const scenes::Outline card = scenes::box({kThin, kHalf});
    const scenes::Outline roof = scenes::box({0.5f * pitch - 0.0005f, kThin});
    std::vector<BodyHandle> bodies;
    for (int level = 0; level < kLevels; ++level) {
        const float ground = static_cast<float>(level) * (2.0f * rise + 2.0f * kThin);
        for (int i = 0; i < kLevels - level; ++i) {
            const float middle = pitch * (static_cast<float>(i) + 0.5f * static_cast<float>(level));
            bodies.push_back(trial.add(card, {middle - reach, ground + rise}, paper, -kLean));
            bodies.push_back(trial.add(card, {middle + reach, ground + rise}, paper, kLean));
            if (i > 0)
                bodies.push_back(
                    trial.add(roof, {middle - 0.5f * pitch, ground + 2.0f * rise + kThin}, paper));
        }
    }
    std::vector<scenes::Pose> starts;
    for (const BodyHandle body : bodies) starts.push_back(trial.scene().poseOf(body));
    trial.run(10.0);
    double drift = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        drift = std::max(drift, movedBy(trial, bodies[i], starts[i]));
    trial.report("drift", drift * 1000.0, "mm", 20.0);
    trial.report("residual", trial.fastest() * 1000.0, "mm/s", 50.0);
}

}  // namespace plumb::accuracy
