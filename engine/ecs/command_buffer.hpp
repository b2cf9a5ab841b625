#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "reflect/entity_id.hpp"

namespace plumb {

class World;

/// Deferred changes of a world: recorded at any time, applied in order by flush(). World::update flushes
/// the world's own buffer after each system. Commands for entities that no longer exist do nothing.
class CommandBuffer {
public:
    void destroy(EntityId id);
    template <class T>
    void add(EntityId id, const T& component = {});
    template <class T>
    void remove(EntityId id);

    /// Applies all commands in order, including those that are recorded while it runs.
    void flush(World& world);
    [[nodiscard]] bool empty() const { return commands_.empty(); }
    void clear() {
        commands_.clear();
        payload_.clear();
    }

private:
    struct Command {
        EntityId id;
        void (*apply)(World& world, EntityId id, const std::byte* payload) = nullptr;
        std::size_t payload = 0;  // offset in payload_
    };

    std::vector<Command> commands_;
    std::vector<std::byte> payload_;
};

}  // namespace plumb
