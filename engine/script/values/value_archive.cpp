#include "script/values/value_archive.hpp"

#include <bit>
#include <string>
#include <utility>

#include <lua.hpp>

#include "ecs/saved_type.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_source.hpp"
#include "script/script_vector.hpp"
#include "script/values/component.hpp"
#include "script/values/function_places.hpp"
#include "script/values/userdata.hpp"

namespace plumb::script {
namespace {

enum Tag : std::uint32_t {
    End,
    Nil,
    False,
    True,
    Integer,
    Number,
    Text,
    Vector,
    Entity,
    Component,
    Table,
    Place
};

BlockKind kindAt(lua_State* state, int index) {
    const auto* block = static_cast<const BlockKind*>(lua_touserdata(state, index));
    return block == nullptr ? BlockKind{} : *block;
}

/// Index of the metatable of a table among the objects of a reader.
lua_Integer metatableOf(std::uint32_t number) { return -lua_Integer{number} - 1; }

/// True if scripts can see the metatable of the table at an index, and set it: pushes it.
bool pushMetatable(lua_State* state, int index) {
    if (lua_getmetatable(state, index) == 0) return false;
    lua_pushliteral(state, "__metatable");
    const bool isHidden = lua_rawget(state, -2) != LUA_TNIL;
    lua_pop(state, isHidden ? 2 : 1);
    return !isHidden;
}

bool hasFunction(lua_State* state, int table) {
    for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
        if (lua_isfunction(state, -1) == 0) continue;
        lua_pop(state, 2);
        return true;
    }
    return false;
}

}  // namespace

bool ValueWriter::canWrite(int index) {
    switch (lua_type(state_, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING:
        case LUA_TTABLE: return true;
        case LUA_TFUNCTION:
            return numbers_.contains(lua_topointer(state_, index)) || !functionPlace(state_, index).empty();
        case LUA_TUSERDATA: {
            const BlockKind kind = kindAt(state_, index);
            return kind == BlockKind::Vector || kind == BlockKind::Entity || kind == BlockKind::Component;
        }
        default: return false;
    }
}

void ValueWriter::name(int index) {
    numbers_.emplace(lua_topointer(state_, index), count_);
    lua_pushvalue(state_, index);
    lua_rawseti(state_, objects_, lua_Integer{++count_});
}

void ValueWriter::write(int at) {
    const int index = lua_absindex(state_, at);
    switch (lua_type(state_, index)) {
        case LUA_TBOOLEAN: return tag(lua_toboolean(state_, index) != 0 ? True : False);
        case LUA_TNUMBER: {
            const bool isWhole = lua_isinteger(state_, index) != 0;
            tag(isWhole ? Integer : Number);
            std::uint64_t bits = isWhole ? static_cast<std::uint64_t>(lua_tointeger(state_, index))
                                         : std::bit_cast<std::uint64_t>(lua_tonumber(state_, index));
            return archive_.number(bits);
        }
        case LUA_TSTRING: {
            std::size_t size = 0;
            const char* text = lua_tolstring(state_, index, &size);
            std::string copy{text, size};
            tag(Text);
            return archive_.text(copy);
        }
        case LUA_TTABLE:
        case LUA_TFUNCTION: return writeObject(index);
        case LUA_TUSERDATA: break;
        default: return tag(Nil);
    }
    if (const Vec2* vector = vectorAt(state_, index)) {
        Vec2 copy = *vector;
        tag(Vector);
        return archive_.value(copy);
    }
    EntityId entity = entityOfHandle(state_, index);
    if (kindAt(state_, index) == BlockKind::Component) {
        const ComponentHandle handle = checkComponent(state_, index);
        TypeKey type = handle.type->key;
        entity = handle.entity;
        tag(Component);
        archiveKey(archive_, type);
        return archive_.value(entity);
    }
    tag(Entity);
    archive_.value(entity);
}

/// Writes the number of a table or function, and its place if it has one and is met for the first time.
void ValueWriter::writeObject(int index) {
    const auto known = numbers_.find(lua_topointer(state_, index));
    std::uint32_t number = known != numbers_.end() ? known->second : count_;
    std::string place = known != numbers_.end() ? std::string{} : functionPlace(state_, index);
    if (known == numbers_.end()) name(index);
    tag(place.empty() ? Table : Place);
    archive_.number(number);
    if (place.empty()) return;
    auto which = static_cast<std::uint32_t>(places_.size());
    archive_.number(which);
    places_.push_back(std::move(place));
    atPlaces_.insert(number);
}

void ValueWriter::writeContents(std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t number = first; number < (end != 0 ? end : count_); ++number) {
        lua_rawgeti(state_, objects_, lua_Integer{number} + 1);
        const int index = lua_gettop(state_);
        atPlaces_.contains(number) ? writeUpvalues(index) : writePairs(index);
        lua_pop(state_, 1);
    }
}

