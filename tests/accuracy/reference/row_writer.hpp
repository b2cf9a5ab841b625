#pragma once

#include <vector>

#include "tests/accuracy/reference/group.hpp"
#include "tests/accuracy/reference/solve_rows.hpp"

namespace plumb::reference {

/// Writes the solver rows of contacts and joint laws for the bodies of a group.
class RowWriter {
public:
    explicit RowWriter(const Scene& scene) : scene_{scene}, localOf_(scene.bodies.size(), 0) {}

    void setGroup(const Group& group);                                                      ///< call it first
    [[nodiscard]] std::uint32_t local(std::uint32_t body) const { return localOf_[body]; }  ///< group index
    [[nodiscard]] const Body& bodyAt(std::size_t local) const { return scene_.bodies[group_->bodies[local]]; }
    [[nodiscard]] Triple inverseMassOf(std::uint32_t local) const;

    /// Clears the system and sets its masses and momenta for a step of `h` s, including forces and drag.
    void beginStep(RowSystem& system, const std::vector<Triple>& velocities, double h);
    /// Clears the system and sets its masses and momenta for an impact, which takes no time.
    void beginImpact(RowSystem& system, const std::vector<Triple>& velocities);
    /// Clears the system and sets it up to correct positions: its velocities are then displacements.
    void beginShift(RowSystem& system);

    /// Adds a row (solve_rows.hpp) with impulse directions `push` and velocity directions `speed`. Static and
    /// kinematic bodies have prescribed velocities. @return the index of the row
    std::uint32_t add(RowSystem& system, const Gradient& push, const Gradient& speed, std::uint32_t localA,
                      std::uint32_t localB, Row row) const;
    /// Adds the row of a spring law; if Law::isPoint, both rows of the pair that this law begins.
    /// @param middle guessed poses in the middle of the step
    /// @param start, guess  velocities at the start of the step; guessed velocities at its end
    void addSpring(RowSystem& system, std::uint32_t law, const std::vector<Triple>& middle,
                   const std::vector<Triple>& start, const std::vector<Triple>& guess, double h) const;

private:
    void addSpringRow(RowSystem& system, const Law& law, const Gradient& gradient, double speedAtStart,
                      double speedAtGuess, double h) const;
    [[nodiscard]] double give(const Gradient& one, const Gradient& two, const Law& law) const;
    [[nodiscard]] double rate(const Gradient& gradient, const Law& law,
                              const std::vector<Triple>& velocities) const;

    const Scene& scene_;
    const Group* group_ = nullptr;
    std::vector<std::uint32_t> localOf_;  // index in the group of each body of the scene
    std::vector<Triple> known_;           // prescribed velocities of bodies and locked directions
};

}  // namespace plumb::reference
