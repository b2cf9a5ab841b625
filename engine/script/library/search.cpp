#include <algorithm>
#include <cstdint>
#include <string_view>

#include <lua.hpp>

#include "script/library/library_parts.hpp"
#include "script/library/pattern.hpp"
#include "script/library/work.hpp"

// string.find, match, gmatch and gsub with patterns that end in a limited number of steps.

namespace plumb::script {
namespace {

std::string_view textAt(lua_State* state, int index) {
    std::size_t length = 0;
    const char* text = luaL_checklstring(state, index, &length);
    return {text, length};
}

int raise(lua_State* state, PatternMatcher::Problem problem) {
    switch (problem) {
        case PatternMatcher::Problem::TooManySteps:
            return luaL_error(state,
                              "the pattern needs too many steps for this text; use fewer '.-' and '.*'");
        case PatternMatcher::Problem::TooComplex:
            return luaL_error(state, "the pattern is nested too deeply");
        case PatternMatcher::Problem::Malformed:
            return luaL_error(state, "malformed pattern (ends after '%%' or '[')");
        case PatternMatcher::Problem::TooManyCaptures: return luaL_error(state, "too many captures");
        default: return luaL_error(state, "invalid pattern capture");
    }
}

/// Matches at a position; raises an error if something is wrong with the pattern.
std::size_t matchAt(lua_State* state, PatternMatcher& matcher, std::size_t position) {
    const std::int64_t before = matcher.steps();
    const std::size_t end = matcher.match(position);
    constexpr std::int64_t kWorkPerStep = 3;
    spend(state, kWorkPerStep * (matcher.steps() - before));
    if (matcher.problem() != PatternMatcher::Problem::None) raise(state, matcher.problem());
    return end;
}

void pushCapture(lua_State* state, const PatternMatcher& matcher, std::string_view text, int index) {
    const PatternMatcher::Capture& capture = matcher.capture(index);
    if (capture.isOpen) luaL_error(state, "unfinished capture");
    if (capture.isPosition) {
        lua_pushinteger(state, static_cast<lua_Integer>(capture.begin + 1));
    } else {
        lua_pushlstring(state, text.data() + capture.begin, capture.length);
    }
}

/// Pushes all captures, or the whole match if there are none. @return their number
int pushCaptures(lua_State* state, const PatternMatcher& matcher, std::string_view text, std::size_t begin,
                 std::size_t end) {
    if (matcher.captureCount() == 0) {
        lua_pushlstring(state, text.data() + begin, end - begin);
        return 1;
    }
    luaL_checkstack(state, matcher.captureCount(), "too many captures");
    for (int i = 0; i < matcher.captureCount(); ++i) pushCapture(state, matcher, text, i);
    return matcher.captureCount();
}

/// The argument `init`: a position from 1, or from the end if it is negative. @return an offset, beyond the
/// end for none
std::size_t startAt(lua_State* state, int index, std::size_t length) {
    const lua_Integer position = luaL_optinteger(state, index, 1);
    if (position > 0) return static_cast<std::size_t>(position) - 1;
    if (position == 0 || 0 - static_cast<std::uint64_t>(position) > length) return 0;
    return length - static_cast<std::size_t>(-position);
}

int pushNil(lua_State* state) { return lua_pushnil(state), 1; }

int pushRange(lua_State* state, std::size_t begin, std::size_t end) {
    lua_pushinteger(state, static_cast<lua_Integer>(begin + 1));
    lua_pushinteger(state, static_cast<lua_Integer>(end));
    return 2;
}

/// Like std::string_view::find, in a limited number of steps.
std::size_t findPlain(lua_State* state, std::string_view text, std::string_view part, std::size_t start) {
    constexpr std::int64_t kStepsPerPlace = 4;  // a comparison with few equal characters
    if (part.empty()) return start;
    std::int64_t steps = static_cast<std::int64_t>((text.size() - start) / 16);
    std::size_t at = text.find(part.front(), start);
    for (; at != std::string_view::npos; at = text.find(part.front(), at + 1)) {
        const std::string_view here = text.substr(at, part.size());
        const auto [end, rest] = std::mismatch(here.begin(), here.end(), part.begin());
        if (rest == part.end()) break;
        steps += kStepsPerPlace + (end - here.begin());
        if (steps > PatternMatcher::kMaxSteps * kStepsPerPlace)
            raise(state, PatternMatcher::Problem::TooManySteps);
    }
    spend(state, steps);
    return at;
}

int findOrMatch(lua_State* state, bool finds) {
    const std::string_view text = textAt(state, 1);
    std::string_view pattern = textAt(state, 2);
    std::size_t start = startAt(state, 3, text.size());
    if (start > text.size()) return pushNil(state);
    if (finds &&
        (lua_toboolean(state, 4) != 0 || pattern.find_first_of("^$*+?.([%-") == std::string_view::npos)) {
        const std::size_t found = findPlain(state, text, pattern, start);
        return found == std::string_view::npos ? pushNil(state)
                                               : pushRange(state, found, found + pattern.size());
    }
    const bool anchored = !pattern.empty() && pattern.front() == '^';
    if (anchored) pattern.remove_prefix(1);
    PatternMatcher matcher{text, pattern};
    do {
        const std::size_t end = matchAt(state, matcher, start);
        if (end == PatternMatcher::kNone) continue;
        if (!finds) return pushCaptures(state, matcher, text, start, end);
        pushRange(state, start, end);
        return 2 + (matcher.captureCount() == 0 ? 0 : pushCaptures(state, matcher, text, start, end));
    } while (++start <= text.size() && !anchored);
    return pushNil(state);
}

int find(lua_State* state) { return findOrMatch(state, true); }
int match(lua_State* state) { return findOrMatch(state, false); }

/// The iterator of gmatch(): upvalues are the text, the pattern, the next position and the end of the last
/// match.
int nextMatch(lua_State* state) {
    const std::string_view text = textAt(state, lua_upvalueindex(1));
    const std::string_view pattern = textAt(state, lua_upvalueindex(2));
    const auto last = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(4)));
    PatternMatcher matcher{text, pattern};
    for (auto start = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
         start <= text.size(); ++start) {
        const std::size_t end = matchAt(state, matcher, start);
        if (end == PatternMatcher::kNone || end == last) continue;
        lua_pushinteger(state, static_cast<lua_Integer>(end));
        lua_copy(state, -1, lua_upvalueindex(3));
        lua_replace(state, lua_upvalueindex(4));
        return pushCaptures(state, matcher, text, start, end);
    }
    return 0;
}

