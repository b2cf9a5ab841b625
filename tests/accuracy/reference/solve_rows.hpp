#pragma once

#include <vector>

#include "tests/accuracy/reference/algebra.hpp"
#include "tests/accuracy/reference/block_matrix.hpp"

namespace plumb::reference {

inline constexpr std::uint32_t kNoRow = 0xffffffffu;

/// Bounds of the impulse of a row.
enum class RowKind : std::uint8_t {
    Both,      ///< unbounded
    Push,      ///< not negative
    Band,      ///< at most `most` in either direction
    Friction,  ///< at most `friction` times the impulse of row `normal`, in either direction
};

/// One impulse and the velocity that it controls: speed . v + give * impulse = target unless
/// it is at a bound; at the lower bound the velocity is at least the target, and so on.
/// The directions of the impulse and of the velocity differ: the former is that of the
/// middle of a step, the latter of its end.
struct Row {
    std::uint32_t a = kNoRow, b = kNoRow;  ///< bodies of the system, or kNoRow for static and kinematic ones
    Triple pushA, pushB;
    Triple speedA, speedB;
    double target = 0.0;  ///< m/s or rad/s
    double give = 0.0;    ///< of a spring: m/s for each N s
    RowKind kind = RowKind::Both;
    std::uint32_t normal = kNoRow;
    double friction = 0.0;
    double most = kEndless;  ///< N s
    double impulse = 0.0;    ///< N s: initial guess, then the result
};

/// Bodies and rows: mass * v = momentum + the impulses of the rows.
struct RowSystem {
    std::vector<Triple> mass;      ///< of each body; in directions that are locked: 1, and rows have 0 there
    std::vector<Triple> momentum;  ///< N s
    std::vector<Row> rows;         ///< normals before their friction
    std::vector<Triple> velocity;  ///< the result
    double tolerance = 1.0e-13;    ///< m/s: required accuracy of each row, in addition to its relative
                                   ///< accuracy
};

/// The result of a system.
struct RowOutcome {
    double residual = 0.0;   ///< m/s: residual of the worst row
    double tolerance = 0.0;  ///< m/s: required accuracy
    double scale = 0.0;      ///< m/s: the largest target velocity of a row
    int factorings = 0;
    int sweeps = 0;
};

/// Solves systems to convergence: guesses which rows push, stick and slide, solves
/// these as equations with multipliers, and repeats until the guess is consistent (a
/// semi-smooth Newton method on the augmented Lagrangian, which tolerates redundant
/// rows). If the guesses cycle, sweeps of projected Gauss-Seidel find better ones.
/// Sources: P. Alart, A. Curnier, A mixed formulation for frictional contact problems prone to Newton like
/// solution methods, CMAME 92, 1991; M. Jean, The non-smooth contact dynamics method, CMAME 177, 1999.
class RowSolver {
public:
    RowOutcome solve(RowSystem& system);

private:
    enum class Guess : std::uint8_t { Free, Holds, Least, Most };

    void prepare(RowOutcome& outcome);
    void velocitiesFromImpulses();
    [[nodiscard]] double speedOf(const Row& row) const;
    [[nodiscard]] double boundOf(const Row& row) const;
    [[nodiscard]] double worst() const;
    void sweep();
    [[nodiscard]] double trialOf(std::size_t row) const;
    [[nodiscard]] bool takeGuesses(bool isFirst);
    bool factorGuess();
    void solveGuess();
    [[nodiscard]] double weightOf(std::size_t row) const;
    [[nodiscard]] double startOf(std::size_t row) const;
    void addToMatrix(const Row& row, Triple pushA, Triple pushB, double weight);
    void takeImpulses();
    bool newton(RowOutcome& outcome);
    void solveOrGiveUp(RowOutcome& outcome);

    RowSystem* system_ = nullptr;
    BlockMatrix matrix_;
    std::vector<BlockMatrix::Edge> edges_;
    std::vector<double> resistance_;  // by row: m/s for each N s
    std::vector<double> trials_;      // by row: N s
    std::vector<Guess> guesses_;
    std::vector<Guess> factored_;  // the guesses that the matrix is of
    double factoredStiffness_ = 0.0;
    int factorings_ = 0;
    std::vector<double> right_;
    std::vector<Triple> momentum_;
    double stiffness_ = 1.0, tolerance_ = 0.0;
};

}  // namespace plumb::reference
