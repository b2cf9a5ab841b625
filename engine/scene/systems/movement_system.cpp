#include "scene/systems/movement_system.hpp"

#include "scene/systems/physics_system.hpp"

namespace plumb {

void MovementSystem::update(World& world, float dt) { stepAsLast<MovementSystem>(world, dt); }

}  // namespace plumb
