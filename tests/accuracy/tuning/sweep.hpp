#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/tunable.hpp"

namespace plumb::tuning {

/// Returns all constants in the order of engine/physics/tuning.hpp; none in a build without PLUMB_TUNABLE.
std::vector<const Constant*> allConstants();

struct SweepOptions {
    int members = 150;   ///< number of members per family
    int threads = 1;     ///< number of members simulated in parallel
    bool maps = true;    ///< true: also runs the quick part of the stability map
    bool quick = false;  ///< true: runs at most kFirst members per family
};

/// Number of members of each family that run first with a changed constant. If
/// their results are bit-identical to those of the default, the others are skipped.
inline constexpr int kFirst = 40;

/// Effect of a changed constant on one family of random scenes, or on one stability map.
struct Move {
    std::string scene;   ///< name of the family or map
    bool isMap = false;  ///< true: map
    int members = 0;     ///< number of members (scenes) of the family, or of cells of the map
    int base = 0;        ///< at the default: number of members that reach their goals, or of cells that hold
    int reached = 0;     ///< at the changed value: number of members or cells as in `base`
    int worse = 0;       ///< members that reach their goals only at the default, or cells with a worse score
    int better = 0;  ///< members that reach their goals only at the changed value; cells with a better score
    bool differs = false;  ///< true if any bit of a member or any value of a cell differs

    /// Change of the share of members that reach their goals.
    [[nodiscard]] double shift() const { return members > 0 ? (reached - base) / (1.0 * members) : 0.0; }
    [[nodiscard]] bool isLarge() const;  ///< the share changes by > 2 %; maps: at all
    /// True if the numbers of worse and better members differ by no more than random variation.
    [[nodiscard]] bool isChance() const;
};

/// Effect of one changed value of a constant on all families and maps.
struct Trial {
    const Constant* constant = nullptr;
    double factor = 0.0;      ///< changed value / default value
    std::vector<Move> moves;  ///< one per family, then one per map

    [[nodiscard]] bool differs() const;  ///< true if any result differs in any bit
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
