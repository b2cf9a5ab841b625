#pragma once

#include "platform/key.hpp"

namespace plumb {

/// Our key for a USB usage code (SDL's scancodes are these); Key::None for keys without a name.
Key keyFromUsage(int usage);

}  // namespace plumb
