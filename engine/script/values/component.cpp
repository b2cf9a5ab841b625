#include "script/values/component.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_values.hpp"
#include "script/values/name_table.hpp"
#include "script/values/self.hpp"
#include "script/values/userdata.hpp"

namespace plumb::script {
namespace {

// Keys in the registry of the Lua state, by address.
constexpr char kFields = 0;  // NameTable of the fields of each component type, by the type's address
constexpr char kHandle = 0;  // metatable of the handles of components

/// The block of a handle.
struct ComponentBlock {
    static constexpr BlockKind kKind = BlockKind::Component;
    BlockKind kind = kKind;
    EntityId entity;
    const NameTable* names = nullptr;  // the registry keeps it as long as the state exists
};

// ---- fields: a row is the index of a field; `x` and `y` of a component are those of its field `position`

constexpr std::uint32_t kX = 1 << 16;
constexpr std::uint32_t kY = 1 << 17;
constexpr std::uint32_t kIndex = kX - 1;

void addRow(lua_State* state, int names, std::string_view name, std::uint32_t field) {
    lua_pushlstring(state, name.data(), name.size());
    NameTable::Row row;
    row.field = field;
    addName(state, names, row);
}

/// The row of a text that is not in the table because it is long. Raises an error if there is none.
std::uint32_t longName(lua_State* state, const TypeInfo& type) {
    std::size_t size = 0;
    const char* text = lua_type(state, 2) == LUA_TSTRING ? lua_tolstring(state, 2, &size) : nullptr;
    const FieldInfo* field = text == nullptr ? nullptr : type.find({text, size});
    if (field != nullptr) return static_cast<std::uint32_t>(field - type.fields.data());
    failUnknownField(state, type, luaL_tolstring(state, 2, nullptr));
    lua_error(state);
    return 0;
}

/// What the name at index 2 means.
std::uint32_t fieldCode(lua_State* state, const NameTable& names) {
    const NameTable::Row* row = names.find(lua_topointer(state, 2));
    return row != nullptr ? row->field : longName(state, *names.type);
}

int readField(lua_State* state) {
    const auto& block = *static_cast<const ComponentBlock*>(lua_touserdata(state, 1));
    const TypeInfo& type = *block.names->type;
    const std::uint32_t code = fieldCode(state, *block.names);
    World& world = worldOf(state);
    const void* component = std::as_const(world).find(type, block.entity);
    if (component == nullptr) return goneComponent(state, {block.entity, &type});
    const FieldInfo& field = type.fields[code & kIndex];
    if ((code & (kX | kY)) != 0) {
        const auto* position = static_cast<const Vec2*>(field.in(component));
        lua_pushnumber(state, (code & kX) != 0 ? position->x : position->y);
    } else {
        pushValue(state, world, field, field.in(component));
    }
    return 1;
}

void writeCoordinate(lua_State* state, std::uint32_t code, void* position) {
    const lua_Number number = luaL_checknumber(state, 3);
    if (!(number - number == 0.0)) luaL_error(state, "%s must be finite", (code & kX) != 0 ? "x" : "y");
    auto* vector = static_cast<Vec2*>(position);
    ((code & kX) != 0 ? vector->x : vector->y) = static_cast<float>(number);
}

int writeField(lua_State* state) {
    const auto& block = *static_cast<const ComponentBlock*>(lua_touserdata(state, 1));
    const TypeInfo& type = *block.names->type;
    const std::uint32_t code = fieldCode(state, *block.names);
    World& world = worldOf(state);
    void* component = world.find(type, block.entity);
    if (component == nullptr) return goneComponent(state, {block.entity, &type});
    const FieldInfo& field = type.fields[code & kIndex];
    if ((code & (kX | kY)) != 0) {
        writeCoordinate(state, code, field.in(component));
    } else {
        setField(state, 3, world, type, field, component);
    }
    return 0;
}

int componentText(lua_State* state) {
    const ComponentHandle handle = checkComponent(state, 1);
    lua_pushlstring(state, handle.type->name.data(), handle.type->name.size());
    return 1;
}

/// Pushes the table of component handles of the entity handle at an index.
void pushComponents(lua_State* state, int handle) {
    if (lua_getiuservalue(state, handle, 1) == LUA_TTABLE) return;
    lua_pop(state, 1);
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_setiuservalue(state, handle, 1);
}

/// Returns the names of the fields of a type, which followTypes() has passed to followFields().
const NameTable* namesOf(lua_State* state, const TypeInfo& type) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kFields);
    lua_rawgetp(state, -1, &type);
    const auto* names = static_cast<const NameTable*>(lua_touserdata(state, -1));
    lua_pop(state, 2);
    return names;
}

}  // namespace

