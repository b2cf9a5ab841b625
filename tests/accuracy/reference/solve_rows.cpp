#include "tests/accuracy/reference/solve_rows.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::reference {

namespace {

constexpr double kFirstStiffness = 1.0e5;  // times 1 / resistance_ of a row; a round divides errors by this
constexpr double kMaxStiffness = 1.0e8;    // with larger ones, rounding errors dominate
constexpr int kMaxGuesses = 25;            // maximum number of guesses before sweeps are used
constexpr int kMaxRounds = 40;
constexpr int kMaxAttempts = 10;
constexpr int kFirstSweeps = 50;  // number of sweeps in the first attempt; each further attempt doubles it

Triple inverse(Triple mass) { return {1.0 / mass.x, 1.0 / mass.y, 1.0 / mass.turn}; }

void addOuter(BlockMatrix::Block& block, double weight, Triple push, Triple speed) {
    const double rows[3] = {weight * push.x, weight * push.y, weight * push.turn};
    for (std::size_t i = 0; i < 3; ++i) {
        block[3 * i] += rows[i] * speed.x;
        block[3 * i + 1] += rows[i] * speed.y;
        block[3 * i + 2] += rows[i] * speed.turn;
    }
}

}  // namespace

double RowSolver::speedOf(const Row& row) const {
    double speed = 0.0;
    if (row.a != kNoRow) speed += dot(row.speedA, system_->velocity[row.a]);
    if (row.b != kNoRow) speed += dot(row.speedB, system_->velocity[row.b]);
    return speed;
}

double RowSolver::boundOf(const Row& row) const {
    if (row.kind == RowKind::Friction) return row.friction * system_->rows[row.normal].impulse;
    return row.kind == RowKind::Band ? row.most : kEndless;
}

void RowSolver::prepare(RowOutcome& outcome) {
    RowSystem& system = *system_;
    resistance_.clear();
    edges_.clear();
    for (Row& row : system.rows) {
        double resistance = 0.0;
        if (row.a != kNoRow) resistance += dot(row.speedA, scaled(inverse(system.mass[row.a]), row.pushA));
        if (row.b != kNoRow) resistance += dot(row.speedB, scaled(inverse(system.mass[row.b]), row.pushB));
        // A row without movable bodies has no effect; it gets infinite resistance and is skipped.
        if (!(resistance > 0.0)) resistance = kEndless, row.impulse = 0.0;
        resistance_.push_back(resistance);
        // A rigid row can change the velocity by its whole target, a spring only by a part of it.
        if (resistance < kEndless)
            outcome.scale =
                std::max(outcome.scale, std::fabs(row.target) * resistance / (resistance + row.give));
        if (row.a != kNoRow && row.b != kNoRow) edges_.push_back(std::minmax(row.a, row.b));
        if (row.kind == RowKind::Push) row.impulse = std::max(row.impulse, 0.0);
        const double bound = boundOf(row);
        row.impulse = std::clamp(row.impulse, -bound, bound);
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    outcome.tolerance = tolerance_ = std::max(system.tolerance, 1.0e-12 * outcome.scale);
}

void RowSolver::velocitiesFromImpulses() {
    RowSystem& system = *system_;
    system.velocity = system.momentum;
    for (const Row& row : system.rows) {
        if (row.a != kNoRow) system.velocity[row.a] = system.velocity[row.a] + row.impulse * row.pushA;
        if (row.b != kNoRow) system.velocity[row.b] = system.velocity[row.b] + row.impulse * row.pushB;
    }
    for (std::size_t i = 0; i < system.mass.size(); ++i)
        system.velocity[i] = scaled(inverse(system.mass[i]), system.velocity[i]);
}

/// Largest residual of a row with the current impulses and velocities, m/s.
double RowSolver::worst() const {
    double most = 0.0;
    for (std::size_t i = 0; i < system_->rows.size(); ++i) {
        const Row& row = system_->rows[i];
        if (resistance_[i] == kEndless) continue;
        const double miss = speedOf(row) + row.give * row.impulse - row.target;
        const double bound = boundOf(row);
        // The residual is the change of the row's impulse in a projected Gauss-Seidel step, as a velocity.
        const double least = row.kind == RowKind::Push ? 0.0 : -bound;
        const double wanted = std::clamp(row.impulse - miss / (resistance_[i] + row.give), least, bound);
        most = std::max(most, std::fabs(wanted - row.impulse) * resistance_[i]);
    }
    return most;
}

void RowSolver::sweep() {
    RowSystem& system = *system_;
    for (std::size_t i = 0; i < system.rows.size(); ++i) {
        Row& row = system.rows[i];
        if (resistance_[i] == kEndless) continue;
        const double bound = boundOf(row);
        const double miss = speedOf(row) + row.give * row.impulse - row.target;
        const double least = row.kind == RowKind::Push ? 0.0 : -bound;
        const double impulse = std::clamp(row.impulse - miss / (resistance_[i] + row.give), least, bound);
        const double more = impulse - row.impulse;
        row.impulse = impulse;
        if (more == 0.0) continue;
        if (row.a != kNoRow)
            system.velocity[row.a] =
                system.velocity[row.a] + more * scaled(inverse(system.mass[row.a]), row.pushA);
        if (row.b != kNoRow)
            system.velocity[row.b] =
                system.velocity[row.b] + more * scaled(inverse(system.mass[row.b]), row.pushB);
    }
}

/// Returns the impulse that a row would have without its bounds, N s.
double RowSolver::trialOf(std::size_t i) const {
    const Row& row = system_->rows[i];
    const double miss = speedOf(row) - row.target;
    if (row.give > 0.0) return -miss / row.give;
    return row.impulse - stiffness_ / resistance_[i] * miss;
}

/// Updates the guesses. @return true if they did not change, except for rows with negligible impulses
bool RowSolver::takeGuesses(bool isFirst) {
    const std::vector<Row>& rows = system_->rows;
    double largest = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (resistance_[i] < kEndless) trials_[i] = trialOf(i);
        largest = std::max(largest, std::fabs(rows[i].impulse));
    }
    const double negligible = 1.0e-11 * largest;
    bool same = !isFirst;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        Guess guess = Guess::Free;
        double margin = kEndless;  // change of the impulse after which the guess would be another one, N s
        if (resistance_[i] < kEndless) {
            double bound = row.most;
            if (row.kind == RowKind::Friction)
                bound = guesses_[row.normal] == Guess::Free
                            ? 0.0
                            : row.friction * std::max(trials_[row.normal], 0.0);
            if (row.kind == RowKind::Both) guess = Guess::Holds;
            if (row.kind == RowKind::Push) {
                guess = trials_[i] > 0.0 ? Guess::Holds : Guess::Free;
                margin = std::fabs(trials_[i]);
            }
            if (row.kind == RowKind::Band || row.kind == RowKind::Friction) {
                guess = std::fabs(trials_[i]) <= bound ? Guess::Holds
                                                       : (trials_[i] > 0.0 ? Guess::Most : Guess::Least);
                margin = std::fabs(std::fabs(trials_[i]) - bound);
                if (bound == 0.0) guess = Guess::Free, margin = kEndless;
            }
        }
        if (guess != guesses_[i] && !(margin < negligible)) same = false;
        guesses_[i] = guess;
    }
    return same;
}

