#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

struct lua_State;

namespace plumb {

/// The Lua state of a world, with all that its scripts know: a world resource. Copying it copies the state,
/// so snapshots include it, and restoring one brings back locals and coroutines too.
///
/// A state works only at its own addresses (ScriptArena), which all worlds share: the state that is used is
/// in the arena, the others are kept as copies. Use it through ScriptAccess.
class ScriptMemory {
public:
    ScriptMemory() = default;
    ScriptMemory(const ScriptMemory& other);
    ScriptMemory& operator=(const ScriptMemory& other);
    ~ScriptMemory();

    /// True if there is a state.
    [[nodiscard]] bool exists() const { return state_ != nullptr; }
    /// Size of the state, bytes.
    [[nodiscard]] std::size_t bytes() const;

private:
    friend class ScriptAccess;

    [[nodiscard]] bool isResident() const;
    void copyContent(const ScriptMemory& other);
    void enter();

    std::vector<std::byte> content_;  // of a state that is not in the arena
    lua_State* state_ = nullptr;      // its address in the arena
};

/// Exclusive access to the Lua state of a world, which is created at the first access. Only one thread at a
/// time has access to any state.
class ScriptAccess {
public:
    explicit ScriptAccess(ScriptMemory& memory);
    ScriptAccess(const ScriptAccess&) = delete;
    ScriptAccess& operator=(const ScriptAccess&) = delete;

    [[nodiscard]] lua_State* state() const { return memory_.state_; }
    /// True if the state was created by this access and contains nothing yet.
    [[nodiscard]] bool isNew() const { return isNew_; }

private:
    std::unique_lock<std::recursive_mutex> lock_;
    ScriptMemory& memory_;
    bool isNew_ = false;
};

}  // namespace plumb
