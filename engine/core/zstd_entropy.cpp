#include "core/zstd_entropy.hpp"

#include <algorithm>
#include <bit>

namespace plumb::zstd {
namespace {

constexpr int kMaxHuffmanBits = 11;
constexpr int kMaxWeightsLog = 6;

/// Reads bits, lowest first, for the descriptions of tables. Beyond the end they are 0.
class ForwardBits {
public:
    explicit ForwardBits(Bytes bytes) : bytes_{bytes} {}

    std::uint32_t peek(int count) const {
        std::uint32_t value = 0;
        for (int i = 0; i < count; ++i) {
            const std::size_t position = at_ + static_cast<std::size_t>(i);
            if (position / 8 < bytes_.size()) value |= (bytes_[position / 8] >> (position % 8) & 1u) << i;
        }
        return value;
    }
    std::uint32_t take(int count) {
        const std::uint32_t value = peek(count);
        skip(count);
        return value;
    }
    void skip(int count) { at_ += static_cast<std::size_t>(count); }
    [[nodiscard]] std::size_t bytesUsed() const { return (at_ + 7) / 8; }

private:
    Bytes bytes_;
    std::size_t at_ = 0;
};

int highestBit(std::uint32_t value) { return static_cast<int>(std::bit_width(value)) - 1; }

/// The weights of a Huffman table, compressed with two interleaved states. Source: RFC 8878, section 4.2.1.2.
bool readPackedWeights(Bytes bytes, std::array<std::uint8_t, 256>& weights, std::size_t& count) {
    FseTable table;
    BackwardBits bits;
    if (!table.read(bytes, kMaxWeightsLog, 255) || !bits.open(bytes)) return false;
    std::uint64_t states[2] = {bits.take(table.log), bits.take(table.log)};
    if (bits.left() < 0) return false;
    for (std::size_t turn = 0;; turn ^= 1) {
        const FseTable::State& state = table.at(states[turn]);
        if (count + 2 > 255) return false;
        weights[count++] = state.symbol;
        if (bits.left() < state.bits) {
            // No bits are left for this state: the other one gives the last weight.
            weights[count++] = table.at(states[turn ^ 1]).symbol;
            return true;
        }
        states[turn] = state.base + bits.take(state.bits);
    }
}

}  // namespace

bool BackwardBits::open(Bytes bytes) {
    if (bytes.empty() || bytes.back() == 0) return false;
    bytes_ = bytes;
    left_ = static_cast<std::int64_t>(bytes.size()) * 8 - 8 + highestBit(bytes.back());
    return true;
}

std::uint64_t BackwardBits::bitsAt(std::int64_t position, int count) const {
    if (count == 0 || position + count <= 0) return 0;
    const int missing = position < 0 ? static_cast<int>(-position) : 0;  // zeros before the beginning
    const std::size_t start = static_cast<std::size_t>(position + missing);
    std::uint64_t value = 0;
    const std::size_t last = (start + static_cast<std::size_t>(count - missing) - 1) / 8;
    for (std::size_t byte = start / 8; byte <= last && byte < bytes_.size(); ++byte) {
        const std::size_t shift = (byte - start / 8) * 8;
        if (shift < 64) value |= std::uint64_t{bytes_[byte]} << shift;
    }
    value >>= start % 8;
    value &= (std::uint64_t{1} << (count - missing)) - 1;
    return value << missing;
}

bool FseTable::build(std::span<const std::int16_t> counts, int accuracyLog) {
    log = accuracyLog;
    const std::uint32_t size = 1u << log;
    std::array<std::uint16_t, 256> next{};
    std::uint32_t high = size;
    for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
        if (counts[symbol] != -1) continue;
        if (high == 0) return false;
        states[--high].symbol = static_cast<std::uint8_t>(symbol);
        next[symbol] = 1;
    }
    const std::uint32_t step = (size >> 1) + (size >> 3) + 3;
    std::uint32_t position = 0;
    std::uint32_t placed = size - high;
    for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
        if (counts[symbol] <= 0) continue;
        next[symbol] = static_cast<std::uint16_t>(counts[symbol]);
        for (int i = 0; i < counts[symbol]; ++i) {
            if (++placed > size) return false;
            states[position].symbol = static_cast<std::uint8_t>(symbol);
            do position = (position + step) & (size - 1);
            while (position >= high && placed < size);
        }
    }
    if (placed != size) return false;
    for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint16_t value = next[states[i].symbol]++;
        const int bits = log - highestBit(value);
        states[i].bits = static_cast<std::uint8_t>(bits);
        states[i].base = static_cast<std::uint16_t>((std::uint32_t{value} << bits) - size);
    }
    return true;
}

