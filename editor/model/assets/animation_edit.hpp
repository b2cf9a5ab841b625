#pragma once

#include <functional>
#include <string>

#include "assets/animation.hpp"
#include "editor/model/assets/sheet_slicer.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// An animation file that is open for editing: its sheet, its cells and its clips; its states are changed by
/// StateMachineEdit. Every change is one step of undo and is written at once, so that all that show it
/// follow.
class AnimationEdit {
public:
    explicit AnimationEdit(Workspace& workspace) : workspace_{workspace} {}

    /// Opens an animation file, or makes one of a picture beside it and opens that.
    /// @return what went wrong, for the person; empty: nothing
    std::string open(std::string_view path);
    void close() { path_.clear(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] AnimationId id() const { return id_; }
    [[nodiscard]] Workspace& workspace() const { return workspace_; }
    /// The file as it is now, also after undo or another program's change.
    [[nodiscard]] const AnimationSet& set() const;
    /// The sheet's pixels; empty when there are none.
    [[nodiscard]] const Image& sheet();
    [[nodiscard]] int columns();
    [[nodiscard]] int rows();
    [[nodiscard]] Rect cellOf(const AnimationFrame& frame) const;

    /// Any change of the file; while a game plays it says that it waits for its end.
    /// @param label  completes "Undo …"
    /// @return       whether something is other than before
    bool change(std::string label, const std::function<void(AnimationSet&)>& edit);

    void setCells(CellSize cells);
    /// @return whether cells could be distinguished
    bool sliceByItself();
    /// A clip of all cells of the sheet that have something in them, row by row.
    void addClipOfAll();
    void addClip();
    void removeClip(int clip);
    /// Keeps the state machine on the same clips.
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

/// Which frame of a clip shows at a time (s since it began); 0 for an empty clip.
int frameAt(const Animation& clip, double seconds);

}  // namespace plumb::editor
