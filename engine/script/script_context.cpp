#include "script/script_context.hpp"

#include <lua.hpp>

namespace plumb::script {

ContextScope::ContextScope(Context& context) : before_{current_} { current_ = &context; }
ContextScope::~ContextScope() { current_ = before_; }

void failWithoutWorld(lua_State* state) {
    luaL_error(state,
               "the world is not available while a file is loaded; call this in a handler, e.g. onCreate");
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
