#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "editor/ui/editor_window.hpp"

namespace plumb::editor::ui {

/// A way through the editor as text, one action a line, played by the same events as a person's hands:
///
///     # a comment
///     click Toolbar/Play
///     click Timeline/track 10%          a tenth along it from the left, not its middle
///     click Tiles/palette 10% 50%       the same, and half down
///     click @160,64                     a place in the scene (px, world)
///     right-click Scene/crate
///     double-click Inspector/Transform/position.x
///     click Scene/crate with Shift
///     drag @40,100 to @80,100
///     move @80,100
///     key Ctrl+S
///     type hello world
///     press Right                       goes down, and stays down
///     release Right
///     wait 30                           frames
///     picture images/first.png
///
/// The tutorial's pictures are made by it, and its test says when the editor no longer is what it tells.
class Tour {
public:
    /// What surrounds the window: which one it is (another project has another), how a frame is shown, and
    /// how a picture of it is taken.
    struct Stage {
        std::function<const EditorWindow&()> window;
        std::function<const Workspace&()> workspace;
        std::function<void(const std::vector<Event>&)> frame;
        std::function<Result<Done>(std::string_view path)> picture;
    };

    /// @param name  of the text, for errors
    /// @error       a line that is no action: its number, and what there is
    static Result<Tour> read(std::string_view text, std::string_view name);

    /// @error a widget that is not on the screen, or a picture that cannot be written
    Result<Done> play(const Stage& stage) const;

    /// One line.
    struct Step {
        std::string_view verb;  ///< of the table in tour.cpp
        std::string from;       ///< what comes after the verb
        std::string to;         ///< where a drag ends
        Modifiers with;         ///< keys held meanwhile
        std::string where;      ///< "tutorial.tour:12", for errors
    };

private:
    std::vector<Step> steps_;
};

}  // namespace plumb::editor::ui