void addComponents(lua_State* state) {
    lua_newtable(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kFields);
    constexpr luaL_Reg kFunctions[] = {{"__index", readField},
                                       {"__newindex", writeField},
                                       {"__tostring", componentText},
                                       {nullptr, nullptr}};
    luaL_newlib(state, kFunctions);
    lua_pushliteral(state, "component");
    lua_setfield(state, -2, "__name");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kHandle);
}

/// The table stays the same, because handles know its address.
void followFields(lua_State* state, const TypeInfo& type) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kFields);
    const std::size_t expected = type.fields.size() + 2;
    if (lua_rawgetp(state, -1, &type) == LUA_TNIL) {
        lua_pop(state, 1);
        void* memory = lua_newuserdatauv(state, sizeof(NameTable), kNameValues);
        std::construct_at(static_cast<NameTable*>(memory))->type = &type;
        lua_pushvalue(state, -1);
        lua_rawsetp(state, -3, &type);
    }
    clearNames(state, lua_gettop(state), expected);
    const int names = lua_gettop(state);
    for (std::uint32_t i = 0; i < type.fields.size(); ++i) {
        const FieldInfo& field = type.fields[i];
        addRow(state, names, field.name, i);
        if (field.kind != FieldKind::Vec2 || field.name != "position" || type.find("x") != nullptr) continue;
        addRow(state, names, "x", i | kX);
        addRow(state, names, "y", i | kY);
    }
    lua_settop(state, names - 2);
}

void pushComponentOf(lua_State* state, int handle, EntityId entity, const TypeInfo& type) {
    pushComponents(state, handle);
    if (lua_rawgetp(state, -1, &type) != LUA_TNIL) return lua_remove(state, -2);
    lua_pop(state, 1);
    const NameTable* names = namesOf(state, type);
    auto* block = static_cast<ComponentBlock*>(lua_newuserdatauv(state, sizeof(ComponentBlock), 0));
    *block = {ComponentBlock::kKind, entity, names};
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kHandle);
    lua_setmetatable(state, -2);
    lua_pushvalue(state, -1);
    lua_rawsetp(state, -3, &type);
    lua_remove(state, -2);
}

void pushComponent(lua_State* state, EntityId entity, const TypeInfo& type) {
    pushEntity(state, entity);
    pushComponentOf(state, lua_gettop(state), entity, type);
    lua_remove(state, -2);
}

ComponentHandle checkComponent(lua_State* state, int index) {
    if (const auto* block = blockAt<ComponentBlock>(state, index)) return {block->entity, block->names->type};
    const TypeInfo* script = typeOfSelf(state, index);
    if (script == nullptr) luaL_typeerror(state, index, "component");
    return {entityAt(state, index), script};
}

int goneComponent(lua_State* state, const ComponentHandle& handle) {
    const char* problem = worldOf(state).alive(handle.entity) ? "the entity no longer has the component %s"
                                                              : "the entity of this %s was destroyed";
    lua_pushlstring(state, handle.type->name.data(), handle.type->name.size());
    return luaL_error(state, problem, lua_tostring(state, -1));
}

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

void setField(lua_State* state, int index, World& world, const TypeInfo& type, const FieldInfo& field,
              void* component) {
    if (readValue(state, index, world, type.name, field, field.in(component))) return;
    luaL_where(state, 1);
    lua_insert(state, -2);
    lua_concat(state, 2);
    lua_error(state);
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
