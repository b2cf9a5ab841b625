#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace plumb::stability {

/// Rating of a cell of a map. Larger is better.
enum class Score : std::uint8_t { BlowsUp, Wrong, Soft, Close, Exact, Count };

/// Measurements of a cell. All are ratios, so that the same rules
/// apply to every scene, whatever its size, mass and speed.
struct Figures {
    double penetration = 0.0;  ///< maximum overlap at the end, to the smallest body's thickness
    double joints = 0.0;       ///< maximum joint gap at the end, to the length of a link
    double off = 0.0;          ///< deviation from the exact result: each map defines the reference
    double residual = 0.0;  ///< speed in the last half second, to that of a fall by the smallest body's size
    double energyGain = 0.0;  ///< maximum energy at any time relative to that at the start, minus 1
    double speeding = 0.0;    ///< maximum speed at any time, to the maximum that the scene explains
    bool finite = true;       ///< all numbers stayed finite and no body was quarantined

    friend bool operator==(const Figures&, const Figures&) = default;
};

// The rules, for all maps.

inline constexpr double kExact = 1.0e-3;          ///< an error up to this is Exact
inline constexpr double kClose = 1.0e-2;          ///< up to this Close: "within 1 %"
inline constexpr double kSoft = 0.1;              ///< up to this Soft: compliant, but it holds
inline constexpr double kMaxEnergyGain = 1.0e-2;  ///< an unexplained energy gain above this blows up
inline constexpr double kMaxSpeeding = 2.0;       ///< so does a speed of twice what explains it

/// Appearance and meaning of each score.
struct ScoreInfo {
    char sign;              ///< in each cell, in CSV and in the floors of the tests
    std::string_view word;  ///< in JSON and legends
    std::string_view fill;  ///< colors that remain distinguishable with any kind of color blindness
                            ///< (ColorBrewer RdYlBu)
    std::string_view ink;
    std::string_view rule;  ///< in words
};
const ScoreInfo& infoOf(Score score);
/// @return the score with this sign; BlowsUp for any other character
Score scoreOf(char sign);

/// The largest of the figures that count as errors; infinite if one is NaN.
double errorOf(const Figures& figures);
Score scoreOf(const Figures& figures);
/// The figure that decided the score of a cell, as text.
std::string reasonOf(const Figures& figures);

/// The cells of a row around `home`, the easiest, that are no worse than `floor`.
struct Reach {
    std::size_t first = 0;
    std::size_t end = 0;  ///< one past the last; `first` if there are none

    [[nodiscard]] bool none() const { return first == end; }
    friend bool operator==(const Reach&, const Reach&) = default;
};
Reach reachOf(std::span<const Score> row, std::size_t home, Score floor);

}  // namespace plumb::stability
