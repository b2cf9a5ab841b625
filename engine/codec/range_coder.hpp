#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumb {

// A binary range coder with adaptive probabilities: for short data whose symbols have very different
// frequencies, where general compression would need longer to learn them. Integers alone: the same bytes on
// every machine. A writer and a reader code the same sequence of calls with models in the same state.
// Source: G. Martin, "Range encoding", 1979; the handling of carries is that of LZMA by I. Pavlov.

/// The probability of one bit, learned from the bits before it.
class BitModel {
public:
    static constexpr int kBits = 15;

    [[nodiscard]] std::uint32_t zero() const { return zero_; }  ///< probability of 0, in 1 / 2^kBits
    void learn(bool one) {
        constexpr int kOne = 1 << kBits;
        constexpr int kLeast = 32;     // so that the range of no bit becomes empty
        constexpr int kMostSeen = 40;  // from here on, old bits are forgotten
        // The estimator of Krichevsky and Trofimov: n + 1/2 bits of a kind among n + 1.
        const int step = 2 * ((one ? 0 : kOne) - int{zero_}) / (2 * int{seen_} + 3);
        zero_ = static_cast<std::uint16_t>(std::clamp(zero_ + step, kLeast, kOne - kLeast));
        if (seen_ < kMostSeen) ++seen_;
    }

private:
    std::uint16_t zero_ = 1 << (kBits - 1);
    std::uint16_t seen_ = 0;
};

/// Writes bits.
class RangeEncoder {
public:
    static constexpr int kUnwritten = 4;  ///< zeros that finish() may leave out

    /// Writes `one`, and returns it, so that one function can describe writing and reading.
    bool bit(BitModel& model, bool one) {
        const std::uint32_t bound = (range_ >> BitModel::kBits) * model.zero();
        if (one) {
            low_ += bound;
            range_ -= bound;
        } else {
            range_ = bound;
        }
        model.learn(one);
        shift();
        return one;
    }

    /// Writes the lowest `count` bits, of equal probability, from the highest.
    std::uint64_t bits(std::uint64_t value, int count) {
        for (int i = count - 1; i >= 0; --i) {
            range_ >>= 1;
            if ((value >> i & 1) != 0) low_ += range_;
            shift();
        }
        return value;
    }

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }  ///< bytes that are final, roughly

    /// Ends the data. Do not write after it.
    std::string finish() {
        // Of all numbers in the range, the one that ends in most zeros: these bytes need not be written.
        for (std::uint64_t mask = 0xffffffffu; mask != 0; mask >>= 1) {
            const std::uint64_t end = (low_ + mask) & ~mask;
            if (end >= low_ + range_) continue;
            low_ = end;
            break;
        }
        for (int i = 0; i < 5; ++i) shiftByte();
        for (int i = 0; i < kUnwritten && !bytes_.empty() && bytes_.back() == '\0'; ++i) bytes_.pop_back();
        return std::move(bytes_);
    }

private:
    void shift() {
        while (range_ < kLeastRange) {
            range_ <<= 8;
            shiftByte();
        }
    }

    /// Moves the highest byte of low_ out. Bytes 0xff wait: a carry may still change them.
    void shiftByte() {
        if (low_ < 0xff000000u || low_ > 0xffffffffu) {
            const auto carry = static_cast<unsigned>(low_ >> 32);
            if (started_) bytes_ += static_cast<char>(waiting_ + carry);
            for (; waitingOnes_ > 0; --waitingOnes_) bytes_ += static_cast<char>(0xff + carry);
            waiting_ = static_cast<std::uint8_t>(low_ >> 24);
            started_ = true;
        } else {
            ++waitingOnes_;
        }
        low_ = (low_ & 0x00ffffffu) << 8;
    }

    static constexpr std::uint32_t kLeastRange = std::uint32_t{1} << 24;

    std::string bytes_;
    std::uint64_t low_ = 0;
    std::uint32_t range_ = 0xffffffffu;
    std::uint8_t waiting_ = 0;
    std::uint64_t waitingOnes_ = 0;
    bool started_ = false;
};

/// Reads what a RangeEncoder has written. Any bytes may be read: damaged ones give other values.
class RangeDecoder {
public:
    /// @param bytes  must outlive this
    explicit RangeDecoder(std::string_view bytes) : bytes_{bytes} {
        for (int i = 0; i < 4; ++i) code_ = code_ << 8 | nextByte();
    }

    /// Reads a bit. The second argument is that of RangeEncoder, without a meaning here.
    bool bit(BitModel& model, bool = false) {
        const std::uint32_t bound = (range_ >> BitModel::kBits) * model.zero();
        const bool one = code_ >= bound;
        if (one) {
            code_ -= bound;
            range_ -= bound;
        } else {
            range_ = bound;
        }
        model.learn(one);
        shift();
        return one;
    }

    std::uint64_t bits(std::uint64_t, int count) {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) {
            range_ >>= 1;
            const bool one = code_ >= range_;
            if (one) code_ -= range_;
            value = value << 1 | (one ? 1u : 0u);
            shift();
        }
        return value;
    }

    /// True if all was read, as it is after the last value.
    [[nodiscard]] bool isAtEnd() const { return at_ >= bytes_.size() && !isBeyondEnd(); }
    /// True if more was read than there is.
    [[nodiscard]] bool isBeyondEnd() const { return at_ > bytes_.size() + RangeEncoder::kUnwritten; }

private:
    std::uint32_t nextByte() {
        const std::size_t at = at_++;
        return at < bytes_.size() ? static_cast<unsigned char>(bytes_[at]) : 0u;  // finish() leaves zeros out
    }
    void shift() {
        while (range_ < std::uint32_t{1} << 24) {
            range_ <<= 8;
            code_ = code_ << 8 | nextByte();
        }
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    std::uint32_t range_ = 0xffffffffu;
    std::uint32_t code_ = 0;
};

/// Numbers of `Bits` bits, each with a probability of its own.
template <int Bits>
struct BitTree {
    std::array<BitModel, std::size_t{1} << Bits> models{};

    template <class Coder>
    unsigned code(Coder& coder, unsigned value) {
        unsigned node = 1;
        for (int i = Bits - 1; i >= 0; --i)
            node = node << 1 | (coder.bit(models[node], (value >> i & 1) != 0) ? 1u : 0u);
        return node - (1u << Bits);
    }
};

/// Numbers below 2^63, small ones being the most frequent: the number of bits and the two bits after the
/// first have probabilities, the other bits are equally probable.
struct NumberModel {
    static constexpr int kLearned = 2;

    BitTree<6> size;
    std::array<BitTree<kLearned>, 64> top;

    template <class Coder>
    std::uint64_t code(Coder& coder, std::uint64_t value) {
        int width = 0;
        while (value >> width != 0 && width < 63) ++width;
        width = static_cast<int>(size.code(coder, static_cast<unsigned>(width)));
        if (width <= 1) return static_cast<std::uint64_t>(width);
        const std::uint64_t first = std::uint64_t{1} << (width - 1);
        const int rest = width - 1 - kLearned;
        if (rest < 0) return first | coder.bits(value & (first - 1), width - 1);
        const auto high = static_cast<unsigned>(value >> rest & ((1u << kLearned) - 1));
        const std::uint64_t learned = top[static_cast<std::size_t>(width)].code(coder, high);
        return first | learned << rest | coder.bits(value & ((std::uint64_t{1} << rest) - 1), rest);
    }
};

}  // namespace plumb
