#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

#include "physics/simulation.hpp"

namespace plumb::bench {

inline constexpr float kTick = 1.0f / 60.0f;  ///< s

// Each prints its table and returns an exit code.

/// Instructions of a step without an effect, with it unused, and pinned on but not required, by callgrind.
/// @return 1 when an unused one costs more than 1 %, 77 when valgrind is not installed
int measureCost(const char* program, bool quick);
/// The program that measureCost() runs under valgrind.
int runCounted(bool quick);
/// Boxes without rotation and friction compared with others; cost of events for continuing contacts.
int measureContacts(bool quick);
/// Cost of crates without rotation beside a ragdoll and a
/// jelly, in instructions, relative to their cost alone.
/// @return 1 when the ratio misses its goal, 77 when valgrind is not installed
int measureMixed(const char* program, bool quick);
/// The program that measureMixed() runs under valgrind.
int runMixed(bool quick);
/// Bytes of state and the time to copy, restore and hash them.
int measureState(bool quick);

/// The shortest of `rounds` runs, in ns.
template <class Act>
double quickest(int rounds, Act&& act) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds; ++i) {
        const auto start = std::chrono::steady_clock::now();
        act();
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        best = std::min(best, time.count());
    }
    return best;
}

}  // namespace plumb::bench
