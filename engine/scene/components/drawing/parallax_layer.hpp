#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Makes the entity's Sprite a backdrop that moves slower or faster than the world and may repeat for ever.
struct ParallaxLayer {
    Vec2 factor{0.5f,
                0.5f};  ///< ratio of the camera's movement; 0 stays on the screen, 1 is part of the world
    bool repeatX = true;
    bool repeatY = false;

    static void describe(TypeBuilder<ParallaxLayer>& type) {
        type.name("ParallaxLayer").doc("Makes the entity's Sprite a backdrop that moves with the camera.");
        type.field<&ParallaxLayer::factor>("factor")
            .unit(Unit::Ratio)
            .doc("0 stays on the screen, 1 is part of the world.");
        type.field<&ParallaxLayer::repeatX>("repeatX").doc("Repeats to the left and right.");
        type.field<&ParallaxLayer::repeatY>("repeatY").doc("Repeats up and down.");
    }
};

}  // namespace plumb
