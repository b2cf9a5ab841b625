#pragma once

#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

/// The library of this repository.
Engine plumbEngine();

}  // namespace plumb::scenes
