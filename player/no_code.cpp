#include "app/module.hpp"

// The player of projects without code of their own.

PLUMB_MODULE(module) { static_cast<void>(module); }
