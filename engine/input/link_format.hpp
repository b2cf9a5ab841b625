#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "codec/base64.hpp"
#include "codec/range_coder.hpp"
#include "core/hash.hpp"
#include "input/input_frame.hpp"

// The bytes of a link: its version (u8), a checksum of the version and of what follows (u32, little-endian),
// and a range coded stream:
//
//     project, engine, scene    each: number of bytes, bytes
//     keys                      the bindings that the player has changed, as JSON: likewise
//     seed                      64 bits
//     for each run of equal input: its changes, in ascending order, the end of the list, ticks - 1
//     an empty list of changes: the end of the replay
//     the hash: one bit that says whether there is one, 64 bits
//
// A change of what is held is its index; of what has a value, the difference to the value before.

namespace plumb::link_format {

inline constexpr unsigned kVersion = 2;
inline constexpr std::size_t kHeadBytes = 5;
inline constexpr std::string_view kMark = "#r=";
inline constexpr std::uint64_t kMaxNameBytes = 1024;
inline constexpr std::uint64_t kMaxKeysBytes = 16384;

/// Returns the bytes before a stream.
inline std::string headOf(std::string_view stream) {
    const auto checksum = static_cast<std::uint32_t>(mixBits(hashText(stream) + kVersion));
    std::string head{static_cast<char>(kVersion)};
    for (int shift = 0; shift < 32; shift += 8) head += static_cast<char>(checksum >> shift & 255);
    return head;
}

inline std::string linkOfStream(std::string_view stream) {
    std::string bytes = headOf(stream);
    bytes += stream;
    return std::string{kMark} + toBase64Url(bytes);
}

// ---- changes of the input

enum class Part : std::uint8_t { End, Key, MouseButton, Mouse, Wheel, Pad, PadButton, PadAxis, Save };
inline constexpr std::size_t kParts = 9;

struct Change {
    Part part = Part::End;
    unsigned index = 0;  ///< of the key or button; of the axis; of the slot
    int x = 0;           ///< difference of Mouse, Wheel and PadAxis
    int y = 0;
};

inline constexpr unsigned kPadButtonBits = 16;  // index of a button: gamepad * 16 + button
inline constexpr unsigned kPadAxisBits = 8;

/// The number of indices of a part.
inline constexpr std::array<unsigned, kParts> kIndices{
    1,         kKeyCount, kMouseButtonCount,         1,
    1,         kPadCount, kPadCount* kPadButtonBits, kPadCount* kPadAxisBits,
    kSaveSlots};

template <class Word, class Add>
void eachBit(Word bits, const Add& add) {
    for (unsigned i = 0; bits != 0; ++i, bits = static_cast<Word>(bits >> 1)) {
        if ((bits & 1) != 0) add(i);
    }
}

/// Calls `add` for each difference of two frames, in ascending order of part and index.
template <class Add>
void eachChange(const InputFrame& before, const InputFrame& now, const Add& add) {
    for (unsigned word = 0; word < now.keys.size(); ++word)
        eachBit(before.keys[word] ^ now.keys[word], [&](unsigned bit) { add({Part::Key, word * 32 + bit}); });
    eachBit(static_cast<unsigned>(before.mouseButtons ^ now.mouseButtons), [&](unsigned bit) {
        add({Part::MouseButton, bit});
    });
    const Change mouse{Part::Mouse, 0, now.mouseX - before.mouseX, now.mouseY - before.mouseY};
    if (mouse.x != 0 || mouse.y != 0) add(mouse);
    const Change wheel{Part::Wheel, 0, now.wheelX - before.wheelX, now.wheelY - before.wheelY};
    if (wheel.x != 0 || wheel.y != 0) add(wheel);
    eachBit(static_cast<unsigned>(before.connectedPads ^ now.connectedPads), [&](unsigned bit) {
        add({Part::Pad, bit});
    });
    for (unsigned pad = 0; pad < now.pads.size(); ++pad)
        eachBit(static_cast<unsigned>(before.pads[pad].buttons ^ now.pads[pad].buttons), [&](unsigned bit) {
            add({Part::PadButton, pad * kPadButtonBits + bit});
        });
    for (unsigned pad = 0; pad < now.pads.size(); ++pad) {
        for (unsigned axis = 0; axis < kPadAxisCount; ++axis) {
            const int moved = now.pads[pad].axes[axis] - before.pads[pad].axes[axis];
            if (moved != 0) add({Part::PadAxis, pad * kPadAxisBits + axis, moved});
        }
    }
    eachBit(before.saves ^ now.saves, [&](unsigned bit) { add({Part::Save, bit}); });
}

inline bool move(std::int16_t& value, int by) {
    const int moved = value + by;
    if (moved < -32768 || moved > 32767) return false;
    value = static_cast<std::int16_t>(moved);
    return true;
}

template <class Word>
bool flip(Word& word, unsigned bit) {
    word = static_cast<Word>(word ^ (Word{1} << bit));
    return true;
}

/// @param change  anything that can be decoded
/// @return false if the frame cannot have this change
inline bool apply(const Change& change, InputFrame& frame) {
    const auto part = static_cast<std::size_t>(change.part);
    if (part >= kParts || change.index >= kIndices[part]) return false;
    switch (change.part) {
        case Part::Key: return flip(frame.keys[change.index / 32], change.index % 32);
        case Part::MouseButton: return flip(frame.mouseButtons, change.index);
        case Part::Mouse: return move(frame.mouseX, change.x) && move(frame.mouseY, change.y);
        case Part::Wheel: return move(frame.wheelX, change.x) && move(frame.wheelY, change.y);
        case Part::Pad: return flip(frame.connectedPads, change.index);
        case Part::PadButton:
            return flip(frame.pads[change.index / kPadButtonBits].buttons, change.index % kPadButtonBits);
        case Part::PadAxis: {
            const unsigned axis = change.index % kPadAxisBits;
            return axis < kPadAxisCount && move(frame.pads[change.index / kPadAxisBits].axes[axis], change.x);
        }
        case Part::Save: return flip(frame.saves, change.index);
        case Part::End: return false;
    }
    return false;
}

// ---- the stream: each function describes writing and reading

/// Differences: a motion is often like the one before it.
struct MotionModel {
    static constexpr std::size_t kSizes = 9;

