#pragma once

#include <functional>
#include <string>

#include "assets/animation.hpp"
#include "editor/model/assets/sheet_slicer.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Editor of an open animation file: its sprite sheet, cells and clips (StateMachineEdit edits its states).
/// Every change is one undo step and is written to the file at once, which updates all users of the
/// animation.
class AnimationEdit {
public:
    explicit AnimationEdit(Workspace& workspace) : workspace_{workspace} {}

    /// Opens an animation file. For an image file, opens the animation file beside it, which is created if
    /// needed.
    /// @return an error message for the user; empty on success
    std::string open(std::string_view path);
    void close() { path_.clear(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] AnimationId id() const { return id_; }
    [[nodiscard]] Workspace& workspace() const { return workspace_; }
    /// The present content of the file, including changes by undo or other programs.
    [[nodiscard]] const AnimationSet& set() const;
    /// The pixels of the sheet; empty if it has none.
    [[nodiscard]] const Image& sheet();
    [[nodiscard]] int columns();
    [[nodiscard]] int rows();
    [[nodiscard]] Rect cellOf(const AnimationFrame& frame) const;  ///< px in the sheet

    /// Applies any edit to the file. While a game runs, only shows a notice to stop it first.
    /// @param label  completes "Undo …"
    /// @return       true if the file changed
    bool change(std::string label, const std::function<void(AnimationSet&)>& edit);

    void setCells(CellSize cells);
    /// Sets the cell size guessed from the pixels (guessCells). @return false if the sheet has no clear grid
    bool detectCells();
    /// Adds a clip of all cells of the sheet that are not empty, row by row.
    void addClipOfAll();
    void addClip();
    void removeClip(int clip);
    /// Renames a clip. States refer to clips by index, so they keep theirs.
    void renameClip(int clip, std::string_view name);
    void addFrame(int clip, int cellX, int cellY);
    void removeFrame(int clip, int frame);
    void moveFrame(int clip, int from, int to);
    void setSeconds(int clip, int frame, float seconds);
    void setLoop(int clip, LoopMode loop);

private:
    Workspace& workspace_;
    std::string path_;
    AnimationId id_;
};

/// Returns the index of a clip's frame at a time (s since its start); 0 for an empty clip.
int frameAt(const Animation& clip, double seconds);

}  // namespace plumb::editor
