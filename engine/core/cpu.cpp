#include "core/cpu.hpp"

#include <atomic>

#if defined(_MSC_VER) && defined(_M_X64)
#include <immintrin.h>
#include <intrin.h>
#endif

namespace plumb {

namespace {

#if defined(__x86_64__) && defined(__GNUC__)
bool cpuHasAvx2() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("popcnt");
}
#elif defined(_MSC_VER) && defined(_M_X64)
bool cpuHasAvx2() {
    int words[4];
    __cpuid(words, 1);
    constexpr int kAvxAndItsSwitch = 1 << 28 | 1 << 27;  // AVX; OSXSAVE: the system saves wide registers
    if ((words[2] & kAvxAndItsSwitch) != kAvxAndItsSwitch || (_xgetbv(0) & 6) != 6) return false;
    __cpuidex(words, 7, 0);
    return (words[1] & (1 << 5 | 1 << 3)) == (1 << 5 | 1 << 3);
}
#endif

SimdWidth widest() {
#if defined(__x86_64__) || defined(_M_X64)
    return cpuHasAvx2() ? SimdWidth::Avx2 : SimdWidth::Sse2;
#elif defined(__SSE2__)  // WebAssembly, whose compiler offers its instructions under these names
    return SimdWidth::Sse2;
#elif defined(__ARM_NEON) && defined(__aarch64__)
    return SimdWidth::Neon;
#else
    return SimdWidth::Scalar;
#endif
}

std::atomic<SimdWidth>& chosen() {
    static std::atomic<SimdWidth> width{widest()};
    return width;
}

}  // namespace

SimdWidth simdWidth() { return chosen().load(std::memory_order_relaxed); }

bool hasSimdWidth(SimdWidth width) {
    const SimdWidth best = widest();
    return width == SimdWidth::Scalar || width == best ||
           (best == SimdWidth::Avx2 && width == SimdWidth::Sse2);
}

bool setSimdWidth(SimdWidth width) {
    if (!hasSimdWidth(width)) return false;
    chosen().store(width, std::memory_order_relaxed);
    return true;
}

}  // namespace plumb
