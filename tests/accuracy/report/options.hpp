#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "tests/accuracy/report/sweep.hpp"

namespace plumb::accuracy {

/// The command line options.
struct Options {
    SweepOptions sweep;
    Path out = "build/accuracy";
    Path docs;          ///< where accuracy.md and accuracy/ are written; empty: nowhere
    bool peers = true;  ///< include other engines
    bool help = false;
    bool list = false;       ///< only list the names of the scenes
    bool stability = false;  ///< run the stability map instead, which parses the other arguments
    bool families = false;   ///< run families and relations instead, likewise
    bool tuning = false;     ///< run the sweep of the constants instead, likewise
    std::vector<std::string_view> otherWords;
};

/// @error an unknown option, with the known ones; an unknown scene, with a similar one
Result<Options> readOptions(std::span<const std::string_view> words);

std::string helpText();
/// The scenes, one per line.
std::string sceneList();

}  // namespace plumb::accuracy
