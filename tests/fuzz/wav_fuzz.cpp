#include "platform/audio_device.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    static_cast<void>(plumb::readWavHeader(plumb::test::textOf(bytes, count), "fuzz"));
    return 0;
}
