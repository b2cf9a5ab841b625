#pragma once

#include <string>

namespace plumb {

class TypeRegistry;
class World;

/// What a world calls for, as a table for people: every stage of the physics step, every system and every
/// device of the player, whether it works, and for whom: component types with the number of their entities.
std::string effectList(World& world, const TypeRegistry& types);

}  // namespace plumb
