#include "core/state_archive.hpp"

namespace plumb {

void StateArchive::block(void* at, std::size_t bytes) {
    if (out_ != nullptr) {
        out_->append(static_cast<const char*>(at), bytes);
        return;
    }
    ok_ = ok_ && bytes <= in_.size();
    if (!ok_) return static_cast<void>(std::memset(at, 0, bytes));
    std::memcpy(at, in_.data(), bytes);
    in_.remove_prefix(bytes);
}

std::size_t StateArchive::count(std::size_t count, std::size_t leastBytes) {
    std::uint64_t items = count;
    number(items);
    if (reading() && items > in_.size() / leastBytes) {
        fail();
        return 0;
    }
    return static_cast<std::size_t>(items);
}

void StateArchive::text(std::string& text) {
    const std::size_t bytes = count(text.size());
    if (reading()) text.resize(bytes);
    if (bytes > 0) block(text.data(), bytes);
}

}  // namespace plumb
