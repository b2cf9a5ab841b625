#include "tests/accuracy/reference/group_step.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb::reference {

namespace {

constexpr int kMaxPasses = 6;  // maximum number of passes until the end of a step agrees with its prediction
constexpr double kSettled = 1.0e-13;  // accepted difference of end and predicted end, m, rad
constexpr int kMaxHits = 12;  // maximum number of impacts that divide a step; further ones do not end it
constexpr int kMaxTries = 6;  // maximum number of tries to end a step at an impact
constexpr double kUnsolved = 1.0e-4;  // a system with a larger residual is unsolved; ratio to the velocities

const Press* findPress(std::span<const Press> presses, std::uint64_t key) {
    const auto at = std::lower_bound(presses.begin(), presses.end(), key,
                                     [](const Press& press, std::uint64_t k) { return press.touch.key < k; });
    return at != presses.end() && at->touch.key == key ? &*at : nullptr;
}

}  // namespace

void GroupStep::load(const Group& group) {
    group_ = &group;
    writer_.setGroup(group);
    q0_.clear();
    v0_.clear();
    for (const std::uint32_t body : group.bodies) {
        q0_.push_back(state_.poses[body]);
        v0_.push_back(state_.velocities[body]);
    }
    active_.clear();
}

void GroupStep::store() {
    for (std::size_t i = 0; i < group_->pushed; ++i) {
        state_.poses[group_->bodies[i]] = q0_[i];
        state_.velocities[group_->bodies[i]] = v0_[i];
    }
}

void GroupStep::findAt(const std::vector<Triple>& poses, std::vector<Touch>& touches) const {
    touches.clear();
    for (const auto& [a, b] : group_->pairs)
        static_cast<void>(
            findTouches(scene_, a, poses[localOfOutline(a)], b, poses[localOfOutline(b)], kNear, touches));
}

/// Collects the active contacts: those active already, and those closed at the start and
/// the predicted end of the step. @param takeAll  true: also those that close in the step
void GroupStep::collect(bool takeAll) {
    std::vector<Active> before;
    before.swap(active_);
    findAt(q1_, scratch_);
    for (const Touch& touch : scratch_) {
        const auto known = std::find_if(before.begin(), before.end(),
                                        [&](const Active& active) { return active.touch.key == touch.key; });
        Active active{touch};
        if (known != before.end()) {
            active = *known;
            active.touch = touch;
        } else {
            if (view(touch, q1_).gap > kClosed) continue;
            const bool wasClosed = view(touch, q0_).gap <= 2.0 * kClosed;
            if (!wasClosed && !takeAll) continue;
            active.isNew = !wasClosed;
        }
        active_.push_back(active);
    }
}

void GroupStep::addContact(Active& active) {
    const Touch& touch = active.touch;
    const std::uint32_t a = writer_.local(touch.bodyA), b = writer_.local(touch.bodyB);
    const TouchView middle = view(touch, middle_), end = view(touch, q1_);
    Row normal{.kind = RowKind::Push, .impulse = active.normal};
    const Gradient push = normalGradient(middle, middle_[a], middle_[b]);
    if (active.isNew) {
        const double before = dot(push.a, v0_[a]) + dot(push.b, v0_[b]);
        if (before < -scene_.bounceSpeed) normal.target = -touch.bounciness * before;
    }
    active.row = writer_.add(system_, push, normalGradient(end, q1_[a], q1_[b]), a, b, normal);
    if (touch.friction == 0.0) return;
    Row tangent{.target = touch.surfaceSpeed,
                .kind = RowKind::Friction,
                .normal = active.row,
                .friction = touch.friction,
                .impulse = active.tangent};
    writer_.add(system_, tangentGradient(middle, middle_[a], middle_[b]),
                tangentGradient(end, q1_[a], q1_[b]), a, b, tangent);
}

