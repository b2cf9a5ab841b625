#include <cstdio>

#include "tests/bench/callgrind.hpp"
#include "tests/bench/game_effects/game_effects_bench.hpp"

int main(int count, char** arguments) {
    using namespace plumb::bench;
    const auto [what, quick] = CountedWords{count, arguments};
    if (what == "counted") return runCountedTicks(quick);
    if (what == "unused") return measureUnused(arguments[0], quick);
    if (what == "projects") return measureProjects(quick);
    if (!what.empty()) {
        std::printf("./plumb bench game-effects [projects | unused] [--quick]\n");
        return 2;
    }
    const int failed = measureProjects(quick);
    const int unused = measureUnused(arguments[0], quick);
    return failed != 0 ? failed : unused;
}