int allMatches(lua_State* state) {
    const std::string_view text = textAt(state, 1);
    static_cast<void>(textAt(state, 2));
    const std::size_t start = std::min(startAt(state, 3, text.size()), text.size() + 1);
    lua_settop(state, 2);
    lua_pushinteger(state, static_cast<lua_Integer>(start));
    lua_pushinteger(state, -1);
    lua_pushcclosure(state, nextMatch, 4);
    return 1;
}

/// Adds a replacement text, in which %0 to %9 are captures.
void addReplacement(lua_State* state, luaL_Buffer& out, const PatternMatcher& matcher, std::string_view text,
                    std::size_t begin, std::size_t end) {
    std::size_t length = 0;
    const char* replacement = lua_tolstring(state, 3, &length);
    for (std::size_t i = 0; i < length; ++i) {
        if (replacement[i] != '%') {
            luaL_addchar(&out, replacement[i]);
            continue;
        }
        const char next = ++i < length ? replacement[i] : '\0';
        if (next == '%') {
            luaL_addchar(&out, '%');
        } else if (next == '0' || (next == '1' && matcher.captureCount() == 0)) {
            luaL_addlstring(&out, text.data() + begin, end - begin);
        } else if (next > '0' && next - '1' < matcher.captureCount()) {
            pushCapture(state, matcher, text, next - '1');
            luaL_tolstring(state, -1, nullptr);
            lua_remove(state, -2);
            luaL_addvalue(&out);
        } else {
            luaL_error(state, "invalid use of '%%' in the replacement text");
        }
    }
}

/// Adds what replaces a match: a text, an entry of a table, or the result of a function.
void addValue(lua_State* state, luaL_Buffer& out, const PatternMatcher& matcher, std::string_view text,
              std::size_t begin, std::size_t end) {
    if (lua_isstring(state, 3) != 0) return addReplacement(state, out, matcher, text, begin, end);
    if (lua_isfunction(state, 3)) {
        lua_pushvalue(state, 3);
        lua_call(state, pushCaptures(state, matcher, text, begin, end), 1);
    } else {
        pushCaptures(state, matcher, text, begin, end);
        if (matcher.captureCount() > 1) lua_pop(state, matcher.captureCount() - 1);
        lua_gettable(state, 3);
    }
    if (lua_toboolean(state, -1) == 0) {
        lua_pop(state, 1);
        luaL_addlstring(&out, text.data() + begin, end - begin);
        return;
    }
    if (lua_isstring(state, -1) == 0)
        luaL_error(state, "invalid replacement value (a %s)", luaL_typename(state, -1));
    luaL_addvalue(&out);
}

int replaceAll(lua_State* state) {
    const std::string_view text = textAt(state, 1);
    std::string_view pattern = textAt(state, 2);
    luaL_argexpected(state, lua_isstring(state, 3) != 0 || lua_istable(state, 3) || lua_isfunction(state, 3),
                     3, "string/function/table");
    const lua_Integer most = luaL_optinteger(state, 4, static_cast<lua_Integer>(text.size()) + 1);
    const bool anchored = !pattern.empty() && pattern.front() == '^';
    if (anchored) pattern.remove_prefix(1);
    PatternMatcher matcher{text, pattern};
    luaL_Buffer out;
    luaL_buffinit(state, &out);
    std::size_t start = 0;
    std::size_t last = PatternMatcher::kNone;
    lua_Integer count = 0;
    while (count < most) {
        const std::size_t end = matchAt(state, matcher, start);
        if (end != PatternMatcher::kNone && end != last) {
            ++count;
            spend(state, 20);  // a function of the library may replace each match
            addValue(state, out, matcher, text, start, end);
            start = last = end;
        } else if (start < text.size()) {
            luaL_addchar(&out, text[start]);
            ++start;
        } else {
            break;
        }
        if (anchored) break;
    }
    if (start < text.size()) luaL_addlstring(&out, text.data() + start, text.size() - start);
    luaL_pushresult(&out);
    lua_pushinteger(state, count);
    return 2;
}

constexpr luaL_Reg kFunctions[] = {
    {"find", find}, {"match", match}, {"gmatch", allMatches}, {"gsub", replaceAll}, {nullptr, nullptr}};

}  // namespace

void addSearch(lua_State* state) {
    lua_getglobal(state, LUA_STRLIBNAME);
    luaL_setfuncs(state, kFunctions, 0);
    lua_pop(state, 1);
}

}  // namespace plumb::script
