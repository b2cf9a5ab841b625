// The code of all searches for boxes. box_searches.cpp includes this file once per instruction set, each time
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

/// Appends `first` + i for each set bit i; returns the new end. Writes up to kSpare entries beyond it.
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

/// Returns the lanes whose boxes overlap `wide`. Each pointer refers to one side of eight boxes.
PLUMB_TARGET inline Mask overlaps(const float* left, const float* top, const float* right,
                                  const float* bottom, const Wide& wide) {
    return (load(left) <= wide.high[0]) & (load(right) <= wide.high[2]) & (load(top) <= wide.high[1]) &
           (load(bottom) <= wide.high[3]);
}

// BoxRows.

PLUMB_TARGET inline std::uint32_t overlapsAt(const BoxRows& rows, std::uint32_t place, const Wide& wide) {
    const auto& low = rows.low;
    return bitsOf(overlaps(&low[0][place], &low[1][place], &low[2][place], &low[3][place], wide));
}

constexpr std::uint32_t kMaxRowHits = 512;  // capacity of the list of hits that takeHits() empties

PLUMB_TARGET inline void takeHits(const RowSearch& search, const std::uint32_t* hits, std::uint32_t hitCount,
                                  std::uint32_t first, std::vector<PairKey>& pairs) {
    const BoxRows& own = *search.own;
    const BoxRows& others = *search.others;
    const bool same = &own == &others;
    PairKey found[kMaxRowHits];
    std::size_t count = 0;
    for (std::uint32_t h = 0; h < hitCount; ++h) {
        const std::uint32_t i = search.searchers[hits[h] / 8 % 8];
        const std::uint32_t j = first + hits[h] / 64 * 8 + hits[h] % 8;
        const std::uint32_t a = own.ids[i];
        const std::uint32_t b = others.ids[j];
        // Of two moved proxies, only one reports the pair: in the same rows the one in the lower slot,
        // otherwise the one in the moving partition.
        const bool left = same ? j <= i : !search.ownMayBeAwake;
        const bool reported = left & (search.isMoved[b] != 0);
        const bool paired = search.allCanPair | ((own.states[i] | others.states[j]) == BoxRows::kAwake);
        found[count] = pairKey(a, b);
        const bool collide = mayCollide(own.filters[i], others.filters[j]);
        count += (paired & !reported & (a != b) & collide) ? 1u : 0u;
    }
    pairs.insert(pairs.end(), found, found + count);
}

/// One byte per searching proxy: a bit for each of the eight slots from `place` on that follows its own slot.
PLUMB_TARGET inline std::uint64_t laterPlaces(const RowSearch& search, std::uint32_t place) {
    std::uint64_t bits = 0;
    for (std::uint32_t i = 0; i < search.count; ++i) {
        const std::uint32_t behind = search.searchers[i] + 1;
        const std::uint32_t skipped = behind > place ? behind - place : 0;
        bits |= std::uint64_t{0xffu << (skipped < kBranch ? skipped : kBranch) & 0xff} << 8 * i;
    }
    return bits;
}

PLUMB_TARGET void findPairsInRows(const RowSearch& search, std::span<const SlotRange> ranges,
                                  std::vector<PairKey>& pairs) {
    Wide boxes[RowSearch::kMaxLookers];
    for (std::uint32_t i = 0; i < search.count; ++i) boxes[i] = widen(search.own->boxAt(search.searchers[i]));
    const std::uint32_t last = search.searchers[search.count - 1];
    std::uint32_t hits[kMaxRowHits + kSpare];
    for (const SlotRange& range : ranges) {
        std::uint32_t* end = hits;
        std::uint32_t first = range.begin;
        for (std::uint32_t place = first; place < range.end; place += kBranch) {
            const std::uint32_t left = range.end - place;
            std::uint64_t bits = 0;
            for (std::uint32_t i = 0; i < search.count; ++i)
                bits |= std::uint64_t{overlapsAt(*search.others, place, boxes[i])} << 8 * i;
            if (left < kBranch) bits &= ((1u << left) - 1) * kEachByte;
            if (search.onlyLater && place <= last) bits &= laterPlaces(search, place);
            end = appendBits(bits, (place - first) * 8, end);
            if (end > hits + kMaxRowHits - kBranch * kBranch) {
                takeHits(search, hits, static_cast<std::uint32_t>(end - hits), first, pairs);
                end = hits;
            }
        }
        takeHits(search, hits, static_cast<std::uint32_t>(end - hits), first, pairs);
    }
}

