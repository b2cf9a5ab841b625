#pragma once

#include <string_view>

namespace plumb {

class World;

/// Stands for drawing in the list of systems. Its update() is empty,
/// as scenes are drawn between ticks, at the display's rate.
struct RenderSystem {
    static constexpr std::string_view kName = "render";

    void update(World&, float) {}
};

}  // namespace plumb
