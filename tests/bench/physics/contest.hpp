#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

/// What the command line asks for.
struct ContestOptions {
    std::vector<std::string> scenes;   ///< names, parts of names or groups; empty for all
    std::vector<std::string> engines;  ///< names or parts of them; empty for all
    int threads = 0;                   ///< 0 for 1 and 2
    std::string jsonPath;              ///< empty: no file
    bool quick = false;                ///< a tenth of the steps, once: does it run at all?
    MeasureOptions measure;
};

/// Reads --scene, --engine, --threads, --steps, --runs; says what is wrong on stderr. @return false then
bool readOptions(std::span<const std::string> arguments, ContestOptions& options);

/// Measures and prints. The first engine is the one that others are compared with. @return an exit code
int runContest(std::span<const Engine> engines, const ContestOptions& options);

}  // namespace plumb::scenes
