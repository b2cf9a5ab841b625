#include "script/script_entity.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "script/script_context.hpp"
#include "script/script_functions.hpp"
#include "script/script_handlers.hpp"
#include "script/script_state.hpp"
#include "script/script_values.hpp"

namespace plumb::script {
namespace {

constexpr const char* kEntity = "entity";
constexpr const char* kComponent = "component";
constexpr const char* kTypeField = "__component";  // in the metatable of a `self`: its component type

// Keys of tables in the registry of the Lua state, by address.
constexpr char kEntities = 0;  // handle of each entity that is in use, by its id; weak
constexpr char kMembers = 0;   // what entities have: functions, and component types by name
constexpr char kFields = 0;    // fields of each component type, by the type's address
constexpr char kSelves = 0;    // metatable of the `self` of each script, by the key of its component type

void pushRegistered(lua_State* state, const char& key) { lua_rawgetp(state, LUA_REGISTRYINDEX, &key); }

lua_Integer keyOf(EntityId entity) {
    return static_cast<lua_Integer>(std::uint64_t{entity.generation} << 32 | entity.index);
}

std::string nameInLua(std::string_view type) {
    std::string name{type};
    if (!name.empty() && name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
    return name;
}

// ---- fields: a number in the table of fields is the index of a field; `x` and `y` of a component are those
// of its field `position`

constexpr lua_Integer kX = 1 << 16;
constexpr lua_Integer kY = 1 << 17;
constexpr lua_Integer kIndex = kX - 1;

void fillFields(lua_State* state, int table, const TypeInfo& type) {
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
        const FieldInfo& field = type.fields[i];
        lua_pushlstring(state, field.name.data(), field.name.size());
        lua_pushinteger(state, static_cast<lua_Integer>(i));
        lua_rawset(state, table);
        if (field.kind != FieldKind::Vec2 || field.name != "position" || type.find("x") != nullptr) continue;
        for (const auto& [name, bit] : {std::pair{"x", kX}, std::pair{"y", kY}}) {
            lua_pushinteger(state, static_cast<lua_Integer>(i) | bit);
            lua_setfield(state, table, name);
        }
    }
}

int goneComponent(lua_State* state, const ComponentHandle& handle) {
    const char* problem = worldOf(state).alive(handle.entity) ? "the entity no longer has the component %s"
                                                              : "the entity of this %s was destroyed";
    lua_pushlstring(state, handle.type->name.data(), handle.type->name.size());
    return luaL_error(state, problem, lua_tostring(state, -1));
}

/// Raises the message on top of the stack as an error in the line that runs.
int raiseMessage(lua_State* state) {
    luaL_where(state, 1);
    lua_insert(state, -2);
    lua_concat(state, 2);
    return lua_error(state);
}

/// Pushes the entry of the table of fields for the name at index 2. @return its number
lua_Integer fieldCode(lua_State* state, const TypeInfo& type) {
    lua_rawgetp(state, lua_upvalueindex(1), &type);
    lua_pushvalue(state, 2);
    lua_rawget(state, -2);
    int isNumber = 0;
    const lua_Integer code = lua_tointegerx(state, -1, &isNumber);
    if (isNumber == 0) {
        failUnknownField(state, type, luaL_tolstring(state, 2, nullptr));
        lua_error(state);
    }
    return code;
}

int readField(lua_State* state) {
    const auto& handle = *static_cast<const ComponentHandle*>(lua_touserdata(state, 1));
    const lua_Integer code = fieldCode(state, *handle.type);
    World& world = worldOf(state);
    const void* component = std::as_const(world).find(*handle.type, handle.entity);
    if (component == nullptr) return goneComponent(state, handle);
    const FieldInfo& field = handle.type->fields[static_cast<std::size_t>(code & kIndex)];
    if ((code & (kX | kY)) != 0) {
        const auto* position = static_cast<const Vec2*>(field.in(component));
        lua_pushnumber(state, (code & kX) != 0 ? position->x : position->y);
    } else {
        pushValue(state, world, field, field.in(component));
    }
    return 1;
}

void writeCoordinate(lua_State* state, lua_Integer code, void* position) {
    const lua_Number number = luaL_checknumber(state, 3);
    if (!(number - number == 0.0)) luaL_error(state, "%s must be finite", (code & kX) != 0 ? "x" : "y");
    auto* vector = static_cast<Vec2*>(position);
    ((code & kX) != 0 ? vector->x : vector->y) = static_cast<float>(number);
}

int writeField(lua_State* state) {
    const auto& handle = *static_cast<const ComponentHandle*>(lua_touserdata(state, 1));
    const lua_Integer code = fieldCode(state, *handle.type);
    World& world = worldOf(state);
    void* component = world.find(*handle.type, handle.entity);
    if (component == nullptr) return goneComponent(state, handle);
    const FieldInfo& field = handle.type->fields[static_cast<std::size_t>(code & kIndex)];
    if ((code & (kX | kY)) != 0) {
        writeCoordinate(state, code, field.in(component));
        return 0;
    }
    if (readValue(state, 3, world, handle.type->name, field, field.in(component))) return 0;
    return raiseMessage(state);
}

int componentText(lua_State* state) {
    const ComponentHandle handle = checkComponent(state, 1);
    lua_pushlstring(state, handle.type->name.data(), handle.type->name.size());
    return 1;
}

// ---- entities

/// Pushes the table of component handles of the entity handle at an index.
void pushComponents(lua_State* state, int handle) {
    if (lua_getiuservalue(state, handle, 1) == LUA_TTABLE) return;
    lua_pop(state, 1);
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_setiuservalue(state, handle, 1);
}

/// Pushes the component of the entity whose handle is at an index, above the table of its components.
void pushComponentOf(lua_State* state, int handle, EntityId entity, const TypeInfo& type) {
    pushComponents(state, handle);
    if (lua_rawgetp(state, -1, &type) != LUA_TNIL) return;
    lua_pop(state, 1);
    *static_cast<ComponentHandle*>(lua_newuserdatauv(state, sizeof(ComponentHandle), 0)) = {entity, &type};
    luaL_setmetatable(state, kComponent);
    lua_pushvalue(state, -1);
    lua_rawsetp(state, -3, &type);
}

/// Pushes the component of this type, or the script, of the entity whose handle is at an index; nil if it has
/// none.
void pushIfThere(lua_State* state, int handle, EntityId entity, const TypeInfo& type) {
    Context& context = contextOf(state);
    if (!context.world.has(type, entity)) return lua_pushnil(state);
    const int self = isReloadable(type.key) ? context.state.selfOf(type.key, entity) : 0;
    if (self != 0) {
        lua_rawgeti(state, LUA_REGISTRYINDEX, self);
    } else {
        pushComponentOf(state, handle, entity, type);
    }
}

int readMember(lua_State* state) {
    pushRegistered(state, kMembers);
    lua_pushvalue(state, 2);
    if (lua_rawget(state, -2) != LUA_TLIGHTUSERDATA) return 1;  // a function, or nil
    const auto& type = *static_cast<const TypeInfo*>(lua_touserdata(state, -1));
    pushIfThere(state, 1, *static_cast<const EntityId*>(lua_touserdata(state, 1)), type);
    return 1;
}

int refuseMember(lua_State* state) {
    return luaL_error(state, "\"%s\" cannot be assigned: use entity:add(\"%s\", {...}), or assign its fields",
                      luaL_tolstring(state, 2, nullptr), lua_tostring(state, 2));
}

int entityText(lua_State* state) {
    const auto* entity = static_cast<const EntityId*>(luaL_checkudata(state, 1, kEntity));
    lua_pushfstring(state, "entity %d", static_cast<int>(entity->index));
    return 1;
}

// ---- self: scripts read it more often than anything else, so all that is needed is in upvalues, and what
// lies on the stack is left there

constexpr int kNamesOfSelf = 1;  // index of the field of a property, or the type of a component, by name
constexpr int kTypeOfSelf = 2;
constexpr int kEntityName = 3;   // the text "entity"
constexpr int kHandleTable = 4;  // metatable of the handles of entities
constexpr int kFunctionsOfSelf = 5;
constexpr int kMembersOfSelf = 6;
constexpr int kUpvaluesOfSelf = 6;

const TypeInfo& typeOfSelf(lua_State* state) {
    return *static_cast<const TypeInfo*>(lua_touserdata(state, lua_upvalueindex(kTypeOfSelf)));
}

/// Pushes the handle of the entity of the self at index 1, and its metatable. That is compared here, because
/// luaL_testudata() looks it up by its name each time.
EntityId pushEntityOfSelf(lua_State* state) {
    lua_pushvalue(state, lua_upvalueindex(kEntityName));
    lua_rawget(state, 1);
    const bool isHandle = lua_type(state, -1) == LUA_TUSERDATA && lua_getmetatable(state, -1) != 0 &&
                          lua_rawequal(state, -1, lua_upvalueindex(kHandleTable)) != 0;
    if (!isHandle) luaL_error(state, "self.entity was overwritten");
    return *static_cast<const EntityId*>(lua_touserdata(state, -2));
}

/// Puts what is called like the text at index 2, and is not in the table of names, at index 3: a function,
/// the type of a component, which is added to the names, or nil. @return its type
int findName(lua_State* state) {
    lua_settop(state, 2);
    lua_pushvalue(state, 2);
    const int found = lua_gettable(state, lua_upvalueindex(kFunctionsOfSelf));
    if (found != LUA_TNIL) return found;
    lua_settop(state, 2);
    lua_pushvalue(state, 2);
    const int member = lua_rawget(state, lua_upvalueindex(kMembersOfSelf));
    if (member != LUA_TLIGHTUSERDATA) return member;
    lua_pushvalue(state, 2);
    lua_pushvalue(state, 3);
    lua_rawset(state, lua_upvalueindex(kNamesOfSelf));
    return member;
}

int readSelf(lua_State* state) {
    lua_pushvalue(state, 2);
    int kind = lua_rawget(state, lua_upvalueindex(kNamesOfSelf));
    if (kind == LUA_TNIL) {
        kind = findName(state);
        if (kind != LUA_TLIGHTUSERDATA) return 1;
    }
    const EntityId entity = pushEntityOfSelf(state);
    if (kind == LUA_TLIGHTUSERDATA) {
        constexpr int kHandle = 4;
        pushIfThere(state, kHandle, entity, *static_cast<const TypeInfo*>(lua_touserdata(state, 3)));
        return 1;
    }
    World& world = worldOf(state);
    const TypeInfo& type = typeOfSelf(state);
    const void* component = std::as_const(world).find(type, entity);
    if (component == nullptr) return goneComponent(state, {entity, &type});
    const FieldInfo& property = type.fields[static_cast<std::size_t>(lua_tointeger(state, 3))];
    pushValue(state, world, property, property.in(component));
    return 1;
}

int refuseHandler(lua_State* state) {
    const char* name = lua_tostring(state, 2);
    lua_pushlstring(state, typeOfSelf(state).name.data(), typeOfSelf(state).name.size());
    return luaL_error(
        state,
        "self.%s would never be called: handlers are functions of the file, function %s:%s(...); "
        "let that one ask a value of self what to do",
        name, lua_tostring(state, -1), name);
}

/// Its names are all properties, also those that readSelf() does not find because a function is called alike.
int writeSelf(lua_State* state) {
    lua_pushvalue(state, 2);
    if (lua_rawget(state, lua_upvalueindex(kNamesOfSelf)) == LUA_TNIL) {
        lua_settop(state, 3);
        if (lua_type(state, 2) == LUA_TSTRING && isHandlerName(lua_tostring(state, 2)))
            return refuseHandler(state);
        lua_rawset(state, 1);
        return 0;
    }
    const EntityId entity = pushEntityOfSelf(state);
    World& world = worldOf(state);
    const TypeInfo& type = typeOfSelf(state);
    void* component = world.find(type, entity);
    if (component == nullptr) return goneComponent(state, {entity, &type});
    const FieldInfo& property = type.fields[static_cast<std::size_t>(lua_tointeger(state, 4))];
    if (readValue(state, 3, world, type.name, property, property.in(component))) return 0;
    return raiseMessage(state);
}

/// Pushes the table of the names of the properties, without those that are called like a function of the
/// table at index `functions`, if that is not 0.
void pushNames(lua_State* state, const TypeInfo& type, int functions) {
    lua_createtable(state, 0, static_cast<int>(type.fields.size()));
    const int names = lua_gettop(state);
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
        lua_pushlstring(state, type.fields[i].name.data(), type.fields[i].name.size());
        lua_pushvalue(state, -1);
        if (functions == 0 || lua_gettable(state, functions) == LUA_TNIL) {
            lua_pushvalue(state, names + 1);
            lua_pushinteger(state, static_cast<lua_Integer>(i));
            lua_rawset(state, names);
        }
        lua_settop(state, names);
    }
}

void protect(lua_State* state) {
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_pop(state, 1);
}

void registerTable(lua_State* state, const char& key) {
    lua_newtable(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &key);
}

void addWeakTable(lua_State* state) {
    registerTable(state, kEntities);
    pushRegistered(state, kEntities);
    lua_newtable(state);
    lua_pushliteral(state, "v");
    lua_setfield(state, -2, "__mode");
    lua_setmetatable(state, -2);
    lua_pop(state, 1);
}

}  // namespace

