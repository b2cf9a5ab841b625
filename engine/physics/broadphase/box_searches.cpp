#include "physics/broadphase/box_searches.hpp"

#include <bit>
#include <span>

#include "physics/broadphase/box_lanes.hpp"

namespace plumb::physics {

namespace boxes_scalar {
namespace {
#define PLUMB_TARGET
#include "physics/broadphase/box_search.inl"
#include "physics/broadphase/row_search.inl"
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
constexpr BoxSearches kSearches{{&findPairsOfLeaf, &findInTree, &findOnSweep},
                                {&findPairsInRows, &findInRows, &findCells}};
}  // namespace
}  // namespace boxes_scalar

#if defined(PLUMB_HAS_SSE2)
namespace boxes_sse2 {
namespace {
#define PLUMB_TARGET
#include "physics/broadphase/box_search.inl"
#include "physics/broadphase/row_search.inl"
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
constexpr BoxSearches kSearches{{&findPairsOfLeaf, &findInTree, &findOnSweep},
                                {&findPairsInRows, &findInRows, &findCells}};
}  // namespace
}  // namespace boxes_sse2
namespace boxes_avx2 {
namespace {
#define PLUMB_TARGET PLUMB_AVX2
#include "physics/broadphase/box_search.inl"
#include "physics/broadphase/row_search.inl"
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
constexpr BoxSearches kSearches{{&findPairsOfLeaf, &findInTree, &findOnSweep},
                                {&findPairsInRows, &findInRows, &findCells}};
}  // namespace
}  // namespace boxes_avx2
#endif

#if defined(PLUMB_HAS_NEON)
namespace boxes_neon {
namespace {
#define PLUMB_TARGET
#include "physics/broadphase/box_search.inl"
#include "physics/broadphase/row_search.inl"
#include "physics/broadphase/tree_search.inl"
#undef PLUMB_TARGET
constexpr BoxSearches kSearches{{&findPairsOfLeaf, &findInTree, &findOnSweep},
                                {&findPairsInRows, &findInRows, &findCells}};
}  // namespace
}  // namespace boxes_neon
#endif

const BoxSearches& boxSearchesFor(SimdWidth width) {
#if defined(PLUMB_HAS_SSE2)
    if (width == SimdWidth::Avx2) return boxes_avx2::kSearches;
    if (width == SimdWidth::Sse2) return boxes_sse2::kSearches;
#elif defined(PLUMB_HAS_NEON)
    if (width == SimdWidth::Neon) return boxes_neon::kSearches;
#endif
    static_cast<void>(width);
    return boxes_scalar::kSearches;
}

}  // namespace plumb::physics
