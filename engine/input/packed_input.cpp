#include "input/packed_input.hpp"

#include <bit>
#include <cstring>

#include "core/text.hpp"

namespace plumb {
namespace {

using Words = std::array<std::uint16_t, sizeof(InputFrame) / 2>;

constexpr unsigned kChange = 0x40;   // in the first byte of a change
constexpr unsigned kSmaller = 0x80;  // likewise
constexpr unsigned kIndex = 0x3f;    // likewise
constexpr unsigned kMore = 0x80;     // in a byte of a number, and in the first one of ticks
constexpr unsigned kFirstTicks = 6;  // bits of the number in the first byte of ticks

static_assert(std::tuple_size_v<Words> <= kIndex + 1, "a change has 6 bits for the index of its word");
static_assert(sizeof(InputFrame) % 2 == 0);
static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "it is read in signal handlers");

template <class Byte>
Byte* writeNumber(Byte* out, std::uint64_t number) {
    for (; number > 0x7f; number >>= 7) *out++ = static_cast<Byte>((number & 0x7f) | kMore);
    *out++ = static_cast<Byte>(number);
    return out;
}

template <class Byte>
Byte* writeTicks(Byte* out, std::uint64_t ticks) {
    const std::uint64_t rest = ticks >> kFirstTicks;
    *out++ = static_cast<Byte>((ticks & ((1u << kFirstTicks) - 1)) | (rest > 0 ? kMore : 0));
    return rest > 0 ? writeNumber(out, rest) : out;
}

unsigned char* writeChanges(unsigned char* out, const InputFrame& from, const InputFrame& to) {
    const auto before = std::bit_cast<Words>(from);
    const auto now = std::bit_cast<Words>(to);
    for (unsigned i = 0; i < now.size(); ++i) {
        // As signed numbers, because an axis near its middle changes its sign often.
        const int change = static_cast<std::int16_t>(now[i]) - static_cast<std::int16_t>(before[i]);
        if (change == 0) continue;
        *out++ = static_cast<unsigned char>(kChange | (change < 0 ? kSmaller : 0) | i);
        out = writeNumber(out, static_cast<std::uint64_t>(change < 0 ? -change : change));
    }
    return out;
}

/// Reads what writeNumber() has written.
bool readNumber(std::string_view& packed, std::uint64_t& number) {
    for (unsigned shift = 0; shift < 35 && !packed.empty(); shift += 7) {
        const auto byte = static_cast<unsigned char>(packed.front());
        packed.remove_prefix(1);
        number |= std::uint64_t{byte & 0x7fu} << shift;
        if ((byte & kMore) == 0) return true;
    }
    return false;
}

}  // namespace

void PackedInput::record(const InputFrame& frame) {
    const std::uint64_t state = state_.load(std::memory_order_relaxed);
    const auto valid = static_cast<std::size_t>(state >> 32);
    const auto ticks = static_cast<std::uint32_t>(state);
    const Closed& before = closed_[valid];
    if (full_.load(std::memory_order_relaxed)) return;
    if (before.ticks + ticks == Replay::kMaxTicks) return full_.store(true);
    if (ticks > 0 && frame == frame_) return state_.store(state + 1, std::memory_order_release);
    if (before.size + kLongestRun > size_ || runs_ == Replay::kMaxRuns) return full_.store(true);
    ++runs_;
    unsigned char* end = bytes_.get() + before.size;
    if (ticks > 0) end = writeTicks(end, ticks);
    end = writeChanges(end, frame_, frame);
    frame_ = frame;
    closed_[1 - valid] = {static_cast<std::uint32_t>(end - bytes_.get()), before.ticks + ticks};
    state_.store(std::uint64_t{1 - valid} << 32 | 1u, std::memory_order_release);
}

PackedInput::Content PackedInput::content() const {
    const std::uint64_t state = state_.load(std::memory_order_acquire);
    const Closed& closed = closed_[static_cast<std::size_t>(state >> 32)];
    const auto ticks = static_cast<std::uint32_t>(state);
    Content content;
    content.closed = {reinterpret_cast<const char*>(bytes_.get()), closed.size};
    if (ticks > 0)
        content.openSize =
            static_cast<std::size_t>(writeTicks(content.open.data(), ticks) - content.open.data());
    content.ticks = closed.ticks + ticks;
    return content;
}

std::string unpackInput(std::string_view packed, Replay& replay, std::uint64_t& ticks) {
    const std::size_t size = packed.size();
    InputFrame frame = replay.runs.empty() ? InputFrame{} : replay.runs.back().frame;
    while (!packed.empty()) {
        const auto fails = [&](std::string_view why) {
            return format("the packed input is damaged near byte {}: {}", size - packed.size(), why);
        };
        const auto first = static_cast<unsigned char>(packed.front());
        packed.remove_prefix(1);
        if ((first & kChange) != 0) {
            auto words = std::bit_cast<Words>(frame);
            std::uint64_t change = 0;
            if ((first & kIndex) >= words.size() || !readNumber(packed, change) || change > 0xffff)
                return fails("no such change");
            std::uint16_t& word = words[first & kIndex];
            const int now = static_cast<std::int16_t>(word) +
                            ((first & kSmaller) != 0 ? -static_cast<int>(change) : static_cast<int>(change));
            if (now < -32768 || now > 32767) return fails("a value beyond 16 bits");
            word = static_cast<std::uint16_t>(now);
            frame = std::bit_cast<InputFrame>(words);
            continue;
        }
        std::uint64_t rest = 0;
        if ((first & kMore) != 0 && !readNumber(packed, rest)) return fails("no number of ticks");
        const std::uint64_t more = rest << kFirstTicks | (first & ((1u << kFirstTicks) - 1));
        if (!isPossible(frame)) return fails("input that no device gives");
        if (more == 0 || ticks + more > Replay::kMaxTicks) return fails("too few or too many ticks");
        ticks += more;
        if (!replay.runs.empty() && replay.runs.back().frame == frame) {
            replay.runs.back().ticks += more;
        } else if (replay.runs.size() == Replay::kMaxRuns) {
            return "too many changes of input";
        } else {
            replay.runs.push_back({frame, more});
        }
    }
    return {};
}

}  // namespace plumb