int failUnknownField(lua_State* state, const TypeInfo& type, std::string_view name) {
    std::vector<std::string_view> names;
    for (const FieldInfo& field : type.fields) names.push_back(field.name);
    const std::string_view near = closestName(name, names);
    const bool isScript = type.find("stopped") != nullptr && isReloadable(type.key);
    const bool isCoordinate = (name == "x" || name == "y") && type.find("position") != nullptr;
    const std::string hint =
        isScript       ? "; functions of a script can be called from its first tick on: wait() before"
        : isCoordinate ? "; write position = vec(x, y)"
        : near.empty() ? std::string{}
                       : format("; did you mean \"{}\"?", near);
    return fail(state, format("{} has no field \"{}\"{}", type.name, name, hint));
}

void addEntities(lua_State* state) {
    addWeakTable(state);
    registerTable(state, kMembers);
    registerTable(state, kFields);
    registerTable(state, kSelves);

    luaL_newmetatable(state, kEntity);
    lua_pushcfunction(state, readMember);
    lua_setfield(state, -2, "__index");
    lua_pushcfunction(state, refuseMember);
    lua_setfield(state, -2, "__newindex");
    lua_pushcfunction(state, entityText);
    lua_setfield(state, -2, "__tostring");
    protect(state);

    luaL_newmetatable(state, kComponent);
    pushRegistered(state, kFields);
    lua_pushcclosure(state, readField, 1);
    lua_setfield(state, -2, "__index");
    pushRegistered(state, kFields);
    lua_pushcclosure(state, writeField, 1);
    lua_setfield(state, -2, "__newindex");
    lua_pushcfunction(state, componentText);
    lua_setfield(state, -2, "__tostring");
    protect(state);
}

