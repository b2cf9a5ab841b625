#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace plumb {

/// A part of a font file, which stores big-endian numbers. Reads outside of it return 0 and slices
/// are clipped to it, so wrong offsets in a damaged file cannot cause invalid memory access.
class FontBytes {
public:
    FontBytes() = default;
    explicit FontBytes(std::string_view bytes) : bytes_{bytes} {}

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] bool empty() const { return bytes_.empty(); }

    [[nodiscard]] std::uint32_t u8(std::size_t at) const {
        return at < bytes_.size() ? static_cast<unsigned char>(bytes_[at]) : 0u;
    }
    [[nodiscard]] std::uint32_t u16(std::size_t at) const { return u8(at) << 8 | u8(at + 1); }
    [[nodiscard]] std::uint32_t u32(std::size_t at) const { return u16(at) << 16 | u16(at + 2); }
    [[nodiscard]] int i16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }

    [[nodiscard]] FontBytes slice(std::size_t from, std::size_t length = std::string_view::npos) const {
        return FontBytes{bytes_.substr(std::min(from, bytes_.size()), length)};
    }

private:
    std::string_view bytes_;
};

/// Reads the numbers of a FontBytes sequentially.
class FontCursor {
public:
    explicit FontCursor(FontBytes bytes) : bytes_{bytes} {}

    [[nodiscard]] bool ended() const { return at_ >= bytes_.size(); }
    /// True if a read or skip went beyond the end.
    [[nodiscard]] bool failed() const { return at_ > bytes_.size(); }

    std::uint32_t u8() { return bytes_.u8(at_++); }
    std::uint32_t u16() { return at_ += 2, bytes_.u16(at_ - 2); }
    std::uint32_t u32() { return at_ += 4, bytes_.u32(at_ - 4); }
    int i8() { return static_cast<std::int8_t>(u8()); }
    int i16() { return static_cast<std::int16_t>(u16()); }
    void skip(std::size_t count) { at_ += count; }

private:
    FontBytes bytes_;
    std::size_t at_ = 0;
};

}  // namespace plumb
