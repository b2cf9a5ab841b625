#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "ecs/world.hpp"
#include "gameplay/game_functions.hpp"
#include "input/input.hpp"
#include "platform/key.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/transform.hpp"
#include "scene/scene_stack.hpp"
#include "script/library/work.hpp"
#include "script/script_arguments.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_functions.hpp"
#include "script/script_vector.hpp"
#include "script/values/component.hpp"

namespace plumb::script {
namespace {

/// Pushes "there is no component "Sprit"; did you mean "Sprite"?". @return a negative number
int failUnknownType(lua_State* state, std::string_view name) {
    const std::string_view near = closestName(name, worldOf(state).types()->names());
    return fail(state, format("there is no component \"{}\"{}", name,
                              near.empty() ? std::string{} : format("; did you mean \"{}\"?", near)));
}

const TypeInfo& checkType(lua_State* state, int index) {
    const std::string_view name = checkText(state, index);
    const TypeInfo* type = worldOf(state).types()->find(name);
    if (type == nullptr) {
        failUnknownType(state, name);
        lua_error(state);
    }
    return *type;
}

// ---- entities

/// The entity of has() and get(), which may be destroyed: it has no components then.
EntityId checkFormerEntity(lua_State* state) {
    const EntityId entity = entityAt(state, 1);
    if (!entity) luaL_typeerror(state, 1, "entity");
    return entity;
}

int has(lua_State* state) {
    const EntityId entity = checkFormerEntity(state);
    lua_pushboolean(state, worldOf(state).has(checkType(state, 2), entity) ? 1 : 0);
    return 1;
}

int get(lua_State* state) {
    const EntityId entity = checkFormerEntity(state);
    const TypeInfo& type = checkType(state, 2);
    if (!worldOf(state).has(type, entity)) return lua_pushnil(state), 1;
    pushComponent(state, entity, type);
    return 1;
}

int add(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    const TypeInfo& type = checkType(state, 2);
    if (!lua_isnoneornil(state, 3)) luaL_checktype(state, 3, LUA_TTABLE);
    if (type.size != 0 && type.defaults.empty())
        return luaL_argerror(state, 2, "this component cannot be added");
    worldOf(state).add(type, entity);
    if (lua_istable(state, 3) && !setFields(state, 3, entity, type)) return lua_error(state);
    pushComponent(state, entity, type);
    return 1;
}

int removeComponent(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    worldOf(state).remove(checkType(state, 2), entity);
    return 0;
}

int destroy(lua_State* state) {
    const EntityId entity = entityAt(state, 1);
    if (!entity) return luaL_typeerror(state, 1, "entity");
    worldOf(state).destroy(entity);
    return 0;
}

int isAlive(lua_State* state) {
    lua_pushboolean(state, worldOf(state).alive(entityAt(state, 1)) ? 1 : 0);
    return 1;
}

int name(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    const World& world = worldOf(state);
    const Name* named = world.find<Name>(entity);
    const std::string_view text = named == nullptr ? std::string_view{} : world.texts().find(named->text);
    lua_pushlstring(state, text.data(), text.size());
    return 1;
}

int hasTagged(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    lua_pushboolean(state, hasTag(worldOf(state), entity, checkText(state, 2)) ? 1 : 0);
    return 1;
}

int parent(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    pushEntity(state, parentOf(std::as_const(worldOf(state)), entity));
    return 1;
}

int setParentOf(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    const EntityId above = lua_isnoneornil(state, 2) ? EntityId{} : checkEntity(state, 2);
    if (!setParent(worldOf(state), entity, above))
        return luaL_error(state, "an entity cannot be its own ancestor");
    return 0;
}

int children(lua_State* state) {
    const EntityId entity = checkEntity(state, 1);
    lua_newtable(state);
    lua_Integer count = 0;
    for (const Entity child : childrenOf(worldOf(state), entity)) {
        pushEntity(state, child.id());
        lua_rawseti(state, -2, ++count);
    }
    return 1;
}

constexpr ScriptFunction kEntity[] = {
    {"has", "(component: string): boolean",
     "True if the entity has a component: other:has(\"Hazard\"). A destroyed entity has none.", has},
    {"get", "(component: string): Component?", "The component of this name, or nil.", get},
    {"add", "(component: string, fields: table?): Component",
     "Adds a component, or replaces the existing one: entity:add(\"Lifetime\", { seconds = 2 }).", add},
    {"remove", "(component: string)", "Removes a component.", removeComponent},
    {"destroy", "()", "Destroys the entity and its children.", destroy},
    {"emit", "(event: string, ...: any)",
     "Calls onEvent_NAME(...) of this entity's scripts later in this tick.", emitTo},
    {"isAlive", "(): boolean", "False after the entity was destroyed.", isAlive},
    {"name", "(): string", "The name of the entity.", name},
    {"hasTag", "(tag: string): boolean", "True if the component Tags of the entity contains this word.",
     hasTagged},
    {"parent", "(): Entity?", "The parent of the entity.", parent},
    {"setParent", "(parent: Entity?)", "Makes the entity the last child of another one, or a root.",
     setParentOf},
    {"children", "(): Entity[]", "The children of the entity, in order.", children},
};

// ---- world

/// Entities that have all components that are named from index 2 on.
int query(lua_State* state) {
    World& world = worldOf(state);
    const int count = lua_gettop(state);
    if (count < 2)
        return luaL_error(state, "world:query() needs the name of a component: world:query(\"Coin\")");
    const TypeInfo* rarest = &checkType(state, 2);
    for (int i = 3; i <= count; ++i) {
        const TypeInfo& type = checkType(state, i);
        if (world.count(type) < world.count(*rarest)) rarest = &type;
    }
    constexpr std::int64_t kEntityWork = 20;  // units of Work: 0.1 us
    spend(state, static_cast<std::int64_t>(world.count(*rarest)) * kEntityWork);
    lua_newtable(state);
    lua_Integer found = 0;
    world.eachOf(*rarest, [&](EntityId entity, const void*) {
        if (world.has<Paused>(entity)) return;
        for (int i = 2; i <= count; ++i) {
            if (!world.has(checkType(state, i), entity)) return;
        }
        pushEntity(state, entity);
        lua_rawseti(state, -2, ++found);
    });
    return 1;
}

int createEntity(lua_State* state) {
    World& world = worldOf(state);
    const bool hasPlace = !lua_isnoneornil(state, 2);
    const Vec2 position = hasPlace ? checkFiniteVector(state, 2) : Vec2{};
    const EntityId entity = world.createEntity().id();
    if (hasPlace) world.add<Transform>(entity, position);
    pushEntity(state, entity);
    return 1;
}

int tick(lua_State* state) {
    lua_pushinteger(state, static_cast<lua_Integer>(worldOf(state).tick));
    return 1;
}

constexpr ScriptFunction kWorld[] = {
    {"query", "(self, ...: string): Entity[]",
     "The entities that have all of these components, without paused ones.", query},
    {"createEntity", "(self, position: vec?): Entity",
     "Creates an entity, with a Transform if a position is given.", createEntity},
    {"tick", "(self): integer", "Number of ticks since the game started; 60 a second.", tick},
};

// ---- input

/// The bindings of actions and axes.
const ActionMap& mapOf(lua_State* state) { return worldOf(state).resource<Input>().map(); }
/// What the entity of the handler hears: nothing while an overlay takes the input.
const Input& inputOf(lua_State* state) {
    const Context& context = contextOf(state);
    return inputFor(context.world, context.entity);
}

/// Pushes 'there is no action "Shoot"; the actions are Jump, Attack'. @return a negative number
template <class Bindings>
int failUnknown(lua_State* state, const char* kind, std::string_view name, const std::vector<Bindings>& known,
                const char* others) {
    std::string names;
    for (const Bindings& one : known) names += (names.empty() ? "" : ", ") + one.name;
    return fail(state, format("there is no {} \"{}\"; project.json and the defaults have {}{}", kind, name,
                              names, others));
}

/// What isPressed() and the like ask about: an action, else a key, else a button of the mouse.
struct Control {
    std::optional<Key> key;
    std::optional<MouseButton> button;
    Action action;
};

/// Reads "Jump", "W" or "Mouse Left": the names of bindings, of which those of actions come first.
Control checkControl(lua_State* state) {
    constexpr std::string_view kMouse = "Mouse ";
    const std::string_view name = checkText(state, 2);
    const ActionMap& map = mapOf(state);
    Control control{{}, {}, Action{name}};
    if (map.find(control.action) >= 0) return control;
    control.key = keyFromName(name);
    if (startsWith(name, kMouse)) control.button = mouseButtonFromName(name.substr(kMouse.size()));
    if (!control.key && !control.button) {
        failUnknown(state, "action", name, map.actions,
                    "; a key is named like \"W\" or \"Space\", a button of the mouse like \"Mouse Left\"");
        lua_error(state);
    }
    return control;
}

Axis checkAxis(lua_State* state) {
    const std::string_view name = checkText(state, 2);
    const ActionMap& map = mapOf(state);
    if (map.find(Axis{name}) < 0) {
        failUnknown(state, "axis", name, map.axes, "");
        lua_error(state);
    }
    return Axis{name};
}

/// Pushes the answer to a question about the control that argument number 2 names.
template <class Ask>
int answer(lua_State* state, Ask ask) {
    const Control control = checkControl(state);
    const Input& input = inputOf(state);
    const bool is = control.key      ? ask(input, *control.key)
                    : control.button ? ask(input, *control.button)
                                     : ask(input, control.action);
    lua_pushboolean(state, is ? 1 : 0);
    return 1;
}

int isPressed(lua_State* state) {
    return answer(state, [](const Input& input, auto control) { return input.isPressed(control); });
}
int isHeld(lua_State* state) {
    return answer(state, [](const Input& input, auto control) { return input.isHeld(control); });
}
int isReleased(lua_State* state) {
    return answer(state, [](const Input& input, auto control) { return input.isReleased(control); });
}
int getAxis(lua_State* state) {
    lua_pushnumber(state, inputOf(state).getAxis(checkAxis(state)));
    return 1;
}
int mouseInPicture(lua_State* state) {
    pushVector(state, worldOf(state).resource<Input>().mouse());
    return 1;
}

constexpr ScriptFunction kInput[] = {
    {"isPressed", "(self, control: string): boolean",
     "True in the tick in which it begins: an action (\"Jump\"), a key (\"W\", \"Space\", \"Left\") or a "
     "button "
     "of the mouse (\"Mouse Left\").",
     isPressed},
    {"isHeld", "(self, control: string): boolean", "True while the action, key or button is held.", isHeld},
    {"isReleased", "(self, control: string): boolean",
     "True in the tick in which the action, key or button is released.", isReleased},
    {"getAxis", "(self, axis: string): number",
     "-1 to 1: \"Horizontal\" (right is 1) or \"Vertical\" (down is 1).", getAxis},
    {"mouse", "(self): vec",
     "The position of the mouse in the picture, px; mouseInWorld() is that in the world.", mouseInPicture},
};

}  // namespace

std::span<const ScriptFunction> entityFunctions() { return kEntity; }
std::span<const ScriptFunction> worldFunctions() { return kWorld; }
std::span<const ScriptFunction> inputFunctions() { return kInput; }

}  // namespace plumb::script
