#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace plumb {

/// What an import brought in, what it changed, and what it could not bring.
struct ImportReport {
    std::string from;   ///< what kind of file it was: "Tiled map"
    std::string scene;  ///< path in its project of what was made; the file to open
    int levels = 0;     ///< of a world; 0 for a single map
    int layers = 0;
    int tiles = 0;  ///< cells and loose tiles that are not empty
    int objects = 0;
    int tilesets = 0;
    int images = 0;
    int clips = 0;                   ///< of an animation
    std::vector<std::string> files;  ///< written, as paths in the project; the scene is the last
    std::vector<std::string> notes;  ///< what is there in another form than it was
    std::vector<Error> problems;     ///< what is not there, or not as it should be

    /// Adds a note once.
    void note(std::string text);
    /// For people: one line of counts, then one line for each problem and each note.
    [[nodiscard]] std::string text() const;
    /// The first line of it.
    [[nodiscard]] std::string summary() const;
};

}  // namespace plumb
