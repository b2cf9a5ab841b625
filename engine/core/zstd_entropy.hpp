#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace plumb::zstd {

using Bytes = std::span<const std::uint8_t>;

/// A bit stream that was written forwards and is read backwards: the last bit written comes first.
/// Before its beginning all bits are 0, and `left` becomes negative. Source: RFC 8878, section 4.1.
class BackwardBits {
public:
    /// The highest set bit of the last byte marks the end. @return false if there is none
    bool open(Bytes bytes);

    std::uint64_t take(int count) {
        left_ -= count;
        return bitsAt(left_, count);
    }
    [[nodiscard]] std::uint64_t peek(int count) const { return bitsAt(left_ - count, count); }
    void skip(int count) { left_ -= count; }
    [[nodiscard]] std::int64_t left() const { return left_; }

private:
    [[nodiscard]] std::uint64_t bitsAt(std::int64_t position, int count) const;

    Bytes bytes_;
    std::int64_t left_ = 0;
};

/// A finite state entropy table: each state stands for a symbol and determines the next state.
struct FseTable {
    struct State {
        std::uint8_t symbol = 0;
        std::uint8_t bits = 0;
        std::uint16_t base = 0;
    };

    int log = 0;
    std::array<State, 512> states{};

    /// From counts per symbol; -1 means "less than one". @return false if they do not fill the table
    bool build(std::span<const std::int16_t> counts, int accuracyLog);
    /// A single state that always gives the same symbol.
    void buildConstant(std::uint8_t symbol);
    /// Reads the counts at the front of `bytes` and removes them. Source: RFC 8878, section 4.1.1.
    bool read(Bytes& bytes, int maxLog, int maxSymbol);

    [[nodiscard]] const State& at(std::uint64_t state) const { return states[state & 511]; }
};

/// A prefix code for literals, as a table indexed by the next `log` bits. Source: RFC 8878, section 4.2.
struct HuffmanTable {
    struct Entry {
        std::uint8_t symbol = 0;
        std::uint8_t bits = 0;
    };

    int log = 0;  ///< 0 while there is none
    std::array<Entry, 2048> entries{};

    /// Reads a description at the front of `bytes` and removes it.
    bool read(Bytes& bytes);
    /// Decodes exactly `out.size()` symbols; the stream must end with them.
    bool decode(Bytes stream, std::span<char> out) const;

private:
    bool buildFromWeights(std::span<const std::uint8_t> weights);
};

}  // namespace plumb::zstd
