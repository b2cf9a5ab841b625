#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file_lock.hpp"
#include "editor/model/document/document.hpp"
#include "editor/model/document/undo_stack.hpp"
#include "editor/model/safety/journal_writer.hpp"

namespace plumb::editor {

/// A scene with unsaved changes that is recovered from a journal after a crash.
struct LostWork {
    std::string scene;  ///< path of the scene file, relative to the project
    std::string text;   ///< content of the scene in the journal
    std::string when;   ///< local time of the journal, e.g. "22 Nov 02:15:03"
    Path journal;       ///< file of the journal
};

/// Writes the unsaved scene to a journal file after 1 s or 8 actions, so that a crash loses at most that. If
/// a write is still pending 2 s or 8 actions later, the editor waits for it; a crash never loses 20 actions
/// or 5 s. The journal lies in the project's folder `.plumb`, which git ignores, so that it moves with the
/// project. The scene's own file is never changed.
class Journal {
public:
    static constexpr double kSeconds = 1.0;      ///< s: maximum age of a change until it is written
    static constexpr std::size_t kActions = 8;   ///< maximum number of actions until they are written
    static constexpr double kMostSeconds = 2.0;  ///< s: at this age of a change the editor waits for the disk

    Journal(const TypeRegistry& types, Path project) : types_{types}, project_{std::move(project)} {}
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// Starts to write journals, in a folder that this program locks; other editors of the project use other
    /// folders.
    /// @error  no journal folder can be written
    Result<Done> begin();
    [[nodiscard]] bool begun() const { return writer_.has_value(); }

    /// Starts to write the journal if that is due; to be called in every frame.
    /// @param now  s: present time of any monotonic clock
    void update(const Document& document, const UndoStack& undo, double now);
    /// Deletes the journal, after the scene was saved or its changes were discarded.
    void forget();
    /// Waits until the journal is written.
    void finish();

    /// Returns the unsaved scenes left by crashed editors, newest first. Deletes journals whose text equals
    /// the scene's file.
    [[nodiscard]] std::vector<LostWork> lostWork() const;

private:
    [[nodiscard]] Path fileOf(std::string_view scene) const;
    void write(const Document& document, double now);

    const TypeRegistry& types_;
    Path project_;
    Path folder_;  // journal folder of this session
    std::optional<FileLock> lock_;
    std::optional<JournalWriter> writer_;
    Path file_;                   // the present journal; empty: none
    std::string scene_;           // path of the open scene
    std::uint64_t revision_ = 0;  // revision of the document in the journal
    double written_ = -1e9;       // s: time of the last write
    std::size_t actions_ = 0;     // number of actions since the last write
    std::size_t step_ = 0;        // `UndoStack::size` at the last call of `update`
    std::size_t steps_ = 0;       // `UndoStack::total` at the last call of `update`
    bool reported_ = false;       // a write error was logged
};

}  // namespace plumb::editor
