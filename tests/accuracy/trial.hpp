#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::accuracy {

using scenes::BodyHandle;
using scenes::Material;

inline constexpr double kGravity = 10.0;                                      ///< downward acceleration, m/s2
inline constexpr float kTick = 1.0f / 60.0f;                                  ///< time step, s
inline constexpr double kNoTarget = std::numeric_limits<double>::infinity();  ///< no goal for an error

/// A measured error of an experiment, and its goal.
struct Finding {
    std::string name;  ///< name of the measured quantity; empty if the experiment measures only one
    double error = 0.0;
    std::string unit;     ///< unit of `error` and `target`
    double target = 0.0;  ///< maximum error; infinite: no goal
};

/// Solver settings, or the engine, used to simulate a scene.
struct Method {
    /// quality; kQualityOfWorld: the default quality, increased automatically for hard islands
    physics::Quality quality = 2;
    int iterations = 1;      ///< solver iterations per substep
    bool jointTrees = true;  ///< true: the direct solver handles joints that form trees
    physics::IntegratorKind integrator = physics::IntegratorKind::SemiImplicitEuler;
    const scenes::Engine* peer = nullptr;  ///< another engine with its default settings; null: Plumb

    friend bool operator==(const Method&, const Method&) = default;
};

/// Values measured in every experiment. Energy, momentum and contact
/// forces are measured by single experiments only, as a Finding.
struct Metrics {
    double maxPenetration = 0.0;     ///< deepest penetration at the end, m
    double meanPenetration = 0.0;    ///< mean penetration of overlapping pairs at the end, m
    double jointSeparation = 0.0;    ///< largest joint error at the end, m
    std::optional<double> restTime;  ///< end of the last motion faster than kRest, s; none: not at rest
    double microsPerStep = 0.0;      ///< mean time of a step, µs
    std::optional<double> allocationsPerStep;  ///< memory allocations in the second half; none: not counted

    static constexpr double kRest = 0.05;  ///< speed below which a body counts as resting, m/s
};

/// One run of an experiment with one method: the scene, and the results.
class Trial {
public:
    using CountAllocations = std::size_t (*)();

    /// @param count returns the number of memory allocations of the program so far; null: not counted
    explicit Trial(const Method& method, Vec2 gravity = {0.0f, -static_cast<float>(kGravity)},
                   CountAllocations count = nullptr);
    explicit Trial(physics::Quality quality, Vec2 gravity = {0.0f, -static_cast<float>(kGravity)})
        : Trial{Method{.quality = quality}, gravity} {}

    [[nodiscard]] scenes::SceneBuilder& scene() { return *scene_; }
    [[nodiscard]] const scenes::SceneBuilder& scene() const { return *scene_; }
    [[nodiscard]] const Method& method() const { return method_; }
    /// The world of Plumb. @pre the method uses no other engine
    [[nodiscard]] physics::World& world();
    [[nodiscard]] physics::BodyId id(BodyHandle body) const;  ///< @pre the method uses no other engine

    BodyHandle floor(const Material& material = {});  ///< adds a floor 200 m wide, its top at y = 0
    BodyHandle add(const scenes::Outline& outline, Vec2 centre, const Material& material = {},
                   float angle = 0.0f);
    BodyHandle addFixed(const scenes::Outline& outline, Vec2 centre, const Material& material = {},
                        float angle = 0.0f);
    BodyHandle pin(Vec2 place);  ///< adds a static body without collisions, to which joints can be attached
    void setMass(BodyHandle body, float kilograms) { scene_->setMass(body, kilograms); }
    void setVelocity(BodyHandle body, Vec2 velocity) { scene_->setVelocity(body, velocity); }

    /// Sets a function that is called before each step with the start time of the step, s, to apply forces.
    void drive(std::function<void(double)> push) { push_ = std::move(push); }
    /// Sets a function that is called before the first step and after each step.
    void watch(std::function<void(const Trial&)> watcher) { watcher_ = std::move(watcher); }
    /// Simulates; calls `look` after each step with the time since the start of the trial, s.
    void run(double seconds, const std::function<void(double)>& look = {});
    void report(std::string name, double error, std::string unit, double target);  ///< adds a Finding

    [[nodiscard]] double x(BodyHandle body) const { return scene_->poseOf(body).x; }
    [[nodiscard]] double y(BodyHandle body) const { return scene_->poseOf(body).y; }
    [[nodiscard]] double angle(BodyHandle body) const;  ///< angle of a body, rad, -pi..pi
    [[nodiscard]] Vec2 velocity(BodyHandle body) const { return scene_->velocityOf(body); }
    [[nodiscard]] double spin(BodyHandle body) const {
        return static_cast<double>(scene_->spinOf(body));  ///< rad/s
    }
    [[nodiscard]] double fastest() const;  ///< maximum speed of all moving bodies, m/s
    /// Contact force between two bodies, N; nothing if the engine does not report it.
    [[nodiscard]] std::optional<double> pushBetween(BodyHandle a, BodyHandle b);
    [[nodiscard]] double time() const { return time_; }  ///< simulated time, s
    /// Mean time of a step, µs, without the slowest 2 % of
    /// the steps, which include other work of the machine.
    [[nodiscard]] double microsPerStep() const;
    [[nodiscard]] std::span<const double> stepTimes() const { return spent_; }  ///< wall time of each step, s
    [[nodiscard]] Metrics metrics() const;
    [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
    /// Returns the world before its first step; empty for other engines.
    [[nodiscard]] const std::optional<physics::World>& start() const { return start_; }

private:
    Method method_;
    std::unique_ptr<scenes::SceneBuilder> scene_;
    scenes::PlumbWorld* plumb_ = nullptr;  ///< scene_ if it is Plumb's, else null
    CountAllocations count_ = nullptr;
    std::function<void(double)> push_;           ///< set by drive()
    std::function<void(const Trial&)> watcher_;  ///< set by watch()
    std::optional<physics::World> start_;
    std::vector<Finding> findings_;
    double time_ = 0.0;   ///< simulated time, s
    double moved_ = 0.0;  ///< last time at which a body moved faster than Metrics::kRest, s
    int steps_ = 0;
    bool lost_ = false;          ///< true if another engine's world diverged; the simulation then stops
    std::size_t allocated_ = 0;  ///< allocations in the second half of the last run
    int countedSteps_ = 0;
    std::vector<double> spent_;  ///< wall time of each step, s
};

}  // namespace plumb::accuracy
