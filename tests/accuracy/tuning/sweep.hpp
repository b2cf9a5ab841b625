#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/tunable.hpp"

namespace plumb::tuning {

/// In the order of the table; empty in a build without PLUMB_TUNABLE.
std::vector<const Constant*> allConstants();

struct SweepOptions {
    int members = 150;  ///< of each family
    int threads = 1;
    bool maps = true;    ///< include the quick part of the stability map
    bool quick = false;  ///< no family runs more than kFirst members
};

/// Number of members of each family that run first. If no bit of them changes, the others are skipped.
inline constexpr int kFirst = 40;

/// The effect of another value of a constant on one family or map.
struct Move {
    std::string scene;
    bool isMap = false;
    int members = 0;       ///< of the family, or cells of the map
    int base = 0;          ///< number that reach their goals at the default value; of a map, cells that hold
    int reached = 0;       ///< the same at the other value
    int worse = 0;         ///< members that reach their goals only at the default; of a map, cells with a
                           ///< worse score
    int better = 0;        ///< members that reach them only at the other value
    bool differs = false;  ///< some bit, or value of a cell, differs

    /// Change of the share that reaches its goals.
    [[nodiscard]] double shift() const { return members > 0 ? (reached - base) / (1.0 * members) : 0.0; }
    [[nodiscard]] bool isLarge() const;
    /// True if as many get worse and better as chance explains, where motion is chaotic.
    [[nodiscard]] bool isChance() const;
};

/// The effect of one other value of one constant.
struct Trial {
    const Constant* constant = nullptr;
    double factor = 0.0;
    std::vector<Move> moves;  ///< of all families, then of all maps

    [[nodiscard]] bool differs() const;
};

/// Runs families and maps with the default values, and then with others.
class Sweep {
public:
    explicit Sweep(const SweepOptions& options);
    ~Sweep();
    Sweep(const Sweep&) = delete;
    Sweep& operator=(const Sweep&) = delete;

    [[nodiscard]] Trial trial(const Constant& constant, double factor) const;
    /// Hash of all results at the default values: results with another hash cannot be reused.
    [[nodiscard]] std::uint64_t signature() const;

private:
    struct Base;
    SweepOptions options_;
    Base* base_;
};

}  // namespace plumb::tuning
