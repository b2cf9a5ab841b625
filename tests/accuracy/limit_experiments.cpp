#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/accuracy/experiments.hpp"
#include "tests/accuracy/formulas.hpp"

// Experiments at stability limits: a structure is built slightly above and slightly below its limit.

namespace plumb::accuracy {

namespace {

/// A structure at a signed distance from its stability limit, percent.
struct Candidate {
    double percent = 0.0;  ///< above 0: must fail, below 0: must stand
    BodyHandle body;
    scenes::Pose start;
};

/// Returns the largest distance from the limit, percent, of a candidate that wrongly stands or fails.
double worstWrong(Trial& trial, const std::vector<Candidate>& candidates, double seconds, double moved) {
    trial.run(seconds);
    double worst = 0.0;
    for (const Candidate& candidate : candidates) {
        const double way = std::hypot(trial.x(candidate.body) - candidate.start.x,
                                      trial.y(candidate.body) - candidate.start.y);
        const bool gave = !(way < moved);
        if (gave != (candidate.percent > 0.0)) worst = std::max(worst, std::fabs(candidate.percent));
    }
    return worst;
}

/// Builds a row of candidates, one above and one below the
/// limit per distance in `percents`, `pitch` meters apart.
/// @param make builds one candidate from the distance from its limit, percent, and its position x, m
template <class Make>
std::vector<Candidate> lineUp(Trial& trial, std::span<const double> percents, double pitch, Make&& make) {
    std::vector<Candidate> all;
    double x = -pitch * (static_cast<double>(percents.size()) - 0.5);
    for (const double percent : percents) {
        for (const double sign : {-1.0, 1.0}) {
            const BodyHandle body = make(sign * percent, x);
            all.push_back({sign * percent, body, trial.scene().poseOf(body)});
            x += pitch;
        }
    }
    return all;
}

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Builds a semicircular arch of 41 equal stones around `x`. @return the top stone
BodyHandle halfRing(Trial& trial, double x, double thickness, double radius) {
    constexpr int kStones = 41;
    const Material rough{.friction = 2.0f};
    trial.addFixed(scenes::box({1.3f * static_cast<float>(radius), 1.0f}), at(x, -1.0), rough);
    BodyHandle top;
    const auto corner = [&](int i, double side) {
        const double angle = std::numbers::pi * i / kStones, reach = radius + 0.5 * side * thickness;
        return at(reach * std::cos(angle), reach * std::sin(angle));
    };
    for (int i = 0; i < kStones; ++i) {
        std::array<Vec2, 4> corners{corner(i, -1.0), corner(i, 1.0), corner(i + 1, 1.0), corner(i + 1, -1.0)};
        Vec2 middle;
        for (const Vec2 c : corners) middle += 0.25f * c;
        for (Vec2& c : corners) c = c - middle;
        const BodyHandle stone = trial.add(scenes::polygon(corners), middle + at(x, 0.0), rough);
        if (i == kStones / 2) top = stone;
    }
    return top;
}

}  // namespace

void frictionThreshold(Trial& trial) {
    constexpr double kFriction = 0.5;
    constexpr std::array kPercents{0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
    const Material rough{.friction = static_cast<float>(kFriction)};
    const auto candidates = lineUp(trial, kPercents, 15.0, [&](double percent, double x) {
        const double slope = std::atan(kFriction * (1.0 + 0.01 * percent));
        const auto angle = static_cast<float>(-slope);
        trial.addFixed(scenes::box({5.0f, 1.0f}), at(x, 0.0), rough, angle);
        const double reach = -3.0, up = 1.5;  // position along the slope and perpendicular to it, m
        return trial.add(scenes::box({0.5f, 0.5f}),
                         at(x + reach * std::cos(slope) + up * std::sin(slope),
                            -reach * std::sin(slope) + up * std::cos(slope)),
                         rough, angle);
    });
    trial.report("wrong", worstWrong(trial, candidates, 10.0, 0.05), "%", 0.1);
}

void ladder(Trial& trial) {
    constexpr double kFriction = 0.4, kHalf = 2.0, kThin = 0.05;  // half length, half thickness (m)
    constexpr std::array kPercents{0.2, 0.5, 1.0, 2.0, 5.0, 10.0};
    const Material rough{.friction = static_cast<float>(kFriction)};
    trial.floor(rough);
    const double limit = ladderSlips(kFriction, kHalf, kThin);
    const auto candidates = lineUp(trial, kPercents, 8.0, [&](double percent, double x) {
        const double angle = std::atan(1.0 / (limit * (1.0 + 0.01 * percent)));
        trial.addFixed(scenes::box({0.5f, 4.0f}), at(x - 0.5, 4.0), {.friction = 0.0f});
        // The ladder leans to the left; its long lower side touches wall and floor.
        const double cosine = std::cos(angle), sine = std::sin(angle);
        return trial.add(scenes::box({static_cast<float>(kHalf), static_cast<float>(kThin)}),
                         at(x + kHalf * cosine + kThin * sine, kHalf * sine + kThin * cosine), rough,
                         static_cast<float>(-angle));
    });
    trial.report("wrong", worstWrong(trial, candidates, 10.0, 0.05), "%", 1.0);
}

void stoneArch(Trial& trial) {
    constexpr double kRadius = 10.0;  // middle radius of the arch, m
    constexpr std::array kPercents{2.0, 5.0, 10.0, 20.0};
    const auto candidates = lineUp(trial, kPercents, 30.0, [&](double percent, double x) {
        return halfRing(trial, x, kArchStands * (1.0 - 0.01 * percent) * kRadius, kRadius);
    });
    trial.report("wrong", worstWrong(trial, candidates, 10.0, 0.2 * kRadius), "%", 2.0);
}

}  // namespace plumb::accuracy
