#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "core/text_store.hpp"
#include "ecs/world.hpp"
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

/// Returns the value of a script for one of code: bools, numbers, texts, vectors and entities.
template <class T>
ScriptValue scriptValue(World& world, const T& value) {
    using Kind = ScriptValue::Kind;
    if constexpr (std::same_as<T, bool>) {
        return {Kind::Bool, value ? 1u : 0u};
    } else if constexpr (std::integral<T>) {
        return {Kind::Integer, static_cast<std::uint64_t>(value)};
    } else if constexpr (std::floating_point<T>) {
        return {Kind::Number, std::bit_cast<std::uint64_t>(static_cast<double>(value))};
    } else if constexpr (std::same_as<T, Vec2>) {
        return {Kind::Vector, std::bit_cast<std::uint64_t>(value)};
    } else if constexpr (std::convertible_to<const T&, EntityId>) {
        return {Kind::Entity, std::bit_cast<std::uint64_t>(static_cast<EntityId>(value))};
    } else {
        return {Kind::Text, world.texts().add(std::string_view{value}).value};
    }
}

/// Returns an event for scripts: `world.emit(scriptEvent(world, "score", 10, enemy))` calls onEvent_score(10,
/// enemy).
template <class... T>
ScriptEvent scriptEvent(World& world, std::string_view name, const T&... values) {
    static_assert(sizeof...(T) <= ScriptEvent::kMaxValues, "an event has at most three values");
    ScriptEvent event;
    event.name = world.texts().add(name);
    (event.add(scriptValue(world, values)), ...);
    return event;
}

}  // namespace plumb
