#pragma once

#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "physics/simulation.hpp"

namespace plumb::stability {

/// A random world without initial overlaps and without motors: moving bodies of all shapes in a pit, some
/// with a hinge to a neighbour. Its kinetic plus potential energy must not grow.
class FairScene {
public:
    explicit FairScene(std::uint64_t seed);

    void run();                                            ///< simulates
    [[nodiscard]] bool isSound() const { return sound_; }  ///< all numbers are finite
    /// Maximum energy relative to the initial energy, minus 1.
    [[nodiscard]] double energyGain() const { return mostEnergy_ / startEnergy_ - 1.0; }
    [[nodiscard]] bool hasJoints() const { return world_.joints.size() > 0; }
    [[nodiscard]] const physics::World& world() const { return world_; }

private:
    void addPit();
    void addBody(Vec2 middle);
    void addShape(physics::BodyId body);
    void addHinge();
    [[nodiscard]] double energy() const;
    [[nodiscard]] double between(double low, double high);  ///< uniform random number
    [[nodiscard]] float decades(double low, double high);   ///< log-uniform random number
    bool oneIn(std::uint32_t times) { return random_.below(times) == 0; }

    physics::World world_;
    Random random_;
    std::vector<physics::BodyId> bodies_;
    double gravity_ = 0.0;  ///< downward acceleration, m/s2
    float step_ = 0.0f;     ///< time step, s
    double startEnergy_ = 0.0;
    double mostEnergy_ = 0.0;
    bool sound_ = true;
};

}  // namespace plumb::stability