void ValueWriter::writePairs(int index) {
    if (pushMetatable(state_, index)) {
        write(-1);
        lua_pop(state_, 1);
    } else {
        tag(Nil);
    }
    for (lua_pushnil(state_); lua_next(state_, index) != 0; lua_pop(state_, 1)) {
        if (!canWrite(-2) || !canWrite(-1)) continue;
        write(-2);
        write(-1);
    }
    tag(End);
}

/// Of something else than a function of a file, which has none that count, writes none.
void ValueWriter::writeUpvalues(int index) {
    const bool isOfFile = lua_isfunction(state_, index) != 0 && lua_iscfunction(state_, index) == 0;
    for (int i = 1; const char* name = isOfFile ? lua_getupvalue(state_, index, i) : nullptr; ++i) {
        std::string text = name != kBudget && canWrite(-1) ? name : "";
        if (!text.empty()) {
            archive_.text(text);
            write(-1);
        }
        lua_pop(state_, 1);
    }
    std::string none;
    archive_.text(none);
}

ValueReader::ValueReader(lua_State* state, StateArchive& archive, const std::vector<std::string>& places)
    : state_{state}, archive_{archive} {
    lua_newtable(state);
    objects_ = lua_gettop(state);
    lua_newtable(state);
    places_ = lua_gettop(state);
    for (std::size_t i = 0; i < places.size(); ++i) {
        pushAtPlace(state, places[i]);
        lua_rawseti(state, places_, static_cast<lua_Integer>(i) + 1);
    }
}

void ValueReader::name(int index) {
    if (lua_istable(state_, index) != 0) named_.insert(lua_topointer(state_, index));
    lua_pushvalue(state_, index);
    lua_rawseti(state_, objects_, lua_Integer{++count_});
}

void ValueReader::readContents(std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t number = first; number < (end != 0 ? end : count_) && archive_.ok(); ++number) {
        lua_rawgeti(state_, objects_, lua_Integer{number} + 1);
        const int index = lua_gettop(state_);
        if (atPlaces_.contains(number)) {
            readUpvalues(index);
        } else {
            if (!pushMetatable(state_, index)) lua_pushnil(state_);
            read(lua_gettop(state_));
            lua_rawseti(state_, objects_, metatableOf(number));
            readPairs(index);
        }
        lua_settop(state_, index - 1);
    }
}

/// Moves the values of a table to the table at `former`.
void ValueReader::empty(int index, int former) {
    for (lua_pushnil(state_); lua_next(state_, index) != 0;) {
        lua_pushvalue(state_, -2);
        lua_insert(state_, -2);
        lua_rawset(state_, former);
        lua_pushvalue(state_, -1);
        lua_pushnil(state_);
        lua_rawset(state_, index);
    }
}

/// Puts functions, and tables that have some, back where there is nothing now.
void ValueReader::putBack(int index, int former) {
    for (lua_pushnil(state_); lua_next(state_, former) != 0; lua_pop(state_, 1)) {
        const bool isTable = lua_istable(state_, -1) != 0;
        if (lua_isfunction(state_, -1) == 0 && !(isTable && hasFunction(state_, lua_gettop(state_))))
            continue;
        lua_pushvalue(state_, -2);
        const bool isReplaced = lua_rawget(state_, index) != LUA_TNIL;
        lua_pop(state_, 1);
        if (isReplaced) continue;
        lua_pushvalue(state_, -2);
        lua_pushvalue(state_, -2);
        lua_rawset(state_, index);
    }
}

