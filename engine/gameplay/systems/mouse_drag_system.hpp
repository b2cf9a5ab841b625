#pragma once

#include <string_view>

namespace plumb {

class World;

/// Lets the player drag bodies with the mouse.
/// Reads: Input, the camera, RigidBody. Writes: MouseDrag, MouseJoint, SoftGrip, its own Transform and
/// Hidden. When: before physics.
struct MouseDragSystem {
    static constexpr std::string_view kName = "mouse drag";

    void update(World& world, float dt);
};

}  // namespace plumb
