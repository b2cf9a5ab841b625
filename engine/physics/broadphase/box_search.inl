// What all searches for boxes share. box_searches.cpp includes this, tree_search.inl and row_search.inl once
// for each kind of processor, into a namespace of its own that has the functions of box_lanes.hpp, with
// PLUMB_TARGET. No includes, no lambdas, nothing from elsewhere that is not inlined: all of it must be
// compiled for that processor.
//
// How many boxes overlap is anybody's guess, and a wrong guess of the processor costs more than a test or
// two. So tests give bits, and bits become lists, with hardly a branch.

constexpr std::uint64_t kEachByte = 0x0101010101010101ull;
constexpr std::uint32_t kSpare = 3;  // of lists that are written to by fours

/// A box to compare eight with.
struct Wide {
    Floats high[4];  ///< m: right, bottom, -left, -top
};

PLUMB_TARGET inline Wide widen(const AABB& box) {
    return {{spread(box.max.x), spread(box.max.y), spread(-box.min.x), spread(-box.min.y)}};
}

/// Appends the places of the bits, plus `first`. Writes up to kSpare places more.
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
