#pragma once

#include "platform/key.hpp"

namespace plumb {

/// Returns the key of a USB usage code (the same as SDL's scancode); Key::None for keys without a name.
Key keyFromUsage(int usage);

/// Returns the usage code of a key; 0 for Key::None.
int usageOf(Key key);

}  // namespace plumb
