#include "app/module.hpp"

// Code of the player for projects without C++ code: registers no components or systems.

PLUMB_MODULE(module) { static_cast<void>(module); }
