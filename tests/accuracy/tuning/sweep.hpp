#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/tunable.hpp"

namespace plumb::tuning {

/// In the order of the table; none in a build without PLUMB_TUNABLE.
std::vector<const Constant*> allConstants();

struct SweepOptions {
    int members = 150;  ///< of each family
    int threads = 1;
    bool maps = true;    ///< the quick part of the stability map too
    bool quick = false;  ///< no family is played further than kFirst members
};

/// A family plays as many members first. If every bit of them stays, the others are not played.
inline constexpr int kFirst = 40;

/// What one family or one map does at another value of a constant.
struct Move {
    std::string scene;
    bool isMap = false;
    int members = 0;       ///< of the family, or cells of the map
    int base = 0;          ///< that reach their goals at the value of the table; of a map, that hold
    int reached = 0;       ///< at the other one
    int worse = 0;         ///< only with the value of the table; of a map, cells with a worse score
    int better = 0;        ///< only with the other one
    bool differs = false;  ///< some bit, or figure of a cell

    /// Part of all by which the share that reaches its goals moves.
    [[nodiscard]] double shift() const { return members > 0 ? (reached - base) / (1.0 * members) : 0.0; }
    [[nodiscard]] bool isLarge() const;
    /// Whether as many turn worse and better as chance explains, where motion is chaotic.
    [[nodiscard]] bool isChance() const;
};

/// What scenes do at one other value of one constant.
struct Trial {
    const Constant* constant = nullptr;
    double factor = 0.0;
    std::vector<Move> moves;  ///< of all families, then of all maps

    [[nodiscard]] bool differs() const;
};

/// Plays families and maps at the values of the table, and then at others.
class Sweep {
public:
    explicit Sweep(const SweepOptions& options);
    ~Sweep();
    Sweep(const Sweep&) = delete;
    Sweep& operator=(const Sweep&) = delete;

    [[nodiscard]] Trial trial(const Constant& constant, double factor) const;
    /// Of all outcomes at the values of the table: results of another one say nothing of this one.
    [[nodiscard]] std::uint64_t signature() const;

private:
    struct Base;
    SweepOptions options_;
    Base* base_;
};

}  // namespace plumb::tuning
