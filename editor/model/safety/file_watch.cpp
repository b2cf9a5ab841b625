#include "editor/model/safety/file_watch.hpp"

#include "core/hash.hpp"

namespace plumb::editor {
namespace {

std::uint64_t hashOfFile(const Path& file) {
    const Result<std::string> text = readFile(file);
    return text ? hashText(*text) : 0;
}

}  // namespace

void FileWatch::know(Path file) {
    file_ = std::move(file);
    stamp_ = fileStamp(file_);
    hash_ = hashOfFile(file_);
}

FileWatch::State FileWatch::look() {
    if (file_.empty()) return State::Same;
    const std::uint64_t stamp = fileStamp(file_);
    if (stamp == stamp_) return State::Same;
    if (stamp == 0) return State::Gone;
    if (hashOfFile(file_) != hash_) return State::Changed;
    stamp_ = stamp;
    return State::Same;
}

}  // namespace plumb::editor
