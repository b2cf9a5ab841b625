#include "gameplay/systems/physics_count_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/physics_counts.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

void PhysicsCountSystem::update(World& world, float) {
    if (world.count<Label>() == 0) return;
    if (lowestPhysics(world) != world.findResource<PhysicsState>()) return;  // the bottom scene is paused
    world.resource<PhysicsCounts>().detection = physics::detectionOf(world.resource<PhysicsState>().world);
}

}  // namespace plumb
