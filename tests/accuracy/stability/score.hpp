#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace plumb::stability {

/// How well a cell of a map came out. Better is larger.
enum class Score : std::uint8_t { BlowsUp, Wrong, Soft, Close, Exact, Count };

/// What was measured in a cell. All are ratios, so that one set of rules judges every scene, whatever its
/// size, weight and speed.
struct Figures {
    double penetration = 0.0;  ///< deepest overlap at the end, to the smallest body's thickness
    double joints = 0.0;       ///< widest gap in a joint at the end, to the length of a link
    double off = 0.0;          ///< from the exact answer: each map says to what
    double residual = 0.0;  ///< speed in the last half second, to that of a fall by the smallest body's size
    double energyGain = 0.0;  ///< most energy at any time over that at the start, minus 1
    double speeding = 0.0;    ///< highest speed at any time, to the highest that the scene explains
    bool finite = true;       ///< all numbers stayed finite and no body was quarantined

    friend bool operator==(const Figures&, const Figures&) = default;
};

// The rules, for all maps.

inline constexpr double kExact = 1.0e-3;      ///< an error up to this is Exact
inline constexpr double kClose = 1.0e-2;      ///< up to this Close: "within 1 %"
inline constexpr double kSoft = 0.1;          ///< up to this Soft: it gives, but holds
inline constexpr double kMostGain = 1.0e-2;   ///< more energy than this from nowhere blows up
inline constexpr double kMostSpeeding = 2.0;  ///< as does twice the speed that anything explains

/// What each score looks like and means.
struct ScoreInfo {
    char sign;              ///< in each cell, in CSV and in the floors of the tests
    std::string_view word;  ///< in JSON and legends
    std::string_view fill;  ///< colours that all kinds of colour blindness keep apart (ColorBrewer RdYlBu)
    std::string_view ink;
    std::string_view rule;  ///< in words
};
const ScoreInfo& infoOf(Score score);
/// @return the score with this sign; BlowsUp for any other character
Score scoreOf(char sign);

/// The largest of the figures that count as error; infinite when one is no number.
double errorOf(const Figures& figures);
Score scoreOf(const Figures& figures);
/// Why a cell has its score: the figure that decided, in words.
std::string reasonOf(const Figures& figures);

/// The cells of a row around `home`, the easiest, that are no worse than `floor`.
struct Reach {
    std::size_t first = 0;
    std::size_t end = 0;  ///< behind the last; `first` when there are none

    [[nodiscard]] bool none() const { return first == end; }
    friend bool operator==(const Reach&, const Reach&) = default;
};
Reach reachOf(std::span<const Score> row, std::size_t home, Score floor);

}  // namespace plumb::stability
