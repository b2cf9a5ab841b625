// What all searches for boxes share. box_searches.cpp includes this file once per instruction set, each time
// into a namespace of its own, with PLUMB_TARGET and the operations on eight floats defined. No includes, no
// lambdas, no calls that are not inlined: all of this code must be compiled for that instruction set.
//
// How many boxes overlap is unpredictable, and a mispredicted branch costs more than a few tests. So tests
// produce bits, and bits become lists, nearly without branches.

constexpr std::uint64_t kEachByte = 0x0101010101010101ull;
constexpr std::uint32_t kSpare = 3;  // spare entries at the end of lists that are written in groups of four

/// A box, broadcast for comparison with eight others.
struct Wide {
    Floats high[4];  ///< m: right, bottom, -left, -top
};

PLUMB_TARGET inline Wide widen(const AABB& box) {
    return {{spread(box.max.x), spread(box.max.y), spread(-box.min.x), spread(-box.min.y)}};
}

/// Appends the index of each set bit, plus `first`. Writes up to kSpare entries beyond the end.
PLUMB_TARGET inline std::uint32_t* appendBits(std::uint64_t bits, std::uint32_t first, std::uint32_t* to) {
    const int count = std::popcount(bits);
    for (int done = 0; done < count; done += 4) {
        for (int i = 0; i < 4; ++i) {
            to[done + i] = first + static_cast<std::uint32_t>(std::countr_zero(bits));
            bits &= bits - 1;
        }
    }
    return to + count;
}

/// The lanes whose boxes, of which each side has eight floats, overlap.
PLUMB_TARGET inline Mask overlaps(const float* left, const float* top, const float* right,
                                  const float* bottom, const Wide& wide) {
    return (load(left) <= wide.high[0]) & (load(right) <= wide.high[2]) & (load(top) <= wide.high[1]) &
           (load(bottom) <= wide.high[3]);
}

#include "physics/broadphase/row_search.inl"
#include "physics/broadphase/tree_search.inl"

constexpr BoxSearches kSearches{&findPairsOfLeaf, &findPairsInRows, &findInTree, &findInRows};
