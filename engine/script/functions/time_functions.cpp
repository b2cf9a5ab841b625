#include <array>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <string_view>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "gameplay/delayed_events.hpp"
#include "gameplay/tweens.hpp"
#include "script/script_arguments.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_functions.hpp"
#include "script/script_values.hpp"
#include "script/script_vector.hpp"
#include "script/values/component.hpp"

namespace plumb::script {
namespace {

// ---- waiting

Context& handlerContext(lua_State* state, const char* function) {
    Context& context = contextOf(state);
    if (context.handler != state)
        luaL_error(state, "%s() works in handlers, not in coroutines of your own", function);
    if (lua_isyieldable(state) == 0)
        luaL_error(state,
                   "%s() cannot wait inside of a function that the engine calls for an answer, e.g. that of "
                   "waitUntil() or table.sort(); return from it first",
                   function);
    return context;
}

int wait(lua_State* state) {
    Context& context = handlerContext(state, "wait");
    context.request = {static_cast<std::uint32_t>(ticksOf(optionalFinite(state, 1, 0.0f))), {}};
    return lua_yield(state, 0);
}

/// Called again in each tick, until the condition holds.
int waitUntilTrue(lua_State* state, int, lua_KContext) {
    lua_settop(state, 1);
    lua_pushvalue(state, 1);
    lua_call(state, 0, 1);
    if (lua_toboolean(state, -1) != 0) return 0;
    handlerContext(state, "waitUntil").request = {};
    return lua_yieldk(state, 0, 0, waitUntilTrue);
}
int waitUntil(lua_State* state) {
    luaL_checktype(state, 1, LUA_TFUNCTION);
    return waitUntilTrue(state, LUA_OK, 0);
}

int waitFor(lua_State* state) {
    const std::string_view name = checkText(state, 1);
    const bool isLimited = !lua_isnoneornil(state, 2);
    const auto most = isLimited ? static_cast<std::uint32_t>(ticksOf(checkFinite(state, 2))) : 0u;
    Context& context = handlerContext(state, "waitFor");
    context.request = {most, context.world.texts().add(name)};
    return lua_yield(state, 0);
}

// ---- events

ScriptValue checkValue(lua_State* state, int index) {
    World& world = worldOf(state);
    switch (lua_type(state, index)) {
        case LUA_TNIL: return {};
        case LUA_TBOOLEAN: return scriptValue(world, lua_toboolean(state, index) != 0);
        case LUA_TNUMBER:
            return lua_isinteger(state, index) != 0 ? scriptValue(world, lua_tointeger(state, index))
                                                    : scriptValue(world, lua_tonumber(state, index));
        case LUA_TSTRING: {
            std::size_t size = 0;
            const char* text = lua_tolstring(state, index, &size);
            return scriptValue(world, std::string_view{text, size});
        }
        default: break;
    }
    if (const Vec2* vector = vectorAt(state, index)) return scriptValue(world, *vector);
    const EntityId entity = entityAt(state, index);
    if (!entity)
        luaL_argerror(
            state, index,
            "events pass nil, booleans, numbers, texts, vectors and entities; pass the parts of a table");
    return scriptValue(world, entity);
}

/// The event whose name is at an index, followed by its values.
ScriptEvent checkEvent(lua_State* state, int index) {
    const std::string_view name = checkText(state, index);
    const int count = lua_gettop(state) - index;
    if (count > static_cast<int>(ScriptEvent::kMaxValues))
        luaL_error(state, "an event has at most %d values", static_cast<int>(ScriptEvent::kMaxValues));
    ScriptEvent event;
    event.name = worldOf(state).texts().add(name);
    for (int i = 1; i <= count; ++i) event.add(checkValue(state, index + i));
    return event;
}

int emit(lua_State* state) {
    worldOf(state).emit(checkEvent(state, 1));
    return 0;
}

int emitToTarget(lua_State* state) {
    const EntityId target = checkEntity(state, 1);
    ScriptEvent event = checkEvent(state, 2);
    event.target = target;
    worldOf(state).emit(event);
    return 0;
}

int emitAfterSeconds(lua_State* state) {
    const float seconds = checkFinite(state, 1);
    const ScriptEvent event = checkEvent(state, 2);
    const Context& context = contextOf(state);
    const DelayedEvent timer = emitAfter(context.world, context.entity, seconds, event);
    lua_pushinteger(state, static_cast<lua_Integer>(timer.number));
    return 1;
}

int cancelEvent(lua_State* state) {
    cancel(worldOf(state), DelayedEvent{static_cast<std::uint64_t>(luaL_checkinteger(state, 1))});
    return 0;
}

// ---- tweens

constexpr std::array kEases{"linear",   "quadIn",     "quadOut",   "quadInOut",  "cubicIn",
                            "cubicOut", "cubicInOut", "sineIn",    "sineOut",    "sineInOut",
                            "backIn",   "backOut",    "backInOut", "elasticOut", "bounceOut"};

Ease checkEase(lua_State* state, int index) {
    if (lua_isnoneornil(state, index)) return Ease::QuadInOut;
    const std::string_view wanted = luaL_checkstring(state, index);
    for (std::size_t i = 0; i < kEases.size(); ++i) {
        if (wanted == kEases[i]) return static_cast<Ease>(i);
    }
    luaL_argerror(state, index, "unknown easing; e.g. \"linear\", \"quadOut\", \"sineInOut\", \"bounceOut\"");
    return Ease::Linear;
}

/// Sets the goal of a tween to the value on top of the stack. @return false after pushing a message
bool readGoal(lua_State* state, const TypeInfo& type, const FieldInfo& field, Tweens::Entry& tween) {
    World& world = worldOf(state);
    const int value = lua_gettop(state);
    if (field.kind == FieldKind::Color) {
        std::array<std::uint8_t, 4> color{};
        if (!readValue(state, value, world, type.name, field, color.data())) return false;
        tween.kind = Tweens::Kind::Color;
        for (std::size_t i = 0; i < color.size(); ++i) tween.to[i] = color[i];
        return true;
    }
    if (field.kind != FieldKind::Float && field.kind != FieldKind::Vec2) {
        const char* problem = field.kind == FieldKind::Int
                                  ? "a whole number cannot change gradually; declare it as number {...}"
                                  : "only numbers, vectors and colors change gradually; assign it";
        const std::string text = format("{}.{}: {}", type.name, field.name, problem);
        lua_pushlstring(state, text.data(), text.size());
        return false;
    }
    tween.kind = field.kind == FieldKind::Float ? Tweens::Kind::Float : Tweens::Kind::Vec2;
    return readValue(state, value, world, type.name, field, tween.to.data());
}

/// The field `position` if a coordinate of it is called like this: scripts write transform.x too. Or null.
const FieldInfo* fieldOfCoordinate(const TypeInfo& type, std::string_view name) {
    const FieldInfo* position = type.find("position");
    const bool has = position != nullptr && position->kind == FieldKind::Vec2 && type.find("x") == nullptr;
    return has && (name == "x" || name == "y") ? position : nullptr;
}

/// Raises an error if a key of the table of goals is no field.
void checkGoals(lua_State* state, int goals, const TypeInfo& type) {
    for (lua_pushnil(state); lua_next(state, goals) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) != LUA_TSTRING)
            luaL_argerror(state, goals, "the names of fields expected, as in { position = vec(10, 20) }");
        const std::string_view name = lua_tostring(state, -2);
        if (type.find(name) != nullptr || fieldOfCoordinate(type, name) != nullptr) continue;
        failUnknownField(state, type, name);
        lua_error(state);
    }
}

