#include "physics/solver/kernels.hpp"

#include "core/cpu.hpp"

namespace plumb::physics {

namespace scalar {
extern const SolverKernels kKernels;
}
#if defined(__x86_64__) || defined(_M_X64)
namespace sse2 {
extern const SolverKernels kKernels;
}
namespace avx2 {
extern const SolverKernels kKernels;
}
#elif defined(__aarch64__)
namespace neon {
extern const SolverKernels kKernels;
}
#endif

const SolverKernels& solverKernels() {
    switch (simdWidth()) {
#if defined(__x86_64__) || defined(_M_X64)
        case SimdWidth::Avx2: return avx2::kKernels;
        case SimdWidth::Sse2: return sse2::kKernels;
#elif defined(__aarch64__)
        case SimdWidth::Neon: return neon::kKernels;
#endif
        default: return scalar::kKernels;
    }
}

}  // namespace plumb::physics
