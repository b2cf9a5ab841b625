#pragma once

#include <span>
#include <string>

#include "core/result.hpp"

namespace plumb::editor {

/// The command line options of the editor.
struct EditorOptions {
    std::string project;         ///< folder of the project; empty: show the welcome screen
    std::string scene;           ///< name of the scene to open; empty: the project's start scene
    std::string replay;          ///< file of a replay to play up to 2 s before its end; empty: none
    std::string newProject;      ///< folder of a project to create, then exit; empty: none
    std::string from = "empty";  ///< template of the new project
    bool validate = false;       ///< check all scenes, prefabs and assets, print the problems and exit
    std::string exportTo;        ///< folder to export the game to, then exit; empty: no export
    std::string player;          ///< of the export: see ExportParts; empty: the one for this computer
    std::string licences;        ///< of the export: see ExportParts
    std::string finished;        ///< a finished export to be copied to `exportTo`; empty: one is made
    std::string resources;       ///< folder for writeWindowsResources(), then exit; empty: none
    std::string screenshot;      ///< PNG file for a screenshot of the window, then exit; empty: none
    std::string tour;            ///< script of actions to run, then exit (editor/ui/tour.hpp); empty: none
    std::string importFrom;      ///< file of another editor to import, then exit; empty: no import
    std::string importTo;        ///< file to write the import to; empty: named after `importFrom`
    std::string select;          ///< name of the entity to select at the start
    int width = 1280;            ///< px: width of the window
    int height = 720;            ///< px: height of the window
    float scale = 0.0f;          ///< scale of the user interface; 0: the scale in the settings
    std::string theme;           ///< "dark" or "light"; empty: the theme in the settings
    bool welcome = false;        ///< show the welcome screen first, even if a project is given
    bool help = false;           ///< print the usage and exit
};

/// Parses the command line. @error  an unknown option, or a missing or invalid value
Result<EditorOptions> parseEditorOptions(std::span<const char* const> words);

/// Returns the text that `--help` prints.
std::string editorUsage();

}  // namespace plumb::editor
