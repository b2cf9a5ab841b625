#pragma once

#include <functional>
#include <vector>

#include "tests/accuracy/stability/score.hpp"
#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::stability {

using scenes::BodyHandle;
using scenes::Material;
using scenes::Outline;

inline constexpr double kGravity = 10.0;  ///< m/s2, down

/// Parameters of a simulation.
struct Terms {
    double quality = 2.0;       ///< 0..5; below 0 automatic, from 2 on
    double step = 1.0 / 60.0;   ///< s
    double gravity = kGravity;  ///< m/s2, down
    double origin = 0.0;        ///< m: offset of the scene to the right
};

/// Reference values for the figures of a scene.
struct Yardstick {
    double size = 1.0;        ///< m: thickness of the smallest body, or the length of a link
    double extent = 1.0;      ///< m: of the scene along gravity
    double mostSpeed = 0.0;   ///< m/s that the scene explains besides falls; 0: not checked
    bool driven = false;      ///< by a motor or a kinematic body: energy may grow
    bool rests = true;        ///< it should stay in its initial position, at rest
    bool overlapped = false;  ///< energy is measured from the time when all bodies are separated
};

/// The world of one cell of a map. Positions are relative to the origin of the terms, y is up.
class Lab {
public:
    Lab(const Terms& terms, const Yardstick& yardstick);

    BodyHandle floor(const Material& material = {}, double half = 200.0);  ///< its top at y = 0
    BodyHandle add(const Outline& outline, Vec2 centre, const Material& material = {}, double angle = 0.0);
    BodyHandle addFixed(const Outline& outline, Vec2 centre, const Material& material = {},
                        double angle = 0.0);
    BodyHandle addKinematic(const Outline& outline, Vec2 centre);
    void hinge(BodyHandle a, BodyHandle b, Vec2 anchorA, Vec2 anchorB);
    /// B rotates about a point of A that is its own origin, driven by a motor against a limit.
    void drivenHinge(BodyHandle a, BodyHandle b, Vec2 anchorB, double limit, double speed, double torque);
    void setMass(BodyHandle body, double kilograms);
    void setVelocity(BodyHandle body, Vec2 velocity, double spin = 0.0);
    /// Reference height of the potential energy: the lowest reachable position.
    void countHeightFrom(double y) { lowest_ = y; }

    /// Simulates; `look` is called after each step with the time (s) since the start.
    void run(double seconds, const std::function<void(double)>& look = {});
    void setOff(double ratio) { off_ = ratio; }  ///< deviation from the exact result, if it is not at rest
    [[nodiscard]] Figures figures() const;

    [[nodiscard]] double x(BodyHandle body) const;
    [[nodiscard]] double y(BodyHandle body) const { return scene_.poseOf(body).y; }
    [[nodiscard]] double angle(BodyHandle body) const;  ///< rad, -pi..pi
    [[nodiscard]] Vec2 velocity(BodyHandle body);
    [[nodiscard]] physics::World& world() { return scene_.world(); }
    [[nodiscard]] physics::BodyId idOf(BodyHandle body) const { return scene_.idOf(body); }

private:
    /// A body that should stay in its initial position.
    struct Stayer {
        BodyHandle body;
        Vec2 start;
    };
    BodyHandle create(scenes::Motion motion, const Outline& outline, Vec2 centre, const Material& material,
                      double angle);
    void look(bool isLate);
    [[nodiscard]] double energy();
    [[nodiscard]] double moved() const;

    Terms terms_;
    Yardstick yardstick_;
    scenes::PlumbWorld scene_;
    std::vector<Stayer> stayers_;
    double lowest_ = 0.0;
    double off_ = 0.0;
    double time_ = 0.0;
    double startEnergy_ = -1.0;  ///< J; below 0 before it is measured
    double mostEnergy_ = 0.0;
    double mostSpeed_ = 0.0;
    double residual_ = 0.0;
    bool sound_ = true;
};

}  // namespace plumb::stability
