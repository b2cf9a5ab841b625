#pragma once

#include <cstddef>

#include "physics/world.hpp"

namespace plumb::physics {

/// What a snapshot of the world copies, in bytes.
[[nodiscard]] std::size_t stateBytes(const World& world);

}  // namespace plumb::physics
