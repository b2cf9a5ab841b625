#pragma once

#include <functional>
#include <string>

#include "core/result.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The text that a person types over one of the values of a panel. It belongs to the panel and not to the
/// widget: a click on another entity while typing makes the widget vanish, and what was typed counts all the
/// same.
class Typing {
public:
    struct Over {
        std::string before;  ///< what stands there to be typed over
        /// Takes what was typed. What it refuses leaves the value as it was.
        std::function<Result<Done>(Workspace& workspace, std::string_view text)> take;
        /// What it would become, in a few words; none: nothing is said while typing.
        std::function<Result<std::string>(std::string_view text)> preview{};
        bool lines = false;  ///< Enter makes a new line
    };

    /// To be called for each value that can be typed over, in their order: Tab goes from one to the next.
    /// @return whether typing shall begin there
    bool reached(const std::string& path);
    /// Makes a value a text, from the next frame on, and puts the hands on it.
    /// What was typed elsewhere is taken before.
    void begin(Ui& ui, const std::string& path, Over over);
    [[nodiscard]] bool on(std::string_view path) const { return !path_.empty() && path == path_; }
    /// The text, in place of what shows the value. @pre on(path)
    void draw(Ui& ui);
    /// After all were drawn: what was typed into a widget that has vanished is taken.
    void endFrame(Ui& ui);

private:
    bool input();
    void say(Ui& ui, const Result<std::string>& text) const;
    /// @param stay  a text that is refused stays, to be mended
    void finish(Ui& ui, bool stay);

    std::string path_;  // empty: nothing is typed
    std::string text_;
    Over over_;
    std::string problem_;  // why Enter was refused
    bool focus_ = false;   // the keyboard goes there in this frame
    bool active_ = false;  // it has had the keyboard
    bool drawn_ = false;   // in this frame
    int waiting_ = 0;      // frames in which the keyboard did not come

    std::string last_;    // the value that was reached last in this frame
    std::string before_;  // and the one before it
    std::string wanted_;  // where typing shall begin
    bool wantNext_ = false;
};

}  // namespace plumb::editor::ui