void FseTable::buildConstant(std::uint8_t symbol) {
    log = 0;
    states[0] = {symbol, 0, 0};
}

bool FseTable::read(Bytes& bytes, int maxLog, int maxSymbol) {
    ForwardBits bits{bytes};
    const int accuracyLog = static_cast<int>(bits.take(4)) + 5;
    if (accuracyLog > maxLog) return false;
    std::array<std::int16_t, 256> counts{};
    int remaining = 1 << accuracyLog;
    int symbols = 0;
    while (remaining > 0 && symbols <= maxSymbol) {
        // Values below the threshold take one bit less.
        const int width = highestBit(static_cast<std::uint32_t>(remaining + 1)) + 1;
        const std::uint32_t threshold = (1u << width) - 1 - static_cast<std::uint32_t>(remaining + 1);
        const std::uint32_t half = (1u << (width - 1)) - 1;
        std::uint32_t value = bits.peek(width);
        if ((value & half) < threshold) {
            value &= half;
            bits.skip(width - 1);
        } else {
            if (value > half) value -= threshold;
            bits.skip(width);
        }
        const int count = static_cast<int>(value) - 1;
        remaining -= count < 0 ? 1 : count;
        counts[static_cast<std::size_t>(symbols++)] = static_cast<std::int16_t>(count);
        if (count != 0) continue;
        for (std::uint32_t repeat = 3; repeat == 3;) {
            repeat = bits.take(2);
            symbols += static_cast<int>(repeat);
            if (symbols > maxSymbol + 1) return false;
        }
    }
    if (remaining != 0 || bits.bytesUsed() > bytes.size()) return false;
    bytes = bytes.subspan(bits.bytesUsed());
    return build(std::span{counts}.first(static_cast<std::size_t>(symbols)), accuracyLog);
}

bool HuffmanTable::read(Bytes& bytes) {
    if (bytes.empty()) return false;
    std::array<std::uint8_t, 256> weights{};
    std::size_t count = 0;
    const std::size_t header = bytes[0];
    const std::size_t size = header < 128 ? header : (header - 127 + 1) / 2;
    if (1 + size > bytes.size()) return false;
    const Bytes description = bytes.subspan(1, size);
    if (header < 128) {
        if (!readPackedWeights(description, weights, count)) return false;
    } else {
        count = header - 127;
        for (std::size_t i = 0; i < count; ++i) {
            weights[i] =
                static_cast<std::uint8_t>(i % 2 == 0 ? description[i / 2] >> 4 : description[i / 2] & 15);
        }
    }
    bytes = bytes.subspan(1 + size);
    return buildFromWeights(std::span{weights}.first(count));
}

bool HuffmanTable::buildFromWeights(std::span<const std::uint8_t> weights) {
    std::uint32_t sum = 0;
    for (const std::uint8_t weight : weights) {
        if (weight > kMaxHuffmanBits) return false;
        sum += weight > 0 ? 1u << (weight - 1) : 0;
    }
    if (sum == 0) return false;
    log = highestBit(sum) + 1;
    // The weight of the last symbol is not written: it fills the table up to a power of two.
    const std::uint32_t rest = (1u << log) - sum;
    if (log > kMaxHuffmanBits || !std::has_single_bit(rest)) return log = 0, false;
    std::array<std::uint8_t, 257> all{};
    std::copy(weights.begin(), weights.end(), all.begin());
    all[weights.size()] = static_cast<std::uint8_t>(highestBit(rest) + 1);

    std::size_t at = 0;
    for (int weight = 1; weight <= log; ++weight) {
        for (std::size_t symbol = 0; symbol <= weights.size(); ++symbol) {
            if (all[symbol] != weight) continue;
            const Entry entry{static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(log + 1 - weight)};
            const std::size_t length = std::size_t{1} << (weight - 1);
            std::fill_n(entries.begin() + static_cast<std::ptrdiff_t>(at), length, entry);
            at += length;
        }
    }
    return true;
}

bool HuffmanTable::decode(Bytes stream, std::span<char> out) const {
    BackwardBits bits;
    if (log == 0 || !bits.open(stream)) return false;
    for (char& symbol : out) {
        const Entry& entry = entries[bits.peek(log)];
        symbol = static_cast<char>(entry.symbol);
        bits.skip(entry.bits);
        if (bits.left() < 0) return false;
    }
    return bits.left() == 0;
}

}  // namespace plumb::zstd