void ValueReader::readPairs(int index) {
    lua_newtable(state_);
    const int former = lua_gettop(state_);
    empty(index, former);
    for (std::uint32_t tag = nextTag(); tag != End && archive_.ok(); tag = nextTag()) {
        readTagged(tag, 0);
        const bool isNaN = lua_type(state_, -1) == LUA_TNUMBER && lua_rawequal(state_, -1, -1) == 0;
        if (isNaN) archive_.fail();
        // A key may be gone: the handle of a component of an entity that was destroyed. Its pair is, too.
        const bool isGone = isNaN || lua_isnil(state_, -1) != 0;
        lua_pushvalue(state_, -1);
        lua_rawget(state_, former);
        readTagged(nextTag(), lua_gettop(state_));
        lua_remove(state_, -2);
        if (isGone || lua_isnil(state_, -1) != 0) {
            lua_pop(state_, 2);
        } else {
            lua_rawset(state_, index);
        }
    }
    putBack(index, former);
}

/// @param index  of the function; another value: this version of the game does not have it
void ValueReader::readUpvalues(int index) {
    std::string name;
    for (archive_.text(name); !name.empty() && archive_.ok(); archive_.text(name)) {
        const int place = pushUpvalue(state_, index, name);
        if (place == 0) lua_pushnil(state_);
        read(lua_gettop(state_));
        if (place == 0 || lua_setupvalue(state_, index, place) == nullptr) lua_pop(state_, 1);
        lua_pop(state_, 1);
    }
}

void ValueReader::setMetatables() {
    for (std::uint32_t number = 0; number < count_; ++number) {
        lua_getglobal(state_, "setmetatable");  // refuses what scripts may not use
        lua_rawgeti(state_, objects_, lua_Integer{number} + 1);
        const bool has = lua_rawgeti(state_, objects_, metatableOf(number)) != LUA_TNIL;
        if (has && lua_pcall(state_, 2, 0, 0) != LUA_OK) archive_.fail();
        lua_settop(state_, places_);
    }
}

std::uint32_t ValueReader::nextTag() {
    std::uint32_t tag = End;
    archive_.number(tag);
    return tag;
}

void ValueReader::read(int into) { readTagged(nextTag(), into); }

void ValueReader::readTagged(std::uint32_t tag, int into) {
    std::uint64_t bits = 0;
    switch (tag) {
        case False:
        case True: return lua_pushboolean(state_, tag == True ? 1 : 0);
        case Integer: return archive_.number(bits), lua_pushinteger(state_, static_cast<lua_Integer>(bits));
        case Number: return archive_.number(bits), lua_pushnumber(state_, std::bit_cast<lua_Number>(bits));
        case Text: {
            std::string text;
            archive_.text(text);
            lua_pushlstring(state_, text.data(), text.size());
            return;
        }
        case Vector: {
            Vec2 vector;
            archive_.value(vector);
            return pushVector(state_, vector);
        }
        case Entity: {
            EntityId entity;
            archive_.value(entity);
            return pushEntity(state_, entity);
        }
        case Component: {
            TypeKey key = 0;
            EntityId entity;
            archiveKey(archive_, key);
            archive_.value(entity);
            // The description in the registry: its address identifies the type for scripts.
            const World& world = contextOf(state_).world;
            const TypeInfo* type = key < kMaxTypes ? world.types()->find(key) : nullptr;
            if (type == nullptr || !world.has(*type, entity)) return lua_pushnil(state_);
            return pushComponent(state_, entity, *type);
        }
        case Table: return readTable(into);
        case Place: return readAtPlace();
        case Nil: return lua_pushnil(state_);
        default: break;
    }
    archive_.fail();
    lua_pushnil(state_);
}

void ValueReader::readTable(int into) {
    std::uint32_t number = 0;
    archive_.number(number);
    if (!archive_.ok() || number > count_) {
        archive_.fail();
        return lua_pushnil(state_);
    }
    if (number < count_) return static_cast<void>(lua_rawgeti(state_, objects_, lua_Integer{number} + 1));
    if (into != 0 && lua_istable(state_, into) != 0 && !named_.contains(lua_topointer(state_, into))) {
        lua_pushvalue(state_, into);
    } else {
        lua_newtable(state_);
    }
    name(-1);
}

void ValueReader::readAtPlace() {
    std::uint32_t number = 0, place = 0;
    archive_.number(number);
    archive_.number(place);
    if (!archive_.ok() || number != count_) {
        archive_.fail();
        return lua_pushnil(state_);
    }
    lua_rawgeti(state_, places_, lua_Integer{place} + 1);
    if (lua_isfunction(state_, -1) == 0 && lua_istable(state_, -1) == 0)
        lua_pop(state_, 1), lua_pushnil(state_);
    atPlaces_.insert(number);
    name(-1);
}

}  // namespace plumb::script
