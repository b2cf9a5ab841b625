#include "editor/model/headless/asset_content.hpp"

#include <string>

#include "core/text.hpp"
#include "platform/audio_device.hpp"
#include "platform/image_file.hpp"
#include "render/font.hpp"

namespace plumb::editor {
namespace {

template <class T>
Result<Done> doneOr(const Result<T>& read) {
    return read ? Result<Done>{Done{}} : Result<Done>{read.error()};
}

std::uint8_t byteAt(std::string_view bytes, std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); }

/// True if the file starts like an MP3: with an ID3 tag or a frame header (11 set bits, valid layer and bit
/// rate).
bool looksLikeMp3(std::string_view bytes) {
    if (bytes.size() < 128) return false;
    if (startsWith(bytes, "ID3")) return true;
    const bool sync = byteAt(bytes, 0) == 0xff && (byteAt(bytes, 1) & 0xe0) == 0xe0;
    const int layer = byteAt(bytes, 1) >> 1 & 3;
    const int rate = byteAt(bytes, 2) >> 4;
    return sync && layer != 0 && rate != 15;
}

/// Checks the header of a WAV file; compressed music (OGG, FLAC, MP3) is recognized only by its first bytes.
Result<Done> checkSound(std::string_view bytes, std::string_view where) {
    if (startsWith(bytes, "RIFF")) return doneOr(readWavHeader(bytes, where));
    const bool isOgg = startsWith(bytes, "OggS") && bytes.size() > 64;
    const bool isFlac = startsWith(bytes, "fLaC") && bytes.size() > 42;
    if (isOgg || isFlac || looksLikeMp3(bytes)) return Done{};
    return Error{std::string{where}, "the file is not a supported sound",
                 "save it as WAV, or music as OGG, FLAC or MP3"};
}

}  // namespace

Result<Done> checkContent(AssetKind kind, std::string_view bytes, std::string_view where) {
    if (kind == AssetKind::Texture) return doneOr(decodeImage(bytes, where));
    if (kind == AssetKind::Sound) return checkSound(bytes, where);
    if (kind == AssetKind::Font) return doneOr(Font::fromBytes(std::string{bytes}, std::string{where}));
    return Done{};
}

}  // namespace plumb::editor
