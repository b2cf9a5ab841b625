#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "core/text_store.hpp"
#include "ecs/events.hpp"
#include "ecs/resources.hpp"
#include "ecs/tile_store.hpp"

namespace plumb {

struct ComponentType;
class World;

/// A byte buffer that is only overwritten: growing does not clear it first.
class ByteBuffer {
public:
    /// Discards the content and reserves memory.
    void prepare(std::size_t bytes) {
        used_ = 0;
        if (bytes <= capacity_) return;
        capacity_ = bytes;
        bytes_.reset(new std::byte[bytes]);
    }
    /// @pre prepare() has reserved enough memory
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

/// The entities and components of a world at one time: the used parts of its
/// arrays. The sparse arrays follow from them and are recomputed by a restore.
struct StorageImage {
    struct PoolImage {
        const ComponentType* type = nullptr;
        std::uint32_t count = 0;
        std::uint32_t disorder = 0;
    };

    std::uint32_t used = 0;        ///< highest entity index used so far
    std::uint32_t freeCount = 0;   ///< number of indices to reuse
    std::uint64_t clock = 0;       ///< of changes, when it was saved
    std::uint32_t retired = 0;     ///< number of indices whose generations are used up
    std::vector<PoolImage> pools;  ///< indexed by Pool::ordinal
    ByteBuffer bytes;              ///< the records, the free indices, then entities and column of each pool
};

/// The state of a world at one time: World::save fills it, World::restore restores it including
/// the order, also in another world. Filling the same snapshot again reuses its memory.
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
    Events::Inboxes inboxes_;
    const World* source_ = nullptr;  // compared, never dereferenced
    std::uint64_t tick_ = 0;
};

}  // namespace plumb
