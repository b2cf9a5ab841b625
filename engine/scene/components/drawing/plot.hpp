#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// What a plot shows of the physics.
enum class PlotMeasure : std::uint8_t {
    Energy,    ///< ratio of that at the beginning
    Overlap,   ///< mm: how deep two shapes are in each other at most
    X,         ///< m: the place of the target
    Y,         ///< m, up
    Distance,  ///< mm: how far bodies are at most from where they are in the scene itself
};

/// A curve that grows while the game runs, of the scene's physics and of each Ghost. The Transform is its top
/// left corner: px of the picture.
struct Plot {
    PlotMeasure measure = PlotMeasure::Energy;
    EntityId target;                  ///< of X and Y: whose place
    TextId text;                      ///< its title
    TextId name;                      ///< of the scene's own curve
    Color color{244, 234, 213, 255};  ///< of the scene's own curve, and of what is written
    Color background{32, 36, 60, 255};
    float width = 360.0f;   ///< px
    float height = 160.0f;  ///< px
    float seconds = 10.0f;  ///< s that are shown
    float min = 0.0f;       ///< at the bottom; as large as max: as the curves want it
    float max = 0.0f;       ///< at the top
    bool powers = false;    ///< each line is ten times the one below it; min and max are exponents
    int layer = 70;         ///< order of drawing: higher is in front

    static void describe(TypeBuilder<Plot>& type) {
        type.name("Plot").doc(
            "A curve that grows while the game runs, of the scene's physics and of each Ghost.");
        type.field<&Plot::measure>("measure")
            .names({{"energy", 0}, {"overlap", 1}, {"x", 2}, {"y", 3}, {"distance", 4}})
            .doc(
                "Energy as a ratio of that at the beginning; the deepest overlap (mm); the place of the "
                "target "
                "(m); how far bodies are from where they are in the scene itself (mm).");
        type.field<&Plot::target>("target").doc("Of x and y: whose place.");
        type.field<&Plot::text>("text").doc("Its title.");
        type.field<&Plot::name>("name").doc("Of the scene's own curve.");
        type.field<&Plot::color>("color").doc("Of the scene's own curve.");
        type.field<&Plot::background>("background");
        type.field<&Plot::width>("width").unit(Unit::Pixels).range(64.0f, 4096.0f);
        type.field<&Plot::height>("height").unit(Unit::Pixels).range(32.0f, 4096.0f);
        type.field<&Plot::seconds>("seconds").unit(Unit::Seconds).range(1.0f, 120.0f).doc("That are shown.");
        type.field<&Plot::min>("min").doc("At the bottom; as large as max: as the curves want it.");
        type.field<&Plot::max>("max").doc("At the top.");
        type.field<&Plot::powers>("powers").doc(
            "Each line is ten times the one below; min and max are exponents.");
        type.field<&Plot::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
    }
};

}  // namespace plumb
