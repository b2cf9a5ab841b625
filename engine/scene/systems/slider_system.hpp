#pragma once

#include <string_view>

namespace plumb {

class World;

/// Moves the knobs of sliders with the mouse, and what they stand for.
/// Reads: Input, Slider. Writes: the fields that sliders name, Lab.
/// When: before physics.
struct SliderSystem {
    static constexpr std::string_view kName = "sliders";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
