#pragma once

#include <deque>
#include <string_view>
#include <vector>

#include "editor/model/profiler/profiler.hpp"

namespace plumb::editor {

/// What one part of a tick took in the last second.
struct StageTime {
    std::string_view name;
    std::string_view doc;    ///< what it does; may be empty
    bool inPhysics = false;  ///< a stage of the physics
    float median = 0.0f;     ///< ms
    float p99 = 0.0f;        ///< ms: of a hundred ticks one takes longer
};

/// The parts of a tick: stages of the physics in their order, then systems by what they cost, then the
/// picture. Parts that took nothing are left out.
std::vector<StageTime> stageTimes(const std::deque<Profiler::Sample>& samples,
                                  const std::vector<Profiler::Zone>& zones);

/// ms of whole ticks of the last second, without their pictures.
StageTime tickTime(const std::deque<Profiler::Sample>& samples);

}  // namespace plumb::editor
