#include "core/zstd.hpp"

#include <bit>
#include <cstring>
#include <optional>

#include "core/text.hpp"
#include "core/zstd_entropy.hpp"

namespace plumb {
namespace {

using zstd::BackwardBits;
using zstd::Bytes;
using zstd::FseTable;
using zstd::HuffmanTable;

constexpr std::uint32_t kFrameMagic = 0xFD2FB528u;
constexpr std::uint32_t kSkippableMagic = 0x184D2A50u;  ///< the lowest four bits are free
constexpr std::size_t kBlockBytes = std::size_t{128} << 10;

/// A kind of code in sequences: its limits, and the default table.
struct CodeKind {
    int maxLog;
    int maxSymbol;
    int defaultLog;
    std::span<const std::int16_t> defaultCounts;
};

// Source: RFC 8878, section 3.1.1.3.2.2, "Default Distributions".
constexpr std::int16_t kLiteralCounts[] = {4, 3, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 1, 1,  1,  2,  2,
                                           2, 2, 2, 2, 2, 2, 2, 3, 2, 1, 1, 1, 1, 1, -1, -1, -1, -1};
constexpr std::int16_t kOffsetCounts[] = {1, 1, 1, 1, 1, 1, 2, 2, 2, 1,  1,  1,  1,  1, 1,
                                          1, 1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1};
constexpr std::int16_t kMatchCounts[] = {1, 4, 3, 2, 2, 2, 2, 2, 2, 1, 1,  1,  1,  1,  1,  1,  1, 1,
                                         1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,  1,  1,  1,  1,  1,  1, 1,
                                         1, 1, 1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1};
constexpr CodeKind kLiteralKind{9, 35, 6, kLiteralCounts};
constexpr CodeKind kOffsetKind{8, 31, 5, kOffsetCounts};
constexpr CodeKind kMatchKind{9, 52, 6, kMatchCounts};

// Source: RFC 8878, section 3.1.1.3.2.1.1: base value and number of extra bits of each length code.
constexpr std::uint32_t kLiteralBase[] = {0,  1,  2,   3,   4,   5,    6,    7,    8,    9,     10,    11,
                                          12, 13, 14,  15,  16,  18,   20,   22,   24,   28,    32,    40,
                                          48, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768, 65536};
constexpr std::uint8_t kLiteralBits[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0,  0,  0,  0,  1,  1,
                                         1, 1, 2, 2, 3, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
constexpr std::uint32_t kMatchBase[] = {
    3,  4,  5,  6,  7,  8,  9,  10,  11,  12,  13,   14,   15,   16,   17,    18,    19,   20,
    21, 22, 23, 24, 25, 26, 27, 28,  29,  30,  31,   32,   33,   34,   35,    37,    39,   41,
    43, 47, 51, 59, 67, 83, 99, 131, 259, 515, 1027, 2051, 4099, 8195, 16387, 32771, 65539};
constexpr std::uint8_t kMatchBits[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0,  0,  0,  0,  0,  0, 0,
                                       0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0,  0,  0,  1,  1,  1, 1,
                                       2, 2, 3, 3, 4, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

std::uint64_t littleNumber(Bytes bytes, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
    return value;
}

/// 64-bit checksum of a frame. Source: Y. Collet, "xxHash fast digest algorithm", version 0.1.1, section 4.
std::uint64_t xxHash64(std::string_view text) {
    constexpr std::uint64_t kPrimes[] = {0x9E3779B185EBCA87ull, 0xC2B2AE3D27D4EB4Full, 0x165667B19E3779F9ull,
                                         0x85EBCA77C2B2AE63ull, 0x27D4EB2F165667C5ull};
    const Bytes bytes{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
    const auto round = [&](std::uint64_t lane, std::uint64_t word) {
        return std::rotl(lane + word * kPrimes[1], 31) * kPrimes[0];
    };
    std::size_t at = 0;
    std::uint64_t hash = kPrimes[4];
    if (bytes.size() >= 32) {
        std::uint64_t lanes[4] = {kPrimes[0] + kPrimes[1], kPrimes[1], 0, 0 - kPrimes[0]};
        for (; at + 32 <= bytes.size(); at += 32) {
            for (std::size_t i = 0; i < 4; ++i)
                lanes[i] = round(lanes[i], littleNumber(bytes.subspan(at + 8 * i), 8));
        }
        hash = std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) +
               std::rotl(lanes[3], 18);
        for (const std::uint64_t lane : lanes) hash = (hash ^ round(0, lane)) * kPrimes[0] + kPrimes[3];
    }
    hash += bytes.size();
    for (; at + 8 <= bytes.size(); at += 8) {
        hash = std::rotl(hash ^ round(0, littleNumber(bytes.subspan(at), 8)), 27) * kPrimes[0] + kPrimes[3];
    }
    if (at + 4 <= bytes.size()) {
        hash =
            std::rotl(hash ^ littleNumber(bytes.subspan(at), 4) * kPrimes[0], 23) * kPrimes[1] + kPrimes[2];
        at += 4;
    }
    for (; at < bytes.size(); ++at) hash = std::rotl(hash ^ bytes[at] * kPrimes[4], 11) * kPrimes[0];
    hash = (hash ^ hash >> 33) * kPrimes[1];
    hash = (hash ^ hash >> 29) * kPrimes[2];
    return hash ^ hash >> 32;
}

/// Decompresses one frame after the other. Source: RFC 8878, section 3.
class ZstdReader {
public:
    ZstdReader(Bytes packed, std::size_t limit) : rest_{packed}, limit_{limit} {}

    /// @return the error, or nothing
    std::optional<std::string> run() {
        while (!rest_.empty()) {
            if (!readFrame()) {
                if (!reason_.empty()) return reason_;
                return "the packed data is cut off or damaged";
            }
        }
        return {};
    }

    std::string out;

private:
    bool fail(std::string reason) {
        reason_ = std::move(reason);
        return false;
    }
    bool hasRoom(std::size_t count) {
        return count <= limit_ - out.size() || fail(format("more than {} bytes come out of it", limit_));
    }
    bool take(std::size_t count, Bytes& taken) {
        if (count > rest_.size()) return false;
        taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return true;
    }
    bool takeNumber(std::size_t count, std::uint64_t& value) {
        Bytes bytes;
        if (!take(count, bytes)) return false;
        value = littleNumber(bytes, count);
        return true;
    }

    bool readFrame() {
        std::uint64_t magic = 0;
        if (!takeNumber(4, magic)) return false;
        if ((magic & 0xfffffff0u) == kSkippableMagic) {
            std::uint64_t size = 0;
            Bytes skipped;
            return takeNumber(4, size) && take(size, skipped);
        }
        if (magic != kFrameMagic) return fail("this is not Zstandard data");
        std::uint64_t descriptor = 0;
        if (!takeNumber(1, descriptor) || !readFrameHeader(descriptor)) return false;

        frameStart_ = out.size();
        huffman_.log = 0;
        tables_ = {};
        offsets_[0] = 1, offsets_[1] = 4, offsets_[2] = 8;
        for (bool last = false; !last;) {
            if (!readBlock(last)) return false;
        }
        std::uint64_t sum = 0;
        if (!(descriptor & 4)) return true;
        if (!takeNumber(4, sum)) return false;
        return (xxHash64(std::string_view{out}.substr(frameStart_)) & 0xffffffffu) == sum ||
               fail("the sum of the packed data is wrong");
    }

    bool readFrameHeader(std::uint64_t descriptor) {
        const bool single = descriptor & 32;
        const std::size_t dictionaryBytes = (std::size_t{1} << (descriptor & 3)) >> 1;
        const std::size_t sizeFlag = descriptor >> 6;
        const std::size_t sizeBytes = sizeFlag == 0 ? (single ? 1 : 0) : std::size_t{1} << sizeFlag;
        std::uint64_t window = 0;
        std::uint64_t dictionary = 0;
        std::uint64_t size = 0;
        if ((descriptor & 8) || (!single && !takeNumber(1, window)) ||
            !takeNumber(dictionaryBytes, dictionary) || !takeNumber(sizeBytes, size)) {
            return false;
        }
        if (dictionary != 0) return fail("Zstandard data with a dictionary is not read");
        if (sizeFlag == 1) size += 256;
        return size <= limit_ - out.size() || fail(format("more than {} bytes come out of it", limit_));
    }

    bool readBlock(bool& last) {
        std::uint64_t header = 0;
        if (!takeNumber(3, header)) return false;
        last = header & 1;
        const std::size_t size = header >> 3;
        const auto kind = header >> 1 & 3;
        Bytes bytes;
        if (size > kBlockBytes || kind == 3 || !take(kind == 1 ? 1 : size, bytes)) return false;
        if (kind == 2) return readPackedBlock(bytes);
        if (!hasRoom(size)) return false;
        if (kind == 0) out.append(reinterpret_cast<const char*>(bytes.data()), size);
        if (kind == 1) out.append(size, static_cast<char>(bytes[0]));
        return true;
    }

    bool readPackedBlock(Bytes block) {
        if (!readLiterals(block) || block.empty()) return false;
        std::size_t count = block[0];
        std::size_t used = 1;
        if (count >= 128) {
            used = count == 255 ? 3 : 2;
            if (block.size() < used) return false;
            count = count == 255 ? block[1] + (std::size_t{block[2]} << 8) + 0x7f00
                                 : ((count - 128) << 8) + block[1];
        }
        block = block.subspan(used);
        if (count > 0) return readSequences(block, count);
        return block.empty() && hasRoom(literals_.size()) && (out += literals_, true);
    }

    /// Source: RFC 8878, section 3.1.1.3.1.
    bool readLiterals(Bytes& block) {
        if (block.empty()) return false;
        const int kind = block[0] & 3;
        const int form = block[0] >> 2 & 3;
        const bool packed = kind >= 2;
        const std::size_t headerBytes = packed ? (form < 2 ? 3u : static_cast<std::size_t>(form + 2))
                                               : (form == 1   ? 2u
                                                  : form == 3 ? 3u
                                                              : 1u);
        if (block.size() < headerBytes) return false;
        const std::uint64_t header = littleNumber(block, headerBytes);
        block = block.subspan(headerBytes);
        if (!packed) return readPlainLiterals(block, kind == 1, header >> (form == 1 || form == 3 ? 4 : 3));

        const int sizeBits = form < 2 ? 10 : form == 2 ? 14 : 18;
        const std::uint64_t mask = (std::uint64_t{1} << sizeBits) - 1;
        const std::size_t size = header >> 4 & mask;
        const std::size_t packedSize = header >> (4 + sizeBits) & mask;
        if (size > kBlockBytes || packedSize > block.size()) return false;
        Bytes streams = block.first(packedSize);
        block = block.subspan(packedSize);
        if (kind == 2 && !huffman_.read(streams)) return false;
        literals_.resize(size);
        return form == 0 ? huffman_.decode(streams, literals_) : decodeFourStreams(streams);
    }

    bool readPlainLiterals(Bytes& block, bool repeated, std::size_t size) {
        const std::size_t used = repeated ? 1 : size;
        if (size > kBlockBytes || used > block.size()) return false;
        literals_.assign(size, static_cast<char>(repeated ? block[0] : 0));
        if (!repeated && size > 0) std::memcpy(literals_.data(), block.data(), size);
        block = block.subspan(used);
        return true;
    }

    bool decodeFourStreams(Bytes streams) {
        if (streams.size() < 6) return false;
        const std::size_t quarter = (literals_.size() + 3) / 4;
        if (quarter * 3 > literals_.size()) return false;
        std::span<char> wanted{literals_};
        std::size_t sizes[4] = {};
        std::size_t sum = 6;
        for (std::size_t i = 0; i < 3; ++i) sum += sizes[i] = littleNumber(streams.subspan(2 * i), 2);
        if (sum > streams.size()) return false;
        sizes[3] = streams.size() - sum;
        streams = streams.subspan(6);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t count = i < 3 ? quarter : wanted.size();
            if (!huffman_.decode(streams.first(sizes[i]), wanted.first(count))) return false;
            wanted = wanted.subspan(count);
            streams = streams.subspan(sizes[i]);
        }
        return true;
    }

    bool readTable(Bytes& block, int mode, const CodeKind& kind, std::optional<FseTable>& table) {
        if (mode == 3) return table.has_value();
        table.emplace();
        if (mode == 0) return table->build(kind.defaultCounts, kind.defaultLog);
        if (mode == 2) return table->read(block, kind.maxLog, kind.maxSymbol);
        if (block.empty() || block[0] > kind.maxSymbol) return false;
        table->buildConstant(block[0]);
        block = block.subspan(1);
        return true;
    }

    /// Source: RFC 8878, section 3.1.1.3.2.1.2.
    bool readSequences(Bytes block, std::size_t count) {
        if (block.empty()) return false;
        const int modes = block[0];
        block = block.subspan(1);
        BackwardBits bits;
        if ((modes & 3) || !readTable(block, modes >> 6, kLiteralKind, tables_.literals) ||
            !readTable(block, modes >> 4 & 3, kOffsetKind, tables_.offsets) ||
            !readTable(block, modes >> 2 & 3, kMatchKind, tables_.matches) || !bits.open(block)) {
            return false;
        }
        std::uint64_t literalState = bits.take(tables_.literals->log);
        std::uint64_t offsetState = bits.take(tables_.offsets->log);
        std::uint64_t matchState = bits.take(tables_.matches->log);
        std::string_view literals = literals_;
        for (std::size_t i = 0; i < count; ++i) {
            const FseTable::State literal = tables_.literals->at(literalState);
            const FseTable::State offset = tables_.offsets->at(offsetState);
            const FseTable::State match = tables_.matches->at(matchState);
            if (literal.symbol > 35 || match.symbol > 52 || offset.symbol > 31 || bits.left() < 0)
                return false;
            const std::size_t offsetValue = (std::size_t{1} << offset.symbol) + bits.take(offset.symbol);
            const std::size_t matchLength = kMatchBase[match.symbol] + bits.take(kMatchBits[match.symbol]);
            const std::size_t literalLength =
                kLiteralBase[literal.symbol] + bits.take(kLiteralBits[literal.symbol]);
            if (!runSequence(literals, literalLength, matchLength, offsetValue)) return false;
            if (i + 1 == count) break;
            literalState = literal.base + bits.take(literal.bits);
            matchState = match.base + bits.take(match.bits);
            offsetState = offset.base + bits.take(offset.bits);
        }
        return bits.left() == 0 && hasRoom(literals.size()) && (out += literals, true);
    }

    bool runSequence(std::string_view& literals, std::size_t literalLength, std::size_t matchLength,
                     std::size_t value) {
        if (literalLength > literals.size() || !hasRoom(literalLength)) return false;
        out += literals.substr(0, literalLength);
        literals.remove_prefix(literalLength);
        const std::size_t distance = nextOffset(value, literalLength);
        if (distance == 0 || distance > out.size() - frameStart_ || !hasRoom(matchLength)) return false;
        const std::size_t start = out.size();
        out.resize(start + matchLength);
        for (std::size_t i = start; i < out.size(); ++i) out[i] = out[i - distance];  // may overlap itself
        return true;
    }

    /// The last three offsets can be repeated. Source: RFC 8878, section 3.1.1.5.
    std::size_t nextOffset(std::size_t value, std::size_t literalLength) {
        std::size_t distance = value - 3;
        std::size_t index = 2;
        if (value <= 3) {
            index = value - 1 + (literalLength == 0 ? 1 : 0);
            distance = index < 3 ? offsets_[index] : offsets_[0] - 1;
        }
        if (index > 1) offsets_[2] = offsets_[1];
        if (index > 0) offsets_[1] = offsets_[0];
        return offsets_[0] = distance;
    }

    struct Tables {
        std::optional<FseTable> literals;
        std::optional<FseTable> offsets;
        std::optional<FseTable> matches;
    };

    Bytes rest_;
    std::size_t limit_;
    std::string reason_;
    std::size_t frameStart_ = 0;
    std::string literals_;
    HuffmanTable huffman_;
    Tables tables_;
    std::size_t offsets_[3] = {1, 4, 8};
};

}  // namespace

Result<std::string> unpackZstd(std::string_view packed, std::size_t limit, std::string_view where) {
    const Bytes bytes{reinterpret_cast<const std::uint8_t*>(packed.data()), packed.size()};
    ZstdReader reader{bytes, limit};
    std::optional<std::string> wrong = packed.empty() ? "there is no packed data" : reader.run();
    if (wrong) return Error{std::string{where}, *wrong, "the file is damaged or too large; export it again"};
    return std::move(reader.out);
}

}  // namespace plumb
