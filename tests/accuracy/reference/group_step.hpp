#pragma once

#include <span>
#include <vector>

#include "tests/accuracy/reference/row_writer.hpp"

namespace plumb::reference {

/// Advances the bodies of a group by one step, which is divided at impacts. A step uses the trapezoidal rule:
/// velocities at its end satisfy joints and contacts, with the impulse directions of its middle; positions
/// advance by the mean of old and new velocities; remaining position errors are corrected. The rule is of
/// second order and symmetric in time, so energy does not drift. A step with an impact ends at the impact,
/// which is solved as a separate system. Sources: E. Hairer, C. Lubich, G. Wanner, Geometric Numerical
/// Integration, 2006, V.4 and VII.1; M. Jean, The non-smooth contact dynamics method, CMAME 177, 1999; V.
/// Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008, 8 and 10.
class GroupStep {
public:
    GroupStep(const Scene& scene, RunState& state) : scene_{scene}, state_{state}, writer_{scene} {}

    /// Removes overlaps and makes velocities consistent with
    /// joints and contacts. Call it before the first step.
    void begin(const Group& group);
    /// @param warm contact forces of the last step, used as first guess
    /// @param found out: contact forces of this step are appended
    void advance(const Group& group, double duration, std::span<const Press> warm, std::vector<Press>& found);

private:
    struct Active {  // a contact that may exert an impulse in the current step
        Touch touch;
        bool isNew = false;          // closed in this step, after kMaxHits impacts: does not end the step
        double normal = 0.0;         // normal impulse, N s
        double tangent = 0.0;        // friction impulse on B, N s
        std::uint32_t row = kNoRow;  // index of the row of the normal impulse in system_
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

    // Attempts a step of `h` seconds, which keep() accepts: group_step.cpp.
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

    // Find the time of the first impact in a step, at which a gap closes: closings.cpp.
    [[nodiscard]] double earliestClosing(double h);
    [[nodiscard]] double closingOfPair(std::uint32_t a, std::uint32_t b, double h);
    [[nodiscard]] double closingOfTouches(std::uint32_t a, std::uint32_t b, double h);
    [[nodiscard]] double gapAt(std::uint32_t a, std::uint32_t b, double time, double h) const;
    [[nodiscard]] Triple poseAt(std::size_t local, double time, double h) const;
    [[nodiscard]] double longestWay(std::uint32_t a, std::uint32_t b, double h) const;

    // Solve impacts: impacts.cpp.
    void strike();
    bool bounceOnce(std::span<const Touch> touches);
    void solveImpact(std::span<const Touch> touches, bool bounces);
    [[nodiscard]] double approachOf(const Touch& touch) const;

    // Correct position errors: correct_positions.cpp.
    void correctPositions(int mostRounds, double hopeless);
    double correctPositionsOnce();

    const Scene& scene_;
    RunState& state_;
    RowWriter writer_;
    RowSolver solver_, shifter_;
    RowSystem system_, shift_;  // systems of velocities and of position corrections
    const Group* group_ = nullptr;
    std::vector<Triple> q0_, v0_, q1_, v1_, middle_;  // poses q, velocities v at start (0) and end (1)
    std::vector<Active> active_;
    std::vector<std::uint32_t> lawOfRow_;  // index of the law of each row of system_ (laws come first)
    mutable std::vector<Touch> scratch_;
};

}  // namespace plumb::reference
