#pragma once

#include "math/color.hpp"

namespace plumb {

/// The color behind everything in a world without scenes; a scene's file has its own. A resource.
struct Background {
    Color color{0, 0, 0, 255};
};

}  // namespace plumb
