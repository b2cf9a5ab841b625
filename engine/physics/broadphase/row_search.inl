// The searches through BoxRows; box_search.inl explains how this is compiled.

PLUMB_TARGET inline std::uint32_t overlapsAt(const BoxRows& rows, std::uint32_t place, const Wide& wide) {
    const auto& low = rows.low;
    return bitsOf(overlaps(&low[0][place], &low[1][place], &low[2][place], &low[3][place], wide));
}

constexpr std::uint32_t kMaxRowHits = 512;

PLUMB_TARGET inline void takeHits(const RowSearch& search, const std::uint32_t* hits, std::uint32_t hitCount,
                                  std::uint32_t first, std::vector<PairKey>& pairs) {
    const BoxRows& own = *search.own;
    const BoxRows& others = *search.others;
    const bool same = &own == &others;
    PairKey found[kMaxRowHits];
    std::size_t count = 0;
    for (std::uint32_t h = 0; h < hitCount; ++h) {
        const std::uint32_t i = search.lookers[hits[h] / 8 % 8];
        const std::uint32_t j = first + hits[h] / 64 * 8 + hits[h] % 8;
        const std::uint32_t a = own.ids[i];
        const std::uint32_t b = others.ids[j];
        // Of two moved proxies, only one reports the pair: in the same rows the one in the lower slot,
        // otherwise the one in the moving partition.
        const bool left = same ? j <= i : !search.ownMayBeAwake;
        const bool reported = left & (search.isMoved[b] != 0);
        const bool paired = search.allCanPair | ((own.states[i] | others.states[j]) == BoxRows::kAwake);
        found[count] = pairKey(a, b);
        const bool met = meet(own.filters[i], others.filters[j]);
        count += (paired & !reported & (a != b) & met) ? 1u : 0u;
    }
    pairs.insert(pairs.end(), found, found + count);
}

/// For each searching proxy the bits of those of eight slots that come after its own.
PLUMB_TARGET inline std::uint64_t laterPlaces(const RowSearch& search, std::uint32_t place) {
    std::uint64_t bits = 0;
    for (std::uint32_t i = 0; i < search.count; ++i) {
        const std::uint32_t behind = search.lookers[i] + 1;
        const std::uint32_t skipped = behind > place ? behind - place : 0;
        bits |= std::uint64_t{0xffu << (skipped < kBranch ? skipped : kBranch) & 0xff} << 8 * i;
    }
    return bits;
}

PLUMB_TARGET void findPairsInRows(const RowSearch& search, std::span<const Stretch> stretches,
                                  std::vector<PairKey>& pairs) {
    Wide boxes[RowSearch::kMaxLookers];
    for (std::uint32_t i = 0; i < search.count; ++i) boxes[i] = widen(search.own->boxAt(search.lookers[i]));
    const std::uint32_t last = search.lookers[search.count - 1];
    std::uint32_t hits[kMaxRowHits + kSpare];
    for (const Stretch& stretch : stretches) {
        std::uint32_t* end = hits;
        std::uint32_t first = stretch.begin;
        for (std::uint32_t place = first; place < stretch.end; place += kBranch) {
            const std::uint32_t left = stretch.end - place;
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

PLUMB_TARGET void findInRows(const BoxRows& rows, Stretch part, const AABB& box, const LineSweep* sweep,
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
