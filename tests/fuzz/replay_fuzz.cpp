#include <cstdlib>

#include "input/recorder.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// Input that is accepted must be written to a text that reads back to an equal replay.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    const plumb::Result<plumb::Replay> replay = plumb::parseReplay(plumb::test::textOf(bytes, count), "fuzz");
    if (!replay) return 0;
    const plumb::Result<plumb::Replay> again = plumb::parseReplay(plumb::writeReplay(*replay), "again");
    if (!again || again->runs != replay->runs) std::abort();
    return 0;
}
