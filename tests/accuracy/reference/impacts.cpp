#include <algorithm>

#include "tests/accuracy/reference/group_step.hpp"

namespace plumb::reference {

namespace {

constexpr int kMaxBounces = 4000;

}  // namespace

double GroupStep::approachOf(const Touch& touch) const {
    const std::uint32_t a = writer_.local(touch.bodyA), b = writer_.local(touch.bodyB);
    const Gradient gradient = normalGradient(view(touch, q0_), q0_[a], q0_[b]);
    return dot(gradient.a, v0_[a]) + dot(gradient.b, v0_[b]);
}

/// Solves an impact: changes velocities instantaneously so that joints hold and no contact approaches.
void GroupStep::solveImpact(std::span<const Touch> touches, bool bounces) {
    writer_.beginImpact(system_, v0_);
    for (const std::uint32_t index : group_->laws) {
        const Law& law = scene_.laws[index];
        Gradient gradient = gradientOf(law.measure, q0_[writer_.local(law.a)], q0_[writer_.local(law.b)]);
        Row row;
        if (law.kind == ConstraintKind::AtLeast && law.sign * gradient.value < kClosed) {
            row.kind = RowKind::Push;
            gradient.a = law.sign * gradient.a, gradient.b = law.sign * gradient.b;
        } else if (law.kind != ConstraintKind::Hold) {
            continue;
        }
        writer_.add(system_, gradient, gradient, writer_.local(law.a), writer_.local(law.b), row);
    }
    for (const Touch& touch : touches) {
        const std::uint32_t a = writer_.local(touch.bodyA), b = writer_.local(touch.bodyB);
        const TouchView now = view(touch, q0_);
        const Gradient along = normalGradient(now, q0_[a], q0_[b]),
                       across = tangentGradient(now, q0_[a], q0_[b]);
        Row normal{.kind = RowKind::Push};
        const double approach = approachOf(touch);
        if (bounces && approach < -scene_.bounceSpeed) normal.target = -touch.bounciness * approach;
        const std::uint32_t row = writer_.add(system_, along, along, a, b, normal);
        if (touch.friction == 0.0) continue;
        writer_.add(system_, across, across, a, b,
                    {.target = touch.surfaceSpeed,
                     .kind = RowKind::Friction,
                     .normal = row,
                     .friction = touch.friction});
    }
    if (system_.rows.empty()) return;
    solve(0.0);
    for (std::size_t i = 0; i < group_->pushed; ++i) v0_[i] = system_.velocity[i];
}

/// Resolves the impact of the two bodies that approach each other fastest, including joints
/// but no contacts with other bodies. So impulses travel through a row of balls one by one, as
/// in Newton's cradle. @return false if no two bodies approach fast enough to bounce
bool GroupStep::bounceOnce(std::span<const Touch> touches) {
    double fastest = -scene_.bounceSpeed;
    std::size_t worst = touches.size();
    for (std::size_t i = 0; i < touches.size(); ++i) {
        if (touches[i].bounciness == 0.0) continue;
        const double approach = approachOf(touches[i]);
        if (approach < fastest) fastest = approach, worst = i;
    }
    if (worst == touches.size()) return false;
    std::vector<Touch> both;
    for (const Touch& touch : touches) {
        if (touch.bodyA == touches[worst].bodyA && touch.bodyB == touches[worst].bodyB) both.push_back(touch);
    }
    solveImpact(both, true);
    return true;
}

void GroupStep::strike() {
    std::vector<Touch> touches;
    findAt(q0_, touches);
    std::erase_if(touches, [&](const Touch& touch) { return view(touch, q0_).gap > kClosed; });
    for (int i = 0; i < kMaxBounces && bounceOnce(touches); ++i) {
    }
    solveImpact(touches, false);
}

}  // namespace plumb::reference
