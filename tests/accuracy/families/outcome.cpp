#include "tests/accuracy/families/outcome.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/clock.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "physics/measure/measures.hpp"
#include "tests/bench/physics/scene_error.hpp"

namespace plumb::families {

namespace {

constexpr int kStepsBetweenLooks = 30;  // steps between measurements of overlaps, which are slow

/// Kinetic energy of all bodies, J.
double kineticEnergyOf(const physics::World& world) {
    double sum = 0.0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const physics::BodyMass& mass = world.bodies.mass[i];
        const physics::BodyMotion& motion = world.bodies.motion[i];
        const auto speed = static_cast<double>(length(motion.velocity));
        const auto spin = static_cast<double>(motion.angularVelocity);
        if (mass.inverseMass > 0.0f) sum += 0.5 * static_cast<double>(mass.mass) * speed * speed;
        if (mass.inverseInertia > 0.0f) sum += 0.5 / static_cast<double>(mass.inverseInertia) * spin * spin;
    }
    return sum;
}

/// Records kinetic plus potential energy and its growth. Soft contacts and joints store energy and release it
/// later, and pushing shapes out of an overlap of one slop lifts the bodies above. So growth is measured from
/// the lowest level that was not exceeded for 2 s. (The slowest oscillation observed takes 1.5 s: that of a
/// 24 m arch that sinks when it is built.)
class EnergyBook {
public:
    /// @param layers  see Blueprint::layers
    explicit EnergyBook(int layers) : layers_{layers} {}

    void note(const physics::World& world) {
        const double now = physics::energyOf(world);
        if (steps_ == 0) {
            level_ = low_ = high_ = now;
            for (const physics::BodyMass& mass : world.bodies.mass) lift_ += static_cast<double>(mass.mass);
            lift_ *= layers_ * static_cast<double>(length(world.settings.gravity) * world.settings.slop);
        }
        gain_ = std::max(gain_, now - level_);
        recent_[steps_++ % recent_.size()] = now;
        const auto last = recent_.begin() + static_cast<std::ptrdiff_t>(std::min(steps_, recent_.size()));
        level_ = std::min(level_, *std::max_element(recent_.begin(), last));
        low_ = std::min(low_, now);
        high_ = std::max(high_, now);
        // Bodies at constant speed convert no energy; the gain is then related to the kinetic energy.
        motion_ = std::max(motion_, kineticEnergyOf(world));
    }
    /// Energy gain relative to the energy that was converted:
    /// the larger of energy range and maximum kinetic energy.
    [[nodiscard]] double gain() const {
        const double turned = std::max(high_ - low_, motion_);
        return turned > 0.0 ? std::max(gain_ - lift_, 0.0) / turned : 0.0;
    }

private:
    int layers_ = 1;
    std::array<double, 120> recent_{};  ///< total energy in the steps of the last 2 s, J
    std::size_t steps_ = 0;
    double level_ = 0.0;
    double low_ = 0.0;
    double high_ = 0.0;
    double gain_ = 0.0;
    double lift_ = 0.0;    ///< allowed gain, by pushing overlapping contacts apart, J
    double motion_ = 0.0;  ///< maximum kinetic energy, J
};

/// Maximum ratio of the total to the normal velocity change in an impact: sqrt(2), for friction up to 1.
constexpr double kMaxByFriction = 1.4142135623730951;

/// Measures how much further bodies move in a step than their speed explains. That speed is the maximum of
/// the speeds before and after the step, and of the speed before plus all velocity changes by impacts within
/// the step: a body hit by a bullet can cross a room within a step and be slow again at its end.
class JumpMeter {
public:
    void before(const Stage& stage) {
        moments_.clear();
        for (std::uint32_t body = 0; body < stage.size(); ++body) {
            Moment& moment = moments_.emplace_back();
            if (!stage.has(body)) continue;
            moment.there = true;
            moment.position = stage.positionOf(body);
            moment.speed = static_cast<double>(length(stage.velocityOf(body)));
        }
    }
    void after(const Stage& stage) {
        for (std::uint32_t body = 0; body < std::min(stage.size(), moments_.size()); ++body) {
            const Moment& moment = moments_[body];
            if (!moment.there || !stage.has(body) || stage.wasTeleported(body)) continue;
            const scenes::Point now = stage.positionOf(body);
            const double moved = std::hypot(now.x - moment.position.x, now.y - moment.position.y);
            const auto after = static_cast<double>(length(stage.velocityOf(body)));
            const auto excess = [&](double speed) { return moved - speed * static_cast<double>(kStep); };
            if (excess(std::max(moment.speed, after)) <= largest_) continue;
            const double within = moment.speed + kMaxByFriction * stage.hitSpeedOf(body);
            largest_ = std::max(largest_, excess(std::max(within, after)));
        }
    }
    [[nodiscard]] double largest() const { return largest_; }

private:
    struct Moment {
        bool there = false;
        scenes::Point position;
        double speed = 0.0;
    };
    std::vector<Moment> moments_;
    double largest_ = 0.0;
};

std::uint64_t bitsOf(const physics::World& world) {
    Hasher hash;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const physics::BodyPose& pose = world.bodies.pose[i];
        const physics::BodyMotion& motion = world.bodies.motion[i];
        hash.add(std::bit_cast<std::uint64_t>(pose.centre.x));
        hash.add(std::bit_cast<std::uint64_t>(pose.centre.y));
        for (const float value : {pose.rotation.cos, pose.rotation.sin, motion.velocity.x, motion.velocity.y,
                                  motion.angularVelocity})
            hash.add(std::uint64_t{std::bit_cast<std::uint32_t>(value)});
    }
    for (const physics::SoftBody& soft : world.softBodies.all) {
        for (const physics::SoftParticle& particle : soft.particles) {
            hash.add(std::bit_cast<std::uint64_t>(particle.place.x));
            hash.add(std::bit_cast<std::uint64_t>(particle.place.y));
        }
    }
    return hash.value();
}

