#include "script/script_memory.hpp"

#include <lua.hpp>

#include "core/assert.hpp"
#include "script/library/work.hpp"
#include "script/script_arena.hpp"

namespace plumb {
namespace {

std::recursive_mutex accessMutex;
ScriptMemory* resident = nullptr;  // whose state is in the arena; guarded by the mutex

void* allocate(void*, void* block, std::size_t oldSize, std::size_t newSize) {
    if (block == nullptr) oldSize = 0;  // Lua passes the kind of the object
    ScriptArena& arena = ScriptArena::instance();
    const bool allowed = newSize <= oldSize || script::Work::spendBlock(newSize);
    void* result = allowed ? arena.allocate(block, oldSize, newSize) : nullptr;
    if (result != nullptr || newSize == 0) return result;
    script::Work::spendCollection(arena.content().size());
    if (!allowed) return nullptr;
    arena.joinFreed();
    return arena.allocate(block, oldSize, newSize);
}

}  // namespace

ScriptMemory::ScriptMemory(const ScriptMemory& other) { copyContent(other); }

ScriptMemory& ScriptMemory::operator=(const ScriptMemory& other) {
    if (this != &other) copyContent(other);
    return *this;
}

ScriptMemory::~ScriptMemory() {
    const std::lock_guard lock{accessMutex};
    if (isResident()) resident = nullptr;
}

bool ScriptMemory::isResident() const { return resident == this; }

std::size_t ScriptMemory::bytes() const {
    const std::lock_guard lock{accessMutex};
    return isResident() ? ScriptArena::instance().content().size() : content_.size();
}

void ScriptMemory::copyContent(const ScriptMemory& other) {
    const std::lock_guard lock{accessMutex};
    ScriptArena& arena = ScriptArena::instance();
    const std::span<const std::byte> from = other.isResident() ? arena.content() : std::span{other.content_};
    state_ = other.state_;
    if (isResident() && state_ != nullptr) {
        arena.load(from);
    } else {
        if (isResident()) resident = nullptr;
        content_.assign(from.begin(), from.end());
    }
}

/// Brings the state into the arena; the one that was there is kept as a copy.
void ScriptMemory::enter() {
    if (isResident()) return;
    ScriptArena& arena = ScriptArena::instance();
    if (resident != nullptr) {
        const std::span<const std::byte> content = arena.content();
        resident->content_.assign(content.begin(), content.end());
    }
    resident = this;
    if (state_ != nullptr) {
        arena.load(content_);
        content_.clear();
    } else {
        arena.clear();
        state_ = lua_newstate(&allocate, nullptr);
        if (state_ == nullptr) failAssertion("out of memory for scripts", __FILE__, __LINE__);
    }
}

ScriptAccess::ScriptAccess(ScriptMemory& memory)
    : lock_{accessMutex}, memory_{memory}, isNew_{!memory.exists()} {
    memory_.enter();
}

}  // namespace plumb
