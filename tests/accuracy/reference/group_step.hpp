#pragma once

#include <span>
#include <vector>

#include "tests/accuracy/reference/row_writer.hpp"

namespace plumb::reference {

/// Advances the bodies of a group by one step, or by several if there are hits in it.
/// A step is that of the trapezoidal rule: velocities are such that joints and contacts
/// hold at its end, with the impulse directions of its middle; positions follow by the
/// mean of both velocities, and remaining errors of joints and contacts are corrected.
/// It is of second order and symmetric in time, so energy does not drift. A step with a
/// hit ends there, and the impact is a system of its own. Sources: E. Hairer, C.
/// Lubich, G. Wanner, Geometric Numerical Integration, 2006, V.4 and VII.1; M. Jean,
/// The non-smooth contact dynamics method, CMAME 177, 1999; V. Acary, B. Brogliato,
/// Numerical Methods for Nonsmooth Dynamical Systems, 2008, 8 and 10.
class GroupStep {
public:
    GroupStep(const Scene& scene, RunState& state) : scene_{scene}, state_{state}, writer_{scene} {}

    /// Removes overlaps, and makes velocities consistent with joints and contacts. Before the first step.
    void begin(const Group& group);
    /// @param warm contact impulses of the last step
    /// @param found receives those of this step
    void advance(const Group& group, double duration, std::span<const Press> warm, std::vector<Press>& found);

private:
    struct Active {
        Touch touch;
        bool isNew = false;   // hit in this step; there are too many for each to end a step
        double normal = 0.0;  // N s
        double tangent = 0.0;
        std::uint32_t row = kNoRow;
    };

    void load(const Group& group);
    void store();
    [[nodiscard]] std::size_t localOfOutline(std::uint32_t outline) const {
        return writer_.local(scene_.outlines[outline].body);
    }
    void findAt(const std::vector<Triple>& poses, std::vector<Touch>& touches) const;
    [[nodiscard]] TouchView view(const Touch& touch, const std::vector<Triple>& poses) const {
        return viewOf(touch, poses[writer_.local(touch.bodyA)], poses[writer_.local(touch.bodyB)]);
    }

    // One attempt at a step: group_step.cpp.
    void tryStep(double h, bool takeAll);
    void collect(bool takeAll);
    void writeRows(double h);
    void addContact(Active& active);
    void addLaw(std::uint32_t law, double h);
    double takeSolution(double h);
    void checkSprings(double h);
    void solve(double scale);
    [[nodiscard]] bool hasClosed() const;
    void keep(double h, double duration, bool isHit, std::vector<Press>& found);

    // Time of the first hit: closings.cpp.
    [[nodiscard]] double earliestClosing(double h);
    [[nodiscard]] double closingOfPair(std::uint32_t a, std::uint32_t b, double h);
    [[nodiscard]] double closingOfTouches(std::uint32_t a, std::uint32_t b, double h);
    [[nodiscard]] double gapAt(std::uint32_t a, std::uint32_t b, double time, double h) const;
    [[nodiscard]] Triple poseAt(std::size_t local, double time, double h) const;
    [[nodiscard]] double longestWay(std::uint32_t a, std::uint32_t b, double h) const;

    // Impacts: blows.cpp.
    void strike();
    bool bounceOnce(std::span<const Touch> touches);
    void solveBlow(std::span<const Touch> touches, bool bounces);
    [[nodiscard]] double approachOf(const Touch& touch) const;

    // Positions: put_right.cpp.
    void putRight(int mostRounds, double hopeless);
    double putRightOnce();

    const Scene& scene_;
    RunState& state_;
    RowWriter writer_;
    RowSolver solver_, shifter_;
    RowSystem system_, shift_;  // for velocities, for positions
    const Group* group_ = nullptr;
    std::vector<Triple> q0_, v0_, q1_, v1_, middle_;  // by body of the group
    std::vector<Active> active_;
    std::vector<std::uint32_t> lawOfRow_;
    mutable std::vector<Touch> scratch_;
};

}  // namespace plumb::reference