void GroupStep::addLaw(std::uint32_t index, double h) {
    const Law& law = scene_.laws[index];
    const std::uint32_t a = writer_.local(law.a), b = writer_.local(law.b);
    if (law.kind == ConstraintKind::Spring) {
        const bool isSecond = index > 0 && scene_.laws[index - 1].isPoint;
        if (!isSecond) writer_.addSpring(system_, index, middle_, v0_, v1_, h);
        return;
    }
    Gradient push = gradientOf(law.measure, middle_[a], middle_[b]);
    Gradient end = gradientOf(law.measure, q1_[a], q1_[b]);
    Row row{.impulse = state_.lawPushes[index] * h};
    if (law.kind == ConstraintKind::AtLeast) {
        if (law.sign * end.value > kClosed && row.impulse == 0.0) return;
        for (Gradient* gradient : {&push, &end})
            gradient->a = law.sign * gradient->a, gradient->b = law.sign * gradient->b;
        row.kind = RowKind::Push;
    }
    if (law.kind == ConstraintKind::Drive) {
        row.kind = RowKind::Band;
        row.target = law.speed;
        row.most = law.most * h;
    }
    writer_.add(system_, push, end, a, b, row);
}

void GroupStep::writeRows(double h) {
    writer_.beginStep(system_, v0_, h);
    lawOfRow_.clear();
    for (const std::uint32_t law : group_->laws) {
        addLaw(law, h);
        lawOfRow_.resize(system_.rows.size(), law);
    }
    for (Active& active : active_) addContact(active);
}

/// Solves the system of the step.
/// @param scale  magnitude of the velocity changes by forces in the step, m/s
void GroupStep::solve(double scale) {
    double fastest = 0.0;
    for (const Triple& velocity : v0_) fastest = std::max(fastest, largest(velocity));
    system_.tolerance = std::max(1.0e-12 * fastest, 1.0e-10 * scale) + 1.0e-16;
    const RowOutcome outcome = solver_.solve(system_);
    state_.factorings += outcome.factorings;
    state_.sweeps += outcome.sweeps;
    const double relative = outcome.residual / (fastest + scale + outcome.scale + 1.0e-9);
    if (outcome.residual > outcome.tolerance) state_.worstResidual = std::max(state_.worstResidual, relative);
    if (relative > kUnsolved && state_.trouble.empty()) {
        state_.trouble =
            format("the solver of a step did not converge: {} bodies, {} rows, residual {} m/s",
                   group_->pushed, system_.rows.size(), shortestText(static_cast<float>(outcome.residual)));
    }
}

/// Applies the solved velocities. @return the largest difference of the end poses from their prediction
double GroupStep::takeSolution(double h) {
    double change = 0.0;
    for (std::size_t i = 0; i < group_->pushed; ++i) {
        v1_[i] = system_.velocity[i];
        const Triple end = q0_[i] + 0.5 * h * (v0_[i] + v1_[i]);
        change = std::max(change, largest(end - q1_[i]));
        q1_[i] = end;
    }
    for (Active& active : active_) {
        active.normal = system_.rows[active.row].impulse;
        const bool rubs = active.touch.friction > 0.0;
        active.tangent = rubs ? system_.rows[active.row + 1].impulse : 0.0;
    }
    for (std::size_t r = 0; r < lawOfRow_.size(); ++r) {
        if (system_.rows[r].give == 0.0) state_.lawPushes[lawOfRow_[r]] = system_.rows[r].impulse / h;
    }
    return change;
}

/// Reports an error if a spring reaches its force limit, which is not modeled.
void GroupStep::checkSprings(double h) {
    for (std::size_t r = 0; r < lawOfRow_.size() && state_.trouble.empty(); ++r) {
        const Row& row = system_.rows[r];
        if (row.give == 0.0) continue;
        const bool hasTwin = r > 0 && lawOfRow_[r - 1] == lawOfRow_[r];
        const double force = hasTwin ? std::hypot(row.impulse, system_.rows[r - 1].impulse) : row.impulse;
        const Law& law = scene_.laws[lawOfRow_[r]];
        if (std::fabs(force) <= law.most * h * (1.0 + 1.0e-9)) continue;
        state_.trouble =
            format("the spring of joint {} reaches its maximum force, which is not supported", law.joint);
    }
}

