#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "tests/accuracy/report/sweep.hpp"

namespace plumb::accuracy {

/// What the command line asks for.
struct Options {
    SweepOptions sweep;
    Path out = "build/accuracy";
    Path docs;          ///< where accuracy.md and accuracy/ go; empty for nowhere
    bool peers = true;  ///< other engines too
    bool help = false;
    bool list = false;       ///< only the names of the scenes
    bool stability = false;  ///< the stability map instead, which reads the other words
    bool families = false;   ///< families and relations instead, the same
    bool tuning = false;     ///< what each constant of the physics does instead, the same
    std::vector<std::string_view> otherWords;
};

/// @error a word that means nothing, with those that would; a scene that is not there, with one like it
Result<Options> readOptions(std::span<const std::string_view> words);

std::string helpText();
/// The scenes, one in a line.
std::string sceneList();

}  // namespace plumb::accuracy
