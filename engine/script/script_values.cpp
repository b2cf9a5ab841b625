#include "script/script_values.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include <lua.hpp>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/whole_number.hpp"
#include "scene/files/world_field_context.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_list.hpp"
#include "script/script_vector.hpp"

namespace plumb::script {
namespace {

// Rectangles, colors, enums and curves take the detour over their form in files, which has the messages too.

/// @param field  whose value it is
void pushJson(lua_State* state, const Json& json, std::string_view field) {
    switch (json.type()) {
        case Json::value_t::boolean: lua_pushboolean(state, json.get<bool>() ? 1 : 0); return;
        case Json::value_t::number_integer:
        case Json::value_t::number_unsigned: lua_pushinteger(state, json.get<std::int64_t>()); return;
        case Json::value_t::number_float: lua_pushnumber(state, json.get<double>()); return;
        case Json::value_t::string: {
            const std::string& text = *json.get_ptr<const std::string*>();
            lua_pushlstring(state, text.data(), text.size());
            return;
        }
        case Json::value_t::array: {
            lua_createtable(state, static_cast<int>(json.size()), 0);
            for (std::size_t i = 0; i < json.size(); ++i) {
                pushJson(state, json[i], field);
                lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
            }
            return protectList(state, field);
        }
        default: lua_pushnil(state);
    }
}

constexpr int kMaxDepth = 4;  // of tables in tables: a curve has two

Json jsonAt(lua_State* state, int index, int depth = 0) {
    switch (lua_type(state, index)) {
        case LUA_TBOOLEAN: return lua_toboolean(state, index) != 0;
        case LUA_TNUMBER:
            if (lua_isinteger(state, index) != 0)
                return static_cast<std::int64_t>(lua_tointeger(state, index));
            return lua_tonumber(state, index);
        case LUA_TSTRING: {
            std::size_t size = 0;
            const char* text = lua_tolstring(state, index, &size);
            return std::string{text, size};
        }
        case LUA_TTABLE: {
            Json list = Json::array();
            pushItems(state, index);
            const int items = lua_gettop(state);
            const auto count = static_cast<lua_Integer>(lua_rawlen(state, items));
            for (lua_Integer i = 1; i <= count && depth < kMaxDepth; ++i) {
                lua_rawgeti(state, items, i);
                list.push_back(jsonAt(state, lua_gettop(state), depth + 1));
                lua_pop(state, 1);
            }
            lua_pop(state, 1);
            return list;
        }
        default: return {};
    }
}

template <class T>
T load(const void* from) {
    T value{};
    std::memcpy(&value, from, sizeof value);
    return value;
}

void pushText(lua_State* state, std::string_view text) { lua_pushlstring(state, text.data(), text.size()); }

void pushAsset(lua_State* state, World& world, const FieldInfo& field, TextId path) {
    if (path.empty()) return lua_pushnil(state);
    std::string_view text = world.texts().find(path);
    const auto* assets = world.service<AssetStore>();
    if (text.empty() && assets != nullptr) text = assets->pathOf(field.asset, path);
    pushText(state, text);
}

void pushList(lua_State* state, World& world, const FieldInfo& field, const void* list) {
    const FieldInfo item = itemOf(field);
    const std::size_t count = std::min<std::size_t>(field.countOf(list), field.capacity);
    lua_createtable(state, static_cast<int>(count), 0);
    for (std::size_t i = 0; i < count; ++i) {
        pushValue(state, world, item, static_cast<const std::byte*>(list) + i * field.elementSize);
        lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
    protectList(state, field.name);
}

/// Pushes "Spin.rate: expected a number, found a string". @return false
bool refuse(lua_State* state, std::string_view type, const FieldInfo& field, const char* expected,
            int found) {
    const std::string text = format("{}.{}: expected {}, found {}{}", type, field.name, expected,
                                    lua_isnil(state, found) != 0 ? "" : "a ", luaL_typename(state, found));
    pushText(state, text);
    return false;
}

float limited(const FieldInfo& field, double number) {
    return std::clamp(static_cast<float>(number), field.min, field.max);
}

bool readVector(lua_State* state, int index, std::string_view type, const FieldInfo& field, void* value) {
    const Vec2* vector = vectorAt(state, index);
    if (vector == nullptr) return refuse(state, type, field, "a vector, vec(x, y)", index);
    if (!isFinite(*vector)) return refuse(state, type, field, "finite numbers", index);
    std::memcpy(value, vector, sizeof *vector);
    return true;
}

bool readNumber(lua_State* state, int index, std::string_view type, const FieldInfo& field, void* value) {
    if (lua_type(state, index) != LUA_TNUMBER) return refuse(state, type, field, "a number", index);
    const double number = lua_tonumber(state, index);
    if (!std::isfinite(number)) return refuse(state, type, field, "a finite number", index);
    const float stored = limited(field, number);
    std::memcpy(value, &stored, sizeof stored);
    return true;
}

bool readTextId(lua_State* state, int index, World& world, std::string_view type, const FieldInfo& field,
                void* value) {
    if (lua_type(state, index) != LUA_TSTRING) return refuse(state, type, field, "a text", index);
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    const TextId id = world.texts().add({text, size});
    std::memcpy(value, &id, sizeof id);
    return true;
}

bool readEntity(lua_State* state, int index, std::string_view type, const FieldInfo& field, void* value) {
    EntityId id;
    if (lua_isnil(state, index) == 0) {
        id = entityAt(state, index);
        if (!id) return refuse(state, type, field, "an entity, or nil", index);
    }
    std::memcpy(value, &id, sizeof id);
    return true;
}

bool readList(lua_State* state, int index, World& world, std::string_view type, const FieldInfo& field,
              void* list) {
    if (lua_type(state, index) != LUA_TTABLE) return refuse(state, type, field, "a table", index);
    const FieldInfo item = itemOf(field);
    pushItems(state, index);
    const int table = lua_gettop(state);
    const std::size_t count = std::min<std::size_t>(lua_rawlen(state, table), field.capacity);
    std::vector<std::byte> items(field.capacity * field.elementSize);
    for (std::size_t i = 0; i < count; ++i) {
        lua_rawgeti(state, table, static_cast<lua_Integer>(i + 1));
        if (!readValue(state, lua_gettop(state), world, type, item, items.data() + i * field.elementSize))
            return false;
        lua_pop(state, 1);
    }
    std::memcpy(list, items.data(), items.size());
    field.countOf(list) = static_cast<std::uint32_t>(count);
    lua_pop(state, 1);
    return true;
}

bool readByJson(lua_State* state, int index, World& world, std::string_view type, const FieldInfo& field,
                void* value) {
    WorldFieldContext context{world};
    const Json json = field.kind == FieldKind::Asset && lua_isnil(state, index) != 0 ? Json(std::string{})
                                                                                     : jsonAt(state, index);
    const Result<Done> read = valueFromJson(field, value, json, context);
    if (!read) pushText(state, format("{}.{}", type, read.error().text()));
    return read.ok();
}

/// A texture, tileset, animation, sound or font must be loaded before it is used.
void loadAsset(World& world, const FieldInfo& field, const void* value) {
    auto* assets = world.service<AssetStore>();
    const std::string_view path = world.texts().find(load<TextId>(value));
    if (assets != nullptr && !path.empty()) assets->load(field.asset, path);
}

}  // namespace

FieldInfo itemOf(const FieldInfo& list) {
    FieldInfo item = list;
    item.kind = list.element;
    item.size = list.elementSize;
    return item;
}

void pushValue(lua_State* state, World& world, const FieldInfo& field, const void* value) {
    switch (field.kind) {
        case FieldKind::Bool: return lua_pushboolean(state, load<bool>(value) ? 1 : 0);
        case FieldKind::Int: return lua_pushinteger(state, loadWhole(value, field.size, field.isSigned));
        case FieldKind::Float: return lua_pushnumber(state, load<float>(value));
        case FieldKind::Vec2: return pushVector(state, load<Vec2>(value));
        case FieldKind::Text: return pushText(state, world.texts().find(load<TextId>(value)));
        case FieldKind::Entity: return pushEntity(state, load<EntityId>(value));
        case FieldKind::Asset: return pushAsset(state, world, field, load<TextId>(value));
        case FieldKind::Tiles: return lua_pushnil(state);
        case FieldKind::List:
            if (!isCurve(field)) return pushList(state, world, field, value);
            [[fallthrough]];
        case FieldKind::Rect:
        case FieldKind::Color:
        case FieldKind::Enum:
            pushJson(state, valueToJson(field, value, WorldFieldContext{world}), field.name);
    }
}

bool readValue(lua_State* state, int index, World& world, std::string_view type, const FieldInfo& field,
               void* value) {
    switch (field.kind) {
        case FieldKind::Float: return readNumber(state, index, type, field, value);
        case FieldKind::Vec2: return readVector(state, index, type, field, value);
        case FieldKind::Text: return readTextId(state, index, world, type, field, value);
        case FieldKind::Entity: return readEntity(state, index, type, field, value);
        case FieldKind::Tiles:
            return refuse(state, type, field, "no assignment: scripts cannot change tiles", index);
        case FieldKind::List:
            if (!isCurve(field)) return readList(state, index, world, type, field, value);
            [[fallthrough]];
        default: break;
    }
    if (!readByJson(state, index, world, type, field, value)) return false;
    if (field.kind == FieldKind::Asset) loadAsset(world, field, value);
    return true;
}

void pushValue(lua_State* state, World& world, const ScriptValue& value) {
    const auto as = [&value](auto like) { return std::bit_cast<decltype(like)>(value.bits); };
    switch (value.kind) {
        case ScriptValue::Kind::Nil: return lua_pushnil(state);
        case ScriptValue::Kind::Bool: return lua_pushboolean(state, value.bits != 0 ? 1 : 0);
        case ScriptValue::Kind::Integer: return lua_pushinteger(state, as(lua_Integer{}));
        case ScriptValue::Kind::Number: return lua_pushnumber(state, as(lua_Number{}));
        case ScriptValue::Kind::Vector: return pushVector(state, as(Vec2{}));
        case ScriptValue::Kind::Entity: return pushEntity(state, as(EntityId{}));
        case ScriptValue::Kind::Text: break;
    }
    const std::string_view text = world.texts().find(as(TextId{}));
    lua_pushlstring(state, text.data(), text.size());
}

}  // namespace plumb::script
