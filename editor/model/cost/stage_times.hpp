#pragma once

#include <deque>
#include <string_view>
#include <vector>

#include "editor/model/profiler/profiler.hpp"

namespace plumb::editor {

/// Time of one part of a tick over the last second.
struct StageTime {
    std::string_view name;
    std::string_view doc;    ///< description; may be empty
    bool inPhysics = false;  ///< it is a stage of the physics step
    float median = 0.0f;     ///< ms
    float p99 = 0.0f;        ///< 99th percentile, ms
};

/// Returns the parts of a tick that took time: physics stages in their order, then systems, most expensive
/// first, then drawing.
std::vector<StageTime> stageTimes(const std::deque<Profiler::Sample>& samples,
                                  const std::vector<Profiler::Zone>& zones);

/// Returns the time of whole ticks over the last second, without drawing.
StageTime tickTime(const std::deque<Profiler::Sample>& samples);

}  // namespace plumb::editor