void lookAtErrors(const Stage& stage, Outcome& outcome) {
    const auto scale = static_cast<double>(stage.variation().placement.scale);
    const scenes::SceneError error = scenes::errorOf(stage.scene());
    outcome.sound = outcome.sound && error.finite;
    outcome.maxOverlap = std::max(outcome.maxOverlap, error.maxPenetration / scale);
    outcome.maxJointError = std::max(outcome.maxJointError, error.maxJointError / scale);
}

void lookAtEnd(const Stage& stage, Outcome& outcome) {
    lookAtErrors(stage, outcome);
    for (std::uint32_t body = 0; body < stage.size(); ++body) {
        if (!stage.has(body)) {
            outcome.ends.emplace_back();
            continue;
        }
        outcome.ends.push_back(stage.positionOf(body));
        outcome.restSpeed = std::max(outcome.restSpeed, static_cast<double>(length(stage.velocityOf(body))));
    }
    for (const Goal& goal : stage.plan().goals) {
        const double error = outcome.sound ? goal.error(stage) : INFINITY;
        if (error <= goal.bound) continue;
        if (outcome.reached) outcome.missed = format("{}: {} of {}", goal.name, error, goal.bound);
        outcome.reached = false;
    }
    if (const physics::World* world = stage.world()) {
        outcome.bits = bitsOf(*world);
        for (const std::uint32_t body : world->awake)
            outcome.awake += world->bodies.info[body].kind == physics::BodyKind::Dynamic ? 1 : 0;
    }
}

}  // namespace

Outcome play(const Blueprint& plan, const Variation& variation) {
    Outcome outcome;
    if (plan.extra && variation.peer != nullptr) {
        outcome.missing = plan.extraNeeds;
        return outcome;
    }
    Stage stage{plan, variation};
    outcome.missing = stage.scene().missing();
    if (!outcome.missing.empty()) return outcome;
    const int steps = static_cast<int>(std::lround(plan.seconds / static_cast<double>(kStep)));
    EnergyBook energy{plan.layers};
    JumpMeter jumps;
    double spent = 0.0;
    for (int i = 0; i < steps && outcome.sound; ++i) {
        if (stage.world() != nullptr) jumps.before(stage);
        const double start = wallSeconds();
        stage.step();
        spent += wallSeconds() - start;
        outcome.contacts = std::max(outcome.contacts, stage.scene().contactCount());
        if (const physics::World* world = stage.world()) {
            jumps.after(stage);
            if (plan.closed) energy.note(*world);
            outcome.sound = outcome.sound && world->quarantined.empty();
        }
        if (i % kStepsBetweenLooks == kStepsBetweenLooks - 1) lookAtErrors(stage, outcome);
    }
    outcome.maxJump = jumps.largest();
    outcome.energyGain = energy.gain();
    outcome.microsPerStep = 1e6 * spent / std::max(steps, 1);
    lookAtEnd(stage, outcome);
    return outcome;
}

double largestDistance(const Outcome& a, const Outcome& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.ends.size(), b.ends.size()); ++i)
        largest = std::max(largest, std::hypot(a.ends[i].x - b.ends[i].x, a.ends[i].y - b.ends[i].y));
    return largest;
}

}  // namespace plumb::families
