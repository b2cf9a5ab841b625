#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Makes the entity's Sprite a backdrop that scrolls slower
/// or faster than the world and may repeat endlessly.
struct ParallaxLayer {
    Vec2 factor{0.5f, 0.5f};  ///< scroll ratio: 0 stays fixed on the screen, 1 moves like the world
    bool repeatX = true;
    bool repeatY = false;

    static void describe(TypeBuilder<ParallaxLayer>& type) {
        type.name("ParallaxLayer")
            .doc("Makes the entity's Sprite a backdrop that scrolls slower or faster than the world.");
        type.field<&ParallaxLayer::factor>("factor")
            .unit(Unit::Ratio)
            .doc("Scroll ratio: 0 stays fixed on the screen, 1 moves like the world.");
        type.field<&ParallaxLayer::repeatX>("repeatX").doc("Repeats the backdrop to the left and right.");
        type.field<&ParallaxLayer::repeatY>("repeatY").doc("Repeats the backdrop up and down.");
    }
};

}  // namespace plumb
