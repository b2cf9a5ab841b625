#pragma once

#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "ecs/world.hpp"
#include "math/vec2.hpp"
#include "reflect/field_types.hpp"
#include "scene/components/drawing/particle_emitter.hpp"

// Functions that systems of a game often need. They are part of the simulation: replays repeat their effects.

namespace plumb {

class AssetStore;

/// Returns the first entity with this Name, or the empty handle. A path finds the child of a child:
/// "Boss/Arm/Hand".
Entity findEntity(World& world, std::string_view name);
/// Returns the entities whose Tags contain this word, in the order in which they were created.
std::vector<Entity> findEntities(World& world, std::string_view tag);
/// True if the Tags of an entity contain this word.
bool hasTag(const World& world, EntityId entity, std::string_view tag);
/// Instantiates a prefab file: "coin", "prefabs/coin" or "prefabs/coin.prefab.json"; a file without folder
/// may be in "prefabs" or in "assets". Errors are logged, each once.
/// @param position  px, of the root
/// @return the root entity, or the empty handle
Entity spawn(World& world, std::string_view prefab, Vec2 position);
/// The same for a field of a component. @return the empty handle if the field is empty
Entity spawn(World& world, PrefabId prefab, Vec2 position);
/// Returns the random number generator of the simulation. Others, e.g. rand(), make replays diverge.
Random& randomOf(World& world);
/// Plays a sound, starting in this tick. @param volume  ratio, 0..1
void playSound(World& world, SoundId sound, float volume = 1.0f);
/// Returns the position of the mouse (px) in the view of the first enabled camera.
Vec2 mouseInWorld(World& world);
/// Plays a clip of an entity's Animator from its start, unless it is playing already. Does nothing if there
/// is no clip of this name.
void playClip(World& world, EntityId entity, std::string_view clip);
/// Changes the velocity of an entity's RigidBody by impulse / mass. @param impulse  kg px/s
void applyImpulse(World& world, EntityId entity, Vec2 impulse);
/// Shakes the first enabled camera, unless it still shakes more strongly.
/// @param strength  px, at the start @param seconds  s
void shakeCamera(World& world, float strength, float seconds);
/// Emits `count` particles at once, from a new entity that is destroyed after the last of them.
/// @param position  px
/// @param emitter   look and motion of the particles; its rate, burst and loop are not used
Entity burst(World& world, Vec2 position, int count, ParticleEmitter emitter);
/// Sets the text that replaces {word} in every Label.
void showText(World& world, std::string_view word, std::string_view text);
/// Returns the store of the game's textures, sounds and other assets.
AssetStore& assetsOf(World& world);

// Requests that are performed at the end of this tick.

/// Changes to another scene: "level2", "scenes/level2" or "scenes/level2.scene.json". If there is no such
/// scene, an error with the nearest name is logged, and the current scene continues; so it does if the name
/// is empty.
void changeScene(World& world, std::string_view scene);
/// The same for a field of a component. Does nothing if the field is empty.
void changeScene(World& world, SceneId scene);
/// Opens a scene over the current one, which is paused meanwhile; names and errors as for changeScene().
void showOverlay(World& world, std::string_view scene);
/// The same for a field of a component. Does nothing if the field is empty.
void showOverlay(World& world, SceneId scene);
/// Closes the top overlay.
void hideOverlay(World& world);
/// Loads the current scene again.
void restartScene(World& world);
/// Ends the game.
void quitGame(World& world);
/// Saves the whole state of the game, after this tick. Errors are logged, and the game goes on. Does nothing
/// in a replay, in the editor, and headless without --saves.
/// @param slot  1..32; another one is an error, which is logged
void saveGame(World& world, int slot);
/// Continues with a saved game, after this tick. Does nothing where saveGame() does nothing, and if the game
/// cannot be loaded, which is logged.
void loadGame(World& world, int slot);
/// True if there is a saved game in the slot. Part of the input, so that replays do not depend on files.
bool hasSave(const World& world, int slot);
/// Opens the options of the player: screen, sound and keys. They pause the game.
void showOptions(World& world);

}  // namespace plumb
