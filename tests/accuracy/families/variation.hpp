#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "physics/settings.hpp"
#include "tests/bench/physics/measure.hpp"

namespace plumb::families {

/// How a scene is placed in the world. The result must not depend on this.
struct Placement {
    bool mirrored = false;  ///< x becomes -x
    int quarterTurns = 0;   ///< of everything, gravity too
    float scale = 1.0f;     ///< of all lengths, and with them gravity and speeds: times are unchanged
    double originX = 0.0;   ///< m
    double originY = 0.0;
};

/// A method for simulating a scene.
struct Variation {
    physics::Quality quality = 2;  ///< kQualityOfWorld: automatic
    bool sleeping = true;
    bool directJoints = true;
    bool continuous = true;
    bool allEffects = false;  ///< runs every effect, even those that the scene does not require
    physics::BroadPhaseKind broadPhase = physics::BroadPhaseKind::Tree;
    int threads = 1;
    int restoreEvery = 0;       ///< steps, after which the world is replaced by a copy of itself; 0: never
    int delay = 0;              ///< steps of the empty world before the scene is built
    std::uint64_t shuffle = 0;  ///< seed of the order in which bodies and joints are created; 0: as planned
    Placement placement;
    std::function<void(physics::Settings&)> tune;  ///< may change any setting, before the scene is scaled
    std::vector<bool> dropped;                     ///< by body: removed; may be shorter
    const scenes::Engine* peer = nullptr;          ///< another engine, with its defaults
};

}  // namespace plumb::families
