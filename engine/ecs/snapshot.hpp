#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "core/text_store.hpp"
#include "ecs/resources.hpp"
#include "ecs/tile_store.hpp"

namespace plumb {

struct ComponentType;
class World;

/// Bytes that are only ever overwritten: growing them does not clear them first.
class ByteBuffer {
public:
    /// Forgets the content and makes room.
    void prepare(std::size_t bytes) {
        used_ = 0;
        if (bytes <= capacity_) return;
        capacity_ = bytes;
        bytes_.reset(new std::byte[bytes]);
    }
    /// @pre prepare() made room for it
    void append(const void* from, std::size_t bytes) {
        if (bytes > 0) std::memcpy(bytes_.get() + used_, from, bytes);
        used_ += bytes;
    }
    [[nodiscard]] const std::byte* data() const { return bytes_.get(); }
    [[nodiscard]] std::size_t size() const { return used_; }

private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t used_ = 0;
    std::size_t capacity_ = 0;
};

/// The entities and components of a world at one moment: the used beginnings of its arrays. What follows
/// from the rest, the sparse arrays, is worked out again when it is restored.
struct StorageImage {
    struct PoolImage {
        const ComponentType* type = nullptr;
        std::uint32_t count = 0;
        std::uint32_t disorder = 0;
    };

    std::uint32_t used = 0;
    std::uint32_t freeCount = 0;
    std::uint32_t retired = 0;
    std::vector<PoolImage> pools;  ///< by ordinal
    ByteBuffer bytes;              ///< the records, the free indices, then entities and column of each pool
};

/// A world at one moment: World::save fills it, World::restore brings it back to the exact order, also into
/// another world. Filling the same one again reuses its memory.
class Snapshot {
public:
    [[nodiscard]] std::size_t byteCount() const { return storage_.bytes.size(); }
    [[nodiscard]] std::uint64_t tick() const { return tick_; }

private:
    friend class World;

    StorageImage storage_;
    Resources resources_;
    TileStore tiles_;
    TextStore texts_;
    const World* source_ = nullptr;  // compared, never followed
    std::uint64_t tick_ = 0;
};

}  // namespace plumb
