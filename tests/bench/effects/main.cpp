#include <cstdio>
#include <string_view>

#include "tests/bench/effects/effects_bench.hpp"

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
    if (what == "counted") return runCounted(quick);
    if (what == "cost") return measureCost(arguments[0], quick);
    if (what == "contacts") return measureContacts(quick);
    if (what == "state") return measureState(quick);
    if (!what.empty()) {
        std::printf("./plumb bench effects [contacts | state | cost] [--quick]\n");
        return 2;
    }
    const int failed = measureContacts(quick) | measureState(quick);
    const int cost = measureCost(arguments[0], quick);
    return failed != 0 ? failed : cost;
}
