#pragma once

#include <cstdint>

#include <lua.hpp>

namespace plumb::script {

/// What a userdata is: the first word of its block. Scripts cannot make userdata of their own, so all that
/// they have begin so, and looking at the word replaces looking up a metatable by its name.
enum class BlockKind : std::uint32_t { Vector = 1, Entity, Component, Property };

/// Returns the block at an index of the stack; null if the value is none of this kind.
template <class Block>
const Block* blockAt(lua_State* state, int index) {
    const auto* block = static_cast<const Block*>(lua_touserdata(state, index));
    return block != nullptr && block->kind == Block::kKind ? block : nullptr;
}

}  // namespace plumb::script
