#pragma once

#include <cstddef>
#include <functional>

namespace plumb::accuracy {

inline constexpr int kMaxThreads = 256;

/// Returns the number of hardware threads.
int processors();

/// Progress callback, called with the number of finished items by one thread at a time.
using ShowDone = std::function<void(std::size_t done, std::size_t all)>;

/// Calls `act(i)` for each i below `count` on several threads, in any order.
void onThreads(int threads, std::size_t count, const std::function<void(std::size_t)>& act,
               const ShowDone& show = {});

}  // namespace plumb::accuracy
