#pragma once

#include <cstdint>

#include "core/file.hpp"

namespace plumb::editor {

/// Notices when another program changes a file that is open here. A file that was only written anew with the
/// same content has not changed.
class FileWatch {
public:
    enum class State : unsigned char { Same, Changed, Gone };

    /// The file as it is now is what we know.
    void know(Path file);
    void forget() { file_.clear(); }
    /// Asks the disk; cheap while the file's time and size stay.
    [[nodiscard]] State look();

private:
    Path file_;
    std::uint64_t stamp_ = 0;
    std::uint64_t hash_ = 0;
};

}  // namespace plumb::editor
