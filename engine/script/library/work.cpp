#include "script/library/work.hpp"

#include <lua.hpp>

namespace plumb::script {

bool Work::spendBlock(std::size_t bytes) {
    constexpr std::int64_t kBlock = 14;  // taking it, and later finding it as garbage: 70 ns
    constexpr std::size_t kBytesPerUnit = 8;
    constexpr std::size_t kSmall = 1024;
    constexpr std::int64_t kReserve = 500'000;  // for small blocks of messages, when all work is done
    if (left_ >= 0) return spend(kBlock + static_cast<std::int64_t>(bytes / kBytesPerUnit));
    if (bytes > kSmall || left_ < -kReserve) return false;
    left_ -= kBlock;
    return true;
}

void Work::spendCollection(std::size_t usedBytes) {
    constexpr std::size_t kBytesPerUnit = 8;
    static_cast<void>(spend(static_cast<std::int64_t>(usedBytes / kBytesPerUnit)));
}

void failTooMuchWork(lua_State* state) {
    luaL_error(state, "the script does too much work in functions and with new tables and texts");
}

void spendText(lua_State* state, std::size_t bytes) {
    constexpr std::size_t kBytesPerUnit = 4;
    spend(state, static_cast<std::int64_t>(bytes / kBytesPerUnit) + 1);
}

}  // namespace plumb::script
