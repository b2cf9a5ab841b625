#include "core/inflate.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr int kMaxCodeBits = 15;

/// The bits of a deflate stream, lowest first. Beyond the end they are 0, and `overrun` is set.
class BitReader {
public:
    explicit BitReader(std::string_view bytes) : bytes_{bytes} {}

    std::uint32_t take(int count) {
        while (held_ < count) {
            if (at_ < bytes_.size()) {
                bits_ |= std::uint64_t{static_cast<unsigned char>(bytes_[at_])} << held_;
            } else {
                overrun_ = true;
            }
            ++at_;
            held_ += 8;
        }
        const auto value = static_cast<std::uint32_t>(bits_ & ((std::uint64_t{1} << count) - 1));
        bits_ >>= count;
        held_ -= count;
        return value;
    }
    void alignToByte() {
        bits_ >>= held_ % 8;
        held_ -= held_ % 8;
    }
    [[nodiscard]] bool overrun() const { return overrun_; }
    /// Whole bytes taken so far. @pre at a byte border
    [[nodiscard]] std::size_t position() const { return at_ - static_cast<std::size_t>(held_ / 8); }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    std::uint64_t bits_ = 0;
    int held_ = 0;
    bool overrun_ = false;
};

/// A canonical prefix code: how many codes each length has, and the symbols in the order of their codes.
struct PrefixCode {
    std::array<std::uint16_t, kMaxCodeBits + 1> counts{};
    std::array<std::uint16_t, 288> symbols{};

