#include "script/script_errors.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "scene/components/name.hpp"
#include "script/script_frames.hpp"

namespace plumb::script {
namespace {

constexpr std::size_t kMaxFrames = 8;      // functions listed
constexpr std::size_t kMaxVariables = 12;  // variables listed

std::string entityName(const World& world, EntityId entity) {
    const Name* name = world.find<Name>(entity);
    const std::string_view text = name == nullptr ? std::string_view{} : world.texts().find(name->text);
    return text.empty() ? format("entity {}", entity.index) : std::string{text};
}

/// "speed = 40, target = nil"
std::string listOf(const std::vector<ScriptVariable>& variables) {
    std::string list;
    for (std::size_t i = 0; i < std::min(variables.size(), kMaxVariables); ++i)
        list += format("{}{} = {}", list.empty() ? "" : ", ", variables[i].name, variables[i].value);
    return list;
}

}  // namespace

std::string textAt(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TSTRING)
        return format("an error that is a {}", luaL_typename(state, index));
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    return {text, size};
}

Error handlerError(lua_State* coroutine, const World& world, EntityId entity) {
    std::string message = textAt(coroutine, -1);
    const std::vector<ScriptFrame> frames = framesOf(coroutine);
    std::string where = "scripts", stack;
    for (std::size_t i = 0; i < std::min(frames.size(), kMaxFrames); ++i) {
        const std::string line = format("{}:{}", frames[i].file, frames[i].line);
        if (i == 0) where = line;
        stack += format("\n  in {} at {}", frames[i].function, line);
    }
    while (startsWith(message, where + ": ")) message.erase(0, where.size() + 2);
    std::string what = format("{} (in \"{}\")", message, entityName(world, entity)) + stack;
    if (!frames.empty() && !frames.front().variables.empty())
        what += "\n  with " + listOf(frames.front().variables);
    return {where, what, "the script of this entity is stopped until its file is changed"};
}

}  // namespace plumb::script
