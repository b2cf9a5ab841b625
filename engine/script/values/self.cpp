#include "script/values/self.hpp"

#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include <lua.hpp>

#include "ecs/world.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_handlers.hpp"
#include "script/script_state.hpp"
#include "script/script_values.hpp"
#include "script/values/component.hpp"
#include "script/values/name_table.hpp"

namespace plumb::script {
namespace {

// Keys in the registry of the Lua state, by address.
constexpr char kSelves = 0;  // metatable of the `self` of each script, by the key of its component type
constexpr char kOwners = 0;  // handle of the entity of each script that runs, by the address of its `self`
// Key in a metatable of kSelves, by address: the SelfNames.
constexpr char kNamesOfSelf = 0;

/// What scripts of one type read of self: the properties, and the components that were asked for. Scripts do
/// so more often than anything else, and mostly one of them many times, so it keeps which was the last.
struct SelfNames : NameTable {
    static constexpr std::size_t kSeen = 4;
    /// Which self asked last for a component. User value kSeenValue + i is the handle.
    struct Seen {
        const void* self = nullptr;  // its address; null: none
        const TypeInfo* component = nullptr;
        EntityId entity;
    };
    std::array<Seen, kSeen> seen;
    const void* self = nullptr;  // that asked last for a property
    EntityId entity;

    static constexpr int kSeenValue = kNameValues + 1;
    static constexpr int kValues = kNameValues + static_cast<int>(kSeen);

