#include "tests/accuracy/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/assert.hpp"
#include "core/clock.hpp"
#include "tests/bench/physics/scene_error.hpp"

namespace plumb::accuracy {

Trial::Trial(const Method& method, Vec2 gravity, CountAllocations count) : method_{method}, count_{count} {
    const scenes::WorldSetup setup{.gravity = gravity, .sleeping = false};
    if (method.peer != nullptr) {
        scene_ = method.peer->open(setup);
        return;
    }
    auto made = std::make_unique<scenes::PlumbWorld>(setup);
    plumb_ = made.get();
    scene_ = std::move(made);
    physics::Settings& settings = world().settings;
    settings.automaticQuality = method.quality == physics::kQualityOfWorld;
    if (!settings.automaticQuality) settings.quality = method.quality;
    settings.iterations = static_cast<std::uint8_t>(method.iterations);
    settings.directJoints = method.jointTrees;
    settings.integrator = method.integrator;
}

physics::World& Trial::world() {
    PLUMB_ASSERT(plumb_ != nullptr, "world() called on a trial of another engine");
    return plumb_->world();
}

physics::BodyId Trial::id(BodyHandle body) const {
    PLUMB_ASSERT(plumb_ != nullptr, "id() called on a trial of another engine");
    return plumb_->idOf(body);
}

BodyHandle Trial::floor(const Material& material) {
    return addFixed(scenes::box({100.0f, 1.0f}), {0.0f, -1.0f}, material);
}

BodyHandle Trial::add(const scenes::Outline& outline, Vec2 centre, const Material& material, float angle) {
    const BodyHandle body = scene_->createBody({.position = centre, .angle = angle});
    scene_->addShape(body, outline, material);
    return body;
}

BodyHandle Trial::addFixed(const scenes::Outline& outline, Vec2 centre, const Material& material,
                           float angle) {
    const BodyHandle body =
        scene_->createBody({.motion = scenes::Motion::Static, .position = centre, .angle = angle});
    scene_->addShape(body, outline, material);
    return body;
}

BodyHandle Trial::pin(Vec2 place) {
    return scene_->createBody({.motion = scenes::Motion::Static, .position = place});
}

void Trial::run(double seconds, const std::function<void(double)>& look) {
    if (steps_ == 0) {
        scene_->finish();
        if (plumb_ != nullptr) start_ = world();
        if (watcher_) watcher_(*this);
    }
    const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(kTick)));
    allocated_ = 0;
    countedSteps_ = 0;
    for (int i = 0; i < steps; ++i) {
        if (push_) push_(time_);
        const std::size_t before = count_ != nullptr ? count_() : 0;
        const double start = wallSeconds();
        scene_->step(kTick);
        spent_.push_back(wallSeconds() - start);
        if (2 * i >= steps && count_ != nullptr) allocated_ += count_() - before, ++countedSteps_;
        time_ = ++steps_ / 60.0;
        // Stops a diverged world, because some engines never finish a step of such a world.
        if (plumb_ == nullptr && steps_ % 8 == 0 && scenes::isLost(*scene_)) lost_ = true;
        if (lost_) return;
        if (!(fastest() < Metrics::kRest)) moved_ = time_;
        if (watcher_) watcher_(*this);
        if (look) look(time_);
    }
}

void Trial::report(std::string name, double error, std::string unit, double target) {
    const double known = std::isfinite(error) && !lost_ ? error : std::numeric_limits<double>::infinity();
    findings_.push_back({std::move(name), known, std::move(unit), target});
}

double Trial::angle(BodyHandle body) const {
    const scenes::Pose pose = scene_->poseOf(body);
    return std::atan2(pose.sin, pose.cos);
}

double Trial::fastest() const {
    float best = 0.0f;
    for (std::uint32_t i = 0; i < scene_->bodies().size(); ++i) {
        if (!scene_->alive({i}) || !scene_->isDynamic({i})) continue;
        const float speed = length(scene_->velocityOf({i}));
        if (!(speed <= best)) best = speed;  // negated comparison: NaN counts as the fastest
    }
    return static_cast<double>(best);
}

std::optional<double> Trial::pushBetween(BodyHandle a, BodyHandle b) {
    // Contacts store the impulse of the last substep. Its duration is unknown
    // with automatic quality, which uses a different number of substeps per island.
    if (plumb_ == nullptr || method_.quality == physics::kQualityOfWorld) return std::nullopt;
    const std::uint32_t first = id(a).index, second = id(b).index;
    double impulse = 0.0;
    for (const physics::Contact& contact : world().contacts) {
        if (std::min(contact.bodyA, contact.bodyB) != std::min(first, second)) continue;
        if (std::max(contact.bodyA, contact.bodyB) != std::max(first, second)) continue;
        impulse += static_cast<double>(std::fabs(contact.impulse0) + std::fabs(contact.impulse1));
    }
    return impulse * 60.0 * static_cast<double>(1 << method_.quality);
}

double Trial::microsPerStep() const {
    if (spent_.empty()) return 0.0;
    std::vector<double> sorted = spent_;
    std::sort(sorted.begin(), sorted.end());
    sorted.resize(sorted.size() - sorted.size() / 50);
    return 1.0e6 * std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
}

Metrics Trial::metrics() const {
    const scenes::SceneError error = scenes::errorOf(*scene_);
    Metrics metrics{.maxPenetration = error.maxPenetration,
                    .meanPenetration = error.meanPenetration,
                    .jointSeparation = error.maxJointError,
                    .microsPerStep = microsPerStep()};
    if (!error.finite) metrics.jointSeparation = std::numeric_limits<double>::infinity();
    if (moved_ < time_) metrics.restTime = moved_;
    if (countedSteps_ > 0) metrics.allocationsPerStep = static_cast<double>(allocated_) / countedSteps_;
    return metrics;
}

}  // namespace plumb::accuracy