/// Starts the tween of a coordinate, if the table at index 2 has a goal for it. @return false after pushing a
/// message
bool tweenCoordinate(lua_State* state, const TypeInfo& type, const char* name, Tweens::Entry tween,
                     float seconds) {
    lua_pushstring(state, name);
    const bool hasGoal = lua_rawget(state, 2) != LUA_TNIL;
    const FieldInfo* position = fieldOfCoordinate(type, name);
    if (hasGoal && position != nullptr) {
        FieldInfo coordinate = *position;
        coordinate.name = name;
        coordinate.kind = FieldKind::Float;
        const std::size_t place = name[0] == 'x' ? offsetof(Vec2, x) : offsetof(Vec2, y);
        tween.offset = static_cast<std::uint32_t>(position->offset + place);
        if (!readGoal(state, type, coordinate, tween)) return false;
        addTween(worldOf(state), tween, seconds);
    }
    lua_pop(state, 1);
    return true;
}

/// tween(component, {field = value}, seconds, ease)
int tweenFields(lua_State* state) {
    const ComponentHandle component = checkComponent(state, 1);
    luaL_checktype(state, 2, LUA_TTABLE);
    const float seconds = checkFinite(state, 3);
    Tweens::Entry tween;
    tween.ease = checkEase(state, 4);
    tween.entity = component.entity;
    tween.type = component.type->key;
    checkGoals(state, 2, *component.type);
    for (const FieldInfo& field : component.type->fields) {
        lua_pushlstring(state, field.name.data(), field.name.size());
        lua_rawget(state, 2);
        if (lua_isnil(state, -1) == 0) {
            tween.offset = static_cast<std::uint32_t>(field.offset);
            if (!readGoal(state, *component.type, field, tween)) return lua_error(state);
            addTween(worldOf(state), tween, seconds);
        }
        lua_pop(state, 1);
    }
    for (const char* name : {"x", "y"}) {
        if (!tweenCoordinate(state, *component.type, name, tween, seconds)) return lua_error(state);
    }
    return 0;
}

int stopEntityTweens(lua_State* state) {
    stopTweens(worldOf(state), checkEntity(state, 1));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"wait", "(seconds: number?)",
     "Waits; without a time until the next tick. The handler goes on afterwards.", wait},
    {"waitUntil", "(condition: fun(): boolean)",
     "Waits until the function returns true; it is called in every tick.", waitUntil},
    {"waitFor", "(event: string, timeout: number?): any, any, any",
     "Waits for an event and returns its values; nil if it does not come within `timeout` seconds.", waitFor},
    {"emit", "(event: string, ...: any)",
     "Calls onEvent_NAME(...) of all scripts later in this tick. An event has up to three values.", emit},
    {"emitAfter", "(seconds: number, event: string, ...: any): integer",
     "Emits an event later, unless the scene ends before; rests while the scene is paused. Returns a number "
     "for cancel().",
     emitAfterSeconds},
    {"cancel", "(timer: integer)", "Cancels an event of emitAfter(); does nothing if it was emitted.",
     cancelEvent},
    {"tween", "(component: Component, fields: table, seconds: number, ease: string?)",
     "Changes fields of a component, or properties of self, gradually: tween(self.sprite, { tint = "
     "\"#ffffff00\" }, 0.3, "
     "\"quadOut\").",
     tweenFields},
    {"stopTweens", "(entity: Entity)", "Ends the tweens of an entity; fields keep their current values.",
     stopEntityTweens},
};

}  // namespace

std::span<const ScriptFunction> timeFunctions() { return kFunctions; }
int emitTo(lua_State* state) { return emitToTarget(state); }

}  // namespace plumb::script
