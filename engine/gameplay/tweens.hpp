#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"
#include "ecs/component_type.hpp"
#include "ecs/world.hpp"
#include "math/color.hpp"
#include "math/easing.hpp"
#include "math/vec2.hpp"
#include "reflect/type_key.hpp"

namespace plumb {

/// Fields of components that change to a value over a time. A world resource of plain data: rewinding and
/// snapshots include it.
struct Tweens {
    enum class Kind : std::uint8_t { Float, Vec2, Color };
    struct Entry {
        EntityId entity;
        TypeKey type = 0;
        std::uint32_t offset = 0;  ///< bytes of the field from the start of the component
        Kind kind = Kind::Float;
        Ease ease = Ease::Linear;
        std::array<float, 4> from{};  ///< initial value of each number of the field
        std::array<float, 4> to{};    ///< final value of each number of the field
        std::uint64_t start = 0;      ///< World::tick at which the tween starts
        std::uint64_t ticks = 1;      ///< duration
    };

    std::vector<Entry> entries;

    void addTo(Hasher& hasher) const;
    void archive(StateArchive& archive);
    /// Removes tweens of a component type, e.g. after its layout has changed.
    void drop(TypeKey type) {
        std::erase_if(entries, [type](const Entry& entry) { return entry.type == type; });
    }
};

/// Event: a tween has reached its end.
struct TweenEnded {
    EntityId entity;
};

/// Returns the field that a tween changes; null if the entity no longer has the component.
std::byte* fieldOf(World& world, const Tweens::Entry& tween);

/// Implementation of tween(), without the types of component and field.
void addTween(World& world, Tweens::Entry entry, float seconds);

template <class T, class V>
Tweens::Entry tweenOf(EntityId entity, V T::*field, Ease ease) {
    static_cast<void>(componentType<T>());  // registers T, so that TweenSystem can find its components
    const T object{};
    Tweens::Entry entry;
    entry.entity = entity;
    entry.type = typeKey<T>();
    entry.offset = static_cast<std::uint32_t>(reinterpret_cast<const std::byte*>(&(object.*field)) -
                                              reinterpret_cast<const std::byte*>(&object));
    entry.ease = ease;
    return entry;
}

/// Changes a field of an entity's component gradually from its current value to another one, e.g.
/// tween(world, coin, &Sprite::tint, Color{255, 255, 255, 0}, 0.3f, Ease::QuadOut). Replaces a tween of the
/// same field. A tween ends early, without TweenEnded, if the entity loses the component.
/// @param seconds  s, rounded to ticks, at least one
/// @error seconds is NaN or infinite: it is logged, and the field stays as it is
template <class T>
void tween(World& world, EntityId entity, float T::*field, float to, float seconds,
           Ease ease = Ease::QuadInOut) {
    Tweens::Entry entry = tweenOf(entity, field, ease);
    entry.to = {to};
    addTween(world, entry, seconds);
}
template <class T>
void tween(World& world, EntityId entity, Vec2 T::*field, Vec2 to, float seconds,
           Ease ease = Ease::QuadInOut) {
    Tweens::Entry entry = tweenOf(entity, field, ease);
    entry.kind = Tweens::Kind::Vec2;
    entry.to = {to.x, to.y};
    addTween(world, entry, seconds);
}
template <class T>
void tween(World& world, EntityId entity, Color T::*field, Color to, float seconds,
           Ease ease = Ease::QuadInOut) {
    Tweens::Entry entry = tweenOf(entity, field, ease);
    entry.kind = Tweens::Kind::Color;
    entry.to = {static_cast<float>(to.r), static_cast<float>(to.g), static_cast<float>(to.b),
                static_cast<float>(to.a)};
    addTween(world, entry, seconds);
}
/// Ends the tweens of an entity without TweenEnded; fields keep their current values.
void stopTweens(World& world, EntityId entity);

}  // namespace plumb
