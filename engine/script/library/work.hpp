#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

struct lua_State;

namespace plumb::script {

/// Work that the budget of prepared scripts does not see, because one call of the library may do much: it is
/// counted here, so that a script that repeats such calls is stopped too, after the same work on every
/// machine. There is no limit outside of a ScriptHostScope. State of the thread.
class Work {
public:
    /// Units of some 5 ns: a value moved, or 8 bytes of a text copied. These take about 100 ms.
    static constexpr std::int64_t kMax = 20'000'000;

    static void begin() { left_ = kMax; }
    static void end() { left_ = kUnlimited; }
    /// @return false if there was more work than allowed, also before
    static bool spend(std::int64_t units) {
        if (left_ < 0) return false;
        if (left_ != kUnlimited) left_ = std::max(left_ - std::min(units, kMax), std::int64_t{-1});
        return left_ >= 0;
    }

    /// True if there was more work than allowed.
    static bool isSpent() { return left_ < 0; }

    /// Counts what the allocator does. @return false if the block should be refused
    static bool spendBlock(std::size_t bytes);
    /// Counts the search for garbage that follows when there is no room.
    static void spendCollection(std::size_t usedBytes);

private:
    static constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();
    static inline constinit thread_local std::int64_t left_ = kUnlimited;
};

/// Raises the error of a script that does too much work.
void failTooMuchWork(lua_State* state);
/// Counts work; raises an error if there is too much.
inline void spend(lua_State* state, std::int64_t units) {
    if (!Work::spend(units)) failTooMuchWork(state);
}
/// Counts the reading of a text.
void spendText(lua_State* state, std::size_t bytes);

}  // namespace plumb::script
