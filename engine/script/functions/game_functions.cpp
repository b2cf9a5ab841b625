#include "gameplay/game_functions.hpp"

#include <algorithm>
#include <vector>

#include <lua.hpp>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "gameplay/touches.hpp"
#include "input/input_frame.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/physics_queries.hpp"
#include "scene/world_transform.hpp"
#include "script/script_arguments.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_functions.hpp"
#include "script/script_vector.hpp"
#include "script/values/component.hpp"

namespace plumb::script {
namespace {

/// Sets fields of components: {Sprite = {tint = "#ff0000"}}. @return false after pushing a message
bool setComponents(lua_State* state, int table, EntityId entity) {
    World& world = worldOf(state);
    for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
        const char* name = lua_type(state, -2) == LUA_TSTRING ? lua_tostring(state, -2) : "?";
        const TypeInfo* type = world.types()->find(name);
        if (type == nullptr || lua_istable(state, -1) == 0 || !world.has(*type, entity)) {
            lua_pushfstring(state, "the prefab has no component \"%s\", or its fields are no table", name);
            return false;
        }
        if (!setFields(state, lua_gettop(state), entity, *type)) return false;
    }
    return true;
}

int spawnPrefabAt(lua_State* state) {
    const std::string_view prefab = checkText(state, 1);
    const Vec2 position = checkFiniteVector(state, 2);
    if (!lua_isnoneornil(state, 3)) luaL_checktype(state, 3, LUA_TTABLE);
    const EntityId entity = spawn(worldOf(state), prefab, position).id();
    if (!entity) return luaL_error(state, "the prefab cannot be spawned; see the log");
    if (lua_istable(state, 3) && !setComponents(state, 3, entity)) return lua_error(state);
    pushEntity(state, entity);
    return 1;
}

/// Pushes a table of handles, of entities or their ids.
template <class Handle>
void pushEntities(lua_State* state, const std::vector<Handle>& entities) {
    lua_createtable(state, static_cast<int>(entities.size()), 0);
    for (std::size_t i = 0; i < entities.size(); ++i) {
        pushEntity(state, entities[i]);
        lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
}

int findByName(lua_State* state) {
    const std::string_view name = checkText(state, 1);
    pushEntity(state, findEntity(worldOf(state), name).id());
    return 1;
}

int findByTag(lua_State* state) {
    const std::string_view tag = checkText(state, 1);
    pushEntities(state, findEntities(worldOf(state), tag));
    return 1;
}

int playSoundFile(lua_State* state) {
    if (lua_isnoneornil(state, 1))
        return luaL_argerror(
            state, 1,
            "path of a sound expected, got nil; a property of the kind sound is nil while no "
            "file is chosen: if self.noise then playSound(self.noise) end");
    const std::string_view path = checkText(state, 1);
    const float volume = optionalFinite(state, 2, 1.0f);
    World& world = worldOf(state);
    playSound(world, assetsOf(world).loadSound(path), volume);
    return 0;
}

int showTextFor(lua_State* state) {
    const std::string_view word = checkText(state, 1);
    // 3, not 3.0: scores are often sums of properties, which are numbers with a fraction.
    lua_Integer whole = 0;
    if (lua_type(state, 2) == LUA_TNUMBER && lua_numbertointeger(lua_tonumber(state, 2), &whole) &&
        static_cast<lua_Number>(whole) == lua_tonumber(state, 2)) {
        lua_pushinteger(state, whole);
        lua_replace(state, 2);
    }
    std::size_t size = 0;
    const char* text = luaL_tolstring(state, 2, &size);
    showText(worldOf(state), word, {text, size});
    return 0;
}

int mouse(lua_State* state) {
    pushVector(state, mouseInWorld(worldOf(state)));
    return 1;
}

int changeToScene(lua_State* state) {
    changeScene(worldOf(state), checkText(state, 1));
    return 0;
}
int openOverlayScene(lua_State* state) {
    showOverlay(worldOf(state), checkText(state, 1));
    return 0;
}
int closeOverlayScene(lua_State* state) {
    hideOverlay(worldOf(state));
    return 0;
}
int restart(lua_State* state) {
    restartScene(worldOf(state));
    return 0;
}
int quit(lua_State* state) {
    quitGame(worldOf(state));
    return 0;
}

/// The slot that is argument 1, by default 1. Every integer that is not the number of a slot becomes another
/// one that is not, which an int can hold.
int slotAt(lua_State* state) {
    const lua_Integer slot = luaL_optinteger(state, 1, 1);
    return static_cast<int>(std::clamp<lua_Integer>(slot, 0, kSaveSlots + 1));
}

int save(lua_State* state) {
    saveGame(worldOf(state), slotAt(state));
    return 0;
}
int load(lua_State* state) {
    loadGame(worldOf(state), slotAt(state));
    return 0;
}
int isSaved(lua_State* state) {
    lua_pushboolean(state, hasSave(worldOf(state), slotAt(state)) ? 1 : 0);
    return 1;
}
int options(lua_State* state) {
    showOptions(worldOf(state));
    return 0;
}

int playEntityClip(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    playClip(worldOf(state), entity, checkText(state, 2));
    return 0;
}

int setEntityParameter(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    const std::string_view name = checkText(state, 2);
    const bool isBool = lua_isboolean(state, 3);
    setParameter(worldOf(state), entity, name,
                 isBool ? static_cast<float>(lua_toboolean(state, 3)) : checkFinite(state, 3));
    return 0;
}

int applyImpulseTo(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    applyImpulse(worldOf(state), entity, checkFiniteVector(state, 2));
    return 0;
}

int shake(lua_State* state) {
    const float strength = checkFinite(state, 1);
    shakeCamera(worldOf(state), strength, checkFinite(state, 2));
    return 0;
}

int worldPositionOf(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    pushVector(state, worldPose(worldOf(state), entity).position);
    return 1;
}

int teleportEntity(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    const Vec2 position = checkFiniteVector(state, 2);
    auto* transform = worldOf(state).find<Transform>(entity);
    if (transform == nullptr) return luaL_argerror(state, 1, "the entity has no Transform");
    teleport(*transform, position);
    return 0;
}

/// An entity to ignore, or a table: { except = entity, mask = bits of layers, triggers = true }.
QueryFilter checkFilter(lua_State* state, int index) {
    QueryFilter filter;
    if (lua_isnoneornil(state, index)) return filter;
    filter.except = entityAt(state, index);
    if (filter.except || lua_istable(state, index) == 0) {
        filter.except = checkEntity(state, index);
        return filter;
    }
    lua_getfield(state, index, "except");
    filter.except = entityAt(state, -1);
    lua_getfield(state, index, "mask");
    if (lua_isnil(state, -1) == 0 && lua_isinteger(state, -1) == 0)
        luaL_argerror(state, index, "mask must be a whole number: the sum of the bits of layers");
    if (lua_isinteger(state, -1) != 0) filter.mask = static_cast<std::uint32_t>(lua_tointeger(state, -1));
    lua_getfield(state, index, "triggers");
    filter.triggers = lua_toboolean(state, -1) != 0;
    lua_pop(state, 3);
    return filter;
}

int castRayFrom(lua_State* state) {
    const Vec2 from = checkFiniteVector(state, 1);
    const Vec2 way = checkFiniteVector(state, 2);
    const std::optional<QueryHit> hit = castRay(worldOf(state), from, way, checkFilter(state, 3));
    if (!hit) return lua_pushnil(state), 1;
    lua_createtable(state, 0, 4);
    pushEntity(state, hit->entity);
    lua_setfield(state, -2, "entity");
    pushVector(state, hit->point);
    lua_setfield(state, -2, "point");
    pushVector(state, hit->normal);
    lua_setfield(state, -2, "normal");
    lua_pushnumber(state, hit->fraction);
    lua_setfield(state, -2, "fraction");
    return 1;
}

int overlapBoxBetween(lua_State* state) {
    const Vec2 a = checkFiniteVector(state, 1);
    const Vec2 b = checkFiniteVector(state, 2);
    const QueryFilter filter = checkFilter(state, 3);
    std::vector<EntityId> found;
    overlapBox(worldOf(state), {min(a, b), max(a, b)}, filter, found);
    pushEntities(state, found);
    return 1;
}

constexpr ScriptFunction kGame[] = {
    {"spawn", "(prefab: string, position: vec, fields: table?): Entity",
     "Instantiates a prefab: spawn(\"coin\", vec(10, 20), { Coin = { value = 5 } }). The third value sets "
     "fields "
     "of components of its root.",
     spawnPrefabAt},
    {"findEntity", "(name: string): Entity?",
     "The first entity with this name; a path finds the child of a child: \"Boss/Arm/Hand\".", findByName},
    {"findEntities", "(tag: string): Entity[]", "The entities whose component Tags contains this word.",
     findByTag},
    {"teleport", "(entity: Entity, position: vec)",
     "Moves an entity without drawing the motion from its old position.", teleportEntity},
    {"worldPosition", "(entity: Entity): vec",
     "The position of an entity in the world, px; transform.position is relative to its parent.",
     worldPositionOf},
    {"applyImpulse", "(entity: Entity, impulse: vec)",
     "Changes the velocity of the entity's RigidBody by impulse / mass, kg px/s.", applyImpulseTo},
    {"playClip", "(entity: Entity, clip: string)",
     "Plays a clip of the entity's Animator, unless it is playing already.", playEntityClip},
    {"setParameter", "(entity: Entity, name: string, value: number|boolean)",
     "Sets a parameter of the state machine of the entity's Animator.", setEntityParameter},
    {"shakeCamera", "(strength: number, seconds: number)", "Shakes the camera by up to `strength` px.",
     shake},
    {"playSound", "(path: string, volume: number?)", "Plays a sound, starting in this tick.", playSoundFile},
    {"showText", "(word: string, text: any)", "Sets the text that replaces {word} in every Label.",
     showTextFor},
    {"mouseInWorld", "(): vec", "The position of the mouse in the world, px.", mouse},
    {"castRay", "(from: vec, way: vec, filter: Entity|table?): table?",
     "The first collider that a ray from `from` to `from + way` hits: { entity, point, normal, fraction }, "
     "or nil.",
     castRayFrom},
    {"overlapBox", "(min: vec, max: vec, filter: Entity|table?): Entity[]",
     "The entities whose colliders overlap a box.", overlapBoxBetween},
    {"changeScene", "(scene: string)", "Changes to another scene at the end of this tick.", changeToScene},
    {"showOverlay", "(scene: string)", "Opens a scene over the current one, which is paused meanwhile.",
     openOverlayScene},
    {"hideOverlay", "()", "Closes the top overlay.", closeOverlayScene},
    {"restartScene", "()", "Loads the current scene again.", restart},
    {"quitGame", "()", "Ends the game.", quit},
    {"saveGame", "(slot: integer?)", "Saves the game at the end of this tick, in slot 1 to 32.", save},
    {"loadGame", "(slot: integer?)", "Continues with a saved game at the end of this tick.", load},
    {"hasSave", "(slot: integer?): boolean", "True if there is a saved game in the slot.", isSaved},
    {"showOptions", "()", "Opens the options of the player, which pause the game.", options},
};

}  // namespace

std::span<const ScriptFunction> gameFunctions() { return kGame; }

}  // namespace plumb::script
