#include "script/script_declaration.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <set>
#include <utility>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "math/color.hpp"
#include "reflect/type_key.hpp"
#include "script/script_values.hpp"
#include "script/script_vector.hpp"
#include "script/values/userdata.hpp"

namespace plumb::script {
namespace {

constexpr const char* kProperty = "property";
// Keys in the registry of the Lua state, by address: the table that was passed to script() by the file that
// runs, and those of all files that have run, by name.
constexpr char kDeclared = 0;
constexpr char kAllDeclared = 0;

/// A property of a script, as declared by number{...} and the like. Its user value is the table of details.
struct Property {
    static constexpr BlockKind kKind = BlockKind::Property;
    BlockKind blockKind = kKind;
    FieldKind kind = FieldKind::Float;
    FieldKind element = FieldKind::Float;
    AssetKind asset = AssetKind::None;
    std::size_t capacity = 0;  // of a list
    lua_Integer order = 0;     // properties are listed in the order in which they were declared
};

struct KindName {
    const char* name;
    FieldKind kind;
    AssetKind asset = AssetKind::None;
};
constexpr std::array kKinds{KindName{"number", FieldKind::Float},
                            KindName{"integer", FieldKind::Int},
                            KindName{"boolean", FieldKind::Bool},
                            KindName{"text", FieldKind::Text},
                            KindName{"vector", FieldKind::Vec2},
                            KindName{"color", FieldKind::Color},
                            KindName{"entity", FieldKind::Entity},
                            KindName{"choice", FieldKind::Enum},
                            KindName{"texture", FieldKind::Asset, AssetKind::Texture},
                            KindName{"tileset", FieldKind::Asset, AssetKind::Tileset},
                            KindName{"animation", FieldKind::Asset, AssetKind::Animation},
                            KindName{"sound", FieldKind::Asset, AssetKind::Sound},
                            KindName{"font", FieldKind::Asset, AssetKind::Font},
                            KindName{"scene", FieldKind::Asset, AssetKind::Scene},
                            KindName{"prefab", FieldKind::Asset, AssetKind::Prefab}};

constexpr std::array<std::pair<std::string_view, Unit>, 11> kUnits{{{"px", Unit::Pixels},
                                                                    {"px/s", Unit::PixelsPerSecond},
                                                                    {"px/s2", Unit::PixelsPerSecondSquared},
                                                                    {"s", Unit::Seconds},
                                                                    {"deg", Unit::Degrees},
                                                                    {"rad", Unit::Radians},
                                                                    {"rad/s", Unit::RadiansPerSecond},
                                                                    {"ratio", Unit::Ratio},
                                                                    {"kg", Unit::Kilograms},
                                                                    {"tiles", Unit::Tiles},
                                                                    {"ticks", Unit::Ticks}}};

Property& pushProperty(lua_State* state, int details) {
    auto* property = new (lua_newuserdatauv(state, sizeof(Property), 1)) Property;
    lua_pushvalue(state, details);
    lua_setiuservalue(state, -2, 1);
    luaL_setmetatable(state, kProperty);
    lua_getfield(state, LUA_REGISTRYINDEX, kProperty);
    lua_getfield(state, -1, "count");
    property->order = lua_tointeger(state, -1) + 1;
    lua_pushinteger(state, property->order);
    lua_setfield(state, -3, "count");
    lua_pop(state, 2);
    return *property;
}

/// number{40, min = 0} or number(40). The upvalue is the index of the kind.
int makeProperty(lua_State* state) {
    const KindName& kind = kKinds[static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(1)))];
    lua_settop(state, 1);
    if (lua_type(state, 1) != LUA_TTABLE) {
        lua_newtable(state);
        lua_pushvalue(state, 1);
        lua_rawseti(state, -2, 1);
        lua_replace(state, 1);
    }
    Property& property = pushProperty(state, 1);
    property.kind = kind.kind;
    property.asset = kind.asset;
    return 1;
}

