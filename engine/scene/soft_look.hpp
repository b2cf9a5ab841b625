#pragma once

#include <cstdint>

#include "core/hash.hpp"
#include "math/color.hpp"
#include "physics/soft/softbody.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Material and appearance that ropes, cloth and jellies have in common.
struct SoftLook {
    float mass = 1.0f;                 ///< kg, of the whole soft body
    float softness = 0.0f;             ///< stretch compliance, m/N; 0: does not stretch
    float bending = 0.01f;             ///< bend compliance, m/N; larger bends more easily
    float damping = 0.5f;              ///< 1/s: decay rate of the particles' velocity
    float friction = 0.5f;             ///< friction coefficient; 0 is frictionless
    float thickness = 6.0f;            ///< px, of the threads or the skin
    std::uint32_t layers = 1;          ///< bits: collision layers of the soft body
    std::uint32_t mask = 0xffffffffu;  ///< bits: layers that the soft body collides with
    Color color;
    int layer = 0;  ///< drawing layer; higher numbers are in front

    /// Adds the material to a hash; the appearance is left out.
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
    type.template field<&T::mass>("mass")
        .unit(Unit::Kilograms)
        .range(1e-4f, 1e6f)
        .doc("Mass of the whole soft body, kg.");
    type.template field<&T::softness>("softness")
        .range(0.0f, 1000.0f)
        .doc("Stretch compliance, m/N; 0 does not stretch.");
    type.template field<&T::bending>("bending")
        .range(0.0f, 1000.0f)
        .doc("Bend compliance, m/N; larger bends more easily.");
    type.template field<&T::damping>("damping").range(0.0f, 1000.0f).doc("Decay rate of the velocity, 1/s.");
    type.template field<&T::friction>("friction")
        .unit(Unit::Ratio)
        .range(0.0f, 10.0f)
        .doc("Friction coefficient; 0 is frictionless.");
    type.template field<&T::thickness>("thickness")
        .unit(Unit::Pixels)
        .range(0.0f, 256.0f)
        .doc("Thickness of the threads or the skin, px.");
    type.template field<&T::layers>("layers").layerBits().doc("Collision layers of the soft body.");
    type.template field<&T::mask>("mask").layerBits().doc(
        "Collision layers that the soft body collides with.");
    type.template field<&T::color>("color");
    type.template field<&T::layer>("layer")
        .range(-1000.0f, 1000.0f)
        .doc("Drawing layer; higher numbers are in front.");
}

}  // namespace plumb
