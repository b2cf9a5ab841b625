#pragma once

#include <cstdint>

#include "math/color.hpp"
#include "math/vec2.hpp"
#include "physics/settings.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// On, off, or as the scene has it.
enum class AsScene : std::uint8_t { Same, Off, On };

/// The scene's physics a second time with other settings, beginning from where the scene stands. Its outlines
/// are drawn, and plots show it; it touches nothing, and game code never sees it.
struct Ghost {
    int quality = -1;    ///< 2^quality substeps; -1: the scene's
    int iterations = 0;  ///< of each substep; 0: the scene's
    physics::IntegratorKind integrator = physics::IntegratorKind::Count;  ///< Count: the scene's
    AsScene continuous = AsScene::Same;
    AsScene automaticQuality = AsScene::Same;
    AsScene jointTrees = AsScene::Same;  ///< joints that make up trees are solved at once
    float nudge = 0.0f;                  ///< px: so far to the right its first body begins
    Vec2 offset;                         ///< px: so far beside the scene it is drawn
    Color color{120, 200, 255, 255};

    static void describe(TypeBuilder<Ghost>& type) {
        type.name("Ghost").doc(
            "The scene's physics a second time with other settings: drawn and plotted, never met.");
        type.field<&Ghost::quality>("quality").range(-1.0f, 6.0f).doc("2^quality substeps; -1: the scene's.");
        type.field<&Ghost::iterations>("iterations")
            .range(0.0f, 64.0f)
            .doc("Of each substep; 0: the scene's.");
        type.field<&Ghost::integrator>("integrator")
            .names({{"ExplicitEuler", 0}, {"SemiImplicitEuler", 1}, {"Verlet", 2}, {"Rk4", 3}, {"same", 4}});
        type.field<&Ghost::continuous>("continuous").names({{"same", 0}, {"off", 1}, {"on", 2}});
        type.field<&Ghost::automaticQuality>("automaticQuality").names({{"same", 0}, {"off", 1}, {"on", 2}});
        type.field<&Ghost::jointTrees>("jointTrees")
            .names({{"same", 0}, {"off", 1}, {"on", 2}})
            .doc("Joints that make up trees are solved at once.");
        type.field<&Ghost::nudge>("nudge")
            .unit(Unit::Pixels)
            .doc("So far to the right its first body begins.");
        type.field<&Ghost::offset>("offset").unit(Unit::Pixels).doc("So far beside the scene it is drawn.");
        type.field<&Ghost::color>("color");
    }
};

}  // namespace plumb
