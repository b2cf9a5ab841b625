#include "physics/solver/kernels.hpp"

#include "core/cpu.hpp"
#include "physics/solver/joint_kernels.hpp"

namespace plumb::physics {

namespace scalar {
extern const SolverKernels kKernels;
extern const JointKernels kJointKernels;
}  // namespace scalar
#if defined(__x86_64__) || defined(_M_X64)
namespace sse2 {
extern const SolverKernels kKernels;
extern const JointKernels kJointKernels;
}  // namespace sse2
namespace avx2 {
extern const SolverKernels kKernels;
extern const JointKernels kJointKernels;
}  // namespace avx2
#elif defined(__aarch64__)
namespace neon {
extern const SolverKernels kKernels;
extern const JointKernels kJointKernels;
}  // namespace neon
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

const JointKernels& jointKernels() {
    switch (simdWidth()) {
#if defined(__x86_64__) || defined(_M_X64)
        case SimdWidth::Avx2: return avx2::kJointKernels;
        case SimdWidth::Sse2: return sse2::kJointKernels;
#elif defined(__aarch64__)
        case SimdWidth::Neon: return neon::kJointKernels;
#endif
        default: return scalar::kJointKernels;
    }
}

}  // namespace plumb::physics
