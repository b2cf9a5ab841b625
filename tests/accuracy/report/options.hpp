#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "tests/accuracy/report/sweep.hpp"

namespace plumb::accuracy {

/// Command-line options of plumb-accuracy.
struct Options {
    SweepOptions sweep;
    Path out = "build/accuracy";  ///< output folder of the results
    Path docs;                    ///< output folder of accuracy.md and accuracy/; empty: not written
    bool peers = true;            ///< true: other engines are run too
    bool help = false;
    bool list = false;       ///< true: only lists the names of the scenes
    bool stability = false;  ///< true: runs the stability map instead, with the remaining arguments
    bool families = false;   ///< true: runs families of random scenes instead, with the remaining arguments
    bool tuning = false;     ///< true: measures the effect of constants instead, with the remaining arguments
    std::vector<std::string_view> otherWords;  ///< remaining arguments, after --stability or the like
};

/// Parses command-line arguments.
/// @error an unknown option, with a list of all options; an unknown scene, with a suggestion
Result<Options> readOptions(std::span<const std::string_view> words);

std::string helpText();
/// Returns a list of all scenes, one per line.
std::string sceneList();

}  // namespace plumb::accuracy
