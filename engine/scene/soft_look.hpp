#pragma once

#include <cstdint>

#include "core/hash.hpp"
#include "math/color.hpp"
#include "physics/soft/softbody.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// What ropes, cloth and jellies are made of and how they look: the same for all.
struct SoftLook {
    float mass = 1.0f;                 ///< kg, of the whole
    float softness = 0.0f;             ///< m/N: 0 does not stretch
    float bending = 0.01f;             ///< m/N: larger bends more easily
    float damping = 0.5f;              ///< 1/s, part of its speed lost in a second
    float friction = 0.5f;             ///< 0 is ice
    float thickness = 6.0f;            ///< px, of its threads or its skin
    std::uint32_t layers = 1;          ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it collides with
    Color color;
    int layer = 0;  ///< order of drawing: higher is in front

    /// What it is made from; how it looks is left out.
    void addTo(Hasher& hasher) const {
        for (const float value : {mass, softness, bending, damping, friction, thickness}) hasher.add(value);
        hasher.add(std::uint64_t{layers} << 32 | mask);
    }
    [[nodiscard]] physics::SoftMaterial material(float metres) const {
        physics::SoftMaterial made;
        made.mass = mass;
        made.radius = 0.5f * thickness * metres;
        made.stretchCompliance = softness;
        made.bendCompliance = bending;
        made.damping = damping;
        made.friction = friction;
        made.layers = layers;
        made.mask = mask;
        return made;
    }
};

template <class T>
void describeSoft(TypeBuilder<T>& type) {
    type.template field<&T::mass>("mass").unit(Unit::Kilograms).range(1e-4f, 1e6f);
    type.template field<&T::softness>("softness").range(0.0f, 1000.0f).doc("m/N: 0 does not stretch.");
    type.template field<&T::bending>("bending").range(0.0f, 1000.0f).doc("m/N: larger bends more easily.");
    type.template field<&T::damping>("damping")
        .range(0.0f, 1000.0f)
        .doc("1/s: part of its speed lost in a second.");
    type.template field<&T::friction>("friction").unit(Unit::Ratio).range(0.0f, 10.0f).doc("0 is ice.");
    type.template field<&T::thickness>("thickness").unit(Unit::Pixels).range(0.0f, 256.0f);
    type.template field<&T::layers>("layers").layerBits().doc("What it is.");
    type.template field<&T::mask>("mask").layerBits().doc("What it collides with.");
    type.template field<&T::color>("color");
    type.template field<&T::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
}

}  // namespace plumb
