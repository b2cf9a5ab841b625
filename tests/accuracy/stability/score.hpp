#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace plumb::stability {

/// Rating of a cell of a map. Larger is better.
enum class Score : std::uint8_t { BlowsUp, Wrong, Soft, Close, Exact, Count };

/// Measurements of a cell of a map. All of them are ratios, so
/// that the same rules apply to scenes of any size, mass and speed.
struct Figures {
    double penetration = 0.0;  ///< maximum final overlap, ratio to the smallest body's thickness
    double joints = 0.0;       ///< maximum final joint error, ratio to the length of a link
    double off = 0.0;          ///< deviation from the exact result; each map defines the ratio
    double residual = 0.0;     ///< speed in the last 0.5 s, ratio to the speed after a fall by a body's size
    double energyGain = 0.0;   ///< maximum energy relative to the initial energy, minus 1
    double speeding = 0.0;     ///< maximum speed, ratio to the maximum expected speed
    bool finite = true;        ///< true if all numbers stayed finite and no body was quarantined

    friend bool operator==(const Figures&, const Figures&) = default;
};

// Limits of the scores, for all maps.

inline constexpr double kExact = 1.0e-3;          ///< maximum error of Exact
inline constexpr double kClose = 1.0e-2;          ///< maximum error of Close ("within 1 %")
inline constexpr double kSoft = 0.1;              ///< maximum error of Soft
inline constexpr double kMaxEnergyGain = 1.0e-2;  ///< maximum energy gain; above it the score is BlowsUp
inline constexpr double kMaxSpeeding = 2.0;       ///< maximum speed ratio; above it the score is BlowsUp

/// Appearance and meaning of each score.
struct ScoreInfo {
    char sign;              ///< letter in each cell, in CSV and in floors.txt
    std::string_view word;  ///< name in JSON and legends
    std::string_view fill;  ///< cell color, distinguishable with color blindness (ColorBrewer RdYlBu)
    std::string_view ink;   ///< text color
    std::string_view rule;  ///< description of the rule
};
const ScoreInfo& infoOf(Score score);
/// Returns the score whose ScoreInfo::sign is `sign`; BlowsUp if there is none.
Score scoreOf(char sign);

/// Returns the largest of penetration, joints, off and residual; infinite if one of them is NaN.
double errorOf(const Figures& figures);
Score scoreOf(const Figures& figures);  ///< rates a cell by its figures
/// Returns a text with the figure that determines the score of a cell.
std::string reasonOf(const Figures& figures);

/// Range of columns around the easiest one whose scores are at least `floor`.
struct Reach {
    std::size_t first = 0;
    std::size_t end = 0;  ///< one past the last column; equal to `first` if empty

    [[nodiscard]] bool none() const { return first == end; }
    friend bool operator==(const Reach&, const Reach&) = default;
};
Reach reachOf(std::span<const Score> row, std::size_t home, Score floor);  ///< home: easiest column

}  // namespace plumb::stability
