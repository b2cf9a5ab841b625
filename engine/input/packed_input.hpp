#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "input/recorder.hpp"

namespace plumb {

/// The input of a game since its first tick, in a few bytes for each change, for the report of a crash. Its
/// memory is reserved once and becomes used as it is filled. content() can be called at any time, also in a
/// signal handler that interrupts record().
///
/// A run of equal frames is its changes, one for each 16-bit word of InputFrame that differs from the frame
/// before, and its number of ticks:
///
///     change  1 byte: 0x40 | 0x80 if the word is smaller | index of the word;
///             then by how much, 7 bits in a byte, the lowest first, 0x80 in all but the last
///     ticks   1 byte: 0x80 if there are more than 63 | lowest 6 bits of the number; then the rest as above
class PackedInput {
public:
    static constexpr std::size_t kBytes =
        4'900'000;  ///< 3 hours of two sticks or 4 of a mouse that never rest
    /// Most bytes of a run.
    static constexpr std::size_t kLongestRun = sizeof(InputFrame) / 2 * 4 + 5;

    /// @param bytes  memory, at most kBytes
    explicit PackedInput(std::size_t bytes = kBytes) : size_{bytes}, bytes_{new unsigned char[bytes]} {}

    /// Records the input of the next tick. Does nothing if it is full().
    void record(const InputFrame& frame);

    /// What is recorded: `closed`, then `open`.
    struct Content {
        std::string_view closed;  ///< valid as long as this object
        std::array<char, 5> open{};
        std::size_t openSize = 0;
        std::uint64_t ticks = 0;
    };
    [[nodiscard]] Content content() const;
    /// A tick was not recorded: the memory is full, or a replay has no more ticks or changes.
    [[nodiscard]] bool full() const { return full_; }

private:
    /// All runs but the number of ticks of the last one.
    struct Closed {
        std::uint32_t size = 0;   // bytes
        std::uint64_t ticks = 0;  // of the runs before the last one
    };

    std::size_t size_;
    std::unique_ptr<unsigned char[]> bytes_;
    InputFrame frame_;
    std::size_t runs_ = 0;
    // Of two, one is valid, and the other one is prepared.
    std::array<Closed, 2> closed_{};
    // Index of the valid one << 32 | ticks of the last run: one word, so that both change at once.
    std::atomic<std::uint64_t> state_{0};
    std::atomic<bool> full_{false};
};

/// Adds the runs to a replay. @param ticks  those of the replay
/// @return an error message; empty: none
std::string unpackInput(std::string_view packed, Replay& replay, std::uint64_t& ticks);

}  // namespace plumb
