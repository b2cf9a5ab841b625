#include "script/script_arena.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <vector>

#include "core/assert.hpp"

namespace plumb {

ScriptArena& ScriptArena::instance() {
    static ScriptArena arena;
    return arena;
}

ScriptArena::ScriptArena() : memory_{kBytes} {
    if (!memory_.ok()) failAssertion("not enough address space for scripts", __FILE__, __LINE__);
    clear();
}

void ScriptArena::clear() {
    constexpr std::size_t kFirst = (sizeof(Header) + kStep - 1) / kStep * kStep;
    if (!grow(kFirst)) failAssertion("out of memory", __FILE__, __LINE__);
    std::construct_at(&header());
    header().used = kFirst;
}

void ScriptArena::load(std::span<const std::byte> content) {
    PLUMB_ASSERT(content.size() >= sizeof(Header) && content.size() <= kBytes, "not the content of an arena");
    if (!grow(content.size())) failAssertion("out of memory", __FILE__, __LINE__);
    std::memcpy(start(), content.data(), content.size());
}

/// Makes memory usable up to this size.
bool ScriptArena::grow(std::size_t used) {
    constexpr std::size_t kPart = std::size_t{256} << 10;  // bytes
    if (used > kBytes) return false;
    if (used <= committed_) return true;
    const std::size_t wanted = std::min((used + kPart - 1) / kPart * kPart, kBytes);
    if (!memory_.commit(committed_, wanted - committed_)) return false;
    committed_ = wanted;
    return true;
}

std::size_t ScriptArena::sizeClass(std::size_t bytes) {
    if (bytes <= kSmall) return (bytes + kStep - 1) / kStep - 1;
    return kSmallSizes + static_cast<std::size_t>(std::bit_width((bytes - 1) / kSmall)) - 1;
}

std::size_t ScriptArena::sizeOf(std::size_t sizeClass) {
    return sizeClass < kSmallSizes ? (sizeClass + 1) * kStep : kSmall << (sizeClass - kSmallSizes + 1);
}

void* ScriptArena::take(std::size_t sizeClass) {
    std::uint32_t& first = header().free[sizeClass];
    if (first != 0) {
        std::byte* block = start() + first;
        std::memcpy(&first, block, sizeof first);
        return block;
    }
    const std::size_t at = header().used;
    if (!grow(at + sizeOf(sizeClass))) return takePart(sizeClass);
    header().used = at + sizeOf(sizeClass);
    return start() + at;
}

/// The largest class of blocks that are not larger.
std::size_t ScriptArena::classWithin(std::size_t bytes) {
    if (bytes <= kSmall) return bytes / kStep - 1;
    return kSmallSizes + static_cast<std::size_t>(std::bit_width(bytes / kSmall)) - 2;
}

/// Takes a part of a larger block that was freed.
void* ScriptArena::takePart(std::size_t sizeClass) {
    for (std::size_t larger = sizeClass + 1; larger < kSizes; ++larger) {
        if (header().free[larger] == 0) continue;
        std::byte* block = static_cast<std::byte*>(take(larger));
        const auto begin = static_cast<std::size_t>(block - start());
        giveRange(begin + sizeOf(sizeClass), begin + sizeOf(larger));
        return block;
    }
    return nullptr;
}

/// Frees a range of offsets, as blocks that are as large as possible.
void ScriptArena::giveRange(std::size_t begin, std::size_t end) {
    while (begin < end) {
        const std::size_t sizeClass = classWithin(end - begin);
        give(start() + begin, sizeClass);
        begin += sizeOf(sizeClass);
    }
}

void ScriptArena::joinFreed() {
    std::vector<bool> isFree(header().used / kStep);  // each step of the arena
    for (std::size_t sizeClass = 0; sizeClass < kSizes; ++sizeClass) {
        const std::size_t steps = sizeOf(sizeClass) / kStep;
        for (std::uint32_t at = header().free[sizeClass]; at != 0; std::memcpy(&at, start() + at, sizeof at))
            std::fill_n(isFree.begin() + static_cast<std::ptrdiff_t>(at / kStep), steps, true);
    }
    header().free = {};
    for (auto begin = std::find(isFree.begin(), isFree.end(), true); begin != isFree.end();) {
        const auto end = std::find(begin, isFree.end(), false);
        const auto offset = static_cast<std::size_t>(begin - isFree.begin()) * kStep;
        if (end == isFree.end()) {
            header().used = offset;
        } else {
            giveRange(offset, static_cast<std::size_t>(end - isFree.begin()) * kStep);
        }
        begin = std::find(end, isFree.end(), true);
    }
}

void ScriptArena::give(void* block, std::size_t sizeClass) {
    std::uint32_t& first = header().free[sizeClass];
    std::memcpy(block, &first, sizeof first);
    first = static_cast<std::uint32_t>(static_cast<std::byte*>(block) - start());
}

void* ScriptArena::allocate(void* block, std::size_t oldSize, std::size_t newSize) {
    if (newSize > kBytes) return nullptr;
    if (block == nullptr) return newSize == 0 ? nullptr : take(sizeClass(newSize));
    if (newSize == 0) return give(block, sizeClass(oldSize)), nullptr;
    if (sizeClass(oldSize) == sizeClass(newSize)) return block;
    void* moved = take(sizeClass(newSize));
    if (moved == nullptr) return newSize < oldSize ? block : nullptr;
    std::memcpy(moved, block, std::min(oldSize, newSize));
    give(block, sizeClass(oldSize));
    return moved;
}

}  // namespace plumb