PLUMB_TARGET void findInRows(const BoxRows& rows, SlotRange part, const AABB& box, const LineSweep* sweep,
                             std::uint32_t mask, std::vector<std::uint32_t>& found) {
    const Wide wide = widen(box);
    for (std::uint32_t place = part.begin; place < part.end; place += kBranch) {
        const std::uint32_t left = part.end - place;
        std::uint32_t hits = overlapsAt(rows, place, wide) & (left < kBranch ? (1u << left) - 1 : 0xff);
        for (; hits != 0; hits &= hits - 1) {
            const std::uint32_t i = place + static_cast<std::uint32_t>(std::countr_zero(hits));
            if ((rows.filters[i].layers & mask) == 0) continue;
            if (sweep == nullptr || mayCollide(*sweep, rows.boxAt(i))) found.push_back(rows.ids[i]);
        }
    }
}

// Bvh8.

constexpr std::uint32_t kChunk = 8;                // nodes whose children are tested together
constexpr std::uint32_t kMaxChildren = kChunk * kBranch;  // children of kChunk nodes
constexpr std::uint32_t kMany = 12;  // with more children, the lanes are split into two groups
constexpr std::uint32_t kMaxHits =
    kMaxChildren * kBranch > kMany* kBranch* kBranch ? kMaxChildren* kBranch : kMany* kBranch* kBranch;

/// A box and filters for comparison with eight others.
struct WideProbe {
    Wide box;
    FilterUnion filters;
};

/// A sweep, broadcast for comparison with eight boxes.
struct WideSweep {
    Wide bounds;
    Floats from[2];
    Floats displacement[2];
    Floats reach[2];
};

/// The union of the boxes and filters of some lanes of a leaf.
PLUMB_TARGET inline WideProbe widenLanes(const TreeLeaf& leaf, std::uint32_t lanes) {
    AABB box = kNowhere;
    FilterUnion filters;
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        box = merged(box, leaf.boxes.at(i));
        filters.add(leaf.filters[i]);
    }
    return {widen(box), filters};
}

PLUMB_TARGET inline Mask overlaps(const TreeBoxes& boxes, const Wide& wide) {
    return overlaps(boxes.low[0], boxes.low[1], boxes.low[2], boxes.low[3], wide);
}

PLUMB_TARGET inline std::uint32_t mayCollide(const TreeNode& node, const WideProbe& probe) {
    return bitsOf(haveCommon(node.layers, probe.filters.masks) &
                  haveCommon(node.masks, probe.filters.layers) & overlaps(node.boxes, probe.box));
}

/// Returns the lanes of a leaf that do not search.
PLUMB_TARGET inline std::uint32_t unmovedLanes(const TreeLeaf& leaf, const std::uint8_t* isMoved) {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kBranch; ++i)
        bits |= static_cast<std::uint32_t>(isMoved[leaf.ids[i]] == 0) << i;
    return bits & leaf.live;
}

/// The searching lanes of a leaf: their boxes and, in 64 bits (one byte per searching lane), the bits of the
/// eight lanes of another leaf that each may report.
struct Lookers {
    Wide boxes[kBranch];
    std::uint32_t lanes[kBranch];
    std::uint32_t count = 0;
    std::uint64_t all = 0;     ///< per byte: 0xff if the lane pairs with all lanes, 0 if only with awake ones
    std::uint64_t later = 0;   ///< per byte: the lanes after the searching lane in its own leaf
    std::uint64_t others = 0;  ///< per byte: all lanes except the searching lane
};

