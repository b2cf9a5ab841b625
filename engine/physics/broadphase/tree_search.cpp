#include "physics/broadphase/tree_search.hpp"

#include <bit>
#include <span>

#include "physics/broadphase/box_lanes.hpp"

namespace plumb::physics {

namespace boxes_scalar {
namespace {
#define PLUMB_TARGET
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
}  // namespace
}  // namespace boxes_scalar

#if defined(PLUMB_HAS_SSE2)
namespace boxes_sse2 {
namespace {
#define PLUMB_TARGET
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
}  // namespace
}  // namespace boxes_sse2
namespace boxes_avx2 {
namespace {
#define PLUMB_TARGET PLUMB_AVX2
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
}  // namespace
}  // namespace boxes_avx2
#endif

#if defined(PLUMB_HAS_NEON)
namespace boxes_neon {
namespace {
#define PLUMB_TARGET
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
}  // namespace
}  // namespace boxes_neon
#endif

const TreeSearch& treeSearchFor(SimdWidth width) {
#if defined(PLUMB_HAS_SSE2)
    if (width == SimdWidth::Avx2) return boxes_avx2::kSearch;
    if (width == SimdWidth::Sse2) return boxes_sse2::kSearch;
#elif defined(PLUMB_HAS_NEON)
    if (width == SimdWidth::Neon) return boxes_neon::kSearch;
#endif
    static_cast<void>(width);
    return boxes_scalar::kSearch;
}

}  // namespace plumb::physics
