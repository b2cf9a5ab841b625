#include "script/script_errors.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "scene/components/name.hpp"
#include "script/library/work.hpp"
#include "script/script_arena.hpp"
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

/// Each function that is being called takes about 100 bytes, so one that calls itself without end may come to
/// the end of the memory before it comes to that of the stack.
std::string memoryText(lua_State* coroutine) {
    constexpr int kDeep = 10'000;
    constexpr int kMuch = static_cast<int>(ScriptArena::kBytes / 1024 / 2);  // KiB
    const int depth = scriptDepth(coroutine);
    if (depth >= kDeep)
        return format("stack overflow: {} calls within one another; a function calls itself without end",
                      depth);
    if (Work::isSpent() && lua_gc(coroutine, LUA_GCCOUNT) < kMuch)
        return "it makes too many tables and texts, which takes too long; use wait() in long loops";
    return "not enough memory: scripts can keep 64 MiB of values";
}

}  // namespace

std::string textAt(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TSTRING)
        return format("an error that is a {}", luaL_typename(state, index));
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    return {text, size};
}

bool callProtected(lua_State* state, const std::function<void()>& body) {
    lua_pushcfunction(state, [](lua_State* inner) {
        (*static_cast<const std::function<void()>*>(lua_touserdata(inner, 1)))();
        return 0;
    });
    lua_pushlightuserdata(state, const_cast<std::function<void()>*>(&body));
    return lua_pcall(state, 1, 0, 0) == LUA_OK;
}

std::string placeOf(lua_State* coroutine) {
    const std::vector<ScriptFrame> frames = placesOf(coroutine);
    return frames.empty() ? std::string{"scripts"} : format("{}:{}", frames[0].file, frames[0].line);
}

Error handlerError(lua_State* coroutine, int status, const World& world, EntityId entity) {
    // Without memory not even the values of variables can be described.
    const bool noMemory = status == LUA_ERRMEM;
    std::string message = noMemory ? memoryText(coroutine) : textAt(coroutine, -1);
    const std::vector<ScriptFrame> frames = noMemory ? placesOf(coroutine) : framesOf(coroutine);
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

bool FailureLog::isFirst(const std::string& place) {
    const auto known =
        std::find_if(places_.begin(), places_.end(), [&](const Place& other) { return other.name == place; });
    if (known == places_.end()) return places_.push_back({place}), true;
    ++known->others;
    return false;
}

void FailureLog::logOthers() {
    for (const Place& place : places_) {
        if (place.others == 0) continue;
        const std::string what =
            place.others == 1
                ? std::string{"the same line has stopped the script of one more entity in this tick"}
                : format("the same line has stopped the scripts of {} more entities in this tick",
                         place.others);
        logError("Script", Error{place.name, what, "change the file: they go on when it is saved"});
    }
    places_.clear();
}

}  // namespace plumb::script