/// list(number{min = 0}, 8): at most 8 numbers.
int makeList(lua_State* state) {
    constexpr lua_Integer kItems = 16;
    constexpr lua_Integer kMaxItems = 64;
    const auto item = *static_cast<const Property*>(luaL_checkudata(state, 1, kProperty));
    const lua_Integer capacity = luaL_optinteger(state, 2, kItems);
    luaL_argcheck(state, capacity >= 1 && capacity <= kMaxItems, 2, "a list has 1 to 64 items");
    luaL_argcheck(state, item.kind != FieldKind::List, 1, "a list of lists is not possible");
    lua_getiuservalue(state, 1, 1);
    Property& property = pushProperty(state, lua_gettop(state));
    property.kind = FieldKind::List;
    property.element = item.kind;
    property.asset = item.asset;
    property.capacity = static_cast<std::size_t>(capacity);
    return 1;
}

int declareScript(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 1);
    if (lua_rawgetp(state, LUA_REGISTRYINDEX, &kDeclared) == LUA_TTABLE)
        return luaL_error(state, "script{} was called before: a file declares one component");
    lua_pop(state, 1);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kDeclared);
    lua_newtable(state);
    return 1;
}

// ---- types

std::size_t sizeOf(FieldKind kind) {
    switch (kind) {
        case FieldKind::Bool: return sizeof(bool);
        case FieldKind::Float: return sizeof(float);
        case FieldKind::Color: return sizeof(Color);
        case FieldKind::Enum: return sizeof(std::int32_t);
        default: return 8;
    }
}
std::size_t alignmentOf(FieldKind kind) {
    switch (kind) {
        case FieldKind::Bool: return 1;
        case FieldKind::Float:
        case FieldKind::Vec2:
        case FieldKind::Color:
        case FieldKind::Entity:
        case FieldKind::Enum: return 4;
        default: return 8;
    }
}

/// Builds the component type of a script.
class TypeMaker {
public:
    /// The table that was passed to script() is on top of the stack.
    TypeMaker(lua_State* state, std::string_view name) : state_{state} {
        type_.name = permanentText(name);
        type_.key = reloadableTypeKey(permanentText(format("script {}", name)));
        FieldInfo stopped;
        stopped.name = "stopped";
        stopped.doc = "An error has stopped this script; untick it to let the script go on.";
        stopped.kind = FieldKind::Bool;
        stopped.size = sizeof(bool);
        stopped.transient = true;
        append(stopped);
    }

