#pragma once

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// What all things with one layer number share. A number without an entry is drawn plainly.
struct SceneLayer {
    TextId name;
    int order = 0;              ///< the number that Sprite.layer and its like refer to; higher is in front
    Vec2 parallax{1.0f, 1.0f};  ///< ratio of the camera's movement; 1 is part of the world, 0 stays on screen
    Color tint;
    bool visible = true;
    bool ySort = false;  ///< lower on screen is in front, within the layer

    static void describe(TypeBuilder<SceneLayer>& type) {
        type.name("Layer").doc("What all things with one layer number share.");
        type.field<&SceneLayer::name>("name");
        type.field<&SceneLayer::order>("order").range(-1000.0f, 1000.0f).doc("Higher is in front.");
        type.field<&SceneLayer::parallax>("parallax")
            .unit(Unit::Ratio)
            .doc("1 is part of the world, 0 stays.");
        type.field<&SceneLayer::tint>("tint").doc("Multiplies the colors of all in it.");
        type.field<&SceneLayer::visible>("visible");
        type.field<&SceneLayer::ySort>("ySort").doc("Lower on screen is in front.");
    }
};

/// The description of a layer, for readers that go by reflection.
const TypeInfo& sceneLayerType();

}  // namespace plumb
