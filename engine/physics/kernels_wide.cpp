// The baseline instruction set of the architecture, even if all else is compiled for more (-march=native).
#define PLUMB_LANES_BASE
#include "physics/kernels.inl"
