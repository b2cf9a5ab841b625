// Crashes in tick 100 as the environment variable PLUMB_CRASH says: tests/export/crashes.sh.

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "plumb.hpp"

namespace crash_game {

// NOLINTNEXTLINE(misc-no-recursion)
int overflow(volatile int* depth) {
    volatile char room[4096];
    *depth = *depth + 1;
    room[0] = 0;
    return *depth > std::numeric_limits<int>::max() - 1 ? 0 : overflow(depth) + room[0];
}

struct CrashingSystem {
    void update(plumb::World& world, float) const {
        const char* variable = std::getenv("PLUMB_CRASH");
        if (world.tick != 100 || variable == nullptr) return;
        const std::string_view kind = variable;
        volatile int zero = 0;
        if (kind == "null") *static_cast<volatile int* volatile>(nullptr) = 1;
        if (kind == "recursion") zero = overflow(&zero);
        if (kind == "division") zero = 100 / zero;
        if (kind == "abort") std::abort();
        if (kind == "exception") throw std::runtime_error{"no such level"};
        if (kind == "memory") {
            const std::size_t much = std::numeric_limits<std::ptrdiff_t>::max() / 2;
            volatile char* memory = new char[much];
            memory[0] = 1;
        }
        while (kind == "hang" && zero == 0) {
        }
    }
};

}  // namespace crash_game

PLUMB_MODULE(module) { module.system<crash_game::CrashingSystem>(); }
