#pragma once

#include <cstdint>

#include "math/color.hpp"
#include "math/vec2.hpp"
#include "physics/settings.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// State of a yes/no setting of a ghost: Same as in the scene, Off, or On.
enum class AsScene : std::uint8_t { Same, Off, On };

/// A copy of the scene's physics world that is simulated with other settings, for comparison. It is drawn as
/// outlines and appears in plots, but does not interact with the scene and is not visible to game code.
struct Ghost {
    int quality = -1;    ///< 2^quality substeps per tick; -1: the scene's quality
    int iterations = 0;  ///< solver iterations per substep; 0: as many as in the scene
    physics::IntegratorKind integrator = physics::IntegratorKind::Count;  ///< Count: the scene's integrator
    AsScene continuous = AsScene::Same;        ///< continuous collision detection of fast bodies
    AsScene automaticQuality = AsScene::Same;  ///< more substeps for islands that are hard to solve
    AsScene jointTrees = AsScene::Same;        ///< solve joints that form a tree with a direct solver
    float nudge = 0.0f;               ///< px: initial displacement of its first dynamic body to the right
    Vec2 offset;                      ///< px: offset at which its outlines are drawn, from the scene's bodies
    Color color{120, 200, 255, 255};  ///< color of its outlines and curves

    static void describe(TypeBuilder<Ghost>& type) {
        type.name("Ghost").doc(
            "A copy of the scene's physics with other settings: drawn and plotted, without interaction.");
        type.field<&Ghost::quality>("quality")
            .range(-1.0f, 6.0f)
            .doc("Quality: 2^quality substeps per tick; -1: the scene's quality.");
        type.field<&Ghost::iterations>("iterations")
            .range(0.0f, 64.0f)
            .doc("Solver iterations per substep; 0: as many as in the scene.");
        type.field<&Ghost::integrator>("integrator")
            .names({{"ExplicitEuler", 0}, {"SemiImplicitEuler", 1}, {"Verlet", 2}, {"Rk4", 3}, {"same", 4}});
        type.field<&Ghost::continuous>("continuous").names({{"same", 0}, {"off", 1}, {"on", 2}});
        type.field<&Ghost::automaticQuality>("automaticQuality").names({{"same", 0}, {"off", 1}, {"on", 2}});
        type.field<&Ghost::jointTrees>("jointTrees")
            .names({{"same", 0}, {"off", 1}, {"on", 2}})
            .doc("Solves joints that form a tree with a direct solver.");
        type.field<&Ghost::nudge>("nudge")
            .unit(Unit::Pixels)
            .doc("Initial displacement of the ghost's first dynamic body to the right, px.");
        type.field<&Ghost::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Offset at which the ghost's outlines are drawn, from the scene's bodies, px.");
        type.field<&Ghost::color>("color");
    }
};

}  // namespace plumb
