#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/state_archive.hpp"

struct lua_State;

namespace plumb::script {

// Values of Lua in a saved game: nil, bools, numbers, texts, vectors, entities, components, functions that
// the files define (function_places.hpp), and tables of these, also shared ones, those that contain
// themselves, and their metatables. Coroutines and functions that handlers make are left out.
//
// A table or function is written as its number; they have numbers in the order in which they are met, and the
// first time a function is followed by the number of its place. What they contain follows after all other
// values, one after the other, so that no depth of tables is too great: the pairs of a table, and the
// upvalues of a function by name, which are the local variables of its file and the table of its global ones.

class ValueWriter {
public:
    /// What was met stays on the stack of `state` at `objects` (a table, which is empty).
    ValueWriter(lua_State* state, StateArchive& archive, int objects)
        : state_{state}, archive_{archive}, objects_{objects} {}

    /// Gives the table at an index the next number, which references to it contain.
    void name(int index);
    [[nodiscard]] std::uint32_t count() const {
        return count_;
    }  ///< of tables and functions that have numbers
    [[nodiscard]] const std::vector<std::string>& places() const { return places_; }  ///< for the reader
    /// Writes the value at an index.
    void write(int index);
    /// Writes what the tables and functions with these numbers contain.
    /// @param end  0: up to the last one, also those that are met meanwhile
    void writeContents(std::uint32_t first, std::uint32_t end = 0);

private:
    [[nodiscard]] bool canWrite(int index);
    void tag(std::uint32_t tag) { archive_.number(tag); }
    void writeObject(int index);
    void writePairs(int index);
    void writeUpvalues(int index);

    lua_State* state_;
    StateArchive& archive_;
    int objects_;
    std::uint32_t count_ = 0;
    std::map<const void*, std::uint32_t> numbers_;
    std::vector<std::string> places_;
    std::set<std::uint32_t> atPlaces_;  // numbers of what has one of these places
};

class ValueReader {
public:
    /// What was read stays on the stack of `state`, to which this adds two tables.
    /// @param places  those of the writer: looked up at once, while the files have what they began with
    ValueReader(lua_State* state, StateArchive& archive, const std::vector<std::string>& places);

    /// Gives the table at an index the next number.
    void name(int index);
    [[nodiscard]] std::uint32_t count() const {
        return count_;
    }  ///< of tables and functions that have numbers
    /// Pushes the value that is read; nil if the archive is not ok(). A table has its pairs after
    /// readContents().
    /// @param into  index of a table to fill if the value is a new table; 0, or another value: a new one is
    /// made
    void read(int into = 0);
    /// Reads what the tables and functions with these numbers contain. Functions that a table had before, and
    /// tables of functions, stay if they are not replaced: this version of the game may have added them.
    void readContents(std::uint32_t first, std::uint32_t end = 0);
    /// Gives the tables their metatables. To be called last, with nothing else on the stack.
    void setMetatables();

private:
    [[nodiscard]] std::uint32_t nextTag();
    void readTagged(std::uint32_t tag, int into);
    void readTable(int into);
    void readAtPlace();
    void readUpvalues(int index);
    void readPairs(int index);
    void empty(int index, int former);
    void putBack(int index, int former);

    lua_State* state_;
    StateArchive& archive_;
    int objects_ = 0, places_ = 0;  // indices of the two tables
    std::uint32_t count_ = 0;
    std::set<std::uint32_t> atPlaces_;  // numbers of what was found at its place
    std::set<const void*> named_;       // tables that have numbers
};

}  // namespace plumb::script
