#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Sets off an Explosion where the entity is, when an action is pressed or after a while.
struct Detonator {
    TextId action;            ///< one of project.json; empty for none
    float after = 0.0f;       ///< s, the first time by itself; 0 never
    float radius = 256.0f;    ///< px
    float speed = 8.0f;       ///< px/s that a body of 1 kg for each px of its width gets, at its middle
    std::uint32_t ticks = 0;  ///< ticks since the scene began

    static void describe(TypeBuilder<Detonator>& type) {
        type.name("Detonator").doc("Sets off an Explosion here, when an action is pressed or after a while.");
        type.field<&Detonator::action>("action").doc("One of project.json; empty for none.");
        type.field<&Detonator::after>("after")
            .unit(Unit::Seconds)
            .range(0.0f, 600.0f)
            .doc("The first time by itself; 0 never.");
        type.field<&Detonator::radius>("radius").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&Detonator::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(-1e9f, 1e9f)
            .doc("What a body of 1 kg for each px of its width gets, at its middle.");
        type.field<&Detonator::ticks>("ticks").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
