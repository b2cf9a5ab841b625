#include <cstdlib>
#include <string>

#include "input/link_format.hpp"
#include "input/replay_link.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// The bytes are the stream of a link, so that the fuzzer need not find its checksum.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    const std::string stream{plumb::test::textOf(bytes, count)};
    // The empty stream gets past the checks before it: else nothing is tested.
    static const auto empty = plumb::replayOfLink(plumb::link_format::linkOfStream({}));
    if (empty || empty.error().what != "the link is incomplete") std::abort();
    const plumb::Result<plumb::Replay> replay = plumb::replayOfLink(plumb::link_format::linkOfStream(stream));
    if (!replay || replay->ticks() > 100'000) return 0;
    const plumb::Result<std::string> again = plumb::linkOf(*replay);
    if (again && !plumb::replayOfLink(*again)) std::abort();
    return 0;
}
