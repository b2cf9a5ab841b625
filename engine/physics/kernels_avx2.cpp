#include "physics/kernels.inl"
