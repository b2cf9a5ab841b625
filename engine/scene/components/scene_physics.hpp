#pragma once

#include "math/vec2.hpp"
#include "physics/settings.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// How the physics of this scene differs from the project's. One in a scene is enough; the first one counts.
struct ScenePhysics {
    Vec2 gravity{0.0f, 980.0f};  ///< px/s^2
    int quality = 2;             ///< 2^quality substeps in a tick
    physics::IntegratorKind integrator = physics::IntegratorKind::SemiImplicitEuler;
    int iterations = 1;             ///< of each substep
    bool automaticQuality = false;  ///< hard cases get more substeps by themselves
    float tolerance = 0.0f;         ///< px: the largest error of what touches or is joined; 0: quality counts
    bool continuous = true;         ///< fast bodies never pass through what stands still
    bool sleeping = true;           ///< what rests costs nothing

    static void describe(TypeBuilder<ScenePhysics>& type) {
        type.name("ScenePhysics").doc("How the physics of this scene differs from the project's.");
        type.field<&ScenePhysics::gravity>("gravity").unit(Unit::PixelsPerSecondSquared);
        type.field<&ScenePhysics::quality>("quality")
            .range(0.0f, 6.0f)
            .doc("2^quality substeps in a tick: each step more is slower and several times as exact.");
        type.field<&ScenePhysics::integrator>("integrator")
            .names({{"ExplicitEuler", 0}, {"SemiImplicitEuler", 1}, {"Verlet", 2}, {"Rk4", 3}})
            .doc("How bodies move in fields and on springs.");
        type.field<&ScenePhysics::iterations>("iterations").range(1.0f, 64.0f).doc("Of each substep.");
        type.field<&ScenePhysics::automaticQuality>("automaticQuality")
            .doc("Hard cases get more substeps by themselves.");
        type.field<&ScenePhysics::tolerance>("tolerance")
            .range(0.0f, 16.0f)
            .unit(Unit::Pixels)
            .doc(
                "The largest error: what overlaps or comes apart by more gets more substeps, and the rest as "
                "few as do. 0: all get those of quality.");
        type.field<&ScenePhysics::continuous>("continuous")
            .doc("Fast bodies never pass through what stands still.");
        type.field<&ScenePhysics::sleeping>("sleeping").doc("What rests costs nothing.");
    }
};

}  // namespace plumb
