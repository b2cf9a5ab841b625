#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::accuracy {

using scenes::BodyHandle;
using scenes::Material;

inline constexpr double kGravity = 10.0;      ///< m/s2, down
inline constexpr float kTick = 1.0f / 60.0f;  ///< s

/// One figure of an experiment, beside what it should be.
struct Finding {
    std::string name;  ///< of the figure, where an experiment has several
    double error = 0.0;
    std::string unit;
    double target = 0.0;  ///< the error should be no larger
};

/// A world that an experiment is done in, at one quality, and what came out.
class Trial {
public:
    /// @param quality  kQualityOfWorld: the default, and more where an island is found to need it
    explicit Trial(physics::Quality quality, Vec2 gravity = {0.0f, -static_cast<float>(kGravity)});

    [[nodiscard]] scenes::PlumbWorld& scene() { return scene_; }
    [[nodiscard]] physics::World& world() { return scene_.world(); }

    BodyHandle floor(const Material& material = {});  ///< 200 m wide, its top at y = 0
    BodyHandle add(const scenes::Outline& outline, Vec2 centre, const Material& material = {},
                   float angle = 0.0f);
    BodyHandle addFixed(const scenes::Outline& outline, Vec2 centre, const Material& material = {},
                        float angle = 0.0f);
    void setMass(BodyHandle body, float kilograms);
    void setVelocity(BodyHandle body, Vec2 velocity);

    /// Simulates; `look` is called after each step with the time (s) since the start of the trial.
    void run(double seconds, const std::function<void(double)>& look = {});
    void report(std::string name, double error, std::string unit, double target);

    [[nodiscard]] double x(BodyHandle body) const { return scene_.poseOf(body).x; }
    [[nodiscard]] double y(BodyHandle body) const { return scene_.poseOf(body).y; }
    [[nodiscard]] double angle(BodyHandle body) const;  ///< rad, -pi..pi
    [[nodiscard]] Vec2 velocity(BodyHandle body);
    [[nodiscard]] double fastest();  ///< m/s: of all bodies
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double microsPerStep() const;
    [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }

private:
    scenes::PlumbWorld scene_;
    std::vector<Finding> findings_;
    double time_ = 0.0;
    double spent_ = 0.0;  ///< s of the clock
    int steps_ = 0;
};

}  // namespace plumb::accuracy
