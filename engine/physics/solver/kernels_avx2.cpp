#include "physics/solver/kernels.inl"
#include "physics/solver/joint_kernels.inl"
