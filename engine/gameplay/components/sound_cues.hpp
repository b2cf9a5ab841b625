#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Sounds that an entity plays on events.
struct SoundCues {
    SoundId jump;
    SoundId land;  ///< played when the entity reaches the ground
    SoundId step;  ///< played at animation frame events named "step"
    SoundId hurt;
    SoundId die;
    SoundId collect;      ///< played when the entity, a Collectible, is picked up
    SoundId bounce;       ///< played when the entity launches a body as a Spring, or is stomped
    SoundId activate;     ///< played when the entity is activated: a checkpoint, button, door, goal, ...
    float volume = 1.0f;  ///< ratio

    static void describe(TypeBuilder<SoundCues>& type) {
        type.name("SoundCues").doc("Sounds that the entity plays on events.");
        type.field<&SoundCues::jump>("jump");
        type.field<&SoundCues::land>("land");
        type.field<&SoundCues::step>("step").doc("Sound at animation frame events named step.");
        type.field<&SoundCues::hurt>("hurt");
        type.field<&SoundCues::die>("die");
        type.field<&SoundCues::collect>("collect").doc("Sound when the entity is picked up.");
        type.field<&SoundCues::bounce>("bounce").doc(
            "Sound when a spring throws a body, or an enemy is stomped.");
        type.field<&SoundCues::activate>("activate")
            .doc("Sound when a checkpoint, button, door or goal is activated.");
        type.field<&SoundCues::volume>("volume")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Volume of all sounds, as a ratio.");
    }
};

}  // namespace plumb