void followTypes(lua_State* state, const TypeRegistry& types) {
    registerTable(state, kMembers);
    registerTable(state, kFields);
    // The closures of components keep the old table of fields: give them the new one.
    luaL_getmetatable(state, kComponent);
    for (const auto& [name, function] :
         {luaL_Reg{"__index", readField}, luaL_Reg{"__newindex", writeField}}) {
        pushRegistered(state, kFields);
        lua_pushcclosure(state, function, 1);
        lua_setfield(state, -2, name);
    }
    lua_pop(state, 1);
    pushRegistered(state, kMembers);
    pushRegistered(state, kFields);
    for (const TypeInfo& type : types.all()) {
        lua_newtable(state);
        fillFields(state, lua_gettop(state), type);
        lua_rawsetp(state, -2, &type);
        lua_pushlightuserdata(state, const_cast<TypeInfo*>(&type));
        lua_setfield(state, -3, nameInLua(type.name).c_str());
    }
    lua_pop(state, 1);
    addFunctions(state, entityFunctions());
    lua_pop(state, 1);
}

void pushEntity(lua_State* state, EntityId entity) {
    if (!entity) return lua_pushnil(state);
    pushRegistered(state, kEntities);
    if (lua_rawgeti(state, -1, keyOf(entity)) == LUA_TNIL) {
        lua_pop(state, 1);
        *static_cast<EntityId*>(lua_newuserdatauv(state, sizeof(EntityId), 1)) = entity;
        luaL_setmetatable(state, kEntity);
        lua_pushvalue(state, -1);
        lua_rawseti(state, -3, keyOf(entity));
    }
    lua_remove(state, -2);
}

