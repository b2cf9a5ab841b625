#pragma once

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Settings of a drawing layer. Layer numbers without an entry have the defaults.
struct SceneLayer {
    TextId name;
    int order = 0;              ///< number of the layer, as in Sprite::layer; higher numbers are in front
    Vec2 parallax{1.0f, 1.0f};  ///< scroll ratio: 1 moves like the world, 0 stays fixed on the screen
    Color tint;
    bool visible = true;
    bool ySort = false;  ///< within the layer, sprites lower on the screen are in front

    static void describe(TypeBuilder<SceneLayer>& type) {
        type.name("Layer").doc("Settings of a drawing layer.");
        type.field<&SceneLayer::name>("name");
        type.field<&SceneLayer::order>("order")
            .range(-1000.0f, 1000.0f)
            .doc("Number of the layer; higher numbers are in front.");
        type.field<&SceneLayer::parallax>("parallax")
            .unit(Unit::Ratio)
            .doc("Scroll ratio: 1 moves like the world, 0 stays fixed on the screen.");
        type.field<&SceneLayer::tint>("tint").doc(
            "Color multiplied with the colors of everything in the layer.");
        type.field<&SceneLayer::visible>("visible");
        type.field<&SceneLayer::ySort>("ySort").doc(
            "Within the layer, sprites lower on the screen are in front.");
    }
};

/// Returns the type information of SceneLayer, for reflection.
const TypeInfo& sceneLayerType();

}  // namespace plumb
