#include <cstdlib>

#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// Input that is accepted must be written to a text that reads back to the same text.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    std::vector<plumb::Error> warnings;
    const plumb::Result<plumb::Json> json =
        plumb::parseJson(plumb::test::textOf(bytes, count), "fuzz", &warnings);
    if (!json) return 0;
    const std::string text = plumb::writeJson(*json);
    const plumb::Result<plumb::Json> again = plumb::parseJson(text, "again");
    if (!again || plumb::writeJson(*again) != text) std::abort();
    return 0;
}
