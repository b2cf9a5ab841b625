#pragma once

// The physics library, for programs that use nothing else of the engine.

#include "physics/objects.hpp"
