#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "editor/ui/editor_window.hpp"

namespace plumb::editor::ui {

/// A script of user actions in the editor, one per line, executed as input events:
///
///     # a comment
///     click Toolbar/Play
///     click Timeline/track 10%          at 10 % of the widget's width, instead of its center
///     click Tiles/palette 10% 50%       at 10 % of its width and 50 % of its height
///     click @160,64                     at a point in the scene (px, world)
///     right-click Scene/crate
///     double-click Inspector/Transform/position.x
///     click Scene/crate with Shift
///     drag @40,100 to @80,100
///     move @80,100
///     key Ctrl+S                        presses and releases
///     type hello world
///     press Right                       presses a key and keeps it down
///     release Right
///     wait 30                           waits for 30 frames
///     picture images/first.png          writes a screenshot
///
/// A script creates the images of the tutorial. A test runs it, to detect that the tutorial is out of date.
class Tour {
public:
    /// Callbacks into the surrounding program: return the present window and workspace (opening another
    /// project replaces them), show a frame with events, and write a screenshot.
    struct Stage {
        std::function<const EditorWindow&()> window;
        std::function<const Workspace&()> workspace;
        std::function<void(const std::vector<Event>&)> frame;
        std::function<Result<Done>(std::string_view path)> picture;
    };

    /// Parses a script.
    /// @param name  name of the script's file, for error messages
    /// @error       an invalid action, with its line number
    static Result<Tour> read(std::string_view text, std::string_view name);

    /// Runs the script. @error  a widget that is not visible, or a screenshot that cannot be written
    Result<Done> play(const Stage& stage) const;

    /// One line of the script.
    struct Step {
        std::string_view verb;  ///< one of the actions in tour.cpp, e.g. "click"
        std::string from;       ///< argument of the action; for a drag, its start point
        std::string to;         ///< end point of a drag; empty for other actions
        Modifiers with;         ///< modifier keys held during the action
        std::string where;      ///< file and line for errors, e.g. "tutorial.tour:12"
    };

private:
    std::vector<Step> steps_;
};

}  // namespace plumb::editor::ui
