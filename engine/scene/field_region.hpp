#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "physics/model/field.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Where a field acts: in the entity's BoxCollider or CircleCollider when it has one (make it a trigger),
/// else in a box of a size of its own.
struct FieldRegion {
    Vec2 size;                           ///< px from the Transform to the right and down; {0, 0}: everywhere
    std::uint32_t layers = 0xffffffffu;  ///< bits: acts on colliders of these layers
};

template <class T>
void describeRegion(TypeBuilder<T>& type) {
    type.template field<&T::size>("size")
        .unit(Unit::Pixels)
        .doc("Without a collider: how far it reaches right and down; 0, 0 is everywhere.");
    type.template field<&T::layers>("layers").layerBits().doc("Acts on colliders of these layers.");
}

}  // namespace plumb
