#define PLUMB_LANES_SCALAR
#include "physics/kernels.inl"

namespace plumb::physics {

void linkScalarKernels() { scalarKernels = &scalar::kKernels; }

}  // namespace plumb::physics
