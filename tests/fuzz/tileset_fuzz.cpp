#include <cstdlib>

#include "assets/tileset.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// Input that is accepted must be written to a text that reads back to the same text.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    std::vector<plumb::Error> problems;
    const plumb::Result<plumb::Tileset> tileset =
        plumb::parseTileset(plumb::test::textOf(bytes, count), "fuzz", problems);
    if (!tileset) return 0;
    const std::string text = plumb::writeTileset(*tileset);
    const plumb::Result<plumb::Tileset> again = plumb::parseTileset(text, "again", problems);
    if (!again || plumb::writeTileset(*again) != text) std::abort();
    return 0;
}
