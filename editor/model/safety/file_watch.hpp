#pragma once

#include <cstdint>

#include "core/file.hpp"

namespace plumb::editor {

/// Detects that another program changed the open file. Writing the same content again is not a change.
class FileWatch {
public:
    enum class State : unsigned char { Same, Changed, Gone };

    /// Watches this file, and takes its present content as the known one.
    void know(Path file);
    /// Stops watching.
    void forget() { file_.clear(); }
    /// Compares the file with the known content. Reads the file only if its time or size changed.
    [[nodiscard]] State look();

private:
    Path file_;
    std::uint64_t stamp_ = 0;  // stamp of the file's time and size; 0: no file
    std::uint64_t hash_ = 0;   // hash of the file's content
};

}  // namespace plumb::editor
