#include "core/fixed_list.hpp"

#include <array>
#include <atomic>
#include <string>

#include "core/assert.hpp"
#include "core/log.hpp"

namespace plumb {

void reportListFault(ListFault fault, std::size_t index, std::size_t size, std::size_t capacity) {
    static std::array<std::atomic<bool>, 2> reported{};
    if (!kAssertions && reported[static_cast<std::size_t>(fault)].exchange(true)) return;
    const bool isPush = fault == ListFault::PushOnFull;
    const Error error{
        "FixedList",
        isPush
            ? format("push() on a full list of capacity {}; the value was not added", capacity)
            : format("item {} was requested from a list of size {} and capacity {}", index, size, capacity),
        isPush ? "check full() first, or give the list a larger capacity" : "compare the index with size()"};
    PLUMB_ASSERT(false, error.text().c_str());
    logError("Engine", error);
}

}  // namespace plumb
