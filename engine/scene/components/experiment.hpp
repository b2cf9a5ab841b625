#pragma once

#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Stores the initial state of the scene's bodies. An input action, or releasing a Slider, restores it and
/// restarts ghosts and plots. Only the first Experiment of a scene is used.
struct Experiment {
    TextId action;            ///< name of the input action (project.json) that restarts the experiment
    bool afterSlider = true;  ///< releasing a moved slider restarts the experiment too

    static void describe(TypeBuilder<Experiment>& type) {
        type.name("Experiment")
            .doc("Restores the initial state of all bodies, by an input action or after a slider was moved.");
        type.field<&Experiment::action>("action").doc(
            "Input action that restarts the experiment, by its name in project.json.");
        type.field<&Experiment::afterSlider>("afterSlider")
            .doc("Releasing a moved slider restarts the experiment too.");
    }
};

}  // namespace plumb
