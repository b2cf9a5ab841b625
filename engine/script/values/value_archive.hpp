#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/state_archive.hpp"

struct lua_State;

namespace plumb::script {

// Values of Lua in a saved game: nil, bools, numbers, texts, vectors, entities, components, and tables of
// these, also shared ones and those that contain themselves. Functions and coroutines are left out, and so
// are metatables.
//
// A table is written as its number; tables have numbers in the order in which they are met. The pairs of the
// tables follow after all other values, one table after the other, so that no depth of tables is too great.

class ValueWriter {
public:
    /// The tables that were met stay on the stack of `state` at `tables` (a table of tables, which is empty).
    ValueWriter(lua_State* state, StateArchive& archive, int tables)
        : state_{state}, archive_{archive}, tables_{tables} {}

    /// Gives the table at an index the next number, which references to it contain.
    void name(int index);
    [[nodiscard]] std::uint32_t count() const { return count_; }  ///< of tables that have numbers
    /// Writes the value at an index.
    void write(int index);
    /// Writes the pairs of the tables with these numbers or higher ones, also of those that they contain.
    void writeTables(std::uint32_t first);
    [[nodiscard]] bool canWrite(int index) const;

private:
    void tag(std::uint32_t tag) { archive_.number(tag); }
    void writePairs(int index);

    lua_State* state_;
    StateArchive& archive_;
    int tables_;
    std::uint32_t count_ = 0;
    std::map<const void*, std::uint32_t> numbers_;  // of tables
};

class ValueReader {
public:
    /// The tables that were read stay on the stack of `state` at `tables` (a table of tables, which is
    /// empty).
    ValueReader(lua_State* state, StateArchive& archive, int tables)
        : state_{state}, archive_{archive}, tables_{tables} {}

    /// Gives the table at an index the next number.
    void name(int index);
    [[nodiscard]] std::uint32_t count() const { return count_; }  ///< of tables that have numbers
    /// Pushes the value that is read; nil if the archive is not ok(). A table has its pairs after
    /// readTables().
    /// @param into  index of a table to fill if the value is a new table; 0: a new one is made
    void read(int into = 0);
    /// Reads the pairs of the tables with these numbers or higher ones, also of those that they contain.
    /// Their former values are removed, except functions.
    void readTables(std::uint32_t first);

private:
    [[nodiscard]] std::uint32_t nextTag();
    void readTagged(std::uint32_t tag, int into);
    void readTable(int into);
    void clear(int index);
    void readPairs(int index);

    lua_State* state_;
    StateArchive& archive_;
    int tables_;
    std::uint32_t count_ = 0;
};

}  // namespace plumb::script
