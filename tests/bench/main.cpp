#include <array>
#include <cstdio>
#include <string_view>

#include "tests/bench/bench.hpp"

namespace {

struct Program {
    std::string_view name;
    int (*run)(const plumb::bench::Options& options);
};

/// Every benchmark: one file, one line.
constexpr std::array kPrograms{
    Program{"ecs", &plumb::bench::runEcs},
    Program{"render", &plumb::bench::runRender},
    Program{"scene", &plumb::bench::runScene},
};

int usage() {
    std::printf("plumb-bench NAME [--json FILE] [--quick]\nnames:");
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