EntityId entityAt(lua_State* state, int index) {
    if (const auto* entity = static_cast<const EntityId*>(luaL_testudata(state, index, kEntity)))
        return *entity;
    if (lua_type(state, index) != LUA_TTABLE) return {};
    const int self = lua_absindex(state, index);
    lua_pushliteral(state, "entity");
    lua_rawget(state, self);
    const auto* entity = static_cast<const EntityId*>(luaL_testudata(state, -1, kEntity));
    lua_pop(state, 1);
    return entity == nullptr ? EntityId{} : *entity;
}

EntityId checkEntity(lua_State* state, int index) {
    const EntityId entity = entityAt(state, index);
    if (!entity) luaL_typeerror(state, index, "entity");
    if (!worldOf(state).alive(entity)) luaL_argerror(state, index, "the entity was destroyed");
    return entity;
}

void pushComponent(lua_State* state, EntityId entity, const TypeInfo& type) {
    pushEntity(state, entity);
    pushComponentOf(state, lua_gettop(state), entity, type);
    lua_replace(state, -3);
    lua_pop(state, 1);
}

void defineSelf(lua_State* state, const TypeInfo& type) {
    const int functions = lua_gettop(state);
    pushRegistered(state, kSelves);
    if (lua_rawgeti(state, -1, static_cast<lua_Integer>(type.key)) != LUA_TTABLE) {
        lua_pop(state, 1);
        lua_newtable(state);
        lua_pushboolean(state, 0);
        lua_setfield(state, -2, "__metatable");
        lua_pushlstring(state, type.name.data(), type.name.size());
        lua_setfield(state, -2, "__name");
        lua_pushvalue(state, -1);
        lua_rawseti(state, -3, static_cast<lua_Integer>(type.key));
    }
    lua_pushlightuserdata(state, const_cast<TypeInfo*>(&type));
    lua_setfield(state, -2, kTypeField);
    for (const auto& [name, function] : {luaL_Reg{"__index", readSelf}, luaL_Reg{"__newindex", writeSelf}}) {
        pushNames(state, type, function == readSelf ? functions : 0);
        lua_pushlightuserdata(state, const_cast<TypeInfo*>(&type));
        lua_pushliteral(state, "entity");
        luaL_getmetatable(state, kEntity);
        lua_pushvalue(state, functions);
        pushRegistered(state, kMembers);
        lua_pushcclosure(state, function, kUpvaluesOfSelf);
        lua_setfield(state, -2, name);
    }
    lua_pop(state, 3);
}

