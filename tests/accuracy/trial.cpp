#include "tests/accuracy/trial.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace plumb::accuracy {

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Trial::Trial(physics::Quality quality, Vec2 gravity) : scene_{{.gravity = gravity, .sleeping = false}} {
    world().settings.automaticQuality = quality == physics::kQualityOfWorld;
    if (quality != physics::kQualityOfWorld) world().settings.quality = quality;
}

BodyHandle Trial::floor(const Material& material) {
    return addFixed(scenes::box({100.0f, 1.0f}), {0.0f, -1.0f}, material);
}

BodyHandle Trial::add(const scenes::Outline& outline, Vec2 centre, const Material& material, float angle) {
    const BodyHandle body = scene_.createBody({.position = centre});
    scene_.addShape(body, outline, material);
    if (angle != 0.0f)
        static_cast<void>(physics::setPosition(world(), scene_.idOf(body), physics::Place{centre}, angle));
    return body;
}

BodyHandle Trial::addFixed(const scenes::Outline& outline, Vec2 centre, const Material& material,
                           float angle) {
    const BodyHandle body = scene_.createBody({.motion = scenes::Motion::Static, .position = centre});
    scene_.addShape(body, outline, material);
    if (angle != 0.0f)
        static_cast<void>(physics::setPosition(world(), scene_.idOf(body), physics::Place{centre}, angle));
    return body;
}

void Trial::setMass(BodyHandle body, float kilograms) {
    static_cast<void>(physics::setMass(world(), scene_.idOf(body), kilograms));
}

void Trial::setVelocity(BodyHandle body, Vec2 velocity) {
    static_cast<void>(physics::setVelocity(world(), scene_.idOf(body), velocity));
}

void Trial::run(double seconds, const std::function<void(double)>& look) {
    const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(kTick)));
    for (int i = 0; i < steps; ++i) {
        const double start = now();
        scene_.step(kTick);
        spent_ += now() - start;
        time_ = ++steps_ / 60.0;
        if (look) look(time_);
    }
}

void Trial::report(std::string name, double error, std::string unit, double target) {
    const double known = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
    findings_.push_back({std::move(name), known, std::move(unit), target});
}

double Trial::angle(BodyHandle body) const {
    const scenes::Pose pose = scene_.poseOf(body);
    return std::atan2(pose.sin, pose.cos);
}

Vec2 Trial::velocity(BodyHandle body) { return physics::velocityOf(world(), scene_.idOf(body)); }

double Trial::fastest() {
    float best = 0.0f;
    for (const physics::BodyMotion& motion : world().bodies.motion)
        best = std::max(best, length(motion.velocity));
    return static_cast<double>(best);
}

double Trial::microsPerStep() const { return steps_ > 0 ? spent_ * 1.0e6 / steps_ : 0.0; }

}  // namespace plumb::accuracy