    /// @return false if the lengths define more codes than exist
    bool build(std::span<const std::uint8_t> lengths) {
        counts.fill(0);
        for (const std::uint8_t length : lengths) ++counts[length];
        counts[0] = 0;
        int left = 1;
        std::array<std::uint16_t, kMaxCodeBits + 2> offsets{};
        for (std::size_t length = 1; length <= kMaxCodeBits; ++length) {
            left = left * 2 - counts[length];
            if (left < 0) return false;
            offsets[length + 1] = static_cast<std::uint16_t>(offsets[length] + counts[length]);
        }
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
            if (lengths[symbol] != 0)
                symbols[offsets[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
        }
        return true;
    }

    /// @return the next symbol, or -1 for an undefined code
    int read(BitReader& bits) const {
        int code = 0;
        int first = 0;
        int index = 0;
        for (std::size_t length = 1; length <= kMaxCodeBits; ++length) {
            code |= static_cast<int>(bits.take(1));
            const int count = counts[length];
            if (code - count < first) return symbols[static_cast<std::size_t>(index + code - first)];
            index += count;
            first = (first + count) << 1;
            code <<= 1;
        }
        return -1;
    }
};

constexpr std::array<std::uint16_t, 29> kLengthBase{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                    15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                    67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<std::uint8_t, 29> kLengthBits{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                   2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<std::uint16_t, 30> kDistanceBase{
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
constexpr std::array<std::uint8_t, 30> kDistanceBits{0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                                     6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
constexpr std::array<std::uint8_t, 19> kLengthOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                    11, 4,  12, 3, 13, 2, 14, 1, 15};

/// Unpacks one deflate stream. Source: RFC 1951, section 3.2.
class Inflater {
public:
    Inflater(std::string_view packed, std::size_t limit) : bits_{packed}, limit_{limit} {}

    /// @return the error, or nothing
    std::optional<std::string> run() {
        for (bool last = false; !last;) {
            last = bits_.take(1) == 1;
            const std::uint32_t kind = bits_.take(2);
            const bool good = kind == 0   ? copyStored()
                              : kind == 1 ? fixedBlock()
                                          : kind == 2 && dynamicBlock();
            if (bits_.overrun()) return "the packed data ends in the middle";
            if (tooLarge_) return format("more than {} bytes come out of it", limit_);
            if (!good) return "the packed data is damaged";
        }
        bits_.alignToByte();
        return {};
    }

    std::string out;
    [[nodiscard]] std::size_t consumed() const { return bits_.position(); }

private:
    bool hasRoom(std::size_t count) {
        tooLarge_ = tooLarge_ || count > limit_ - out.size();
        return !tooLarge_;
    }

    bool copyStored() {
        bits_.alignToByte();
        const std::uint32_t length = bits_.take(16);
        const std::uint32_t inverse = bits_.take(16);
        if (length != (~inverse & 0xffffu) || !hasRoom(length)) return false;
        for (std::uint32_t i = 0; i < length && !bits_.overrun(); ++i)
            out += static_cast<char>(bits_.take(8));
        return true;
    }

    bool fixedBlock() {
        std::array<std::uint8_t, 288> lengths{};
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            lengths[i] = static_cast<std::uint8_t>(i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8);
        }
        std::array<std::uint8_t, 30> distances{};
        distances.fill(5);
        return literals_.build(lengths) && distances_.build(distances) && readBlock();
    }

    bool dynamicBlock() {
        const std::size_t literals = bits_.take(5) + 257;
        const std::size_t distances = bits_.take(5) + 1;
        const std::size_t codes = bits_.take(4) + 4;
        if (literals > 286 || distances > 30) return false;
        std::array<std::uint8_t, 19> codeLengths{};
        for (std::size_t i = 0; i < codes; ++i)
            codeLengths[kLengthOrder[i]] = static_cast<std::uint8_t>(bits_.take(3));
        if (!literals_.build(codeLengths)) return false;

        std::array<std::uint8_t, 286 + 30> lengths{};
        for (std::size_t at = 0; at < literals + distances;) {
            const int symbol = literals_.read(bits_);
            if (symbol < 0 || bits_.overrun()) return false;
            if (symbol < 16) {
                lengths[at++] = static_cast<std::uint8_t>(symbol);
                continue;
            }
            if (symbol == 16 && at == 0) return false;
            const std::uint8_t value = symbol == 16 ? lengths[at - 1] : std::uint8_t{0};
            std::size_t repeat = symbol == 16   ? 3 + bits_.take(2)
                                 : symbol == 17 ? 3 + bits_.take(3)
                                                : 11 + bits_.take(7);
            if (at + repeat > literals + distances) return false;
            for (; repeat > 0; --repeat) lengths[at++] = value;
        }
        const std::span all{lengths};
        return lengths[256] != 0 && literals_.build(all.first(literals)) &&
               distances_.build(all.subspan(literals, distances)) && readBlock();
    }

    bool readBlock() {
        while (!bits_.overrun()) {
            const int symbol = literals_.read(bits_);
            if (symbol == 256) return true;
            if (symbol < 0 || symbol > 285) return false;
            if (symbol < 256) {
                if (!hasRoom(1)) return false;
                out += static_cast<char>(symbol);
            } else if (!copyMatch(static_cast<std::size_t>(symbol - 257))) {
                return false;
            }
        }
        return false;
    }

    bool copyMatch(std::size_t lengthCode) {
        const std::size_t length = kLengthBase[lengthCode] + bits_.take(kLengthBits[lengthCode]);
        const int distanceCode = distances_.read(bits_);
        if (distanceCode < 0 || distanceCode > 29) return false;
        const auto code = static_cast<std::size_t>(distanceCode);
        const std::size_t distance = kDistanceBase[code] + bits_.take(kDistanceBits[code]);
        if (distance > out.size() || !hasRoom(length)) return false;
        for (std::size_t i = 0; i < length; ++i) out += out[out.size() - distance];  // may overlap itself
        return true;
    }

    BitReader bits_;
    std::size_t limit_;
    bool tooLarge_ = false;
    PrefixCode literals_;
    PrefixCode distances_;
};

std::uint32_t adler32(std::string_view bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (std::size_t at = 0; at < bytes.size();) {
        // 5552 is the maximum number of bytes before a remainder that cannot overflow.
        for (const std::size_t end = std::min(at + 5552, bytes.size()); at < end; ++at) {
            a += static_cast<unsigned char>(bytes[at]);
            b += a;
        }
        a %= 65521;
        b %= 65521;
    }
    return b << 16 | a;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) value = value >> 1 ^ (value & 1 ? 0xedb88320u : 0u);
        table[i] = value;
    }
    return table;
}();

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = ~0u;
    for (const char c : bytes) crc = crc >> 8 ^ kCrcTable[(crc ^ static_cast<unsigned char>(c)) & 255];
    return ~crc;
}

