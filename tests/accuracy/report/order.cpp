#include "tests/accuracy/report/order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumb::accuracy {

namespace {

constexpr double kBetter = 0.85;    // an error falls if its ratio to the previous one is at most this
constexpr double kStraight = 1.25;  // maximum ratio of an error to the fitted line in a straight part
constexpr std::size_t kMin = 3;     // minimum number of points in a straight part
constexpr double kNoticed = 0.99;   // an error beats another if the ratio of both is at most this

struct Run {
    std::size_t begin = 0, end = 0;
    [[nodiscard]] std::size_t size() const { return end - begin; }
};

Run longestFall(std::span<const Sample> samples) {
    Run best, run;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i == 0 || samples[i].error > kBetter * samples[i - 1].error) run = {i, i};
        run.end = i + 1;
        if (run.size() > best.size()) best = run;
    }
    return best;
}

/// Straight line on log scales: log error = height - power * log effort.
struct Line {
    double power = 0.0, height = 0.0;
};

Line lineThrough(std::span<const Sample> samples) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Sample& sample : samples) {
        const double a = std::log(sample.effort), b = std::log(sample.error);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    const auto n = static_cast<double>(samples.size());
    const double spread = n * xx - x * x;
    const double power = spread > 0.0 ? (x * y - n * xy) / spread : 0.0;
    return {power, (y + power * x) / n};
}

bool isStraight(std::span<const Sample> samples) {
    const Line line = lineThrough(samples);
    return std::all_of(samples.begin(), samples.end(), [&](const Sample& sample) {
        const double off = std::log(sample.error) - line.height + line.power * std::log(sample.effort);
        return std::fabs(off) <= std::log(kStraight);
    });
}

/// Returns the longest straight part of a sequence; empty if there is none.
/// @param early  selects among equally long parts: true: the first, which is furthest from the floor;
/// false: the last
Run straightPart(std::span<const Sample> samples, Run fall, bool early) {
    for (std::size_t size = fall.size(); size >= kMin; --size) {
        Run found;
        for (std::size_t begin = fall.begin; begin + size <= fall.end; ++begin) {
            if (!isStraight(samples.subspan(begin, size))) continue;
            found = {begin, begin + size};
            if (early) break;
        }
        if (found.size() > 0) return found;
    }
    return {};
}

}  // namespace

Order orderOf(std::span<const Sample> samples) {
    std::vector<Sample> good;
    for (const Sample& sample : samples) {
        if (sample.effort > 0.0 && sample.error > 0.0 && std::isfinite(sample.error)) good.push_back(sample);
    }
    if (good.size() < 2) return {};
    const Run fall = longestFall(good);
    const bool ends = fall.size() >= kMin && fall.end < good.size();
    Run run = straightPart(good, fall, ends);
    if (run.size() == 0 && ends) run = {fall.begin, fall.end - 1};  // the last point is affected by the floor
    if (run.size() == 0) run = fall.size() >= kMin ? fall : Run{0, good.size()};
    const std::span<const Sample> used = std::span{good}.subspan(run.begin, run.size());
    Order order{.power = lineThrough(used).power,
                .first = used.front().effort,
                .last = used.back().effort,
                .points = static_cast<int>(used.size())};
    if (ends) {
        order.floorFrom = good[fall.end - 1].effort;
        order.floor = good[fall.end - 1].error;
        for (std::size_t i = fall.end; i < good.size(); ++i)
            order.floor = std::min(order.floor, good[i].error);
    }
    return order;
}

std::vector<std::size_t> paretoFront(std::span<const Sample> samples) {
    std::vector<std::size_t> byEffort;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (std::isfinite(samples[i].error) && std::isfinite(samples[i].effort)) byEffort.push_back(i);
    }
    std::stable_sort(byEffort.begin(), byEffort.end(), [samples](std::size_t a, std::size_t b) {
        return samples[a].effort < samples[b].effort ||
               (samples[a].effort == samples[b].effort && samples[a].error < samples[b].error);
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : byEffort) {
        if (front.empty() || samples[i].error < kNoticed * samples[front.back()].error) front.push_back(i);
    }
    return front;
}

}  // namespace plumb::accuracy
