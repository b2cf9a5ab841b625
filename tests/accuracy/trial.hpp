#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::accuracy {

using scenes::BodyHandle;
using scenes::Material;

inline constexpr double kGravity = 10.0;      ///< m/s2, down
inline constexpr float kTick = 1.0f / 60.0f;  ///< s
inline constexpr double kNoTarget = std::numeric_limits<double>::infinity();

/// One figure of an experiment, and its goal.
struct Finding {
    std::string name;  ///< of the figure, if an experiment has several
    double error = 0.0;
    std::string unit;
    double target = 0.0;  ///< maximum error; infinite if there is none
};

/// How a scene is simulated.
struct Method {
    /// kQualityOfWorld: the default, increased automatically for hard islands
    physics::Quality quality = 2;
    int iterations = 1;
    bool jointTrees = true;  ///< joints that form trees are solved by the direct solver
    physics::IntegratorKind integrator = physics::IntegratorKind::SemiImplicitEuler;
    const scenes::Engine* peer = nullptr;  ///< another engine, with its own defaults

    friend bool operator==(const Method&, const Method&) = default;
};

/// Measured in every experiment. Energy, momentum and contact forces
/// are figures of those experiments that have goals for them.
struct Metrics {
    double maxPenetration = 0.0;   ///< m, at the end
    double meanPenetration = 0.0;  ///< m, at the end, of the pairs that overlap
    double jointSeparation = 0.0;  ///< m, at the end, the largest
    std::optional<double>
        restTime;  ///< s after which nothing moved faster than kRest; none if it never rested
    double microsPerStep = 0.0;
    std::optional<double> allocationsPerStep;  ///< of the second half; none if allocations are not counted

    static constexpr double kRest = 0.05;  ///< m/s
};

/// A world for an experiment with one method, and its results.
class Trial {
public:
    using CountAllocations = std::size_t (*)();

    /// @param count returns the program's number of allocations; may be null
    explicit Trial(const Method& method, Vec2 gravity = {0.0f, -static_cast<float>(kGravity)},
                   CountAllocations count = nullptr);
    explicit Trial(physics::Quality quality, Vec2 gravity = {0.0f, -static_cast<float>(kGravity)})
        : Trial{Method{.quality = quality}, gravity} {}

    [[nodiscard]] scenes::SceneBuilder& scene() { return *scene_; }
    [[nodiscard]] const scenes::SceneBuilder& scene() const { return *scene_; }
    [[nodiscard]] const Method& method() const { return method_; }
    /// @pre it is not another engine
    [[nodiscard]] physics::World& world();
    [[nodiscard]] physics::BodyId id(BodyHandle body) const;  ///< @pre as world()

    BodyHandle floor(const Material& material = {});  ///< 200 m wide, its top at y = 0
    BodyHandle add(const scenes::Outline& outline, Vec2 centre, const Material& material = {},
                   float angle = 0.0f);
    BodyHandle addFixed(const scenes::Outline& outline, Vec2 centre, const Material& material = {},
                        float angle = 0.0f);
    BodyHandle pin(Vec2 place);  ///< static, collides with nothing
    void setMass(BodyHandle body, float kilograms) { scene_->setMass(body, kilograms); }
    void setVelocity(BodyHandle body, Vec2 velocity) { scene_->setVelocity(body, velocity); }

    /// Called before each step with the time (s) at which it starts.
    void drive(std::function<void(double)> push) { push_ = std::move(push); }
    /// Simulates; `look` is called after each step with the time (s) since the start of the trial.
    void run(double seconds, const std::function<void(double)>& look = {});
    void report(std::string name, double error, std::string unit, double target);

    [[nodiscard]] double x(BodyHandle body) const { return scene_->poseOf(body).x; }
    [[nodiscard]] double y(BodyHandle body) const { return scene_->poseOf(body).y; }
    [[nodiscard]] double angle(BodyHandle body) const;  ///< rad, -pi..pi
    [[nodiscard]] Vec2 velocity(BodyHandle body) const { return scene_->velocityOf(body); }
    [[nodiscard]] double spin(BodyHandle body) const {
        return static_cast<double>(scene_->spinOf(body));  ///< rad/s
    }
    [[nodiscard]] double fastest() const;  ///< m/s: of all bodies that move
    /// N: contact force between two bodies; nothing if the engine does not report it.
    [[nodiscard]] std::optional<double> pushBetween(BodyHandle a, BodyHandle b);
    [[nodiscard]] double time() const { return time_; }
    /// The mean without the slowest of 50 steps: those include other work of the machine.
    [[nodiscard]] double microsPerStep() const;
    [[nodiscard]] Metrics metrics() const;
    [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
    /// The world as built, before its first step; empty for other engines.
    [[nodiscard]] const std::optional<physics::World>& start() const { return start_; }

private:
    Method method_;
    std::unique_ptr<scenes::SceneBuilder> scene_;
    scenes::PlumbWorld* plumb_ = nullptr;  ///< the same, unless it is another engine's
    CountAllocations count_ = nullptr;
    std::function<void(double)> push_;
    std::optional<physics::World> start_;
    std::vector<Finding> findings_;
    double time_ = 0.0;
    double moved_ = 0.0;  ///< s: when a body last moved
    int steps_ = 0;
    bool lost_ = false;          ///< another engine's world fell apart: simulation stops
    std::size_t allocated_ = 0;  ///< in the second half of the last run
    int countedSteps_ = 0;
    std::vector<double> spent_;  ///< s of the clock, of each step
};

}  // namespace plumb::accuracy
