#pragma once

#include <string>
#include <utility>
#include <vector>

#include "editor/model/safety/backups.hpp"
#include "editor/model/safety/file_watch.hpp"
#include "editor/model/safety/journal.hpp"

namespace plumb::editor {

class Workspace;

/// Sees to it that no work is lost: by a crash, by saving, by another program, by a wrong click.
class SafetyNet {
public:
    explicit SafetyNet(Workspace& workspace);

    /// From now on a journal is kept, and what crashes have left is in `lost()`. Programs call it; tests and
    /// tools that only look at a project do not.
    void begin();
    /// To be called in every frame. @param seconds  since the last one
    void tend(double seconds);
    /// Until all that the journal has been given is on the disk.
    void finish() { journal_.finish(); }

    Backups backups;
    /// Opens the scene as it was then, not saved.
    Result<Done> restore(const Backup& backup);

    // After a crash.

    [[nodiscard]] const std::vector<LostWork>& lost() const { return lost_; }
    /// Opens the scene as it was lost, not saved. @error  the text cannot be read any more
    Result<Done> recover(std::size_t index);
    /// The text is kept among the backups of its scene.
    void discard(std::size_t index);

    // Another program.

    /// Whether the open file is still the one that was opened or saved.
    [[nodiscard]] FileWatch::State onDisk() const { return onDisk_; }
    void lookAtFile();
    /// Whether saving was refused since the last call because the file had changed.
    [[nodiscard]] bool takeRefusal() { return std::exchange(refused_, false); }
    /// Opens what is on the disk; what was here becomes a backup.
    void takeTheirs();
    /// The next save writes over it; what is on the disk becomes a backup then.
    void keepMine();

    // For the workspace.

    /// The scene is about to be closed; what was not saved becomes a backup.
    void leaving();
    void opened();
    /// The file is another program's: the person is asked which one to keep.
    void refuse() { refused_ = true; }
    void saving();
    void saved();

private:
    void keepUnsaved();
    [[nodiscard]] Path file() const;

    Workspace& workspace_;
    Journal journal_;
    FileWatch watch_;
    FileWatch::State onDisk_ = FileWatch::State::Same;
    std::vector<LostWork> lost_;
    double now_ = 0.0;     // s
    double looked_ = 0.0;  // s, when the file was last looked at
    bool refused_ = false;
};

}  // namespace plumb::editor
