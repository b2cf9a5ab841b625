#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/state_archive.hpp"

struct lua_State;

namespace plumb::script {

// Values of Lua in a saved game: nil, bools, numbers, texts, vectors, entities, components, and tables of
// these, also shared ones and those that contain themselves. Functions and coroutines are left out, and so
// are metatables. The pairs of a new table follow the value that contains it: no nesting is too deep.

class ValueWriter {
public:
    /// The tables that were written stay on the stack of `state` at `tables` (a table of tables).
    ValueWriter(lua_State* state, StateArchive& archive, int tables)
        : state_{state}, archive_{archive}, tables_{tables} {}

    /// Gives the table at an index the next number, which references to it contain.
    void name(int index);
    /// Writes the value at an index.
    void write(int index);
    /// Writes the pairs of the table at an index that can be written.
    void writePairs(int index);
    [[nodiscard]] bool canWrite(int index) const;

private:
    void tag(std::uint32_t tag) { archive_.number(tag); }
    void put(int index);
    void putPairs(int index);
    void putNew();

    lua_State* state_;
    StateArchive& archive_;
    int tables_;
    std::map<const void*, std::uint32_t> numbers_;  // of tables
    std::vector<std::uint32_t> new_;                // tables whose pairs are not written yet
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
    void read(int into = 0);
    /// Reads pairs into the table at an index. Its former values are removed, except functions.
    void readPairs(int index);

private:
    void take(std::uint32_t tag, int into = 0);
    void takePairs(int index);
    void takeNew();

    lua_State* state_;
    StateArchive& archive_;
    int tables_;
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> new_;  // tables whose pairs are not read yet
};

}  // namespace plumb::script
