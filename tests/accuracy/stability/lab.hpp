#pragma once

#include <functional>
#include <vector>

#include "tests/accuracy/stability/score.hpp"
#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::stability {

using scenes::BodyHandle;
using scenes::Material;
using scenes::Outline;

inline constexpr double kGravity = 10.0;  ///< downward acceleration, m/s2

/// Simulation parameters of a cell of a stability map (maps.hpp).
struct Terms {
    double quality = 2.0;       ///< quality 0..5; below 0: automatic quality of at least 2
    double step = 1.0 / 60.0;   ///< time step, s
    double gravity = kGravity;  ///< downward acceleration, m/s2
    double origin = 0.0;        ///< x offset of the scene, m
};

/// Properties of a scene. The measured Figures are ratios to these values.
struct ReferenceValues {
    double size = 1.0;        ///< thickness of the smallest body, or length of a link, m
    double extent = 1.0;      ///< size of the scene along gravity, m
    double mostSpeed = 0.0;   ///< maximum speed expected in addition to falling, m/s; 0: not checked
    bool driven = false;      ///< true: a motor or kinematic body may add energy
    bool rests = true;        ///< true: all bodies should stay at rest in their initial positions
    bool overlapped = false;  ///< true: bodies overlap at the start; energy is measured after they separated
};

/// The world of one cell of a map. Positions are relative to Terms::origin, y is up.
class Lab {
public:
    Lab(const Terms& terms, const ReferenceValues& yardstick);

    BodyHandle floor(const Material& material = {}, double half = 200.0);  ///< its top is at y = 0
    BodyHandle add(const Outline& outline, Vec2 centre, const Material& material = {}, double angle = 0.0);
    BodyHandle addFixed(const Outline& outline, Vec2 centre, const Material& material = {},
                        double angle = 0.0);
    BodyHandle addKinematic(const Outline& outline, Vec2 centre);
    void hinge(BodyHandle a, BodyHandle b, Vec2 anchorA, Vec2 anchorB);
    /// Adds a hinge at the origin of A and `anchorB` of B, with a motor that drives B against a limit, rad.
    void drivenHinge(BodyHandle a, BodyHandle b, Vec2 anchorB, double limit, double speed, double torque);
    void setMass(BodyHandle body, double kilograms);
    void setVelocity(BodyHandle body, Vec2 velocity, double spin = 0.0);
    /// Sets the zero height of the potential energy, which should be the lowest reachable position.
    void countHeightFrom(double y) { lowest_ = y; }

    /// Simulates; calls `look` after each step with the time since the start, s.
    void run(double seconds, const std::function<void(double)>& look = {});
    void setOff(double ratio) { off_ = ratio; }  ///< sets Figures::off, for scenes not expected to rest
    [[nodiscard]] Figures figures() const;

    [[nodiscard]] double x(BodyHandle body) const;
    [[nodiscard]] double y(BodyHandle body) const { return scene_.poseOf(body).y; }
    [[nodiscard]] double angle(BodyHandle body) const;  ///< angle of a body, rad, -pi..pi
    [[nodiscard]] Vec2 velocity(BodyHandle body);
    [[nodiscard]] physics::World& world() { return scene_.world(); }
    [[nodiscard]] physics::BodyId idOf(BodyHandle body) const { return scene_.idOf(body); }

private:
    /// A dynamic body with its initial position.
    struct TrackedBody {
        BodyHandle body;
        Vec2 start;
    };
    BodyHandle create(scenes::Motion motion, const Outline& outline, Vec2 centre, const Material& material,
                      double angle);
    void look(bool isLate);              ///< measures after a step; isLate: within the last 0.5 s
    [[nodiscard]] double energy();       ///< kinetic plus potential energy, J
    [[nodiscard]] double moved() const;  ///< maximum displacement of a body, ratio

    Terms terms_;
    ReferenceValues yardstick_;
    scenes::PlumbWorld scene_;
    std::vector<TrackedBody> stayers_;  ///< all dynamic bodies
    double lowest_ = 0.0;               ///< zero height of the potential energy, m
    double off_ = 0.0;                  ///< set by setOff()
    double time_ = 0.0;                 ///< simulated time, s
    double startEnergy_ = -1.0;         ///< initial energy, J; below 0: not measured yet
    double mostEnergy_ = 0.0;           ///< maximum energy, J
    double mostSpeed_ = 0.0;            ///< maximum speed not explained by falling, m/s
    double residual_ = 0.0;             ///< maximum speed in the last 0.5 s, m/s
    bool sound_ = true;                 ///< all numbers are finite, no body is quarantined
};

}  // namespace plumb::stability
