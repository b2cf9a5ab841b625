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

class ValueWriter {
public:
    ValueWriter(lua_State* state, StateArchive& archive) : state_{state}, archive_{archive} {}

    /// Gives the table at an index the next number, which references to it contain.
    void name(int index);
    /// Writes the value at an index.
    void write(int index, int depth = 0);
    /// Writes the pairs of the table at an index that can be written.
    void writePairs(int index, int depth);
    [[nodiscard]] bool canWrite(int index) const;

private:
    void tag(std::uint32_t tag) { archive_.number(tag); }

    lua_State* state_;
    StateArchive& archive_;
    std::map<const void*, std::uint32_t> numbers_;  // of tables
};

class ValueReader {
public:
    /// The tables that were read stay on the stack of `state` at `tables` (a table of tables).
    ValueReader(lua_State* state, StateArchive& archive, int tables)
        : state_{state}, archive_{archive}, tables_{tables} {}

    /// Gives the table at an index the next number.
    void name(int index);
    /// Pushes the value that is read; nil if the archive is not ok().
    /// @param into  index of a table to fill if the value is a new table; 0: a new one is made
    void read(int into = 0, int depth = 0);
    /// Reads pairs into the table at an index. Its former values are removed, except functions.
    void readPairs(int index, int depth);

private:
    lua_State* state_;
    StateArchive& archive_;
    int tables_;
    std::uint32_t count_ = 0;
};

}  // namespace plumb::script
