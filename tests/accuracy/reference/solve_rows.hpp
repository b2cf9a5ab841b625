#pragma once

#include <vector>

#include "tests/accuracy/reference/algebra.hpp"
#include "tests/accuracy/reference/block_matrix.hpp"

namespace plumb::reference {

inline constexpr std::uint32_t kNoRow = 0xffffffffu;

/// Bounds on the impulse of a Row.
enum class RowKind : std::uint8_t {
    Both,      ///< unbounded
    Push,      ///< at least 0
    Band,      ///< absolute value at most `most`
    Friction,  ///< absolute value at most `friction` times the impulse of row `normal`
};

/// A scalar constraint of a system: an impulse, and the velocity that it controls. It demands speed . v +
/// give * impulse = target. At the impulse's lower bound the left side may be larger than the target, at its
/// upper bound smaller. `push` and `speed` differ: directions of the middle and of the end of a step.
struct Row {
    std::uint32_t a = kNoRow, b = kNoRow;  ///< indices of bodies in the system; kNoRow: not dynamic
    Triple pushA, pushB;                   ///< change of the momentum of A and of B per impulse
    Triple speedA, speedB;  ///< weights of the velocities of A and of B in the controlled velocity
    double target = 0.0;    ///< target velocity, m/s or rad/s
    double give = 0.0;      ///< compliance of a spring, velocity per impulse, m/s per N s
    RowKind kind = RowKind::Both;
    std::uint32_t normal = kNoRow;  ///< for Friction: index of the contact's normal row
    double friction = 0.0;          ///< for Friction: coefficient
    double most = kEndless;         ///< for Band: bound, N s
    double impulse = 0.0;           ///< initial guess, then the result, N s
};

/// A system of bodies and rows: mass * v = momentum + impulses of the rows.
struct RowSystem {
    std::vector<Triple> mass;      ///< mass of each body; 1 in locked directions, where pushes are 0
    std::vector<Triple> momentum;  ///< momentum of each body, N s
    std::vector<Row> rows;         ///< normal rows precede their friction rows
    std::vector<Triple> velocity;  ///< result, one per body
    double tolerance = 1.0e-13;    ///< required absolute accuracy of rows, besides a relative one, m/s
};

/// Accuracy and work of a solution.
struct RowOutcome {
    double residual = 0.0;   ///< largest residual of a row, m/s
    double tolerance = 0.0;  ///< required accuracy, m/s
    double scale = 0.0;      ///< largest target velocity of a row, m/s
    int factorings = 0;      ///< number of matrix factorizations
    int sweeps = 0;          ///< number of Gauss-Seidel sweeps
};

/// Solves systems to convergence with a semi-smooth Newton method on the augmented Lagrangian, which
/// tolerates redundant rows: it guesses which rows are active, stick or slide, solves these as equations, and
/// repeats until the guess is consistent. If the guesses cycle, projected Gauss-Seidel sweeps find better
/// ones. Sources: P. Alart, A. Curnier, A mixed formulation for frictional contact problems prone to Newton
/// like solution methods, CMAME 92, 1991; M. Jean, The non-smooth contact dynamics method, CMAME 177, 1999.
class RowSolver {
public:
    RowOutcome solve(RowSystem& system);

private:
    enum class Guess : std::uint8_t { Free, Holds, Least, Most };  // no impulse, target met, at bounds

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
    std::vector<double> resistance_;  // velocity per impulse of each row, m/s per N s
    std::vector<double> trials_;      // impulse of each row before it is clamped to its bounds, N s
    std::vector<Guess> guesses_;
    std::vector<Guess> factored_;  // guesses for which the matrix is factored
    double factoredStiffness_ = 0.0;
    int factorings_ = 0;
    std::vector<double> right_;
    std::vector<Triple> momentum_;
    double stiffness_ = 1.0, tolerance_ = 0.0;
};

}  // namespace plumb::reference