    Result<TypeInfo> make(std::vector<std::string>& texts) {
        const int declared = lua_gettop(state_);
        for (const auto& [order, name] : sortedNames(declared)) {
            lua_pushlstring(state_, name.data(), name.size());
            lua_rawget(state_, declared);
            if (name == "doc" && lua_type(state_, -1) == LUA_TSTRING) {
                type_.doc = textAt(-1);
            } else if (!addField(name)) {
                const Error error{
                    std::string{name}, lua_tostring(state_, -1),
                    "declare a property like this: speed = number { 40, min = 0, doc = \"...\" }"};
                lua_settop(state_, declared);
                return error;
            }
            lua_settop(state_, declared);
        }
        type_.size = (type_.size + type_.alignment - 1) / type_.alignment * type_.alignment;
        type_.defaults.resize(type_.size);
        for (const TextId id : textIds_) texts.emplace_back(world_.texts().find(id));
        return type_;
    }

private:
    /// Names of properties in the order of their declaration; those declared by a plain value come first.
    std::vector<std::pair<lua_Integer, std::string>> sortedNames(int declared) {
        std::vector<std::pair<lua_Integer, std::string>> names;
        for (lua_pushnil(state_); lua_next(state_, declared) != 0; lua_pop(state_, 1)) {
            if (lua_type(state_, -2) != LUA_TSTRING) continue;
            const auto* property = static_cast<const Property*>(luaL_testudata(state_, -1, kProperty));
            names.emplace_back(property == nullptr ? 0 : property->order, lua_tostring(state_, -2));
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    std::string_view textAt(int index) {
        std::size_t size = 0;
        const char* text = lua_tolstring(state_, index, &size);
        return text == nullptr ? std::string_view{} : permanentText({text, size});
    }
    std::string_view textOption(int table, const char* name) {
        lua_getfield(state_, table, name);
        const std::string_view text = lua_type(state_, -1) == LUA_TSTRING ? textAt(-1) : std::string_view{};
        lua_pop(state_, 1);
        return text;
    }
    float numberOption(int table, const char* name, float otherwise) {
        lua_getfield(state_, table, name);
        const float number =
            lua_type(state_, -1) == LUA_TNUMBER ? static_cast<float>(lua_tonumber(state_, -1)) : otherwise;
        lua_pop(state_, 1);
        return number;
    }

    /// Adds a field for the property, or plain value, on top of the stack. @return false after pushing a
    /// message
    bool addField(std::string_view name) {
        if (name == "entity" || name == "stopped") {
            lua_pushliteral(state_, "every script has this name; choose another one");
            return false;
        }
        FieldInfo field;
        field.name = permanentText(name);
        const int value = lua_gettop(state_);
        const auto* property = static_cast<const Property*>(luaL_testudata(state_, value, kProperty));
        if (property == nullptr) return addPlain(field, value);
        field.kind = property->kind;
        field.element = property->element;
        field.asset = property->asset;
        field.capacity = property->capacity;
        lua_getiuservalue(state_, value, 1);
        const int details = lua_gettop(state_);
        if (!checkOptions(details)) return false;
        field.doc = textOption(details, "doc");
        field.was = textOption(details, "was");
        field.shownIf = textOption(details, "shownIf");
        field.min = numberOption(details, "min", field.min);
        field.max = numberOption(details, "max", field.max);
        field.step = numberOption(details, "step", 0.0f);
        if (!findUnit(field, details) || !findNames(field, details)) return false;
        if (field.min > field.max) {
            lua_pushliteral(state_, "min is larger than max");
            return false;
        }
        setSize(field);
        append(field);
        lua_rawgeti(state_, details, 1);
        const bool isNameList = field.kind == FieldKind::Enum || field.kind == FieldKind::List;
        return isNameList || lua_isnil(state_, -1) != 0 || setDefault(lua_gettop(state_));
    }

    bool checkOptions(int details) {
        constexpr std::array<std::string_view, 7> kOptions{"doc", "was",  "shownIf", "min",
                                                           "max", "step", "unit"};
        for (lua_pushnil(state_); lua_next(state_, details) != 0; lua_pop(state_, 1)) {
            if (lua_type(state_, -2) != LUA_TSTRING) continue;
            const std::string_view option = lua_tostring(state_, -2);
            if (std::find(kOptions.begin(), kOptions.end(), option) != kOptions.end()) continue;
            lua_pushfstring(
                state_, "unknown option \"%s\"; the options are doc, was, shownIf, min, max, step and unit",
                lua_tostring(state_, -2));
            return false;
        }
        return true;
    }

    bool addPlain(FieldInfo field, int value) {
        switch (lua_type(state_, value)) {
            case LUA_TNUMBER: field.kind = FieldKind::Float; break;
            case LUA_TBOOLEAN: field.kind = FieldKind::Bool; break;
            case LUA_TSTRING: field.kind = FieldKind::Text; break;
            default:
                if (vectorAt(state_, value) == nullptr) {
                    lua_pushfstring(state_, "a %s is not a property", luaL_typename(state_, value));
                    return false;
                }
                field.kind = FieldKind::Vec2;
        }
        setSize(field);
        append(field);
        return setDefault(value);
    }

    bool findUnit(FieldInfo& field, int details) {
        const std::string_view unit = textOption(details, "unit");
        if (unit.empty()) return true;
        for (const auto& [name, value] : kUnits) {
            if (name == unit) return field.unit = value, true;
        }
        lua_pushliteral(
            state_,
            "unknown unit; the units are px, px/s, px/s2, s, deg, rad, rad/s, ratio, kg, tiles and ticks");
        return false;
    }

    /// The names of a choice are the items of its table; the first is the default.
    bool findNames(FieldInfo& field, int details) {
        if (field.kind != FieldKind::Enum && field.element != FieldKind::Enum) return true;
        const auto count = static_cast<lua_Integer>(lua_rawlen(state_, details));
        for (lua_Integer i = 1; i <= count; ++i) {
            lua_rawgeti(state_, details, i);
            if (lua_type(state_, -1) == LUA_TSTRING)
                field.names.push_back({textAt(-1), static_cast<int>(field.names.size())});
            lua_pop(state_, 1);
        }
        if (!field.names.empty()) return true;
        lua_pushliteral(state_, "a choice needs names: choice { \"walk\", \"fly\" }");
        return false;
    }

    static void setSize(FieldInfo& field) {
        if (field.kind != FieldKind::List) {
            field.size = sizeOf(field.kind);
            return;
        }
        field.elementSize = sizeOf(field.element);
        field.countOffset = (field.elementSize * field.capacity + 3) / 4 * 4;
        field.size = field.countOffset + sizeof(std::uint32_t);
    }

    void append(FieldInfo& field) {
        const std::size_t alignment = field.kind == FieldKind::List
                                          ? std::max<std::size_t>(alignmentOf(field.element), 4)
                                          : alignmentOf(field.kind);
        type_.alignment = std::max(type_.alignment, alignment);
        field.offset = (type_.size + alignment - 1) / alignment * alignment;
        type_.size = field.offset + field.size;
        type_.defaults.resize(type_.size);
        type_.fields.push_back(field);
    }

    bool setDefault(int value) {
        const FieldInfo& field = type_.fields.back();
        void* stored = field.in(type_.defaults.data());
        if (!readValue(state_, value, world_, type_.name, field, stored)) return false;
        if (field.kind == FieldKind::Text || field.kind == FieldKind::Asset) {
            TextId id;
            std::memcpy(&id, stored, sizeof id);
            textIds_.push_back(id);
        }
        return true;
    }

    lua_State* state_;
    TypeInfo type_;
    World world_;  // whose texts the default values refer to
    std::vector<TextId> textIds_;
};

}  // namespace

std::string_view permanentText(std::string_view text) {
    static std::mutex mutex;
    static std::set<std::string, std::less<>> texts;
    const std::lock_guard lock{mutex};
    const auto found = texts.find(text);
    return found != texts.end() ? *found : *texts.emplace(text).first;
}

void addDeclarations(lua_State* state) {
    luaL_newmetatable(state, kProperty);
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_pop(state, 1);
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        lua_pushinteger(state, static_cast<lua_Integer>(i));
        lua_pushcclosure(state, makeProperty, 1);
        lua_setglobal(state, kKinds[i].name);
    }
    lua_newtable(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kAllDeclared);
    lua_register(state, "list", makeList);
    lua_register(state, "script", declareScript);
}

void beginDeclaration(lua_State* state) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kDeclared);
    lua_pushnil(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kDeclared);
}

void endDeclaration(lua_State* state, std::string_view file) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kAllDeclared);
    lua_pushlstring(state, file.data(), file.size());
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kDeclared);
    lua_rawset(state, -3);
    lua_pop(state, 1);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kDeclared);
}

namespace {

bool pushDeclared(lua_State* state, std::string_view file) {
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kAllDeclared);
    lua_pushlstring(state, file.data(), file.size());
    const bool declared = lua_rawget(state, -2) == LUA_TTABLE;
    lua_remove(state, -2);
    return declared;
}

}  // namespace

bool isDeclared(lua_State* state, std::string_view file) {
    const bool declared = pushDeclared(state, file);
    lua_pop(state, 1);
    return declared;
}

Result<TypeInfo> declaredType(lua_State* state, std::string_view file, std::string_view name,
                              std::vector<std::string>& texts) {
    pushDeclared(state, file);
    Result<TypeInfo> type = TypeMaker{state, name}.make(texts);
    lua_pop(state, 1);
    return type;
}

}  // namespace plumb::script
