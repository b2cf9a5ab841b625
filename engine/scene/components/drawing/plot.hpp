#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Physical quantity that a plot shows.
enum class PlotMeasure : std::uint8_t {
    Energy,    ///< total energy, as a ratio to its initial value
    Overlap,   ///< mm: maximum penetration depth of two shapes
    X,         ///< m: x position of the target
    Y,         ///< m: y position of the target, positive upwards
    Distance,  ///< mm: maximum distance of a body from its position in the scene's own physics
};

/// A plot over time of a physical quantity: one curve for the scene's physics and one for each Ghost. The
/// Transform is the plot's top-left corner, px from the top-left corner of the view.
struct Plot {
    PlotMeasure measure = PlotMeasure::Energy;
    EntityId target;                  ///< entity whose position is plotted for X and Y
    TextId text;                      ///< title of the plot
    TextId name;                      ///< name of the scene's own curve in the legend
    Color color{244, 234, 213, 255};  ///< color of the scene's own curve and of the text
    Color background{32, 36, 60, 255};
    float width = 360.0f;   ///< px
    float height = 160.0f;  ///< px
    float seconds = 10.0f;  ///< s, length of the time axis
    float min = 0.0f;       ///< value at the bottom; if it is not below max, the scale fits the curves
    float max = 0.0f;       ///< value at the top
    bool powers = false;    ///< logarithmic scale; min and max are exponents of ten
    int layer = 70;         ///< drawing layer; higher numbers are in front

    static void describe(TypeBuilder<Plot>& type) {
        type.name("Plot").doc(
            "A plot over time of a physical quantity, with a curve for the scene and one for each Ghost.");
        type.field<&Plot::measure>("measure")
            .names({{"energy", 0}, {"overlap", 1}, {"x", 2}, {"y", 3}, {"distance", 4}})
            .doc(
                "Quantity to plot: energy as a ratio to its initial value; maximum overlap, mm; position x "
                "or y of "
                "the target, m; maximum distance of a body from its position in the scene's own physics, "
                "mm.");
        type.field<&Plot::target>("target").doc("Entity whose position is plotted, for x and y.");
        type.field<&Plot::text>("text").doc("Title of the plot.");
        type.field<&Plot::name>("name").doc("Name of the scene's own curve in the legend.");
        type.field<&Plot::color>("color").doc("Color of the scene's own curve and of the text.");
        type.field<&Plot::background>("background");
        type.field<&Plot::width>("width").unit(Unit::Pixels).range(64.0f, 4096.0f);
        type.field<&Plot::height>("height").unit(Unit::Pixels).range(32.0f, 4096.0f);
        type.field<&Plot::seconds>("seconds")
            .unit(Unit::Seconds)
            .range(1.0f, 120.0f)
            .doc("Length of the time axis, s.");
        type.field<&Plot::min>("min").doc(
            "Value at the bottom; if it is not below max, the scale fits the curves.");
        type.field<&Plot::max>("max").doc("Value at the top.");
        type.field<&Plot::powers>("powers").doc("Logarithmic scale; min and max are exponents of ten.");
        type.field<&Plot::layer>("layer")
            .range(-1000.0f, 1000.0f)
            .doc("Drawing layer; higher numbers are in front.");
    }
};

}  // namespace plumb
