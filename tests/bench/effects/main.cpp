#include <cstdio>

#include "tests/bench/callgrind.hpp"
#include "tests/bench/effects/effects_bench.hpp"

int main(int count, char** arguments) {
    using namespace plumb::bench;
    const auto [what, quick] = CountedWords{count, arguments};
    if (what == "counted") return runCounted(quick);
    if (what == "counted-mixed") return runMixed(quick);
    if (what == "cost") return measureCost(arguments[0], quick);
    if (what == "mixed") return measureMixed(arguments[0], quick);
    if (what == "contacts") return measureContacts(quick);
    if (what == "state") return measureState(quick);
    if (!what.empty()) {
        std::printf("./plumb bench effects [contacts | state | cost | mixed] [--quick]\n");
        return 2;
    }
    const int failed = measureContacts(quick) | measureState(quick);
    const int cost = measureCost(arguments[0], quick), mixed = measureMixed(arguments[0], quick);
    return failed != 0 ? failed : std::max(cost, mixed);
}