std::uint32_t byteAt(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

std::uint32_t littleWord(std::string_view bytes) {
    return byteAt(bytes, 0) | byteAt(bytes, 1) << 8 | byteAt(bytes, 2) << 16 | byteAt(bytes, 3) << 24;
}

Error broken(std::string_view where, std::string what) {
    return Error{std::string{where}, std::move(what), "the file is damaged or too large; export it again"};
}

/// Length of a gzip header. Source: RFC 1952, section 2.3.
std::optional<std::size_t> gzipHeader(std::string_view packed) {
    if (packed.size() < 18 || packed.substr(0, 3) != "\x1f\x8b\x08") return {};
    const std::uint32_t flags = byteAt(packed, 3);
    std::size_t at = 10;
    if (flags & 4) {
        if (at + 2 > packed.size()) return {};
        at += 2 + (byteAt(packed, at) | byteAt(packed, at + 1) << 8);
    }
    for (const std::uint32_t text : {8u, 16u}) {
        if (!(flags & text)) continue;
        const std::size_t end = packed.find('\0', std::min(at, packed.size()));
        if (end == std::string_view::npos) return {};
        at = end + 1;
    }
    if (flags & 2) at += 2;
    return at <= packed.size() ? std::optional{at} : std::nullopt;
}

}  // namespace

Result<std::string> unpackZlib(std::string_view packed, std::size_t limit, std::string_view where) {
    if (packed.size() < 6 || (byteAt(packed, 0) & 15) != 8 ||
        (byteAt(packed, 0) << 8 | byteAt(packed, 1)) % 31 != 0) {
        return broken(where, "this is not zlib data");
    }
    if (byteAt(packed, 1) & 32) return broken(where, "zlib data with a preset dictionary is not read");
    Inflater inflater{packed.substr(2), limit};
    if (std::optional<std::string> wrong = inflater.run()) return broken(where, *wrong);
    const std::string_view sum = packed.substr(std::min(2 + inflater.consumed(), packed.size()));
    if (sum.size() < 4) return broken(where, "the packed data ends in the middle");
    const std::uint32_t expected =
        byteAt(sum, 0) << 24 | byteAt(sum, 1) << 16 | byteAt(sum, 2) << 8 | byteAt(sum, 3);
    if (adler32(inflater.out) != expected) return broken(where, "the sum of the packed data is wrong");
    return std::move(inflater.out);
}

Result<std::string> unpackGzip(std::string_view packed, std::size_t limit, std::string_view where) {
    const std::optional<std::size_t> header = gzipHeader(packed);
    if (!header) return broken(where, "this is not gzip data");
    Inflater inflater{packed.substr(*header), limit};
    if (std::optional<std::string> wrong = inflater.run()) return broken(where, *wrong);
    const std::string_view sums = packed.substr(std::min(*header + inflater.consumed(), packed.size()));
    if (sums.size() < 8) return broken(where, "the packed data ends in the middle");
    const auto length = static_cast<std::uint32_t>(inflater.out.size() & 0xffffffffu);
    if (crc32(inflater.out) != littleWord(sums) || length != littleWord(sums.substr(4))) {
        return broken(where, "the sum of the packed data is wrong");
    }
    return std::move(inflater.out);
}

}  // namespace plumb
