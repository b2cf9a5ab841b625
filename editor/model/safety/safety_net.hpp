#pragma once

#include <string>
#include <utility>
#include <vector>

#include "editor/model/safety/backups.hpp"
#include "editor/model/safety/file_watch.hpp"
#include "editor/model/safety/journal.hpp"

namespace plumb::editor {

class Workspace;

/// Prevents the loss of work by a crash, by overwriting a file, by another program or by a wrong click.
class SafetyNet {
public:
    explicit SafetyNet(Workspace& workspace);

    /// Starts the journal and collects the unsaved scenes left by crashes in `lost()`. Not called by tests
    /// and tools that only read a project.
    void begin();
    /// Must be called in every frame. @param seconds  time since the last call
    void update(double seconds);
    /// Waits until the journal is written.
    void finish() { journal_.finish(); }

    Backups backups;
    /// Opens a backup of the open scene as unsaved content.
    Result<Done> restore(const Backup& backup);

    // After a crash.

    [[nodiscard]] const std::vector<LostWork>& lost() const { return lost_; }
    /// Opens an item of `lost()` as unsaved content. @error  the text is not a valid scene
    Result<Done> recover(std::size_t index);
    /// Deletes an item of `lost()`; its text is added to the backups of its scene.
    void discard(std::size_t index);

    // Changes by another program.

    /// State of the open file on disk compared to the version last opened or saved.
    [[nodiscard]] FileWatch::State onDisk() const { return onDisk_; }
    /// Compares the open file with the version last opened or saved, and updates `onDisk`.
    void lookAtFile();
    /// True if saving was refused since the last call, because another program had changed the file.
    [[nodiscard]] bool takeRefusal() { return std::exchange(refused_, false); }
    /// Opens the version of the other program on disk; unsaved changes are added to the backups.
    void takeTheirs();
    /// Keeps the version in the editor. The next save overwrites the file and adds its content to the
    /// backups.
    void keepMine();

    // Notifications by the workspace.

    /// The scene will be closed; unsaved changes are added to the backups.
    void leaving();
    /// A file was opened.
    void opened();
    /// Saving was refused, because another program changed the file; the user is asked which version to keep.
    void refuse() { refused_ = true; }
    /// The file will be overwritten.
    void saving();
    /// The file was written.
    void saved();

private:
    void keepUnsaved();
    [[nodiscard]] Path file() const;

    Workspace& workspace_;
    Journal journal_;
    FileWatch watch_;
    FileWatch::State onDisk_ = FileWatch::State::Same;
    std::vector<LostWork> lost_;
    double now_ = 0.0;     // s since the start
    double looked_ = 0.0;  // s: time of the last check of the open file
    bool refused_ = false;
};

}  // namespace plumb::editor
