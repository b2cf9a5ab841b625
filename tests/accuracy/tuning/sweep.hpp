#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/tunable.hpp"

namespace plumb::tuning {

/// All constants in the order of tuning.hpp; empty in a build without PLUMB_TUNABLE.
std::vector<const Constant*> allConstants();

struct SweepOptions {
    int members = 150;  ///< number of members per family
    int threads = 1;
    bool maps = true;    ///< true: includes the quick part of the stability map
    bool quick = false;  ///< true: runs at most kFirst members per family
};

/// Number of members of each family that run first. If
/// their results are bit-identical, the others are skipped.
inline constexpr int kFirst = 40;

/// Effect of a changed constant on one family or map.
struct Move {
    std::string scene;
    bool isMap = false;
    int members = 0;  ///< number of members of the family, or of cells of the map
    int base = 0;     ///< number of members that reach their goals, or of cells that hold, at the default
    int reached = 0;  ///< number of members or cells as in `base`, at the changed value
    int worse = 0;    ///< members that reach their goals only at the default, or cells with a worse score
    int better = 0;   ///< members that reach their goals only at the changed value
    bool differs = false;  ///< true if any bit of a member or any value of a cell differs

    /// Change of the share of members that reach their goals.
    [[nodiscard]] double shift() const { return members > 0 ? (reached - base) / (1.0 * members) : 0.0; }
    [[nodiscard]] bool isLarge() const;
    /// True if the numbers of worse and better members differ by no more than random variation.
    [[nodiscard]] bool isChance() const;
};

/// Effect of one changed value of a constant on all families and maps.
struct Trial {
    const Constant* constant = nullptr;
    double factor = 0.0;
    std::vector<Move> moves;  ///< one per family, then one per map

    [[nodiscard]] bool differs() const;
};

/// Runs families and maps with the default values of the constants, and then with changed values.
class Sweep {
public:
    explicit Sweep(const SweepOptions& options);
    ~Sweep();
    Sweep(const Sweep&) = delete;
    Sweep& operator=(const Sweep&) = delete;

    [[nodiscard]] Trial trial(const Constant& constant, double factor) const;
    /// Hash of all results at the default values. Stored results with another hash are obsolete.
    [[nodiscard]] std::uint64_t signature() const;

private:
    struct Base;
    SweepOptions options_;
    Base* base_;
};

}  // namespace plumb::tuning
