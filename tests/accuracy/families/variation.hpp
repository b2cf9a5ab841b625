#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "physics/settings.hpp"
#include "tests/bench/physics/measure.hpp"

namespace plumb::families {

/// Placement of a scene in the world. The result must not depend on it.
struct Placement {
    bool mirrored = false;  ///< true: x becomes -x
    int quarterTurns = 0;   ///< rotation of the scene and its gravity, in quarter turns
    float scale = 1.0f;     ///< factor of all lengths, speeds and gravity; times stay the same
    double originX = 0.0;   ///< position of the scene's origin, m
    double originY = 0.0;
};

/// Settings and placement with which a scene is simulated.
struct Variation {
    physics::Quality quality = 2;  ///< solver quality; kQualityOfWorld: automatic
    bool sleeping = true;          ///< bodies at rest may sleep
    bool directJoints = true;      ///< direct solver for joints that form trees
    bool continuous = true;        ///< continuous collision detection
    bool allEffects = false;       ///< runs every effect, even those that the scene does not require
    physics::BroadPhaseKind broadPhase = physics::BroadPhaseKind::Tree;
    int threads = 1;            ///< threads of the physics step
    int restoreEvery = 0;       ///< steps between replacements of the world by a copy of itself; 0: never
    int delay = 0;              ///< number of steps of the empty world before the scene is built
    std::uint64_t shuffle = 0;  ///< seed of the order in which bodies and joints are created; 0: as planned
    Placement placement;
    std::function<void(physics::Settings&)> tune;  ///< changes settings before scaling; may be empty
    std::vector<bool> dropped;  ///< per body: true if omitted; may be shorter than the list of bodies
    const scenes::Engine* peer = nullptr;  ///< another engine with its default settings; null: Plumb
};

}  // namespace plumb::families
