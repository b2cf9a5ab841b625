#include "physics/solver/kernels.inl"
