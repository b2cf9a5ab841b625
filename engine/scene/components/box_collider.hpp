#pragma once

#include <cstdint>
#include <type_traits>

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// An upright box, from position + offset to position + offset + size * scale.
struct BoxCollider {
    float width = 32.0f;               ///< px
    float height = 32.0f;              ///< px
    Vec2 offset;                       ///< px, from the Transform to the top-left corner
    bool isTrigger = false;            ///< reports contacts, stops nothing
    bool oneWay = false;               ///< solid only for what falls on it
    std::uint32_t layers = 1;          ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it collides with

    BoxCollider() = default;
    /// Takes whole numbers too: BoxCollider(32, 32).
    template <class Width, class Height>
    requires std::is_arithmetic_v<Width> && std::is_arithmetic_v<Height> BoxCollider(Width w, Height h)
        : width{static_cast<float>(w)}, height{static_cast<float>(h)} {}

    static void describe(TypeBuilder<BoxCollider>& type) {
        type.name("BoxCollider")
            .doc("An upright box; its top-left corner is at the Transform plus the offset.");
        type.field<&BoxCollider::width>("width").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&BoxCollider::height>("height").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&BoxCollider::offset>("offset")
            .unit(Unit::Pixels)
            .doc("From the Transform to the top-left corner.");
        type.field<&BoxCollider::isTrigger>("isTrigger").doc("Reports contacts, stops nothing.");
        type.field<&BoxCollider::oneWay>("oneWay").doc("Solid only for what falls on it.");
        type.field<&BoxCollider::layers>("layers").doc("Bits: what it is.");
        type.field<&BoxCollider::mask>("mask").doc("Bits: what it collides with.");
    }
};

}  // namespace plumb
