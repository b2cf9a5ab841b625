#pragma once

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A slider on the screen that changes a number of a component while the game runs. The Transform is the left
/// end of its track, px from the top-left corner of the view.
struct Slider {
    EntityId target;       ///< entity whose number is changed; empty: all entities with the component
    TextId component;      ///< name of the component, e.g. ScenePhysics
    TextId field;          ///< name of a number, bool or enum field, or of a part of a vector, as "gravity.y"
    float min = 0.0f;      ///< value at the left end; with `powers` its exponent of ten
    float max = 1.0f;      ///< value at the right end; with `powers` its exponent of ten
    float step = 0.0f;     ///< step of the value (with `powers` of the exponent); 0: continuous
    bool powers = false;   ///< logarithmic scale; min, max and step are exponents of ten
    TextId text;           ///< label above the left end
    TextId unit;           ///< unit shown after the value
    float width = 220.0f;  ///< px, length of the track
    Color color{244, 234, 213, 255};
    int layer = 70;     ///< drawing layer; higher numbers are in front
    bool held = false;  ///< the mouse drags the knob

    static void describe(TypeBuilder<Slider>& type) {
        type.name("Slider").doc(
            "A slider on the screen that changes a number of a component while the game runs.");
        type.field<&Slider::target>("target").doc(
            "Entity whose number is changed; none: all entities with the component.");
        type.field<&Slider::component>("component").doc("Name of the component, e.g. ScenePhysics.");
        type.field<&Slider::field>("field").doc(
            "Name of a number, bool or enum field of the component, or of a part of a vector, as gravity.y.");
        type.field<&Slider::min>("min").doc("Value at the left end; with powers its exponent of ten.");
        type.field<&Slider::max>("max").doc("Value at the right end; with powers its exponent of ten.");
        type.field<&Slider::step>("step")
            .range(0.0f, 1e6f)
            .doc("Step between two values of the slider; 0: continuous.");
        type.field<&Slider::powers>("powers").doc(
            "Logarithmic scale; min, max and step are exponents of ten.");
        type.field<&Slider::text>("text").doc("Label above the left end.");
        type.field<&Slider::unit>("unit").doc("Unit shown after the value.");
        type.field<&Slider::width>("width")
            .unit(Unit::Pixels)
            .range(16.0f, 4096.0f)
            .doc("Length of the track, px.");
        type.field<&Slider::color>("color");
        type.field<&Slider::layer>("layer")
            .range(-1000.0f, 1000.0f)
            .doc("Drawing layer; higher numbers are in front.");
        type.field<&Slider::held>("held").transient();
    }
};

}  // namespace plumb
