#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

/// Options of the command line.
struct ContestOptions {
    std::vector<std::string> scenes;   ///< names, parts of names or groups; empty: all scenes
    std::vector<std::string> engines;  ///< names or parts of names; empty: all engines
    int threads = 0;                   ///< number of threads; 0: both 1 and 2
    std::string jsonPath;              ///< empty: no file
    bool quick = false;                ///< one run with a tenth of the steps, only to check that it works
    MeasureOptions measure;
};

/// Reads --scene, --engine, --threads, --steps, --runs. @return false if one is invalid, reported on stderr
bool readOptions(std::span<const std::string> arguments, ContestOptions& options);

/// Measures and prints the results. The other engines are compared with the first one. @return an exit code
int runContest(std::span<const Engine> engines, const ContestOptions& options);

}  // namespace plumb::scenes
