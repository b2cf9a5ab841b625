#pragma once

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Remembers where the bodies of its scene began. An action of the player, or a Slider that was let go, puts
/// them back there; ghosts and plots begin anew. One in a scene is enough.
struct Experiment {
    TextId action;            ///< one of project.json
    bool afterSlider = true;  ///< a slider that is let go begins it anew, too

    static void describe(TypeBuilder<Experiment>& type) {
        type.name("Experiment")
            .doc("Puts the bodies back where they began, by an action or after a slider was moved.");
        type.field<&Experiment::action>("action").doc("One of project.json.");
        type.field<&Experiment::afterSlider>("afterSlider")
            .doc("A slider that is let go begins it anew, too.");
    }
};

}  // namespace plumb
