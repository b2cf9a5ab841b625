#include <cstdlib>
#include <string>

#include "codec/base64.hpp"
#include "core/hash.hpp"
#include "input/replay_link.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// The bytes are the stream of a link, so that the fuzzer need not find its checksum.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    const std::string stream{plumb::test::textOf(bytes, count)};
    const auto sum = static_cast<std::uint32_t>(plumb::mixBits(plumb::hashText(stream) + 1));
    std::string link{'\1'};
    for (int shift = 0; shift < 32; shift += 8) link += static_cast<char>(sum >> shift & 255);
    const plumb::Result<plumb::Replay> replay = plumb::replayOfLink(plumb::toBase64Url(link + stream));
    if (!replay || replay->ticks() > 100'000) return 0;
    const plumb::Result<std::string> again = plumb::linkOf(*replay);
    if (again && !plumb::replayOfLink(*again)) std::abort();
    return 0;
}
