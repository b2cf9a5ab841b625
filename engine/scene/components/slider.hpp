#pragma once

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A slider on the screen that changes a number of a component while the game runs. The Transform is where
/// its track begins: px of the picture.
struct Slider {
    EntityId target;       ///< whose number; empty: that of every entity with the component
    TextId component;      ///< its name, e.g. ScenePhysics
    TextId field;          ///< of the component: a number, a switch or a choice; of a vector with .x or .y
    float min = 0.0f;      ///< at the left end; with `powers` the exponent of ten
    float max = 1.0f;      ///< at the right end
    float step = 0.0f;     ///< between two places of the knob; 0: any place. With `powers` of the exponent
    bool powers = false;   ///< each step multiplies
    TextId text;           ///< said above its left end
    TextId unit;           ///< said behind the value
    float width = 220.0f;  ///< px
    Color color{244, 234, 213, 255};
    int layer = 70;     ///< order of drawing: higher is in front
    bool held = false;  ///< the mouse has the knob

    static void describe(TypeBuilder<Slider>& type) {
        type.name("Slider").doc(
            "A slider on the screen that changes a number of a component while the game runs.");
        type.field<&Slider::target>("target").doc(
            "Whose number; none: that of every entity with the component.");
        type.field<&Slider::component>("component").doc("Its name, e.g. ScenePhysics.");
        type.field<&Slider::field>("field").doc(
            "A number, a switch or a choice of it; of a vector with .x or .y.");
        type.field<&Slider::min>("min").doc("At the left end; with powers the exponent of ten.");
        type.field<&Slider::max>("max").doc("At the right end.");
        type.field<&Slider::step>("step")
            .range(0.0f, 1e6f)
            .doc("Between two places of the knob; 0: any place.");
        type.field<&Slider::powers>("powers").doc(
            "Each step multiplies; min, max and step are exponents of ten.");
        type.field<&Slider::text>("text").doc("Said above its left end.");
        type.field<&Slider::unit>("unit").doc("Said behind the value.");
        type.field<&Slider::width>("width").unit(Unit::Pixels).range(16.0f, 4096.0f);
        type.field<&Slider::color>("color");
        type.field<&Slider::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
        type.field<&Slider::held>("held").transient();
    }
};

}  // namespace plumb
