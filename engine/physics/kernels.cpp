#include "physics/kernels.hpp"

#include "core/cpu.hpp"

namespace plumb::physics {

#if defined(__x86_64__) || defined(_M_X64)
namespace avx2 {
extern const SolverKernels kKernels;
}
#endif
extern const SolverKernels& baselineKernels;  // kernels_wide.cpp

const SolverKernels* scalarKernels = nullptr;

const SolverKernels& solverKernels() {
    switch (simdWidth()) {
#if defined(__x86_64__) || defined(_M_X64)
        case SimdWidth::Avx2: return avx2::kKernels;
#endif
        case SimdWidth::Scalar: return scalarKernels != nullptr ? *scalarKernels : baselineKernels;
        default: return baselineKernels;
    }
}

}  // namespace plumb::physics
