#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Triggers an Explosion at the entity when an input action is pressed or after a given time.
struct Detonator {
    TextId action;            ///< name of the input action (project.json); empty for none
    float after = 0.0f;       ///< s from the start of the scene to an automatic explosion; 0: never
    float radius = 256.0f;    ///< px, radius at which the impulse has fallen to 0
    float speed = 8.0f;       ///< kg px/s per px of a body's width: impulse at the center
    std::uint32_t ticks = 0;  ///< ticks since the start of the scene

    static void describe(TypeBuilder<Detonator>& type) {
        type.name("Detonator")
            .doc("Triggers an Explosion here when an input action is pressed or after a given time.");
        type.field<&Detonator::action>("action").doc(
            "Input action, by its name in project.json; empty for none.");
        type.field<&Detonator::after>("after")
            .unit(Unit::Seconds)
            .range(0.0f, 600.0f)
            .doc("Time from the start of the scene to an automatic explosion, s; 0: never.");
        type.field<&Detonator::radius>("radius")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Radius at which the impulse has fallen to 0, px.");
        type.field<&Detonator::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(-1e9f, 1e9f)
            .doc("Speed that a body of 1 kg per px of its width gets at the center, px/s.");
        type.field<&Detonator::ticks>("ticks").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
