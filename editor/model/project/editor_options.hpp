#pragma once

#include <span>
#include <string>

#include "core/result.hpp"

namespace plumb::editor {

/// What a person asked the editor for on its command line.
struct EditorOptions {
    std::string project;     ///< its folder; empty: the welcome screen
    std::string scene;       ///< empty: the project's start scene
    bool validate = false;   ///< open every scene, tell its problems, end
    std::string exportTo;    ///< a folder to copy the game to, then end
    std::string screenshot;  ///< PNG of the window, then end
    std::string tour;        ///< a file of actions to play, then end: see Tour
    std::string importFrom;  ///< a file of another editor …
    std::string importTo;    ///< … and the scene to make of it; empty: named after it
    std::string select;      ///< name of the entity to select at the start
    int width = 1280;        ///< px of the window
    int height = 720;        ///< px of the window
    float scale = 0.0f;      ///< of the interface; 0: as the person set it
    std::string theme;       ///< "dark" or "light"; empty: as the person set it
    bool welcome = false;    ///< the screen of projects comes first, whatever project is named
    bool help = false;
};

/// @error an unknown option, a missing or wrong value
Result<EditorOptions> parseEditorOptions(std::span<const char* const> words);

std::string editorUsage();

}  // namespace plumb::editor
