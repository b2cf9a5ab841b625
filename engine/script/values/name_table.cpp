#include "script/values/name_table.hpp"

#include <algorithm>
#include <bit>
#include <memory>

#include <lua.hpp>

namespace plumb::script {
namespace {

// User values of a table.
constexpr int kTexts = 1;           // a list of all texts
constexpr int kRows = kNameValues;  // the block of the rows

NameTable& tableAt(lua_State* state, int index) {
    return *static_cast<NameTable*>(lua_touserdata(state, index));
}

/// Gives the table at an index a block of free rows, on top of the stack.
void pushRows(lua_State* state, int index, std::size_t count) {
    auto* rows = static_cast<NameTable::Row*>(lua_newuserdatauv(state, count * sizeof(NameTable::Row), 0));
    std::uninitialized_value_construct_n(rows, count);
    NameTable& table = tableAt(state, index);
    table.rows = rows;
    table.mask = static_cast<std::uint32_t>(count) - 1;
}

/// Number of rows for so many names: at most two thirds are in use, so searches end soon.
std::size_t rowsFor(std::size_t names) { return std::bit_ceil(std::max<std::size_t>(names * 3 / 2 + 1, 4)); }

void place(NameTable& table, const NameTable::Row& row) {
    std::uint32_t i = NameTable::hashOf(row.text) & table.mask;
    while (table.rows[i].text != nullptr) i = (i + 1) & table.mask;
    table.rows[i] = row;
}

void grow(lua_State* state, int index) {
    const NameTable before = tableAt(state, index);
    pushRows(state, index, (std::size_t{before.mask} + 1) * 2);
    for (std::uint32_t i = 0; i <= before.mask; ++i)
        if (before.rows[i].text != nullptr) place(tableAt(state, index), before.rows[i]);
    lua_setiuservalue(state, index, kRows);
}

}  // namespace

void clearNames(lua_State* state, int table, std::size_t expected) {
    lua_createtable(state, static_cast<int>(expected), 0);
    lua_setiuservalue(state, table, kTexts);
    pushRows(state, table, rowsFor(expected));
    lua_setiuservalue(state, table, kRows);
    tableAt(state, table).count = 0;
}

void addName(lua_State* state, int table, NameTable::Row row) {
    row.text = lua_topointer(state, -1);
    const std::uint32_t count = ++tableAt(state, table).count;
    lua_getiuservalue(state, table, kTexts);
    lua_insert(state, -2);
    lua_rawseti(state, -2, static_cast<lua_Integer>(count));
    lua_pop(state, 1);
    if (rowsFor(count) > std::size_t{tableAt(state, table).mask} + 1) grow(state, table);
    place(tableAt(state, table), row);
}

}  // namespace plumb::script
