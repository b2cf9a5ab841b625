#include "script/script_context.hpp"

#include <lua.hpp>

#include "script/library/work.hpp"

namespace plumb::script {
namespace {

thread_local Context* current = nullptr;

/// Units of Work of an access to the world, which the budget of loops counts as little as an addition: 0.2
/// us.
constexpr std::int64_t kCallWork = 40;

}  // namespace

ContextScope::ContextScope(Context& context) : before_{current} { current = &context; }
ContextScope::~ContextScope() { current = before_; }

Context* currentContext() { return current; }

Context& contextOf(lua_State* state) {
    if (current == nullptr)
        luaL_error(
            state,
            "the world is not available while a file is loaded; call this in a handler, e.g. onCreate");
    spend(state, kCallWork);
    return *current;
}

std::string_view checkText(lua_State* state, int index) {
    std::size_t size = 0;
    const char* text = luaL_checklstring(state, index, &size);
    return {text, size};
}

int fail(lua_State* state, const std::string& message) {
    luaL_where(state, 1);
    lua_pushlstring(state, message.data(), message.size());
    lua_concat(state, 2);
    return -1;
}

}  // namespace plumb::script
