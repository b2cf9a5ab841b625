#include "ecs/command_buffer.hpp"

#include "ecs/world.hpp"

namespace plumb {

void CommandBuffer::destroy(EntityId id) {
    commands_.push_back({id, [](World& world, EntityId gone, const std::byte*) { world.destroy(gone); }, 0});
}

void CommandBuffer::flush(World& world) {
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        const Command command = commands_[i];  // a copy: applying it may record more
        if (world.alive(command.id)) command.apply(world, command.id, payload_.data() + command.payload);
    }
    clear();
}

}  // namespace plumb
