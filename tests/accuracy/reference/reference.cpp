#include "tests/accuracy/reference/reference.hpp"

#include <algorithm>
#include <cmath>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "physics/model/bodies.hpp"
#include "tests/accuracy/reference/run.hpp"

namespace plumb::reference {

namespace {

std::string text(double value) { return shortestText(static_cast<float>(value)); }

/// Largest differences of a body between two runs, or estimates of the largest errors.
struct BoxStatistics {
    double place = 0.0;     // m
    double angle = 0.0;     // rad
    double velocity = 0.0;  // m/s
};

BoxStatistics statisticsOf(const Scene& scene, const RunState& one, const RunState& two) {
    BoxStatistics spread;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].isPushed) continue;
        const Triple pose = one.poses[i] - two.poses[i], velocity = one.velocities[i] - two.velocities[i];
        spread.place = std::max(spread.place, length(placeOf(pose)));
        spread.angle = std::max(spread.angle, std::fabs(pose.turn));
        spread.velocity = std::max(spread.velocity, length(placeOf(velocity)));
    }
    return spread;
}

/// Estimates the rounding errors of a run. Solved velocities are accurate to 1e-16 times the ratio of a row's
/// stiffness to that of the bodies (kFirstStiffness in solve_rows.cpp); positions are corrected to 1e-12 m.
BoxStatistics roundingOf(const Scene& scene, const RunState& state, double seconds) {
    constexpr double kSpeeds = 2.0e-11;  // relative rounding error of velocities
    const double ratio =
        4.0 * std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(state.steps) + 1.0);
    double furthest = 0.0, turned = 0.0, fastest = 0.0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].isPushed) continue;
        furthest = std::max({furthest, std::fabs(state.poses[i].x), std::fabs(state.poses[i].y)});
        turned = std::max(turned, std::fabs(state.poses[i].turn));
        fastest = std::max(fastest, largest(state.velocities[i]));
    }
    const double speed = state.factorings > 0 ? kSpeeds * fastest : ratio * fastest;
    return {2.0e-12 + ratio * furthest + speed * seconds, 2.0e-12 + ratio * turned + speed * seconds,
            2.0e-12 + speed};
}

/// Estimates the error of the finer of two runs from their difference and the order of convergence, by
/// Richardson extrapolation; doubles the result, as the observed order is inexact.
double leftOf(double difference, double order) {
    return 2.0 * difference / (std::pow(2.0, std::clamp(order, 0.5, 2.0)) - 1.0);
}

constexpr double kMinOrder = 0.5;  // minimum observed order of convergence at which runs converge

/// Runs of one scene, each with half the time step of the previous one.
class Runs {
public:
    Runs(const Scene& scene, double seconds, const Options& options)
        : scene_{scene}, seconds_{seconds}, options_{options}, step_{2.0 * options.step} {}

    /// Runs the scene with half the previous step. @error the reason if the run fails
    Result<Done> add() {
        step_ *= 0.5;
        const double start = wallSeconds();
        RunState finer = runScene(scene_, seconds_, step_, start + options_.patience - spent_);
        lastTime_ = wallSeconds() - start;
        spent_ += lastTime_;
        if (!finer.trouble.empty()) {
            return Error{"reference", finer.trouble, format("at a step of {} s", text(step_))};
        }
        if (count_++ > 0) spreads_.push_back(statisticsOf(scene_, state_, finer));
        state_ = std::move(finer);
        return Done{};
    }
    [[nodiscard]] bool mayGoOn() const {
        return count_ < options_.mostRuns && spent_ + 2.2 * lastTime_ <= options_.patience;
    }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] const RunState& state() const { return state_; }
    [[nodiscard]] const std::vector<BoxStatistics>& spreads() const { return spreads_; }

    [[nodiscard]] double orderOf(double BoxStatistics::*part) const {
        if (spreads_.size() < 2) return 1.0;
        const double before = spreads_[spreads_.size() - 2].*part, last = spreads_.back().*part;
        return last > 0.0 ? std::log2(before / last) : 2.0;
    }
    /// Estimated error of the last run in one quantity (`part`), m, rad or m/s.
    [[nodiscard]] double errorOf(double BoxStatistics::*part) const {
        const double rounding = roundingOf(scene_, state_, seconds_).*part;
        if (spreads_.empty()) return kEndless;
        return leftOf(spreads_.back().*part, orderOf(part)) + rounding;
    }
    [[nodiscard]] bool isRounding() const {
        const double rounding = 10.0 * roundingOf(scene_, state_, seconds_).place;
        return !spreads_.empty() && spreads_.back().place <= rounding;
    }
    [[nodiscard]] bool comesTogether() const {
        return isRounding() || (orderOf(&BoxStatistics::place) >= kMinOrder);
    }

private:
    const Scene& scene_;
    double seconds_;
    const Options& options_;
    double step_;
    double lastTime_ = 0.0, spent_ = 0.0;  // wall time of the last run and of all runs, s
    int count_ = 0;
    RunState state_;
    std::vector<BoxStatistics> spreads_;
};