void becomeSelf(lua_State* state, TypeKey type) {
    pushRegistered(state, kSelves);
    lua_rawgeti(state, -1, static_cast<lua_Integer>(type));
    lua_setmetatable(state, -3);
    lua_pop(state, 1);
}

ComponentHandle checkComponent(lua_State* state, int index) {
    if (lua_istable(state, index) != 0 && luaL_getmetafield(state, index, kTypeField) != LUA_TNIL) {
        const auto* type = static_cast<const TypeInfo*>(lua_touserdata(state, -1));
        lua_pop(state, 1);
        return {entityAt(state, index), type};
    }
    return *static_cast<const ComponentHandle*>(luaL_checkudata(state, index, kComponent));
}

bool setFields(lua_State* state, int table, EntityId entity, const TypeInfo& type) {
    World& world = worldOf(state);
    const int values = lua_absindex(state, table);
    for (lua_pushnil(state); lua_next(state, values) != 0; lua_pop(state, 1)) {
        const char* name = lua_type(state, -2) == LUA_TSTRING ? lua_tostring(state, -2) : "?";
        if (type.find(name) == nullptr) return failUnknownField(state, type, name) >= 0;
    }
    for (const FieldInfo& field : type.fields) {
        lua_pushlstring(state, field.name.data(), field.name.size());
        lua_rawget(state, values);
        void* component = world.find(type, entity);
        if (lua_isnil(state, -1) == 0 &&
            !readValue(state, lua_gettop(state), world, type.name, field, field.in(component)))
            return false;
        lua_pop(state, 1);
    }
    return true;
}

}  // namespace plumb::script
