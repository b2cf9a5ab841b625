#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A circle around position + offset.
struct CircleCollider {
    float radius = 16.0f;              ///< px
    Vec2 offset;                       ///< px, from the Transform to the middle
    bool isTrigger = false;            ///< reports contacts, stops nothing
    std::uint32_t layers = 1;          ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it collides with

    CircleCollider() = default;
    explicit CircleCollider(float size) : radius{size} {}

    static void describe(TypeBuilder<CircleCollider>& type) {
        type.name("CircleCollider").doc("A circle; its middle is at the Transform plus the offset.");
        type.field<&CircleCollider::radius>("radius").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&CircleCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("From the Transform to the middle.");
        type.field<&CircleCollider::isTrigger>("isTrigger").doc("Reports contacts, stops nothing.");
        type.field<&CircleCollider::layers>("layers").doc("Bits: what it is.");
        type.field<&CircleCollider::mask>("mask").doc("Bits: what it collides with.");
    }
};

}  // namespace plumb
