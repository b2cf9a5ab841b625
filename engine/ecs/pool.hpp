#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "ecs/address_range.hpp"
#include "ecs/component_type.hpp"
#include "reflect/entity_id.hpp"

namespace plumb {

/// The position of one entity's component in a pool. `check` is the inverted generation of the entity:
/// a fresh page of zeros means "no component", and one load checks both presence and generation.
struct Slot {
    std::uint32_t check = 0;
    std::uint32_t position = 0;
};

/// Changes are tracked per block of 2^kStampShift components, which has no measurable cost.
inline constexpr std::uint32_t kStampShift = 8;

/// All components of one type: a sparse array from entity to position, the entities in order
/// of position, and the components in one column that never moves. Tags have no column.
///
/// A part of Storage, which keeps the invariants: for each position p below `count` that is not
/// a hole, sparse[dense[p]].position == p. Holes (dense == 0) exist only while a loop iterates.
struct Pool {
    /// An empty pool without capacity.
    Pool() = default;
    Pool(const ComponentType& componentType, std::uint32_t bitOrdinal, std::uint32_t maxEntities);

    Slot* sparse = nullptr;
    std::uint32_t* dense = nullptr;
    std::byte* column = nullptr;
    std::uint64_t* stamps = nullptr;  ///< per block: clock of the last write
    std::uint32_t count = 0;          ///< positions in use, including holes
    std::uint32_t stride = 0;         ///< bytes; 0 for tags
    std::uint32_t capacity = 0;       ///< positions for which memory is committed
    std::uint32_t indexCapacity = 0;  ///< entities for which the sparse array is committed
    std::uint64_t version = 1;        ///< see changes()
    std::uint64_t bit = 0;            ///< its bit in EntityRecord::mask; types beyond the 63rd share one bit
    std::uint32_t ordinal = 0;        ///< index in Storage::pools()
    std::uint32_t disorder = 0;       ///< changes since the last clustering
    const ComponentType* type = nullptr;
    std::vector<std::uint32_t> holes;  ///< positions of removed components

    [[nodiscard]] bool has(EntityId id) const {
        const Slot* const slots = sparse;  // read before any branch, so that loops load it only once
        return id.index < indexCapacity && slots[id.index].check == ~id.generation;
    }
    /// True if an entity with this index, of any generation, has this component.
    [[nodiscard]] bool holds(std::uint32_t index) const {
        return index < indexCapacity && sparse[index].check != 0;
    }
    /// Increases whenever the entity at any position changes. Adding increases `count`, so it does not
    /// have to write `version`; functions that decrease `count` increase `version` by more.
    [[nodiscard]] std::uint64_t changes() const { return version + count; }
    [[nodiscard]] std::uint32_t size() const { return count - static_cast<std::uint32_t>(holes.size()); }
    [[nodiscard]] std::byte* at(std::uint32_t position) const {
        return column + std::size_t{stride} * position;
    }

    /// Allocates memory if necessary, so that an entity with this index can be appended.
    void makeRoom(std::uint32_t index) {
        if (count == capacity || index >= indexCapacity) [[unlikely]]
            grow(index);
    }
    /// Appends a position for an entity that has none yet. @pre makeRoom(id.index)
    [[gnu::always_inline]] std::uint32_t append(EntityId id, std::uint64_t clock) {
        const std::uint32_t position = count;
        sparse[id.index].position = position;
        dense[position] = id.index;
        stamps[position >> kStampShift] = clock;
        count = position + 1;
        sparse[id.index].check = ~id.generation;
        return position;
    }

    /// Removes the component and moves the last one to its position.
    [[gnu::always_inline]] void erase(std::uint32_t index, std::uint32_t bytes, std::uint64_t clock) {
        const std::uint32_t position = sparse[index].position;
        const std::uint32_t last = --count;
        sparse[index] = {};
        if (position != last) {
            const std::uint32_t moved = dense[last];
            dense[position] = moved;
            sparse[moved].position = position;
            move(position, last, bytes);
            stamps[position >> kStampShift] = clock;
            ++disorder;
        }
        version += 2;
    }

    /// Removes the component and leaves a hole for `compact`.
    void punch(std::uint32_t index) {
        const std::uint32_t position = sparse[index].position;
        sparse[index] = {};
        dense[position] = 0;
        holes.push_back(position);
        ++version;
        ++disorder;
    }

    /// Fills the holes with components from the end.
    void compact(std::uint64_t clock);

    /// Records a write to `length` positions from `first` on.
    void stamp(std::uint32_t first, std::uint32_t length, std::uint64_t clock) const {
        std::uint64_t* const begin = stamps + (first >> kStampShift);
        std::uint64_t* const end = stamps + ((first + length - 1) >> kStampShift) + 1;
        for (std::uint64_t* block = begin; block != end; ++block) *block = clock;
    }
    [[nodiscard]] bool writtenSince(std::uint64_t mark) const;
    void stampAll(std::uint64_t clock) const {
        if (count > 0) stamp(0, count, clock);
    }

    /// Allocates memory for positions up to `positions` and entities up to `index`.
    void reserve(std::uint32_t positions, std::uint32_t index);

private:
    void move(std::uint32_t to, std::uint32_t from, std::uint32_t bytes) const {
        if (bytes == 8) {  // most components are small: faster than a call of memcpy
            std::memcpy(column + std::size_t{8} * to, column + std::size_t{8} * from, 8);
            return;
        }
        std::byte* target = column + std::size_t{bytes} * to;
        const std::byte* source = column + std::size_t{bytes} * from;
        const auto copy = [&](std::size_t length) {
            std::memcpy(target, source, length);
            target += length;
            source += length;
        };
        for (; bytes >= 16; bytes -= 16) copy(16);
        if ((bytes & 8u) != 0) copy(8);
        if ((bytes & 4u) != 0) copy(4);
        if ((bytes & 2u) != 0) copy(2);
        if ((bytes & 1u) != 0) copy(1);
    }
    void grow(std::uint32_t index);

    AddressRange memory_;
    std::uint32_t limit_ = 0;  // number of entities for which address space is reserved
    std::size_t sparseAt_ = 0, denseAt_ = 0, columnAt_ = 0;  // bytes into memory_, on huge page borders
};

}  // namespace plumb
