#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

#include "physics/simulation.hpp"

namespace plumb::bench {

inline constexpr float kTick = 1.0f / 60.0f;  ///< s

// Each of these functions prints its results and returns an exit code.

/// Counts the instructions of a step without an effect, with the effect unused, and pinned on without need.
/// @return 1 if an unused effect costs more than 1 %, 77 if valgrind is not installed
int measureCost(const char* program, bool quick);
/// Runs the steps that measureCost() counts under valgrind.
int runCounted(bool quick);
/// Measures the time of a step for boxes with and without rotation, friction and other effects, and the cost
/// of events for continuing contacts.
int measureContacts(bool quick);
/// Counts the instructions for crates without rotation beside a ragdoll and a
/// jelly, and compares them with those for the crates alone.
/// @return 1 if the ratio misses its target, 77 if valgrind is not installed
int measureMixed(const char* program, bool quick);
/// Runs the steps that measureMixed() counts under valgrind.
int runMixed(bool quick);
/// Measures the size of a world's state and the time to copy, restore and hash it.
int measureState(bool quick);

/// Returns the minimum time of `rounds` runs, ns.
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
