#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "ecs/entity.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb {

class Input;
struct PhysicsState;

// The scenes of a world lie on one another: at the bottom the one that was gone to, over it the overlays that
// were opened. All their entities are in the one world; LoadedScenes has the order.

/// Goes to a scene: loads it and takes all others away, with all entities that code made since. Persistent
/// ones stay, with their children.
/// @param text  stands for the file, as an editor has it; null: the file is read
/// @error the file cannot be read; the scenes before are still there, but when it is one of them
Result<LoadReport> switchScene(World& world, const SceneContext& context, std::string_view path,
                               const std::string* text = nullptr);

/// Lays a scene over those that are there. Its Overlay component says whether they stand still (as they do
/// without one) and whether they hear the player.
/// @error the file cannot be read, or the scene is there already; nothing has changed
Result<LoadReport> openOverlay(World& world, const SceneContext& context, std::string_view path);

/// Takes the top overlay away, and what was made while it paused the rest. What it paused goes on exactly as
/// it was left.
/// @return false when there is none
bool closeOverlay(World& world);

/// Where in the stack an entity belongs: to its scene; one that code made, to the top scene that is not
/// paused.
std::size_t placeOf(const World& world, EntityId entity);

/// The physics of the scene at the bottom: as it runs, or as it was when overlays paused it. For looking at
/// it.
const PhysicsState* lowestPhysics(const World& world);

/// What an entity hears of the player: nothing while an overlay above it takes the input. Systems that react
/// to the player ask here, not the Input itself.
const Input& inputFor(World& world, EntityId entity);

}  // namespace plumb
