#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "input/recorder.hpp"

namespace plumb {

// A link contains a replay as text, "#r=" and base64url: at the end of the address of a game's page it plays
// there, and it fits into a message. It is small because what players do repeats itself: a minute with keys
// takes some hundred characters. Of the hashes it keeps only that of the last tick.

inline constexpr std::size_t kMaxLinkBytes =
    120'000;  ///< of the text: Linux has 128 KiB for a word of a command
inline constexpr std::size_t kMaxLinkRuns = std::size_t{1}
                                            << 18;  ///< changes of the input: 70 min of 60 per s

/// Makes the link of a game that is running, of the ticks until now. It needs a few kB a minute at most,
/// where a Replay needs 90 bytes for every change of the input; allocates only when the input changes.
class LinkWriter {
public:
    /// @param begin  project, engine, scene and seed of the game; its runs are not read
    explicit LinkWriter(const Replay& begin);
    LinkWriter(LinkWriter&& other) noexcept;
    LinkWriter& operator=(LinkWriter&& other) noexcept;
    ~LinkWriter();

    /// Adds the input of the next tick.
    void record(const InputFrame& frame);

    [[nodiscard]] std::uint64_t ticks() const;

    /// @param hash  that of the world after the last tick, if it is known
    /// @error the game has become too long for a link
    [[nodiscard]] Result<std::string> link(std::optional<std::uint64_t> hash) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// @error too long for a link
Result<std::string> linkOf(const Replay& replay);

/// Reads a link: the text from "#r=", "%23r=" or "r=" on, what follows that, or a whole address that ends in
/// one. White space in it is left out, and so are other words after it.
/// @error no link, damaged or incomplete, of another version, too long
Result<Replay> replayOfLink(std::string_view text);

}  // namespace plumb