    /// To be called when another script uses this address, or none any more.
    void forget(const void* address) {
        if (self == address) self = nullptr;
        for (Seen& one : seen)
            if (one.self == address) one.self = nullptr;
    }
};

// Upvalues of readSelf() and writeSelf().
constexpr int kNames = 1;  // SelfNames
constexpr int kOwnersTable = 2;
constexpr int kFunctions = 3;
constexpr int kMembers = 4;
constexpr int kUpvalues = 4;

SelfNames& namesOfSelf(lua_State* state) {
    return *static_cast<SelfNames*>(lua_touserdata(state, lua_upvalueindex(kNames)));
}

/// Pushes the handle of the entity of the self at index 1, of a script that may have ended.
/// @return true if it runs
bool pushOwner(lua_State* state) {
    const void* self = lua_topointer(state, 1);
    if (lua_rawgetp(state, lua_upvalueindex(kOwnersTable), self) == LUA_TUSERDATA) return true;
    lua_pop(state, 1);
    lua_pushliteral(state, "entity");
    lua_rawget(state, 1);
    if (!entityOfHandle(state, -1)) luaL_error(state, "self.entity was overwritten");
    return false;
}

/// The entity of the self at index 1.
EntityId ownerOf(lua_State* state, SelfNames& names) {
    const void* self = lua_topointer(state, 1);
    if (names.self == self) return names.entity;
    const bool runs = pushOwner(state);
    const EntityId entity = entityOfHandle(state, -1);
    if (runs) {
        names.self = self;
        names.entity = entity;
    }
    return entity;
}

/// Index of the property that the text at index 2 names; the number of fields if there is none. Only for
/// texts that are not in the table of names, because they are long.
std::size_t longName(lua_State* state, const TypeInfo& type) {
    std::size_t size = 0;
    const char* text = lua_type(state, 2) == LUA_TSTRING ? lua_tolstring(state, 2, &size) : nullptr;
    const FieldInfo* field = text == nullptr ? nullptr : type.find({text, size});
    return field == nullptr ? type.fields.size() : static_cast<std::size_t>(field - type.fields.data());
}

int readProperty(lua_State* state, SelfNames& names, std::size_t index) {
    const EntityId entity = ownerOf(state, names);
    const TypeInfo& type = *names.type;
    World& world = worldOf(state);
    const void* component = std::as_const(world).find(type, entity);
    if (component == nullptr) return goneComponent(state, {entity, &type});
    const FieldInfo& property = type.fields[index];
    pushValue(state, world, property, property.in(component));
    return 1;
}

int readComponent(lua_State* state, SelfNames& names, const NameTable::Row& row) {
    const std::size_t place = row.field % SelfNames::kSeen;
    const int value = SelfNames::kSeenValue + static_cast<int>(place);
    SelfNames::Seen& seen = names.seen[place];
    const void* self = lua_topointer(state, 1);
    const TypeInfo& type = *row.component;
    if (seen.self == self && seen.component == &type && worldOf(state).has(type, seen.entity)) {
        lua_getiuservalue(state, lua_upvalueindex(kNames), value);
        return 1;
    }
    const bool runs = pushOwner(state);
    const EntityId entity = entityOfHandle(state, -1);
    pushIfThere(state, lua_gettop(state), entity, type);
    if (runs && lua_type(state, -1) == LUA_TUSERDATA) {
        lua_pushvalue(state, -1);
        lua_setiuservalue(state, lua_upvalueindex(kNames), value);
        seen = {self, &type, entity};
    }
    return 1;
}

/// What is called like the text at index 2 and is not in the table of names: a function, a property with a
/// long name, or a member of the entity.
int readOther(lua_State* state, SelfNames& names) {
    lua_pushvalue(state, 2);
    if (lua_gettable(state, lua_upvalueindex(kFunctions)) != LUA_TNIL) return 1;
    const std::size_t index = longName(state, *names.type);
    if (index < names.type->fields.size()) return readProperty(state, names, index);
    lua_pushvalue(state, 2);
    if (lua_rawget(state, lua_upvalueindex(kMembers)) != LUA_TLIGHTUSERDATA) return 1;
    NameTable::Row row;
    row.component = static_cast<const TypeInfo*>(lua_touserdata(state, -1));
    row.field = names.count;
    lua_pushvalue(state, 2);
    addName(state, lua_upvalueindex(kNames), row);
    return readComponent(state, names, row);
}

int readSelf(lua_State* state) {
    SelfNames& names = namesOfSelf(state);
    const NameTable::Row* row = names.find(lua_topointer(state, 2));
    if (row == nullptr || row->isHidden) return readOther(state, names);
    return row->component != nullptr ? readComponent(state, names, *row)
                                     : readProperty(state, names, row->field);
}

int refuseHandler(lua_State* state) {
    const std::string_view type = namesOfSelf(state).type->name;
    const char* name = lua_tostring(state, 2);
    lua_pushlstring(state, type.data(), type.size());
    return luaL_error(
        state,
        "self.%s would never be called: handlers are functions of the file, function %s:%s(...); "
        "let that one ask a value of self what to do",
        name, lua_tostring(state, -1), name);
}

/// A property can be assigned, also one that is hidden from readSelf().
int writeSelf(lua_State* state) {
    SelfNames& names = namesOfSelf(state);
    const TypeInfo& type = *names.type;
    const NameTable::Row* row = names.find(lua_topointer(state, 2));
    const bool isKnown = row != nullptr && row->component == nullptr;
    const std::size_t index = isKnown ? row->field : longName(state, type);
    if (index >= type.fields.size()) {
        if (lua_type(state, 2) == LUA_TSTRING && isHandlerName(lua_tostring(state, 2)))
            return refuseHandler(state);
        lua_rawset(state, 1);
        return 0;
    }
    const EntityId entity = ownerOf(state, names);
    World& world = worldOf(state);
    void* component = world.find(type, entity);
    if (component == nullptr) return goneComponent(state, {entity, &type});
    setField(state, 3, world, type, type.fields[index], component);
    return 0;
}

/// Pushes the table of the names of the properties. Those that are called like a function of the table at
/// index `functions` are hidden.
void pushProperties(lua_State* state, const TypeInfo& type, int functions) {
    constexpr std::size_t kComponents = 4;  // that a script asks for
    void* memory = lua_newuserdatauv(state, sizeof(SelfNames), SelfNames::kValues);
    std::construct_at(static_cast<SelfNames*>(memory))->type = &type;
    const int names = lua_gettop(state);
    clearNames(state, names, type.fields.size() + kComponents);
    for (std::uint32_t i = 0; i < type.fields.size(); ++i) {
        lua_pushlstring(state, type.fields[i].name.data(), type.fields[i].name.size());
        lua_pushvalue(state, -1);
        NameTable::Row row;
        row.field = i;
        row.isHidden = lua_gettable(state, functions) != LUA_TNIL;
        lua_pop(state, 1);
        addName(state, names, row);
    }
}

/// Forgets what is known of the self at an index.
void forget(lua_State* state, int index) {
    const void* self = lua_topointer(state, index);
    lua_getmetatable(state, index);
    lua_rawgetp(state, -1, &kNamesOfSelf);
    static_cast<SelfNames*>(lua_touserdata(state, -1))->forget(self);
    lua_pop(state, 2);
}

/// Pushes the metatable of the `self` of a script.
void pushMetatable(lua_State* state, const TypeInfo& type) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kSelves);
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
    lua_remove(state, -2);
}

}  // namespace