PLUMB_TARGET inline void collectLookers(const TreeSearch& search, std::uint32_t lanes, Lookers& searchers) {
    const TreeLeaf& own = search.own->leaves()[search.leaf];
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(lanes));
        const std::uint32_t shift = 8 * searchers.count;
        searchers.all |= std::uint64_t{search.allCanPair | (own.awake >> i & 1u)} * 0xff << shift;
        searchers.later |= std::uint64_t{0xfeu << i & 0xff} << shift;
        searchers.others |= std::uint64_t{~(1u << i) & 0xff} << shift;
        searchers.boxes[searchers.count] = widen(own.boxes.at(i));
        searchers.lanes[searchers.count++] = i;
    }
}

/// One byte per searching lane: the lanes of `leaf` that it reports. Of two searching lanes only one reports.
PLUMB_TARGET inline std::uint64_t openLanes(const TreeSearch& search, const Lookers& searchers,
                                            std::uint32_t leaf) {
    const bool same = search.own == search.others;
    if (same ? leaf > search.leaf : search.ownMayBeAwake) return ~std::uint64_t{0};
    const std::uint64_t unmoved = unmovedLanes(search.others->leaves()[leaf], search.isMoved) * kEachByte;
    return same && leaf == search.leaf ? (unmoved | searchers.later) & searchers.others : unmoved;
}

/// Appends the pairs of the searching lanes with the lanes of the candidate leaves.
PLUMB_TARGET inline void testLeaves(const TreeSearch& search, std::uint32_t lanes,
                                    std::span<const std::uint32_t> candidates, std::vector<PairKey>& pairs) {
    const TreeLeaf& own = search.own->leaves()[search.leaf];
    const TreeLeaf* leaves = search.others->leaves();
    Lookers searchers;
    collectLookers(search, lanes, searchers);
    std::uint32_t hits[kMaxHits + kSpare];  // 6 bits: index of the candidate, 3 bits: index of the searching
                                            // lane, 3 bits: lane
    std::uint32_t* end = hits;
    for (std::uint32_t c = 0; c < candidates.size(); ++c) {
        const std::uint64_t open = openLanes(search, searchers, candidates[c]);
        if (open == 0) continue;
        const TreeLeaf& leaf = leaves[candidates[c]];
        std::uint64_t bits = 0;
        for (std::uint32_t i = 0; i < searchers.count; ++i)
            bits |= std::uint64_t{bitsOf(overlaps(leaf.boxes, searchers.boxes[i]))} << 8 * i;
        end = appendBits(bits & open & (leaf.awake * kEachByte | searchers.all), c * 64, end);
    }
    PairKey found[kMaxHits];
    std::size_t count = 0;
    for (const std::uint32_t* hit = hits; hit != end; ++hit) {
        const std::uint32_t i = searchers.lanes[*hit / 8 % 8];
        const std::uint32_t j = *hit % 8;
        const TreeLeaf& leaf = leaves[candidates[*hit / 64]];
        found[count] = pairKey(own.ids[i], leaf.ids[j]);
        count += mayCollide(own.filters[i], leaf.filters[j]) ? 1u : 0u;
    }
    pairs.insert(pairs.end(), found, found + count);
}

/// Descends from some nodes of a level to the leaves in which the lanes may have partners.
PLUMB_TARGET void findPairsBelow(const TreeSearch& search, std::uint32_t lanes, const WideProbe& probe,
                                 std::uint32_t level, std::span<const std::uint32_t> nodes,
                                 std::vector<PairKey>& pairs) {
    const TreeNode* all = search.others->level(level);
    std::uint32_t children[kMaxChildren + kSpare];
    for (std::size_t first = 0; first < nodes.size(); first += kChunk) {
        const auto chunk =
            nodes.subspan(first, nodes.size() - first < kChunk ? nodes.size() - first : kChunk);
        std::uint32_t* end = children;
        for (const std::uint32_t node : chunk)
            end = appendBits(mayCollide(all[node], probe), node * kBranch, end);
        const std::span<const std::uint32_t> found{children, end};
        if (found.size() > kMany && (lanes & (lanes - 1)) != 0) {
            const TreeLeaf& own = search.own->leaves()[search.leaf];
            std::uint32_t upper = lanes;
            for (int i = std::popcount(lanes) / 2; i > 0; --i) upper &= upper - 1;
            const std::uint32_t lower = lanes & ~upper;
            findPairsBelow(search, upper, widenLanes(own, upper), level, chunk, pairs);
            findPairsBelow(search, lower, widenLanes(own, lower), level, chunk, pairs);
        } else if (found.empty()) {
            continue;
        } else if (level > 0) {
            findPairsBelow(search, lanes, probe, level - 1, found, pairs);
        } else {
            testLeaves(search, lanes, found, pairs);
        }
    }
}

