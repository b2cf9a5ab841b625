#include "platform/image_file.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    const std::string_view file = plumb::test::textOf(bytes, count);
    // Large images only take time; faults in the decoder also appear in small ones.
    const plumb::Result<plumb::ImageSize> size = plumb::readImageSize(file, "fuzz");
    if (size && size->width <= 512 && size->height <= 512)
        static_cast<void>(plumb::decodeImage(file, "fuzz"));
    return 0;
}
