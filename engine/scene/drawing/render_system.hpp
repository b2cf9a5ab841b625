#pragma once

#include <string_view>

namespace plumb {

class World;

/// Requests the drawing effect. It has an empty update(),
/// as drawing happens between ticks, at the display's rate.
struct RenderSystem {
    static constexpr std::string_view kName = "render";

    void update(World&, float) {}
};

}  // namespace plumb
