#include "ecs/pool.hpp"

#include <algorithm>

#include "core/assert.hpp"
#include "core/os.hpp"

namespace plumb {

namespace {

constexpr std::uint32_t kFirstCapacity = 1u << 14;
constexpr std::size_t kColourSpan = 16384;  // bytes

/// Offset of an array. Columns that start at the same offset in a page compete for
/// the same cache lines; so each array of each pool starts at a different offset.
std::size_t colour(std::uint32_t array) { return (array * std::size_t{1088}) % kColourSpan / 64 * 64; }

std::size_t rounded(std::size_t bytes) {
    const std::size_t step = os::memoryStep();
    return (bytes + kColourSpan + step - 1) / step * step;
}

}  // namespace

Pool::Pool(const ComponentType& componentType, std::uint32_t bitOrdinal, std::uint32_t maxEntities)
    : stride{static_cast<std::uint32_t>(componentType.info.size)},
      bit{std::uint64_t{1} << std::min(bitOrdinal, 63u)},
      ordinal{bitOrdinal},
      type{&componentType} {
    for (limit_ = maxEntities; limit_ >= kFirstCapacity && !memory_.ok(); limit_ /= 2) {
        const std::size_t blocks = (limit_ >> kStampShift) + 1;
        sparseAt_ = rounded(blocks * sizeof(std::uint64_t));  // the stamps come first
        denseAt_ = sparseAt_ + rounded(limit_ * sizeof(Slot));
        columnAt_ = denseAt_ + rounded(limit_ * sizeof(std::uint32_t));
        memory_ = AddressRange{columnAt_ + rounded(std::size_t{limit_} * stride)};
        if (memory_.ok()) break;
    }
    if (!memory_.ok()) failAssertion("not enough address space for a component pool", __FILE__, __LINE__);
    memory_.commit(0, sparseAt_);
    stamps = reinterpret_cast<std::uint64_t*>(memory_.start() + colour(ordinal * 4));
    sparse = reinterpret_cast<Slot*>(memory_.start() + sparseAt_ + colour(ordinal * 4 + 1));
    dense = reinterpret_cast<std::uint32_t*>(memory_.start() + denseAt_ + colour(ordinal * 4 + 2));
    column = memory_.start() + columnAt_ + colour(ordinal * 4 + 3);
}

void Pool::reserve(std::uint32_t positions, std::uint32_t index) {
    if (positions > limit_ || index >= limit_) {
        failAssertion("too many entities: the address space of a component pool is used up", __FILE__,
                      __LINE__);
    }
    const auto steps = [this](std::uint32_t from, std::uint32_t wanted) {
        std::uint32_t to = std::max(from, kFirstCapacity);
        while (to < wanted) to = to > limit_ / 4 ? limit_ : to * 4;
        return std::min(to, limit_);
    };
    bool given = true;
    if (positions > capacity) {
        capacity = steps(capacity, positions);
        given = memory_.commit(denseAt_, kColourSpan + capacity * sizeof(std::uint32_t));
        given = memory_.commit(columnAt_, kColourSpan + std::size_t{capacity} * stride) && given;
    }
    if (index >= indexCapacity) {
        indexCapacity = steps(indexCapacity, index + 1);
        given = memory_.commit(sparseAt_, kColourSpan + indexCapacity * sizeof(Slot)) && given;
    }
    if (!given) failAssertion("out of memory", __FILE__, __LINE__);
}

void Pool::grow(std::uint32_t index) { reserve(count + 1, index); }

bool Pool::writtenSince(std::uint64_t mark) const {
    const std::uint32_t blocks = (count + (1u << kStampShift) - 1) >> kStampShift;
    return std::any_of(stamps, stamps + blocks, [mark](std::uint64_t stamp) { return stamp > mark; });
}

void Pool::compact(std::uint64_t clock) {
    if (holes.empty()) return;
    if (!std::is_sorted(holes.begin(), holes.end())) std::sort(holes.begin(), holes.end());
    std::uint32_t end = count;
    for (const std::uint32_t hole : holes) {
        while (end > 0 && dense[end - 1] == 0) --end;
        if (hole >= end) break;
        --end;
        const std::uint32_t moved = dense[end];
        dense[hole] = moved;
        sparse[moved].position = hole;
        move(hole, end, stride);
        stamps[hole >> kStampShift] = clock;
    }
    while (end > 0 && dense[end - 1] == 0) --end;
    version += count - end + 1;
    count = end;
    holes.clear();
}

}  // namespace plumb
