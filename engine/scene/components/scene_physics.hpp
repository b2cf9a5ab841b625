#pragma once

#include "math/vec2.hpp"
#include "physics/settings.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Physics settings of this scene, in place of the project's. Only the first ScenePhysics of a scene is used.
struct ScenePhysics {
    Vec2 gravity{0.0f, 980.0f};  ///< px/s^2, positive y is down
    int quality = 2;             ///< 2^quality substeps per tick
    physics::IntegratorKind integrator = physics::IntegratorKind::SemiImplicitEuler;
    int iterations = 1;             ///< solver iterations per substep
    bool automaticQuality = false;  ///< more substeps for islands that are hard to solve
    float tolerance = 0.0f;         ///< px: maximum error of contacts and joints; 0: fixed quality
    bool continuous = true;         ///< continuous collision detection of fast bodies against static shapes
    bool sleeping = true;           ///< bodies at rest fall asleep and cost no time

    static void describe(TypeBuilder<ScenePhysics>& type) {
        type.name("ScenePhysics").doc("Physics settings of this scene, in place of the project's.");
        type.field<&ScenePhysics::gravity>("gravity")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Gravity of the scene, px/s2; positive y is down.");
        type.field<&ScenePhysics::quality>("quality")
            .range(0.0f, 6.0f)
            .doc(
                "Quality: 2^quality substeps per tick. Each level is slower and several times more "
                "accurate.");
        type.field<&ScenePhysics::integrator>("integrator")
            .names({{"ExplicitEuler", 0}, {"SemiImplicitEuler", 1}, {"Verlet", 2}, {"Rk4", 3}})
            .doc("Numerical integrator of bodies in fields and on springs.");
        type.field<&ScenePhysics::iterations>("iterations")
            .range(1.0f, 64.0f)
            .doc("Solver iterations per substep.");
        type.field<&ScenePhysics::automaticQuality>("automaticQuality")
            .doc("More substeps for islands that are hard to solve: mass ratios, stacks, chains.");
        type.field<&ScenePhysics::tolerance>("tolerance")
            .range(0.0f, 16.0f)
            .unit(Unit::Pixels)
            .doc(
                "Maximum error, px: islands whose contacts or joints exceed it get more substeps, all others "
                "as few "
                "as suffice. 0: all use the substeps of quality.");
        type.field<&ScenePhysics::continuous>("continuous")
            .doc("Continuous collision detection: fast bodies do not pass through static shapes.");
        type.field<&ScenePhysics::sleeping>("sleeping").doc("Bodies at rest fall asleep and cost no time.");
    }
};

}  // namespace plumb