void GroupStep::tryStep(double h, bool takeAll) {
    const std::size_t count = group_->bodies.size();
    q1_.resize(count);
    v1_.resize(count);
    middle_.resize(count);
    double scale = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Triple acceleration = i < group_->pushed ? state_.accelerations[group_->bodies[i]] : Triple{};
        v1_[i] = v0_[i] + h * acceleration;
        q1_[i] = q0_[i] + 0.5 * h * (v0_[i] + v1_[i]);
        if (i < group_->pushed) scale = std::max(scale, h * length(writer_.bodyAt(i).acceleration));
    }
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        for (std::size_t i = 0; i < count; ++i) middle_[i] = 0.5 * (q0_[i] + q1_[i]);
        collect(takeAll);
        writeRows(h);
        solve(scale);
        if (takeSolution(h) < kSettled || system_.rows.empty()) break;
    }
}

/// Accepts the step, and stores its forces unless it is very short.
void GroupStep::keep(double h, double duration, bool isHit, std::vector<Press>& found) {
    checkSprings(h);
    correctPositions(20, kEndless);
    const bool isLong = h > 0.01 * duration;
    for (std::size_t i = 0; i < group_->pushed; ++i) {
        const Body& body = writer_.bodyAt(i);
        Triple& acceleration = state_.accelerations[group_->bodies[i]];
        if (isLong) acceleration = (1.0 / h) * (v1_[i] - v0_[i]);
        if (isHit) acceleration = {body.acceleration.x, body.acceleration.y, 0.0};
    }
    q0_ = q1_;
    v0_ = v1_;
    if (!isLong) return;
    found.clear();
    for (const Active& active : active_) {
        if (active.normal > 0.0) found.push_back({active.touch, active.normal / h, active.tangent / h});
    }
    for (const std::uint32_t law : group_->laws) state_.lawForces[law] = {};
    for (std::size_t r = 0; r < lawOfRow_.size(); ++r) {
        const Row& row = system_.rows[r];
        Triple& force = state_.lawForces[lawOfRow_[r]];
        force = force + (row.b != kNoRow ? row.impulse / h : -row.impulse / h) *
                            (row.b != kNoRow ? row.pushB : row.pushA);
    }
}

/// True if a contact closed in this step that was not active in it.
bool GroupStep::hasClosed() const {
    findAt(q0_, scratch_);
    return std::any_of(scratch_.begin(), scratch_.end(), [&](const Touch& touch) {
        if (view(touch, q0_).gap > kClosed || approachOf(touch) > -kClosed) return false;
        return std::none_of(active_.begin(), active_.end(),
                            [&](const Active& active) { return active.touch.key == touch.key; });
    });
}

void GroupStep::begin(const Group& group) {
    load(group);
    q1_ = q0_;
    correctPositions(200, 1.0e-6);
    q0_ = q1_;
    strike();
    store();
}

void GroupStep::advance(const Group& group, double duration, std::span<const Press> warm,
                        std::vector<Press>& found) {
    load(group);
    std::vector<Press> presses;
    findAt(q0_, scratch_);
    for (const Touch& touch : scratch_) {
        if (const Press* const press = findPress(warm, touch.key)) presses.push_back(*press);
    }
    double left = duration;
    for (int hits = 0; left > 0.0 && state_.trouble.empty();) {
        const bool takeAll = hits >= kMaxHits;
        double h = left;
        const auto start = [&] {
            active_.clear();
            for (const Press& press : presses)
                active_.push_back({press.touch, false, press.normal * h, press.tangent * h});
        };
        start();
        tryStep(h, takeAll);
        bool isHit = false;
        for (int i = 0; i < kMaxTries && !takeAll; ++i) {
            const double time = earliestClosing(h);
            if (!(time < h)) break;
            h = std::max(time, 1.0e-9 * duration);
            isHit = true;
            start();
            tryStep(h, false);
            if (time <= 1.0e-9 * duration) break;
        }
        keep(h, duration, isHit || takeAll, presses);
        left = isHit ? left - h : 0.0;
        if (isHit || hasClosed()) {
            strike();
            ++hits;
            ++state_.events;
        }
    }
    ++state_.steps;
    found.insert(found.end(), presses.begin(), presses.end());
    store();
}

}  // namespace plumb::reference
