#pragma once

#include <span>
#include <string_view>

namespace plumb::box_physics {

/// A stage of the step, and the effects of which any one calls for it.
struct StageName {
    std::string_view name;
    unsigned effects = 0;  ///< bits of Effect
};

/// The stages of a step, in order.
std::span<const StageName> stageNames();

}  // namespace plumb::box_physics
