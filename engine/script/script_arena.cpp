#include "script/script_arena.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

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
    if (!grow(at + sizeOf(sizeClass))) return nullptr;
    header().used = at + sizeOf(sizeClass);
    return start() + at;
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
