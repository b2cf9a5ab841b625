#pragma once

#include "reflect/field_types.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// The tune of a scene: it plays over and over while an entity with it is there.
struct Music {
    SoundId sound;
    float volume = 1.0f;  ///< ratio

    static void describe(TypeBuilder<Music>& type) {
        type.name("Music").doc("The tune of a scene: it plays over and over while an entity with it is there.");
        type.field<&Music::sound>("sound");
        type.field<&Music::volume>("volume").unit(Unit::Ratio).range(0.0f, 1.0f);
    }
};

}  // namespace plumb
