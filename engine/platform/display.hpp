#pragma once

namespace plumb {

/// How often the display shows a new picture on which the window of this thread's GL context lies (Hz);
/// 0 when nobody knows.
double refreshRate();

}  // namespace plumb
