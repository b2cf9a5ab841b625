#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ecs/address_range.hpp"

namespace plumb {

/// The memory of a Lua state: one range of addresses that contains everything, the free lists of the
/// allocator too, so that a copy of its used beginning is a copy of the state. The copy must be loaded at the
/// same addresses, because it contains pointers. So there is one arena in the program, and the states of
/// several worlds take turns in it (ScriptMemory).
class ScriptArena {
public:
    static constexpr std::size_t kBytes = std::size_t{64} << 20;  ///< maximum memory of a state

    static ScriptArena& instance();
    ScriptArena(const ScriptArena&) = delete;
    ScriptArena& operator=(const ScriptArena&) = delete;

    /// Like realloc with the old size; `newSize` 0 frees the block.
    /// @return null if the arena is full: the old block stays valid then
    void* allocate(void* block, std::size_t oldSize, std::size_t newSize);

    /// Joins freed blocks that lie side by side, so that they serve for other sizes. Takes some 10 ms: for
    /// when the arena is full.
    void joinFreed();

    /// The used beginning of the arena.
    [[nodiscard]] std::span<const std::byte> content() const { return {start(), header().used}; }
    /// Replaces the content by a copy of one that was in this arena before.
    void load(std::span<const std::byte> content);
    /// Removes all blocks.
    void clear();

private:
    // Blocks of up to 1 KiB have sizes in steps of 16 bytes, larger ones powers of two. Freed blocks of each
    // size form a list whose links lie in the blocks; offsets from the start, 0 for the end. Larger blocks
    // are split only if the arena is full.
    static constexpr std::size_t kStep = 16;
    static constexpr std::size_t kSmall = 1024;
    static constexpr std::size_t kSmallSizes = kSmall / kStep;
    static constexpr std::size_t kSizes = kSmallSizes + 17;  // and 2 KiB to 128 MiB

    struct Header {
        std::size_t used = 0;  // bytes from the start, the header included
        std::array<std::uint32_t, kSizes> free{};
    };

    ScriptArena();
    [[nodiscard]] std::byte* start() const { return memory_.start(); }
    [[nodiscard]] Header& header() const { return *reinterpret_cast<Header*>(start()); }
    [[nodiscard]] static std::size_t sizeClass(std::size_t bytes);
    [[nodiscard]] static std::size_t sizeOf(std::size_t sizeClass);
    [[nodiscard]] static std::size_t classWithin(std::size_t bytes);
    void* take(std::size_t sizeClass);
    void* takePart(std::size_t sizeClass);
    void giveRange(std::size_t begin, std::size_t end);
    void give(void* block, std::size_t sizeClass);
    bool grow(std::size_t used);

    AddressRange memory_;
    std::size_t committed_ = 0;  // bytes
};

}  // namespace plumb
