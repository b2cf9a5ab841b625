#pragma once

#include <functional>
#include <string>

#include "core/result.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The text that the user types to replace a value of a panel. It belongs to the panel, not to the widget: if
/// a click on another entity removes the widget while typing, the typed text is still applied.
class Typing {
public:
    /// A value that is edited as text.
    struct Over {
        std::string before;  ///< text of the value when typing starts
        /// Applies the typed text. On error the value does not change.
        std::function<Result<Done>(Workspace& workspace, std::string_view text)> take;
        /// Returns a short preview of the result, shown while typing; null: no preview.
        std::function<Result<std::string>(std::string_view text)> preview{};
        bool lines = false;  ///< multi-line: Enter inserts a line break
    };

    /// Must be called for each value that can be typed, in the order in which Tab visits them.
    /// @return true if typing starts at this value, because Tab moved to it
    bool reached(const std::string& path);
    /// Replaces a value by an input field with the keyboard focus, from the next frame on. First applies the
    /// text typed at another value.
    void begin(Ui& ui, const std::string& path, Over over);
    /// True if this value is being typed.
    [[nodiscard]] bool on(std::string_view path) const { return !path_.empty() && path == path_; }
    /// Draws the input field instead of the value. @pre on(path)
    void draw(Ui& ui);
    /// Must be called after all values were drawn; applies the text of an input field that has disappeared.
    void endFrame(Ui& ui);

private:
    bool input();  ///< draws the input field; returns true on Enter
    void say(Ui& ui, const Result<std::string>& text) const;
    /// Applies the typed text. @param stay  on error, keeps the input field open to correct the text
    void finish(Ui& ui, bool stay);

    std::string path_;  // widget path of the typed value; empty: none
    std::string text_;  // the text in the input field
    Over over_;
    std::string problem_;  // error of the last Enter
    bool focus_ = false;   // the input field gets the keyboard focus in this frame
    bool active_ = false;  // the input field has had the focus
    bool drawn_ = false;   // the input field was drawn in this frame
    int waiting_ = 0;      // number of frames in which the input field did not get the focus

    std::string last_;       // path of the last value reached in this frame
    std::string before_;     // path of the value reached before `last_`
    std::string wanted_;     // path at which typing starts; empty: none
    bool wantNext_ = false;  // typing starts at the next value reached
};

}  // namespace plumb::editor::ui
