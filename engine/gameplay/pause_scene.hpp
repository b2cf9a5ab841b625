#pragma once

#include "reflect/field_types.hpp"

namespace plumb {

/// The overlay that the Pause action opens. A world resource, set from the project when a game starts.
struct PauseScene {
    static constexpr bool kNotSaved = true;

    SceneId path;  ///< empty for none
};

}  // namespace plumb
