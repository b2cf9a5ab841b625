#pragma once

#include <cstdint>

namespace plumb {

/// Shape of a change over time. In: starts slowly; Out: ends slowly; InOut: both. Back exceeds the end and
/// returns, Elastic swings about it, Bounce falls onto it. Source: R. Penner, "Programming Macromedia Flash
/// MX", 2002.
enum class Ease : std::uint8_t {
    Linear,
    QuadIn,
    QuadOut,
    QuadInOut,
    CubicIn,
    CubicOut,
    CubicInOut,
    SineIn,
    SineOut,
    SineInOut,
    BackIn,
    BackOut,
    BackInOut,
    ElasticOut,
    BounceOut
};

/// Returns the progress of a change after a part of its time, with the same bits on every machine.
/// @param time  ratio, limited to 0..1
/// @return 0 at the start and 1 at the end, exactly
float eased(Ease ease, float time);

}  // namespace plumb
