// What every machine of the kind has, also where all is compiled for one that has more (-march=native).
#define PLUMB_LANES_BASE
#include "physics/solver/kernels.inl"
// (after the other, which it builds on)
#include "physics/solver/joint_kernels.inl"
