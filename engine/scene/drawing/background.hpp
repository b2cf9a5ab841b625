#pragma once

#include "math/color.hpp"

namespace plumb {

/// Background color of a world without scenes; scene files define their own. A world resource.
struct Background {
    Color color{0, 0, 0, 255};
};

}  // namespace plumb
