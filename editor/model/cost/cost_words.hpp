#pragma once

#include <string>

#include "editor/model/cost/what_if_run.hpp"

namespace plumb::editor {

/// An error below this cannot be seen.
inline constexpr float kSeenPixels = 0.5f;

/// "6.0 mm (0.4 px)".
std::string lengthWords(float metres, PixelScale scale);
/// "0.42 ms", from microseconds.
std::string costWords(float microseconds);
[[nodiscard]] float pixelsOf(float metres, PixelScale scale);

/// What one quality costs and how far off it is, beside the one below it: "Quality 4: +0.31 ms, 1.5 mm
/// (0.1 px)."
/// @param below  null for the first
std::string qualityWords(const WhatIfResult& result, const WhatIfPoint& point, const WhatIfPoint* below);

/// The cheapest quality of which the error cannot be seen; else the most exact one. Null before all are
/// known.
const WhatIfPoint* enoughQuality(const WhatIfResult& result);

/// What it all comes to, in a sentence or two.
std::string verdictWords(const WhatIfResult& result);

/// What was stepped again, how long and how.
std::string methodWords(const WhatIfResult& result, bool wasPlaying, std::uint32_t leftOut);

}  // namespace plumb::editor
