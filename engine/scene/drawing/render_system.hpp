#pragma once

#include <string_view>

namespace plumb {

class World;

/// Calls for drawing. Drawing itself happens between ticks, at the display's rate, so a tick has nothing to
/// do.
struct RenderSystem {
    static constexpr std::string_view kName = "render";

    void update(World&, float) {}
};

}  // namespace plumb
