#pragma once

#include "reflect/field_types.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Background music: the sound is looped while an entity with this component exists.
struct Music {
    SoundId sound;
    float volume = 1.0f;  ///< ratio

    static void describe(TypeBuilder<Music>& type) {
        type.name("Music").doc(
            "Background music: the sound is looped while an entity with this component exists.");
        type.field<&Music::sound>("sound").doc("Sound file of the music.");
        type.field<&Music::volume>("volume")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Volume of the music, as a ratio.");
    }
};

}  // namespace plumb
