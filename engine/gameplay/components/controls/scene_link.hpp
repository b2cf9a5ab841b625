#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Goes to another scene when the player confirms: titles, endings, menus.
struct SceneLink {
    SceneId scene;            ///< where it leads
    bool overlay = false;     ///< keeps this scene beneath
    bool newGame = false;     ///< forgets coins, deaths and time
    float delay = 0.0f;       ///< s, before a press counts
    float after = 0.0f;       ///< s, goes by itself after this; 0 never
    std::uint32_t ticks = 0;  ///< ticks, since the scene began

    static void describe(TypeBuilder<SceneLink>& type) {
        type.name("SceneLink").doc("Goes to another scene when the player confirms: titles, endings, menus.");
        type.field<&SceneLink::scene>("scene").doc("Where it leads.");
        type.field<&SceneLink::overlay>("overlay").doc("Keeps this scene beneath.");
        type.field<&SceneLink::newGame>("newGame").doc("Forgets coins, deaths and time.");
        type.field<&SceneLink::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 600.0f)
            .doc("Before a press counts.");
        type.field<&SceneLink::after>("after")
            .unit(Unit::Seconds)
            .range(0.0f, 600.0f)
            .doc("Goes by itself after this; 0 never.");
        type.field<&SceneLink::ticks>("ticks").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
