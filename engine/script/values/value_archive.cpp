#include "script/values/value_archive.hpp"

#include <bit>
#include <string>

#include <lua.hpp>

#include "ecs/saved_type.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "script/script_context.hpp"
#include "script/script_entity.hpp"
#include "script/script_vector.hpp"
#include "script/values/component.hpp"
#include "script/values/userdata.hpp"

namespace plumb::script {
namespace {

enum Tag : std::uint32_t { End, Nil, False, True, Integer, Number, Text, Vector, Entity, Component, Table };

BlockKind kindAt(lua_State* state, int index) {
    const auto* block = static_cast<const BlockKind*>(lua_touserdata(state, index));
    return block == nullptr ? BlockKind{} : *block;
}

}  // namespace

bool ValueWriter::canWrite(int index) const {
    switch (lua_type(state_, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING:
        case LUA_TTABLE: return true;
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
    lua_rawseti(state_, tables_, lua_Integer{++count_});
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
        case LUA_TTABLE: {
            if (!numbers_.contains(lua_topointer(state_, index))) name(index);
            tag(Table);
            std::uint32_t number = numbers_.at(lua_topointer(state_, index));
            return archive_.number(number);
        }
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

void ValueWriter::writeTables(std::uint32_t first) {
    for (std::uint32_t number = first; number < count_; ++number) {
        lua_rawgeti(state_, tables_, lua_Integer{number} + 1);
        writePairs(lua_gettop(state_));
        lua_pop(state_, 1);
    }
}

void ValueWriter::writePairs(int index) {
    for (lua_pushnil(state_); lua_next(state_, index) != 0; lua_pop(state_, 1)) {
        if (!canWrite(-2) || !canWrite(-1)) continue;
        write(-2);
        write(-1);
    }
    tag(End);
}

void ValueReader::name(int index) {
    lua_pushvalue(state_, index);
    lua_rawseti(state_, tables_, lua_Integer{++count_});
}

void ValueReader::readTables(std::uint32_t first) {
    for (std::uint32_t number = first; number < count_ && archive_.ok(); ++number) {
        lua_rawgeti(state_, tables_, lua_Integer{number} + 1);
        clear(lua_gettop(state_));
        readPairs(lua_gettop(state_));
        lua_pop(state_, 1);
    }
}

/// Removes the values of a table, except functions.
void ValueReader::clear(int index) {
    for (lua_pushnil(state_); lua_next(state_, index) != 0;) {
        const bool isFunction = lua_isfunction(state_, -1) != 0;
        lua_pop(state_, 1);
        if (isFunction) continue;
        lua_pushvalue(state_, -1);
        lua_pushnil(state_);
        lua_rawset(state_, index);
    }
}

void ValueReader::readPairs(int index) {
    for (std::uint32_t tag = nextTag(); tag != End && archive_.ok(); tag = nextTag()) {
        readTagged(tag, 0);
        readTagged(nextTag(), 0);
        const bool isNaN = lua_type(state_, -2) == LUA_TNUMBER && lua_rawequal(state_, -2, -2) == 0;
        if (isNaN) archive_.fail();
        // A key may be gone: the handle of a component of an entity that was destroyed. Its pair is, too.
        if (isNaN || lua_isnil(state_, -2) != 0) {
            lua_pop(state_, 2);
        } else {
            lua_rawset(state_, index);
        }
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
    if (number < count_) return static_cast<void>(lua_rawgeti(state_, tables_, lua_Integer{number} + 1));
    if (into != 0) {
        lua_pushvalue(state_, into);
    } else {
        lua_newtable(state_);
    }
    name(-1);
}

}  // namespace plumb::script
