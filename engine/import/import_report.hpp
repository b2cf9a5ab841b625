#pragma once

#include <set>
#include <string>
#include <string_view>
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
    int clips = 0;                     ///< of an animation
    std::vector<std::string> files;    ///< written, as paths in the project; the scene is the last
    std::vector<std::string> notes;    ///< what is there in another form than it was
    std::vector<Error> problems;       ///< what is not there, or not as it should be
    std::string editor;                ///< that the file came from: "LDtk"
    std::set<std::string> editorKeys;  ///< names in the file that mean something only inside that editor

    /// Adds a note once.
    void note(std::string text);
    /// Adds names of what means something only inside another editor.
    void leaveOut(std::string_view owner, const std::set<std::string>& keys);

    /// The problems, identical ones of several places merged: "tile 3 and 5 more places".
    [[nodiscard]] std::vector<Error> foldedProblems() const;
    /// "70 keys that only LDtk needs were left out"; empty when there are none. The keys are many and matter
    /// to few, so they are no lines of their own.
    [[nodiscard]] std::string leftOut() const;
    /// For people: one line of counts, then one line for each problem and each note.
    [[nodiscard]] std::string text() const;
    /// The first line of it.
    [[nodiscard]] std::string summary() const;
};

}  // namespace plumb