void RowSolver::addToMatrix(const Row& row, Triple pushA, Triple pushB, double weight) {
    if (row.a != kNoRow) {
        addOuter(matrix_.at(row.a, row.a), weight, pushA, row.speedA);
        if (row.b != kNoRow) addOuter(matrix_.at(row.a, row.b), weight, pushA, row.speedB);
    }
    if (row.b != kNoRow) {
        addOuter(matrix_.at(row.b, row.b), weight, pushB, row.speedB);
        if (row.a != kNoRow) addOuter(matrix_.at(row.b, row.a), weight, pushB, row.speedA);
    }
}

/// Returns the weight in impulse = start - weight * speed of a row with Guess::Holds, N s per m/s.
double RowSolver::weightOf(std::size_t i) const {
    const Row& row = system_->rows[i];
    return row.give > 0.0 ? 1.0 / row.give : stiffness_ / resistance_[i];
}
double RowSolver::startOf(std::size_t i) const {
    const Row& row = system_->rows[i];
    return (row.give > 0.0 ? 0.0 : row.impulse) + weightOf(i) * row.target;
}

/// Factors the matrix of all holding and sliding rows, unless it is already factored for these guesses.
bool RowSolver::factorGuess() {
    if (guesses_ == factored_ && stiffness_ == factoredStiffness_) return true;
    const RowSystem& system = *system_;
    matrix_.clear();
    factored_.clear();
    for (std::uint32_t i = 0; i < system.mass.size(); ++i) {
        BlockMatrix::Block& block = matrix_.at(i, i);
        block[0] += system.mass[i].x, block[4] += system.mass[i].y, block[8] += system.mass[i].turn;
    }
    for (std::size_t i = 0; i < system.rows.size(); ++i) {
        const Row& row = system.rows[i];
        if (guesses_[i] == Guess::Holds) addToMatrix(row, row.pushA, row.pushB, weightOf(i));
        if (row.kind != RowKind::Friction || (guesses_[i] != Guess::Most && guesses_[i] != Guess::Least))
            continue;
        const double part = guesses_[i] == Guess::Most ? row.friction : -row.friction;
        addToMatrix(system.rows[row.normal], part * row.pushA, part * row.pushB, weightOf(row.normal));
    }
    if (!matrix_.factor()) return false;
    ++factorings_;
    factored_ = guesses_;
    factoredStiffness_ = stiffness_;
    return true;
}

