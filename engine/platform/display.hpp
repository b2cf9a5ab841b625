#pragma once

namespace plumb {

/// Refresh rate (Hz) of the display that shows the window
/// of this thread's GL context; 0 if it is unknown.
double refreshRate();

}  // namespace plumb
