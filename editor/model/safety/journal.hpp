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

/// What a crash left of a scene that was not saved.
struct LostWork {
    std::string scene;  ///< its path in the project
    std::string text;   ///< as it was last known
    std::string when;   ///< "22 Nov 02:15:03", local time
    Path journal;
};

/// Writes the scene beside its file while it is not saved: after a second or 8 actions. A slow disk is waited
/// for before twice as many could be lost; 20 actions or 5 s are never reached. It lies in the project, in
/// `.plumb`, so that it is found wherever the project goes, also by another person and after the machine was
/// set up anew; git leaves it out. The user's own file is never touched.
class Journal {
public:
    static constexpr double kSeconds = 1.0;
    static constexpr std::size_t kActions = 8;
    static constexpr double kMostSeconds = 2.0;  ///< then it waits for the disk

    Journal(const TypeRegistry& types, Path project) : types_{types}, project_{std::move(project)} {}
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// From now on this program keeps journals here; other editors of the project keep theirs.
    /// @error  the folder cannot be written
    Result<Done> begin();
    [[nodiscard]] bool begun() const { return writer_.has_value(); }

    /// To be called now and then; writes when it is time to.
    /// @param now  s, since any moment
    void tend(const Document& document, const UndoStack& undo, double now);
    /// What is in the journal is not needed any more: it was saved, or given up.
    void forget();
    /// Until the journal has all.
    void finish();

    /// What programs that are gone have left, the newest of each scene. What their files say anyway is
    /// dropped.
    [[nodiscard]] std::vector<LostWork> lostWork() const;

private:
    [[nodiscard]] Path fileOf(std::string_view scene) const;
    void write(const Document& document, double now);

    const TypeRegistry& types_;
    Path project_;
    Path folder_;  // of this session
    std::optional<FileLock> lock_;
    std::optional<JournalWriter> writer_;
    Path file_;                   // what is written at the moment; empty for none
    std::string scene_;           // whose it is
    std::uint64_t revision_ = 0;  // of the document, as it is in the file
    double written_ = -1e9;       // s
    std::size_t actions_ = 0;     // since then
    std::size_t step_ = 0;        // of undo, when it was last looked at
    std::size_t steps_ = 0;
    bool reported_ = false;
};

}  // namespace plumb::editor
