#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace plumb {

/// Result of an import: counts of imported items, conversions, and problems.
struct ImportReport {
    std::string from;   ///< kind of the source file, e.g. "Tiled map"
    std::string scene;  ///< path in its project of the scene or animation written, to be opened next
    int levels = 0;     ///< number of levels of a world; 0 for a single map
    int layers = 0;
    int tiles = 0;  ///< number of non-empty cells plus number of tiles off the grid
    int objects = 0;
    int colliders = 0;  ///< number of entities that are colliders of tiles
    int tilesets = 0;
    int images = 0;
    int clips = 0;                     ///< number of animation clips
    std::vector<std::string> files;    ///< paths in the project of the files written; the scene is the last
    std::vector<std::string> notes;    ///< content that was imported in a different form
    std::vector<Error> problems;       ///< content that is missing or wrong
    std::string editor;                ///< name of the program that wrote the file: "LDtk"
    std::set<std::string> editorKeys;  ///< keys in the file that only that program uses

    /// Adds a note if it is not in the list yet.
    void note(std::string text);
    /// Records keys that were not imported because only the program `owner` ("Tiled", "LDtk") uses them.
    void addEditorKeys(std::string_view owner, const std::set<std::string>& keys);

    /// Returns the problems, with identical ones at several places merged: "tile 3 and 5 more places".
    [[nodiscard]] std::vector<Error> foldedProblems() const;
    /// Returns "70 keys that only LDtk needs were left out", or "" if there are none. One line for all keys,
    /// because they are numerous and seldom relevant.
    [[nodiscard]] std::string leftOut() const;
    /// Returns the report for the user: a line of counts, then a line for each problem and each note.
    [[nodiscard]] std::string text() const;
    /// Returns the path and the counts of imported items in one line.
    [[nodiscard]] std::string summary() const;
};

}  // namespace plumb
