#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/debug/line_watch.hpp"
#include "editor/model/debug/script_place.hpp"
#include "script/script_frames.hpp"

namespace plumb::editor {

class Workspace;

/// A script file as it is shown.
struct ScriptText {
    std::string file;  ///< "scripts/slime.lua"
    std::vector<std::string> lines;
};

/// What the panel Scripts shows: the script files of the project, and the line at which the game is stopped.
class ScriptView {
public:
    explicit ScriptView(Workspace& workspace);

    /// Reads changed files, moves their breakpoints with their lines, shows the line at which the game has
    /// stopped, and stores changed breakpoints; to be called once per frame. @param seconds  since the last
    /// call
    void update(double seconds);

    [[nodiscard]] const std::vector<ScriptText>& files() const { return files_; }
    /// The file that is shown: the chosen one, else the first; null if the project has no scripts.
    [[nodiscard]] const ScriptText* shown() const;
    /// Shows a line in the panel, which comes to the front.
    void show(const ScriptPlace& place);
    /// Shows a file. The panel stays where it is.
    void choose(std::string_view file) { chosen_ = file; }
    /// Returns once the line to scroll to; 0: none.
    int takeLine() { return std::exchange(scrollTo_, 0); }

    /// To be called after the breakpoints were read from their file.
    void breakpointsKept();

    std::size_t frame = 0;  ///< index of the function whose variables are shown

    /// Describes where the game is stopped: "scripts/slime.lua:12, tick 41".
    [[nodiscard]] std::string haltInWords() const;

    /// A field of the script at which the game is stopped.
    struct Property {
        std::string name;
        std::string value;
        WatchedField field;
    };
    /// The properties of that script at this moment.
    [[nodiscard]] std::vector<Property> properties() const;

private:
    void readFiles();
    void followHalt();
    [[nodiscard]] const ScriptText* find(std::string_view file) const;

    Workspace& workspace_;
    std::vector<ScriptText> files_;
    std::optional<std::uint64_t> stamp_;  // of the files that were read
    double waited_ = 0.0;                 // s since the last look at the files
    std::string chosen_;
    int scrollTo_ = 0;
    std::size_t halts_ = 0;        // ScriptDebugger::halts() that was shown
    std::size_t breakpoints_ = 0;  // revision of the breakpoints that was stored
};

}  // namespace plumb::editor
