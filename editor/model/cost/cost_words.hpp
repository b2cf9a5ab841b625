#pragma once

#include <string>

#include "editor/model/cost/what_if_run.hpp"

namespace plumb::editor {

/// Errors below this are not visible, px.
inline constexpr float kSeenPixels = 0.5f;

/// Returns a length for display: "6.0 mm (0.4 px)".
std::string lengthWords(float metres, PixelScale scale);
/// Returns a time for display: "0.42 ms".
std::string costWords(float microseconds);
[[nodiscard]] float pixelsOf(float metres, PixelScale scale);

/// Describes a physics quality by its cost relative to the next lower quality, and by its error:
/// "Quality 4: +0.31 ms, error 1.5 mm (0.1 px)."
/// @param below  the next lower quality; null for the lowest
std::string qualityWords(const WhatIfResult& result, const WhatIfPoint& point, const WhatIfPoint* below);

/// Returns the lowest quality without visible error, else the best one; null until all are measured.
const WhatIfPoint* enoughQuality(const WhatIfResult& result);

/// Summarizes the measurement in one or two sentences.
std::string verdictWords(const WhatIfResult& result);

/// Describes how the measurement was made. @param leftOut  bodies and joints created while it was recorded
std::string methodWords(const WhatIfResult& result, bool wasPlaying, std::uint32_t leftOut);

}  // namespace plumb::editor
