#include "script/script_entity.hpp"

#include <string>
#include <string_view>

#include <lua.hpp>

#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "script/script_context.hpp"
#include "script/script_functions.hpp"
#include "script/values/component.hpp"
#include "script/values/self.hpp"
#include "script/values/userdata.hpp"

namespace plumb::script {
namespace {

// Keys of tables in the registry of the Lua state, by address.
constexpr char kEntities = 0;  // handle of each entity that is in use, by its id; weak
constexpr char kMembers = 0;   // what entities have: functions, and component types by name
constexpr char kHandle = 0;    // metatable of the handles of entities

/// The block of a handle. Its user value is the table of the handles of its components.
struct EntityBlock {
    static constexpr BlockKind kKind = BlockKind::Entity;
    BlockKind kind = kKind;
    EntityId entity;
};

void pushRegistered(lua_State* state, const char& key) { lua_rawgetp(state, LUA_REGISTRYINDEX, &key); }

lua_Integer keyOf(EntityId entity) {
    return static_cast<lua_Integer>(std::uint64_t{entity.generation} << 32 | entity.index);
}

std::string nameInLua(std::string_view type) {
    std::string name{type};
    if (!name.empty() && name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
    return name;
}

int readMember(lua_State* state) {
    pushRegistered(state, kMembers);
    lua_pushvalue(state, 2);
    if (lua_rawget(state, -2) != LUA_TLIGHTUSERDATA) return 1;  // a function, or nil
    const auto& type = *static_cast<const TypeInfo*>(lua_touserdata(state, -1));
    pushIfThere(state, 1, entityOfHandle(state, 1), type);
    return 1;
}

int refuseMember(lua_State* state) {
    return luaL_error(state, "\"%s\" cannot be assigned: use entity:add(\"%s\", {...}), or assign its fields",
                      luaL_tolstring(state, 2, nullptr), lua_tostring(state, 2));
}

int entityText(lua_State* state) {
    lua_pushfstring(state, "entity %d", static_cast<int>(entityOfHandle(state, 1).index));
    return 1;
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

void addEntities(lua_State* state) {
    addWeakTable(state);
    registerTable(state, kMembers);
    constexpr luaL_Reg kFunctions[] = {{"__index", readMember},
                                       {"__newindex", refuseMember},
                                       {"__tostring", entityText},
                                       {nullptr, nullptr}};
    luaL_newlib(state, kFunctions);
    lua_pushliteral(state, "entity");
    lua_setfield(state, -2, "__name");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kHandle);
    addComponents(state);
    addSelves(state);
}

void followTypes(lua_State* state, const TypeRegistry& types) {
    registerTable(state, kMembers);
    pushMembers(state);
    for (const TypeInfo& type : types.all()) {
        followFields(state, type);
        lua_pushlightuserdata(state, const_cast<TypeInfo*>(&type));
        lua_setfield(state, -2, nameInLua(type.name).c_str());
    }
    addFunctions(state, entityFunctions());
    lua_pop(state, 1);
}

void pushMembers(lua_State* state) { pushRegistered(state, kMembers); }

void pushEntity(lua_State* state, EntityId entity) {
    if (!entity) return lua_pushnil(state);
    pushRegistered(state, kEntities);
    if (lua_rawgeti(state, -1, keyOf(entity)) == LUA_TNIL) {
        lua_pop(state, 1);
        auto* block = static_cast<EntityBlock*>(lua_newuserdatauv(state, sizeof(EntityBlock), 1));
        *block = {EntityBlock::kKind, entity};
        pushRegistered(state, kHandle);
        lua_setmetatable(state, -2);
        lua_pushvalue(state, -1);
        lua_rawseti(state, -3, keyOf(entity));
    }
    lua_remove(state, -2);
}

EntityId entityOfHandle(lua_State* state, int index) {
    const auto* block = blockAt<EntityBlock>(state, index);
    return block == nullptr ? EntityId{} : block->entity;
}

EntityId entityAt(lua_State* state, int index) {
    const EntityId entity = entityOfHandle(state, index);
    return entity ? entity : entityOfSelf(state, index);
}

EntityId checkEntity(lua_State* state, int index) {
    const EntityId entity = entityAt(state, index);
    if (!entity) luaL_typeerror(state, index, "entity");
    if (!worldOf(state).alive(entity)) luaL_argerror(state, index, "the entity was destroyed");
    return entity;
}

}  // namespace plumb::script