    std::array<NumberModel, kSizes> size{};  // by the size of the motion before
    std::array<BitModel, 3> negative{};      // by its sign
    std::size_t sizeBefore = 0;
    std::size_t signBefore = 0;

    template <class Coder>
    int code(Coder& coder, int value) {
        const auto large = static_cast<std::uint64_t>(value < 0 ? -std::int64_t{value} : value);
        const std::uint64_t found = size[sizeBefore].code(coder, large);
        // A difference of two values of 16 bits; a larger one is refused by apply().
        const int magnitude = static_cast<int>(std::min<std::uint64_t>(found, 70000));
        const bool isNegative = found != 0 && coder.bit(negative[signBefore], value < 0);
        signBefore = found == 0 ? 0 : isNegative ? 1 : 2;
        sizeBefore = 0;
        while (sizeBefore + 1 < kSizes && found >> sizeBefore != 0) ++sizeBefore;
        return isNegative ? -magnitude : magnitude;
    }
};

/// What was learned about the input of a game.
struct LinkModel {
    NumberModel nameBytes;
    BitTree<8> letters;
    std::array<BitTree<4>, 2 * kParts>
        part{};                       // by the change before in the list; by the last of the list before
    std::array<BitTree<7>, 2> key{};  // by whether the key that changed last is held
    BitTree<3> mouseButton;
    BitTree<2> pad;
    BitTree<6> padButton;
    BitTree<5> padAxis;
    BitTree<5> save;
    std::array<MotionModel, 2> mouse{};
    std::array<MotionModel, 2> wheel{};
    std::array<MotionModel, kPadAxisBits> axes{};
    std::array<NumberModel, kParts> ticks{};  // by the last change
    Part lastPart = Part::End;                // of the list before
    unsigned lastKey = 0;

    template <class Coder>
    void code(Coder& coder, std::string& name, std::uint64_t maxBytes = kMaxNameBytes) {
        const std::uint64_t count = nameBytes.code(coder, name.size());
        // A longer one is damaged; the reader sees that by the size.
        name.resize(static_cast<std::size_t>(std::min(count, maxBytes + 1)));
        for (char& letter : name)
            letter = static_cast<char>(letters.code(coder, static_cast<unsigned char>(letter)));
    }

    /// @param before  part of the change before it in the list; End: it is the first
    /// @param frame   before the change
    template <class Coder>
    Change code(Coder& coder, Change change, Part before, const InputFrame& frame) {
        const std::size_t list = before == Part::End ? kParts + static_cast<std::size_t>(lastPart)
                                                     : static_cast<std::size_t>(before);
        change.part = static_cast<Part>(part[list].code(coder, static_cast<unsigned>(change.part)));
        switch (change.part) {
            case Part::End: break;
            case Part::Key: {
                const bool isHeld = (frame.keys[lastKey / 32] >> lastKey % 32 & 1) != 0;
                change.index = lastKey = key[isHeld ? 1 : 0].code(coder, change.index);
                break;
            }
            case Part::MouseButton: change.index = mouseButton.code(coder, change.index); break;
            case Part::Mouse: codePair(coder, mouse, change); break;
            case Part::Wheel: codePair(coder, wheel, change); break;
            case Part::Pad: change.index = pad.code(coder, change.index); break;
            case Part::PadButton: change.index = padButton.code(coder, change.index); break;
            case Part::PadAxis:
                change.index = padAxis.code(coder, change.index);
                change.x = axes[change.index % kPadAxisBits].code(coder, change.x);
                break;
            case Part::Save: change.index = save.code(coder, change.index); break;
        }
        return change;
    }

    /// Writes the end of a list. @param last  part of its last change
    template <class Coder>
    void endList(Coder& coder, Part last, const InputFrame& frame) {
        code(coder, Change{}, last, frame);
        lastPart = last;
    }

    /// Codes for how many ticks the input stays as it is after a list.
    template <class Coder>
    std::uint64_t codeTicks(Coder& coder, std::uint64_t count) {
        return ticks[static_cast<std::size_t>(lastPart)].code(coder, count - 1) + 1;
    }

    template <class Coder>
    void codePair(Coder& coder, std::array<MotionModel, 2>& models, Change& change) {
        change.x = models[0].code(coder, change.x);
        change.y = models[1].code(coder, change.y);
    }
};

}  // namespace plumb::link_format
