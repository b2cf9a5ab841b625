#include <cstdint>
#include <string>

#include "core/text.hpp"
#include "platform/audio_device.hpp"

namespace plumb {
namespace {

std::uint32_t littleEndian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = count; i > 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
    return value;
}

}  // namespace

Result<WavHeader> readWavHeader(std::string_view bytes, std::string_view where) {
    const auto refuse = [&](std::string what) {
        return Error{std::string{where}, std::move(what), "save it as WAV, 16 bits, 44,100 Hz"};
    };
    if (bytes.empty()) return refuse("the file is empty");
    if (bytes.size() < 12 || !startsWith(bytes, "RIFF") || bytes.substr(8, 4) != "WAVE")
        return refuse("the file is not a WAV file");
    WavHeader header;
    std::uint32_t bytesPerSecond = 0;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::string_view name = bytes.substr(at, 4);
        const std::size_t size = littleEndian(bytes, at + 4, 4);
        at += 8;
        if (name == "fmt " && size >= 16 && at + 16 <= bytes.size()) {
            header.channels = static_cast<int>(littleEndian(bytes, at + 2, 2));
            header.rate = static_cast<int>(littleEndian(bytes, at + 4, 4) & 0x7fffffff);
            bytesPerSecond = littleEndian(bytes, at + 8, 4);
        } else if (name == "data") {
            if (header.channels < 1 || header.channels > 8 || header.rate < 4000 || header.rate > 192000 ||
                bytesPerSecond < 1000) {
                return refuse("the WAV header has invalid values");
            }
            if (size > bytes.size() - at) return refuse("the WAV file is truncated");
            header.seconds = static_cast<float>(size) / static_cast<float>(bytesPerSecond);
            return header;
        }
        if (size > bytes.size() - at) break;
        at += size + size % 2;
    }
    return refuse("the WAV file contains no sound data");
}

}  // namespace plumb
