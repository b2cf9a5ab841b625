#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "physics/model/field.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Region in which a field acts: the entity's BoxCollider or CircleCollider if it has one (it should be a
/// trigger), otherwise a box of `size`.
struct FieldRegion {
    Vec2 size;                           ///< px, from the Transform to the right and down; {0, 0}: everywhere
    std::uint32_t layers = 0xffffffffu;  ///< bits: collision layers that the field acts on
};

template <class T>
void describeRegion(TypeBuilder<T>& type) {
    type.template field<&T::size>("size")
        .unit(Unit::Pixels)
        .doc(
            "Size of the region to the right and down, px, if the entity has no collider; 0, 0: everywhere.");
    type.template field<&T::layers>("layers").layerBits().doc("Collision layers that the field acts on.");
}

}  // namespace plumb
