// Kernels for the architecture's baseline instruction set, even if other files are compiled for a wider one.
#define PLUMB_LANES_BASE
#include "physics/kernels.inl"

namespace plumb::physics {

const SolverKernels& baselineKernels = PLUMB_LANES::kKernels;

}  // namespace plumb::physics
