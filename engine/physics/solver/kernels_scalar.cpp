#define PLUMB_LANES_SCALAR
#include "physics/solver/kernels.inl"
#include "physics/solver/joint_kernels.inl"
