#pragma once

#include <cstddef>
#include <cstdint>

#include "reflect/type_info.hpp"

struct lua_State;

namespace plumb::script {

/// Names with which scripts index a component, and what they mean. Lua keeps a short text once, so its
/// address is as good as its characters: to find a name takes a comparison of addresses. A long text (more
/// than 40 bytes) may be kept many times: it is not found, and has to be compared with the names in `type`.
///
/// A userdata, which keeps its texts alive. It is in the memory of the Lua state as they are, so a snapshot
/// brings both back.
struct NameTable {
    /// What a name means: a component type, or the index of a field.
    struct Row {
        const void* text = nullptr;  ///< address of the text in Lua; null: the row is free
        const TypeInfo* component = nullptr;
        std::uint32_t field = 0;
        bool isHidden = false;  ///< a function has the same name: not for reading
    };

    const TypeInfo* type = nullptr;  ///< whose names they are
    Row* rows = nullptr;             ///< open addressing
    std::uint32_t mask = 0;          ///< number of rows - 1; that is a power of two
    std::uint32_t count = 0;         ///< rows in use

    /// Returns the row of the text at an address, see lua_topointer(); null if there is none.
    [[nodiscard]] const Row* find(const void* text) const {
        for (std::uint32_t i = hashOf(text) & mask;; i = (i + 1) & mask) {
            if (rows[i].text == nullptr) return nullptr;
            if (rows[i].text == text) return &rows[i];
        }
    }
    [[nodiscard]] static std::uint32_t hashOf(const void* text) {
        constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
        return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(text) * kGolden >> 40);
    }
};

/// Number of user values that a userdata needs for its names; others may follow.
inline constexpr int kNameValues = 2;

/// Removes all names of the userdata at an index, which is or begins with a NameTable.
/// @param expected  number of names that will be added at least
void clearNames(lua_State* state, int table, std::size_t expected);
/// Adds the text on top of the stack, which it removes, to the table at an index. @pre it is not in the table
void addName(lua_State* state, int table, NameTable::Row row);

}  // namespace plumb::script
