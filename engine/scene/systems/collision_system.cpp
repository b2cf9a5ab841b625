#include "scene/systems/collision_system.hpp"

#include "scene/systems/physics_system.hpp"

namespace plumb {

void CollisionSystem::update(World& world, float dt) { stepAsLast<CollisionSystem>(world, dt); }

}  // namespace plumb
