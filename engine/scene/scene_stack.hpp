#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "ecs/entity.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb {

class Input;
struct PhysicsState;

// The scenes of a world form a stack: at the bottom the current scene, above it the open overlays. All their
// entities are in the same world; LoadedScenes stores the order.

/// Changes to a scene: loads it and unloads all others, with all entities created by code. Persistent
/// entities and their children are kept.
/// @param text  content to use instead of the file, e.g. from an editor; null: the file is read
/// @error the file cannot be read; the previous scenes are kept, unless the scene is one of them
Result<LoadReport> switchScene(World& world, const SceneContext& context, std::string_view path,
                               const std::string* text = nullptr);

/// Opens a scene as an overlay above the current ones. Its Overlay component controls whether those are
/// paused and receive input; without one they are paused and receive none.
/// @error the file cannot be read, or the scene is already open; the world is unchanged
Result<LoadReport> openOverlay(World& world, const SceneContext& context, std::string_view path);

/// Closes the top overlay and destroys the entities created while it paused the scenes below, which resume in
/// exactly the state they were paused in.
/// @return false if there is no overlay
bool closeOverlay(World& world);

/// Returns the index in the scene stack of an entity's scene. Entities created by code belong to the topmost
/// overlay that pauses the scenes below it but not them; without such an overlay, to the bottom scene.
std::size_t placeOf(const World& world, EntityId entity);

/// Returns the LoadedScene::loading of an entity's scene, as placeOf(); 0 for what outlives all scenes: a
/// persistent entity, or any without a scene.
std::uint32_t loadingOf(const World& world, EntityId entity);

/// Returns the physics of the bottom scene, running or paused by overlays, for display. May be null.
const PhysicsState* lowestPhysics(const World& world);

/// Returns the input for an entity: empty while an overlay above it takes the input. Systems that react to
/// the player must use this function instead of the Input resource.
const Input& inputFor(World& world, EntityId entity);

}  // namespace plumb
