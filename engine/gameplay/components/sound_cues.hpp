#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// The sounds of an entity: what is heard when something happens to it.
struct SoundCues {
    SoundId jump;
    SoundId land;
    SoundId step;  ///< at frame events named step
    SoundId hurt;
    SoundId die;
    SoundId collect;      ///< when it is picked up
    SoundId bounce;       ///< of a spring, or when stomped
    SoundId activate;     ///< of a checkpoint, button, door or goal
    float volume = 1.0f;  ///< ratio

    static void describe(TypeBuilder<SoundCues>& type) {
        type.name("SoundCues").doc("The sounds of an entity: what is heard when something happens to it.");
        type.field<&SoundCues::jump>("jump");
        type.field<&SoundCues::land>("land");
        type.field<&SoundCues::step>("step").doc("At frame events named step.");
        type.field<&SoundCues::hurt>("hurt");
        type.field<&SoundCues::die>("die");
        type.field<&SoundCues::collect>("collect").doc("When it is picked up.");
        type.field<&SoundCues::bounce>("bounce").doc("Of a spring, or when stomped.");
        type.field<&SoundCues::activate>("activate").doc("Of a checkpoint, button, door or goal.");
        type.field<&SoundCues::volume>("volume").unit(Unit::Ratio).range(0.0f, 1.0f);
    }
};

}  // namespace plumb
