#include <algorithm>

#include "core/text.hpp"
#include "tests/accuracy/reference/group_step.hpp"

namespace plumb::reference {

namespace {

constexpr double kAcceptedError = 1.0e-12;  // accepted position error, m, rad

}  // namespace

/// Corrects position errors of joints and contacts by minimal displacements of bodies, to first order.
/// @return the largest error before the correction, m or rad
double GroupStep::correctPositionsOnce() {
    writer_.beginShift(shift_);
    double worst = 0.0;
    for (const std::uint32_t index : group_->laws) {
        const Law& law = scene_.laws[index];
        if (law.kind != ConstraintKind::Hold && law.kind != ConstraintKind::AtLeast) continue;
        const std::uint32_t a = writer_.local(law.a), b = writer_.local(law.b);
        Gradient gradient = gradientOf(law.measure, q1_[a], q1_[b]);
        Row row{.target = -gradient.value};
        if (law.kind == ConstraintKind::AtLeast) {
            row.kind = RowKind::Push;
            row.target *= law.sign;
            gradient.a = law.sign * gradient.a, gradient.b = law.sign * gradient.b;
        }
        const double amiss = law.kind == ConstraintKind::Hold ? std::fabs(row.target) : row.target;
        worst = std::max(worst, amiss);
        writer_.add(shift_, gradient, gradient, a, b, row);
    }
    std::vector<Touch> touches;
    findAt(q1_, touches);
    for (const Touch& touch : touches) {
        const TouchView now = view(touch, q1_);
        const bool presses = std::any_of(active_.begin(), active_.end(), [&](const Active& active) {
            return active.touch.key == touch.key && active.normal > 0.0;
        });
        worst = std::max(worst, presses ? std::fabs(now.gap) : -now.gap);
        const std::uint32_t a = writer_.local(touch.bodyA), b = writer_.local(touch.bodyB);
        const Gradient along = normalGradient(now, q1_[a], q1_[b]);
        writer_.add(shift_, along, along, a, b,
                    {.target = -now.gap, .kind = presses ? RowKind::Both : RowKind::Push});
    }
    if (worst < kAcceptedError) return worst;
    shift_.tolerance = std::max(1.0e-4 * worst, 1.0e-15);
    const RowOutcome outcome = shifter_.solve(shift_);
    state_.factorings += outcome.factorings;
    state_.sweeps += outcome.sweeps;
    for (std::size_t i = 0; i < group_->pushed; ++i) q1_[i] = q1_[i] + shift_.velocity[i];
    return worst;
}

void GroupStep::correctPositions(int mostRounds, double hopeless) {
    double worst = kEndless, before = kEndless;
    for (int round = 0; round < mostRounds && !(worst < kAcceptedError); ++round) {
        worst = correctPositionsOnce();
        if (round % 10 != 9) continue;
        if (worst > 0.9 * before) break;
        before = worst;
    }
    if (worst > hopeless && state_.trouble.empty()) {
        state_.trouble = format("bodies overlap at the start by {} m and cannot be separated",
                                shortestText(static_cast<float>(worst)));
    }
}

}  // namespace plumb::reference
