#include <algorithm>

#include "tests/accuracy/reference/group_step.hpp"

namespace plumb::reference {

namespace {

constexpr double kExact = 1.0e-13;  // accepted gap at the computed time of an impact, m
constexpr double kFarOff = 1.0e9;   // upper limit of computed gaps, m
constexpr int kMaxSamples = 2000;

/// Returns the time between `low` and `high` at which gap(time) reaches 0: it is above 0 at `low`, below 0 at
/// `high`, and infinite for shapes that are far apart. Method: bisection, and secants with the Illinois rule.
template <class Gap>
double closingBetween(double low, double high, double gapLow, double gapHigh, const Gap& gap) {
    for (int i = 0; i < 200 && high - low > 1.0e-15 * high; ++i) {
        double time = 0.5 * (low + high);
        if (gapLow < kEndless && i % 4 != 3) time = low + (high - low) * gapLow / (gapLow - gapHigh);
        time = std::clamp(time, low, high);
        const double now = gap(time);
        if (std::fabs(now) <= kExact) return time;
        if (now > 0.0) {
            low = time, gapLow = now;
        } else {
            high = time, gapHigh = now;
        }
    }
    return low;
}

}  // namespace

/// Returns a body's pose at a time in the step: the velocity changes linearly, the pose is its integral.
Triple GroupStep::poseAt(std::size_t local, double time, double h) const {
    const Triple pose = q0_[local] + time * v0_[local] + (0.5 * time * time / h) * (v1_[local] - v0_[local]);
    return pose;
}

double GroupStep::gapAt(std::uint32_t a, std::uint32_t b, double time, double h) const {
    scratch_.clear();
    return findTouches(scene_, a, poseAt(localOfOutline(a), time, h), b, poseAt(localOfOutline(b), time, h),
                       kFarOff, scratch_);
}

/// Upper bound of the relative displacement of any two points of the outlines in the step, m.
double GroupStep::longestWay(std::uint32_t a, std::uint32_t b, double h) const {
    const std::size_t one = localOfOutline(a), two = localOfOutline(b);
    const auto fastest = [&](std::size_t local) {
        return std::max(std::fabs(v0_[local].turn), std::fabs(v1_[local].turn)) * writer_.bodyAt(local).reach;
    };
    const Triple start = v0_[two] - v0_[one], end = v1_[two] - v1_[one];
    return h * (std::max(length(placeOf(start)), length(placeOf(end))) + fastest(one) + fastest(two));
}

double GroupStep::closingOfPair(std::uint32_t a, std::uint32_t b, double h) {
    const double before = gapAt(a, b, 0.0, h), way = longestWay(a, b, h);
    if (before - way > 0.0 && before < kEndless) return kEndless;
    const auto gap = [&](double time) { return gapAt(a, b, time, h); };
    // A fast shape can pass through the other one within the step, so the gap is sampled often enough to find
    // a time at which they overlap.
    const double width = 0.25 * (scene_.outlines[a].width + scene_.outlines[b].width);
    const int samples = std::clamp(static_cast<int>(way / std::max(width, 1.0e-6)) + 1, 1, kMaxSamples);
    double low = 0.0, gapLow = before;
    for (int i = 1; i <= samples; ++i) {
        const double time = h * i / samples, now = gap(time);
        if (now < -kClosed) return closingBetween(low, time, gapLow, now, gap);
        low = time;
        gapLow = now;
    }
    return kEndless;
}

/// Returns the time in the step at which two outlines that touch already get another contact point, s.
double GroupStep::closingOfTouches(std::uint32_t a, std::uint32_t b, double h) {
    std::vector<Touch> touches;
    const std::size_t one = localOfOutline(a), two = localOfOutline(b);
    static_cast<void>(findTouches(scene_, a, q1_[one], b, q1_[two], 0.0, touches));
    double first = kEndless;
    for (const Touch& touch : touches) {
        const double now = view(touch, q1_).gap, before = view(touch, q0_).gap;
        if (now >= -kClosed || before <= 2.0 * kClosed) continue;
        const auto gap = [&](double time) {
            return viewOf(touch, poseAt(one, time, h), poseAt(two, time, h)).gap;
        };
        first = std::min(first, closingBetween(0.0, h, before, now, gap));
    }
    return first;
}

/// Returns the time of the first impact in the attempted step, s; `kEndless` if there is none.
double GroupStep::earliestClosing(double h) {
    double first = kEndless;
    for (const auto& [a, b] : group_->pairs) {
        const bool isOpen = gapAt(a, b, 0.0, h) > 2.0 * kClosed;
        first = std::min(first, isOpen ? closingOfPair(a, b, h) : closingOfTouches(a, b, h));
    }
    return first;
}

}  // namespace plumb::reference