PLUMB_TARGET void findPairsOfLeaf(const TreeSearch& search, std::vector<PairKey>& pairs) {
    const std::uint32_t root = 0;
    const WideProbe probe = widenLanes(search.own->leaves()[search.leaf], search.lanes);
    findPairsBelow(search, search.lanes, probe, search.others->height() - 1, {&root, 1}, pairs);
}

PLUMB_TARGET inline std::uint32_t hitsOf(const TreeBoxes& boxes, const Wide& wide) {
    return bitsOf(overlaps(boxes, wide));
}

/// Returns the lanes that the sweep may hit, by the same test as mayCollide(LineSweep, AABB).
PLUMB_TARGET inline std::uint32_t hitsOf(const TreeBoxes& boxes, const WideSweep& sweep) {
    const std::uint32_t near = bitsOf(overlaps(boxes, sweep.bounds));
    if (near == 0) return 0;
    Floats off[2];
    Floats half[2];
    for (int axis = 0; axis < 2; ++axis) {
        const Floats low = load(boxes.low[axis]) * spread(0.5f);
        const Floats high = load(boxes.low[axis + 2]) * spread(-0.5f);
        const Floats middle = low + high;
        off[axis] = middle - sweep.from[axis];
        half[axis] = high - low + sweep.reach[axis] + absolute(middle) * spread(2.0f * kRounding);
    }
    const Floats distance = absolute(sweep.displacement[0] * off[1] - sweep.displacement[1] * off[0]);
    const Floats reach =
        absolute(sweep.displacement[0]) * half[1] + absolute(sweep.displacement[1]) * half[0];
    return near & ~bitsOf(distance > reach);
}

/// Appends the proxies below some nodes of a level that the view (a box or a sweep) may hit.
template <class View>
PLUMB_TARGET void findBelow(const Bvh8& tree, const View& view, std::uint32_t mask, std::uint32_t level,
                            std::span<const std::uint32_t> nodes, std::vector<std::uint32_t>& found) {
    const TreeNode* all = tree.level(level);
    for (const std::uint32_t node : nodes) {
        std::uint32_t near = hitsOf(all[node].boxes, view);
        if (near != 0) near &= bitsOf(haveCommon(all[node].layers, mask));
        if (level > 0) {
            std::uint32_t children[kBranch + kSpare];
            const std::uint32_t* end = appendBits(near, node * kBranch, children);
            findBelow(tree, view, mask, level - 1, {children, end}, found);
            continue;
        }
        for (; near != 0; near &= near - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
            const TreeLeaf& leaf = tree.leaves()[node * kBranch + lane];
            for (std::uint32_t hits = hitsOf(leaf.boxes, view); hits != 0; hits &= hits - 1) {
                const int i = std::countr_zero(hits);
                if ((leaf.filters[i].layers & mask) != 0) found.push_back(leaf.ids[i]);
            }
        }
    }
}

PLUMB_TARGET void findInTree(const Bvh8& tree, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
                             std::vector<std::uint32_t>& found) {
    const std::uint32_t root = 0;
    if (sweep == nullptr) return findBelow(tree, widen(box), mask, tree.height() - 1, {&root, 1}, found);
    const WideSweep wide{widen(box),
                         {spread(sweep->from.x), spread(sweep->from.y)},
                         {spread(sweep->displacement.x), spread(sweep->displacement.y)},
                         {spread(sweep->half.x), spread(sweep->half.y)}};
    findBelow(tree, wide, mask, tree.height() - 1, {&root, 1}, found);
}

constexpr BoxSearches kSearches{&findPairsOfLeaf, &findPairsInRows, &findInTree, &findInRows};
