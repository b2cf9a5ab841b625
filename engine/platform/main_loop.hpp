#pragma once

#include <functional>

namespace plumb {

/// Calls `frame` for each picture of the display until it returns false. On the web the page calls it, so
/// this function does not return there: what follows the last frame belongs into `frame`, and the callers'
/// local variables live on.
void runFrames(std::function<bool()> frame);

/// True if events may be waited for; a page must return to its browser instead.
[[nodiscard]] bool canWait();

}  // namespace plumb