void addSelves(lua_State* state) {
    lua_newtable(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kSelves);
    lua_newtable(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kOwners);
}

void defineSelf(lua_State* state, const TypeInfo& type) {
    const int functions = lua_gettop(state);
    pushMetatable(state, type);
    pushProperties(state, type, functions);
    lua_pushvalue(state, -1);
    lua_rawsetp(state, -3, &kNamesOfSelf);
    const int names = lua_gettop(state);
    for (const auto& [name, function] : {luaL_Reg{"__index", readSelf}, luaL_Reg{"__newindex", writeSelf}}) {
        lua_pushvalue(state, names);
        lua_rawgetp(state, LUA_REGISTRYINDEX, &kOwners);
        lua_pushvalue(state, functions);
        pushMembers(state);
        lua_pushcclosure(state, function, kUpvalues);
        lua_setfield(state, functions + 1, name);
    }
    lua_settop(state, functions - 1);
}

void becomeSelf(lua_State* state, TypeKey type) {
    const int self = lua_gettop(state);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kSelves);
    lua_rawgeti(state, -1, static_cast<lua_Integer>(type));
    lua_setmetatable(state, self);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kOwners);
    lua_pushliteral(state, "entity");
    lua_rawget(state, self);
    lua_rawsetp(state, -2, lua_topointer(state, self));
    forget(state, self);
    lua_settop(state, self);
}

void endSelf(lua_State* state, int self) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kOwners);
    lua_rawgeti(state, LUA_REGISTRYINDEX, self);
    lua_pushnil(state);
    lua_rawsetp(state, -3, lua_topointer(state, -2));
    forget(state, lua_gettop(state));
    lua_pop(state, 2);
    luaL_unref(state, LUA_REGISTRYINDEX, self);
}

const TypeInfo* typeOfSelf(lua_State* state, int index) {
    if (lua_istable(state, index) == 0 || lua_getmetatable(state, index) == 0) return nullptr;
    lua_rawgetp(state, -1, &kNamesOfSelf);
    const auto* names = static_cast<const SelfNames*>(lua_touserdata(state, -1));
    lua_pop(state, 2);
    return names == nullptr ? nullptr : names->type;
}

EntityId entityOfSelf(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TTABLE) return {};
    const int self = lua_absindex(state, index);
    const int top = lua_gettop(state);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kOwners);
    if (lua_rawgetp(state, -1, lua_topointer(state, self)) == LUA_TNIL) {
        lua_pushliteral(state, "entity");
        lua_rawget(state, self);
    }
    const EntityId entity = entityOfHandle(state, -1);
    lua_settop(state, top);
    return entity;
}

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

}  // namespace plumb::script
