#include "editor/model/safety/other_editors.hpp"

#include "core/file_lock.hpp"

namespace plumb::editor {

bool isOpenInAnEditor(const Path& project) {
    std::error_code failed;
    for (const auto& session : std::filesystem::directory_iterator{project / ".plumb", failed}) {
        const Path lock = session.path() / "lock";
        if (std::filesystem::exists(lock, failed) && !FileLock::take(lock)) return true;
    }
    return false;
}

}  // namespace plumb::editor
