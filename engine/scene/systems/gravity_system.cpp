#include "scene/systems/gravity_system.hpp"

#include "scene/systems/physics_system.hpp"

namespace plumb {

void GravitySystem::update(World& world, float dt) { stepAsLast<GravitySystem>(world, dt); }

}  // namespace plumb