double energyOf(const Scene& scene, const RunState& state) {
    double energy = 0.0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (!body.isPushed) continue;
        energy += 0.5 * dot(scaled(body.mass, state.velocities[i]), state.velocities[i]);
        const Point place{state.poses[i].x + scene.origin.x, state.poses[i].y + scene.origin.y};
        energy -= body.mass.x * dot(body.acceleration, place);
    }
    return energy;
}

ContactAnswer answerOf(const Scene& scene, const RunState& state, const Press& press) {
    const Touch& touch = press.touch;
    const TouchView view = viewOf(touch, state.poses[touch.bodyA], state.poses[touch.bodyB]);
    return {scene.bodies[touch.bodyA].id,
            scene.bodies[touch.bodyB].id,
            scene.outlines[touch.outlineA].shape,
            scene.outlines[touch.outlineB].shape,
            {view.point.x + scene.origin.x, view.point.y + scene.origin.y},
            view.normal.x,
            view.normal.y,
            press.normal,
            press.tangent};
}

void addJoints(const Scene& scene, const RunState& state, Answer& answer) {
    for (std::size_t i = 0; i < scene.laws.size(); ++i) {
        const std::uint32_t joint = scene.laws[i].joint;
        if (answer.joints.empty() || answer.joints.back().joint != joint) answer.joints.push_back({joint});
        JointAnswer& sum = answer.joints.back();
        sum.forceX += state.lawForces[i].x;
        sum.forceY += state.lawForces[i].y;
        if (scene.laws[i].measure.kind == MeasureKind::Angle) sum.torque += state.lawForces[i].turn;
    }
}

Answer answerOf(const Scene& scene, const Runs& runs, double seconds) {
    Answer answer;
    answer.seconds = seconds;
    const RunState& state = runs.state();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].isPushed) continue;
        const Triple pose = state.poses[i], velocity = state.velocities[i];
        answer.bodies.push_back({scene.bodies[i].id,
                                 {pose.x + scene.origin.x, pose.y + scene.origin.y},
                                 pose.turn,
                                 velocity.x,
                                 velocity.y,
                                 velocity.turn});
    }
    for (const Press& press : state.presses) answer.contacts.push_back(answerOf(scene, state, press));
    addJoints(scene, state, answer);
    answer.energy = energyOf(scene, state);
    answer.error = runs.errorOf(&BoxStatistics::place);
    answer.angleError = runs.errorOf(&BoxStatistics::angle);
    answer.velocityError = runs.errorOf(&BoxStatistics::velocity);
    answer.order = runs.isRounding() ? 0.0 : runs.orderOf(&BoxStatistics::place);
    answer.step = runs.step();
    answer.runs = runs.count();
    for (const BoxStatistics& spread : runs.spreads()) answer.differences.push_back(spread.place);
    answer.residual = state.worstResidual;
    answer.steps = state.steps;
    answer.hits = state.events;
    answer.factorings = state.factorings;
    answer.sweeps = state.sweeps;
    return answer;
}

Error notTogether(const Runs& runs) {
    std::string list;
    for (const BoxStatistics& spread : runs.spreads())
        list += (list.empty() ? "" : ", ") + text(spread.place);
    return {
        "reference",
        format("the runs do not converge: steps halved down to {} s differ by {} m", text(runs.step()), list),
        "the scene is probably chaotic: use a shorter time, or increase Options::patience"};
}

}  // namespace

Result<Answer> solveReference(const physics::World& world, double seconds, const Options& options) {
    if (!(seconds > 0.0) || !(seconds <= 1.0e6) || !(options.step > 0.0)) {
        return Error{"reference", "time and step must be positive numbers of seconds", "set both above 0"};
    }
    auto scene = makeScene(world);
    if (!scene) return scene.error();
    Runs runs{*scene, seconds, options};
    const int least = std::max(options.leastRuns, 2);
    while (runs.count() < least ||
           (runs.errorOf(&BoxStatistics::place) > options.wantedError && runs.mayGoOn())) {
        if (const auto added = runs.add(); !added) return added.error();
    }
    const bool isGood = runs.errorOf(&BoxStatistics::place) <= options.wantedError;
    if (!isGood && !runs.comesTogether()) return notTogether(runs);
    return answerOf(*scene, runs, seconds);
}

Difference compare(const physics::World& world, const Answer& answer) {
    Difference difference;
    for (const BodyAnswer& body : answer.bodies) {
        if (!physics::alive(world, body.body)) continue;
        const physics::BodyPose& pose = world.bodies.pose[body.body.index];
        const physics::BodyMotion& motion = world.bodies.motion[body.body.index];
        const double off = std::hypot(pose.centre.x - body.centre.x, pose.centre.y - body.centre.y);
        const double angle =
            std::atan2(static_cast<double>(pose.rotation.sin), static_cast<double>(pose.rotation.cos));
        if (off >= difference.position) difference.position = off, difference.body = body.body;
        difference.angle = std::max(
            difference.angle, std::fabs(std::remainder(angle - body.angle, 2.0 * 3.14159265358979323846)));
        difference.velocity = std::max(difference.velocity,
                                       std::hypot(static_cast<double>(motion.velocity.x) - body.velocityX,
                                                  static_cast<double>(motion.velocity.y) - body.velocityY));
    }
    return difference;
}

}  // namespace plumb::reference
