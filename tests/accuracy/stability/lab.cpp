#include "tests/accuracy/stability/lab.hpp"

#include <algorithm>
#include <cmath>

#include "tests/bench/physics/scene_error.hpp"

namespace plumb::stability {

namespace {

constexpr double kLate = 0.5;  // length of the final time in which the residual speed is measured, s
constexpr double kApart =
    0.01;  // overlap below which bodies count as separated, ratio to ReferenceValues::size
constexpr physics::Quality kUsual = 2;

scenes::WorldSetup setupOf(const Terms& terms) {
    const int quality = terms.quality < 0.0 ? kUsual : static_cast<int>(terms.quality);
    return {.gravity = {0.0f, -static_cast<float>(terms.gravity)}, .sleeping = false, .quality = quality};
}

}  // namespace

Lab::Lab(const Terms& terms, const ReferenceValues& yardstick)
    : terms_{terms}, yardstick_{yardstick}, scene_{setupOf(terms)} {
    world().settings.automaticQuality = terms.quality < 0.0;
}

BodyHandle Lab::create(scenes::Motion motion, const Outline& outline, Vec2 centre, const Material& material,
                       double angle) {
    const BodyHandle body = scene_.createBody({.motion = motion});
    const physics::WorldPosition place{static_cast<double>(centre.x) + terms_.origin,
                                       static_cast<double>(centre.y)};
    const auto put = physics::setPosition(world(), scene_.idOf(body), place, static_cast<float>(angle));
    scene_.addShape(body, outline, material);
    sound_ = sound_ && put.ok() && scene_.missing().empty();
    return body;
}

BodyHandle Lab::floor(const Material& material, double half) {
    const auto wide = static_cast<float>(half);
    const float deep = 1.0f;
    return create(scenes::Motion::Static, scenes::box({wide, deep}), {0.0f, -deep}, material, 0.0);
}

BodyHandle Lab::add(const Outline& outline, Vec2 centre, const Material& material, double angle) {
    const BodyHandle body = create(scenes::Motion::Dynamic, outline, centre, material, angle);
    stayers_.push_back({body, centre});
    return body;
}

BodyHandle Lab::addFixed(const Outline& outline, Vec2 centre, const Material& material, double angle) {
    return create(scenes::Motion::Static, outline, centre, material, angle);
}

BodyHandle Lab::addKinematic(const Outline& outline, Vec2 centre) {
    return create(scenes::Motion::Kinematic, outline, centre, {}, 0.0);
}

void Lab::hinge(BodyHandle a, BodyHandle b, Vec2 anchorA, Vec2 anchorB) {
    scene_.addJoint({.a = a, .b = b, .anchorA = anchorA, .anchorB = anchorB});
    sound_ = sound_ && scene_.missing().empty();
}

void Lab::drivenHinge(BodyHandle a, BodyHandle b, Vec2 anchorB, double limit, double speed, double torque) {
    scene_.addJoint({.a = a,
                     .b = b,
                     .anchorB = anchorB,
                     .limited = true,
                     .lower = -static_cast<float>(limit),
                     .upper = static_cast<float>(limit),
                     .driven = true,
                     .speed = static_cast<float>(speed),
                     .maxForce = static_cast<float>(torque)});
    sound_ = sound_ && scene_.missing().empty();
}

void Lab::setMass(BodyHandle body, double kilograms) {
    sound_ = physics::setMass(world(), scene_.idOf(body), static_cast<float>(kilograms)).ok() && sound_;
}

void Lab::setVelocity(BodyHandle body, Vec2 velocity, double spin) {
    const physics::BodyId id = scene_.idOf(body);
    sound_ = physics::setVelocity(world(), id, velocity).ok() &&
             physics::setAngularVelocity(world(), id, static_cast<float>(spin)).ok() && sound_;
}

double Lab::energy() {
    double sum = 0.0;
    const physics::Bodies& bodies = world().bodies;
    for (const TrackedBody& stayer : stayers_) {
        const std::uint32_t i = scene_.idOf(stayer.body).index;
        const physics::BodyMotion& motion = bodies.motion[i];
        const physics::BodyMass& mass = bodies.mass[i];
        const auto vx = static_cast<double>(motion.velocity.x), vy = static_cast<double>(motion.velocity.y);
        const auto spin = static_cast<double>(motion.angularVelocity);
        const double height = bodies.pose[i].centre.y - lowest_;
        sum += static_cast<double>(mass.mass) * (0.5 * (vx * vx + vy * vy) + terms_.gravity * height) +
               0.5 * static_cast<double>(mass.inertia) * spin * spin;
    }
    return sum;
}

void Lab::look(bool isLate) {
    sound_ = sound_ && world().quarantined.empty();
    for (const TrackedBody& stayer : stayers_) {
        const std::uint32_t i = scene_.idOf(stayer.body).index;
        const physics::BodyMotion& motion = world().bodies.motion[i];
        const double speed =
            std::hypot(static_cast<double>(motion.velocity.x), static_cast<double>(motion.velocity.y));
        const double turning = std::fabs(static_cast<double>(motion.angularVelocity)) *
                               static_cast<double>(world().bodies.info[i].reach);
        sound_ = sound_ && std::isfinite(speed) && std::isfinite(turning);
        // Speed that the body would have at its initial height, so that falling adds nothing.
        const double risen = world().bodies.pose[i].centre.y - static_cast<double>(stayer.start.y);
        const double unexplained = speed * speed + 2.0 * terms_.gravity * risen;
        mostSpeed_ = std::max(mostSpeed_, std::sqrt(std::max(unexplained, 0.0)));
        if (isLate) residual_ = std::max(residual_, speed + turning);
    }
    if (startEnergy_ < 0.0) {
        if (scenes::errorOf(scene_).maxPenetration > kApart * yardstick_.size) return;
        startEnergy_ = energy();
    }
    mostEnergy_ = std::max(mostEnergy_, energy());
}

void Lab::run(double seconds, const std::function<void(double)>& watch) {
    const auto steps = static_cast<int>(std::lround(seconds / terms_.step));
    const auto late = static_cast<int>(std::lround((seconds - kLate) / terms_.step));
    residual_ = 0.0;
    if (startEnergy_ < 0.0 && !yardstick_.overlapped) startEnergy_ = mostEnergy_ = energy();
    for (int i = 0; i < steps && sound_; ++i) {
        scene_.step(static_cast<float>(terms_.step));
        time_ += terms_.step;
        look(i >= late);
        if (watch) watch(time_);
    }
}

double Lab::moved() const {
    double most = 0.0;
    for (const TrackedBody& stayer : stayers_) {
        const double aside = std::fabs(x(stayer.body) - static_cast<double>(stayer.start.x));
        const double sunk = std::fabs(y(stayer.body) - static_cast<double>(stayer.start.y));
        most = std::max({most, aside / yardstick_.size, sunk / yardstick_.extent});
    }
    return most;
}

Figures Lab::figures() const {
    const scenes::SceneError error = scenes::errorOf(scene_);
    Figures figures;
    figures.finite = sound_ && error.finite;
    if (!figures.finite) return figures;
    figures.penetration = error.maxPenetration / yardstick_.size;
    figures.joints = error.maxJointError / yardstick_.size;
    figures.off = yardstick_.rests ? std::max(off_, moved()) : off_;
    const double fall = std::sqrt(terms_.gravity * yardstick_.size);
    if (yardstick_.rests || yardstick_.overlapped)
        figures.residual = fall > 0.0 ? residual_ / fall : residual_;
    if (!yardstick_.driven && startEnergy_ > 0.0) figures.energyGain = mostEnergy_ / startEnergy_ - 1.0;
    if (yardstick_.mostSpeed > 0.0) figures.speeding = mostSpeed_ / yardstick_.mostSpeed;
    return figures;
}

double Lab::x(BodyHandle body) const { return scene_.poseOf(body).x - terms_.origin; }

double Lab::angle(BodyHandle body) const {
    const scenes::Pose pose = scene_.poseOf(body);
    return std::atan2(pose.sin, pose.cos);
}

Vec2 Lab::velocity(BodyHandle body) { return physics::velocityOf(world(), scene_.idOf(body)); }

}  // namespace plumb::stability
