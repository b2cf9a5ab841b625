#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/bench/bench.hpp"

namespace {

struct Program {
    std::string_view name;
    int (*run)(const plumb::bench::Options& options);
};

/// All benchmarks.
constexpr std::array kPrograms {
    Program{"broadphase", &plumb::bench::runBroadphase}, Program{"ecs", &plumb::bench::runEcs},
        Program{"integrators", &plumb::bench::runIntegrators},
        Program{"particles", &plumb::bench::runParticles}, Program{"physics", &plumb::bench::runPhysics},
        Program{"quality", &plumb::bench::runQuality}, Program{"render", &plumb::bench::runRender},
        Program{"scene", &plumb::bench::runScene}, Program{"scripts", &plumb::bench::runScripts},
#if PLUMB_WITH_EDITOR
        Program{"editor", &plumb::bench::runEditor}, Program{"rewind", &plumb::bench::runRewind},
        Program{"tiles", &plumb::bench::runTiles},
#endif
};

int usage() {
    std::printf(
        "plumb-bench NAME [LINE] [--json FILE] [--quick] [--seconds S]\n"
        "plumb-bench physics has other options; an invalid one prints them\n"
        "  LINE         only rows whose name contains LINE\n"
        "  --quick      small sizes and few rounds, only to check that the benchmark runs\n"
        "  --seconds S  measuring time for each alternative of a row, default 0.4; if the machine has\n"
        "               other work, longer times give better minimums\nnames:");
    for (const Program& program : kPrograms)
        std::printf(" %.*s", static_cast<int>(program.name.size()), program.name.data());
    std::printf("\n");
    return 2;
}

}  // namespace

int main(int count, char** arguments) {
    plumb::bench::Options options;
    std::string_view name;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--json" && i + 1 < count) {
            options.jsonPath = arguments[++i];
        } else if (argument == "--quick") {
            options.quick = true;
        } else if (argument == "--seconds" && i + 1 < count) {
            options.seconds = std::clamp(std::atof(arguments[++i]), 0.01, 600.0);
        } else if (name.empty() && argument.substr(0, 1) != "-") {
            name = argument;
        } else {
            options.rest.emplace_back(argument);
        }
    }
    for (const Program& program : kPrograms) {
        if (program.name == name) return program.run(options);
    }
    return usage();
}
