#pragma once

#include <array>
#include <cstdint>

#include "core/text_store.hpp"
#include "math/vec2.hpp"
#include "reflect/entity_id.hpp"

namespace plumb {

/// A value that scripts pass with an event.
struct ScriptValue {
    enum class Kind : std::uint8_t { Nil, Bool, Integer, Number, Text, Vector, Entity };
    Kind kind = Kind::Nil;
    std::uint64_t bits = 0;  ///< of a bool, std::int64_t, double, TextId, Vec2 or EntityId
};

/// Event: scripts handle it as `onEvent_NAME(...)`, code as any other event. Emitted by emit() of scripts,
/// and by code: `world.emit(scriptEvent(world, "score", 10))`.
struct ScriptEvent {
    static constexpr std::size_t kMaxValues = 3;

    TextId name;
    EntityId target;  ///< entity whose scripts handle it; empty: all scripts
    std::array<std::uint64_t, kMaxValues> bits{};
    std::array<ScriptValue::Kind, kMaxValues> kinds{};
    std::uint8_t count = 0;  ///< number of values

    [[nodiscard]] ScriptValue value(std::size_t index) const { return {kinds[index], bits[index]}; }
    /// @pre count < kMaxValues
    void add(ScriptValue value) {
        kinds[count] = value.kind;
        bits[count++] = value.bits;
    }
};

}  // namespace plumb
