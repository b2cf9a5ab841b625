#pragma once

#include <cstddef>
#include <functional>

namespace plumb::accuracy {

inline constexpr int kMaxThreads = 256;

/// Number of threads that this machine runs in parallel.
int processors();

/// Called from time to time, by one thread at a time, with the number of finished items.
using ShowDone = std::function<void(std::size_t done, std::size_t all)>;

/// Runs `act(i)` for each i below `count`, in any order.
void onThreads(int threads, std::size_t count, const std::function<void(std::size_t)>& act,
               const ShowDone& show = {});

}  // namespace plumb::accuracy