/// Solves for the velocities at which each row has the impulse that
/// belongs to its guess and velocity. @pre factorGuess() returned true
void RowSolver::solveGuess() {
    RowSystem& system = *system_;
    momentum_ = system.momentum;
    for (std::size_t i = 0; i < system.rows.size(); ++i) {
        const Row& row = system.rows[i];
        if (guesses_[i] == Guess::Free) continue;
        const double side = guesses_[i] == Guess::Most ? 1.0 : -1.0;
        double impulse = side * row.most;
        if (guesses_[i] == Guess::Holds)
            impulse = startOf(i);
        else if (row.kind == RowKind::Friction)
            impulse = side * row.friction * startOf(row.normal);
        if (row.a != kNoRow) momentum_[row.a] = momentum_[row.a] + impulse * row.pushA;
        if (row.b != kNoRow) momentum_[row.b] = momentum_[row.b] + impulse * row.pushB;
    }
    right_.resize(3 * momentum_.size());
    for (std::size_t i = 0; i < momentum_.size(); ++i)
        right_[3 * i] = momentum_[i].x, right_[3 * i + 1] = momentum_[i].y,
                   right_[3 * i + 2] = momentum_[i].turn;
    matrix_.solve(right_);
    for (std::size_t i = 0; i < momentum_.size(); ++i)
        system.velocity[i] = {right_[3 * i], right_[3 * i + 1], right_[3 * i + 2]};
}

void RowSolver::takeImpulses() {
    for (std::size_t i = 0; i < system_->rows.size(); ++i)
        trials_[i] = resistance_[i] < kEndless ? trialOf(i) : 0.0;
    for (std::size_t i = 0; i < system_->rows.size(); ++i) {
        Row& row = system_->rows[i];
        const double least = row.kind == RowKind::Push ? 0.0 : -boundOf(row);
        row.impulse = std::clamp(trials_[i], least, boundOf(row));
    }
}

/// Runs Newton rounds. @return true if the tolerance was reached
bool RowSolver::newton(RowOutcome& outcome) {
    stiffness_ = kFirstStiffness;
    double before = kEndless;
    guesses_.assign(system_->rows.size(), Guess::Free);
    for (int round = 0; round < kMaxRounds; ++round) {
        bool same = takeGuesses(true);
        for (int i = 0; !same && i < kMaxGuesses; ++i) {
            if (!factorGuess()) return false;
            solveGuess();
            same = takeGuesses(false);
        }
        if (!same) return false;
        takeImpulses();
        outcome.residual = worst();
        if (outcome.residual <= tolerance_) return true;
        if (outcome.residual > 0.1 * before) {
            if (stiffness_ >= kMaxStiffness && outcome.residual > 0.5 * before) return false;
            stiffness_ = std::min(10.0 * stiffness_, kMaxStiffness);
        }
        before = outcome.residual;
    }
    return false;
}

RowOutcome RowSolver::solve(RowSystem& system) {
    system_ = &system;
    RowOutcome outcome;
    factorings_ = 0;
    solveOrGiveUp(outcome);
    outcome.factorings = factorings_;
    return outcome;
}

void RowSolver::solveOrGiveUp(RowOutcome& outcome) {
    RowSystem& system = *system_;
    prepare(outcome);
    velocitiesFromImpulses();
    if (system.rows.empty()) return;
    outcome.residual = worst();
    if (outcome.residual <= tolerance_) return;
    factored_.clear();
    matrix_.shape(static_cast<std::uint32_t>(system.mass.size()), edges_);
    trials_.assign(system.rows.size(), 0.0);
    std::vector<double> best;
    double bestResidual = kEndless;
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        if (newton(outcome)) return;
        velocitiesFromImpulses();
        for (int i = 0; i < kFirstSweeps << attempt; ++i, ++outcome.sweeps) sweep();
        velocitiesFromImpulses();
        outcome.residual = worst();
        if (outcome.residual <= tolerance_) return;
        if (outcome.residual < bestResidual) {
            bestResidual = outcome.residual;
            best.clear();
            for (const Row& row : system.rows) best.push_back(row.impulse);
        }
    }
    for (std::size_t i = 0; i < best.size(); ++i) system.rows[i].impulse = best[i];
    velocitiesFromImpulses();
    outcome.residual = bestResidual;
}

}  // namespace plumb::reference
