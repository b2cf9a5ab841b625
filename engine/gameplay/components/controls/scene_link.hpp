#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Changes to another scene when the player confirms, or after a time: titles, endings, menus.
struct SceneLink {
    SceneId scene;            ///< the scene to change to
    bool overlay = false;     ///< open the scene as an overlay over this one
    bool newGame = false;     ///< reset coins, deaths and time
    float delay = 0.0f;       ///< s from the start of the scene in which input is ignored
    float after = 0.0f;       ///< s after which the scene changes without input; 0: never
    std::uint32_t ticks = 0;  ///< ticks since the start of the scene

    static void describe(TypeBuilder<SceneLink>& type) {
        type.name("SceneLink")
            .doc(
                "Changes to another scene when the player confirms, or after a time: titles, endings, "
                "menus.");
        type.field<&SceneLink::scene>("scene").doc("Scene to change to.");
        type.field<&SceneLink::overlay>("overlay").doc("Opens the scene as an overlay over this one.");
        type.field<&SceneLink::newGame>("newGame").doc("Resets coins, deaths and time.");
        type.field<&SceneLink::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 600.0f)
            .doc("Time from the start of the scene in which input is ignored, s.");
        type.field<&SceneLink::after>("after")
            .unit(Unit::Seconds)
            .range(0.0f, 600.0f)
            .doc("Time after which the scene changes without input, s; 0: never.");
        type.field<&SceneLink::ticks>("ticks").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
