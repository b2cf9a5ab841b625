#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A piece that plays over and over while the scene lasts. The same piece in the next scene goes on.
struct Music {
    SoundId sound;
    float volume = 1.0f;  ///< ratio

    static void describe(TypeBuilder<Music>& type) {
        type.name("Music").doc("A piece that plays over and over while the scene lasts.");
        type.field<&Music::sound>("sound").doc("The sound file.");
        type.field<&Music::volume>("volume").unit(Unit::Ratio).range(0.0f, 1.0f);
    }
};

}  // namespace plumb
