#include "script/library/work.hpp"

#include <algorithm>
#include <limits>

#include <lua.hpp>

namespace plumb::script {
namespace {

constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();
thread_local std::int64_t workLeft = kUnlimited;

}  // namespace

void Work::begin() { workLeft = kMax; }
void Work::end() { workLeft = kUnlimited; }

bool Work::spend(std::int64_t units) {
    if (workLeft == kUnlimited) return true;
    workLeft -= std::min(units, kMax);
    workLeft = std::max(workLeft, std::int64_t{-1});
    return workLeft >= 0;
}

bool Work::spendBlock(std::size_t bytes) {
    constexpr std::size_t kSmall = 1024;  // smaller ones cost no more than a round of a loop
    constexpr std::size_t kBytesPerUnit = 8;
    return bytes <= kSmall || spend(static_cast<std::int64_t>(bytes / kBytesPerUnit));
}

void Work::spendCollection(std::size_t usedBytes) {
    constexpr std::size_t kBytesPerUnit = 8;
    static_cast<void>(spend(static_cast<std::int64_t>(usedBytes / kBytesPerUnit)));
}

void spend(lua_State* state, std::int64_t units) {
    if (!Work::spend(units)) luaL_error(state, "the script does too much work in functions of the library");
}

void spendText(lua_State* state, std::size_t bytes) {
    constexpr std::size_t kBytesPerUnit = 4;
    spend(state, static_cast<std::int64_t>(bytes / kBytesPerUnit) + 1);
}

}  // namespace plumb::script
