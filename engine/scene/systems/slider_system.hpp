#pragma once

#include <string_view>

namespace plumb {

class World;

/// Lets the mouse drag sliders, and writes their values to the controlled fields.
/// Reads: Input. Writes: Slider, the controlled fields, Lab.
/// When: before physics.
struct SliderSystem {
    static constexpr std::string_view kName = "sliders";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
