#include <cstdio>
#include <string_view>

#include "tests/bench/game_effects/game_effects_bench.hpp"

int main(int count, char** arguments) {
    using namespace plumb::bench;
    std::string_view what;
    bool quick = false;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--quick") {
            quick = true;
        } else {
            what = argument;
        }
    }
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
