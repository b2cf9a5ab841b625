#include "physics/kernels.hpp"

#include "core/cpu.hpp"

namespace plumb::physics {

#if defined(__x86_64__) || defined(_M_X64)
namespace sse2 {
extern const SolverKernels kKernels;
}
namespace avx2 {
extern const SolverKernels kKernels;
}
namespace baseline = sse2;
#elif defined(__aarch64__)
namespace neon {
extern const SolverKernels kKernels;
}
namespace baseline = neon;
#else
namespace scalar {
extern const SolverKernels kKernels;
}
namespace baseline = scalar;
#endif

const SolverKernels* scalarKernels = nullptr;

const SolverKernels& solverKernels() {
    switch (simdWidth()) {
#if defined(__x86_64__) || defined(_M_X64)
        case SimdWidth::Avx2: return avx2::kKernels;
#endif
        case SimdWidth::Scalar: return scalarKernels != nullptr ? *scalarKernels : baseline::kKernels;
        default: return baseline::kKernels;
    }
}

}  // namespace plumb::physics
