#define PLUMB_LANES_SCALAR
#include "physics/solver/kernels.inl"
