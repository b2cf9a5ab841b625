#include "tests/accuracy/stability/score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/text.hpp"

namespace plumb::stability {

namespace {

constexpr std::array<ScoreInfo, static_cast<std::size_t>(Score::Count)> kScores{{
    {'X', "blows up", "#b2182b", "#ffffff",
     "a number is not finite, energy grows by more than 1 % without a motor, or a body is faster than "
     "twice the maximum expected speed"},
    {'W', "wrong but bounded", "#fdae61", "#3d1f00",
     "an error above 10 %: fallen, sunk in or pulled apart, but at rest"},
    {'S', "soft", "#fee9a8", "#3a3000", "an error up to 10 %: visible compliance, but it holds"},
    {'1', "within 1 %", "#abd9e9", "#08304a", "an error up to 1 %"},
    {'E', "exact", "#2c7bb6", "#ffffff", "an error up to 0.1 %"},
}};

std::string percentText(double ratio) {
    const double percent = ratio * 100.0;
    return fixedText(percent, percent < 1.0 ? 3 : percent < 10.0 ? 1 : 0) + " %";
}

}  // namespace

const ScoreInfo& infoOf(Score score) { return kScores[static_cast<std::size_t>(score)]; }

Score scoreOf(char sign) {
    const auto found = std::find_if(kScores.begin(), kScores.end(),
                                    [sign](const ScoreInfo& info) { return info.sign == sign; });
    return found == kScores.end() ? Score::BlowsUp : static_cast<Score>(found - kScores.begin());
}

double errorOf(const Figures& figures) {
    double worst = 0.0;
    for (const double error : {figures.penetration, figures.joints, figures.off, figures.residual}) {
        if (std::isnan(error)) return std::numeric_limits<double>::infinity();  // std::max would ignore it
        worst = std::max(worst, error);
    }
    return worst;
}

Score scoreOf(const Figures& figures) {
    const double error = errorOf(figures);
    const bool bounded = figures.finite && std::isfinite(error) && figures.energyGain <= kMaxEnergyGain &&
                         figures.speeding <= kMaxSpeeding;
    if (!bounded) return Score::BlowsUp;
    if (error <= kExact) return Score::Exact;
    if (error <= kClose) return Score::Close;
    return error <= kSoft ? Score::Soft : Score::Wrong;
}

std::string reasonOf(const Figures& figures) {
    if (!figures.finite || !std::isfinite(errorOf(figures))) return "a number is not finite";
    if (!(figures.energyGain <= kMaxEnergyGain))
        return format("energy grew by {}", percentText(figures.energyGain));
    if (!(figures.speeding <= kMaxSpeeding))
        return format("{} times the maximum expected speed", fixedText(figures.speeding, 1));
    const double error = errorOf(figures);
    if (error == figures.penetration) return format("overlap of {}", percentText(error));
    if (error == figures.joints) return format("joints open by {}", percentText(error));
    if (error == figures.off) return format("off by {}", percentText(error));
    return format("residual speed of {} of a fall", percentText(error));
}

Reach reachOf(std::span<const Score> row, std::size_t home, Score floor) {
    if (home >= row.size() || row[home] < floor) return {home, home};
    Reach reach{home, home + 1};
    while (reach.first > 0 && row[reach.first - 1] >= floor) --reach.first;
    while (reach.end < row.size() && row[reach.end] >= floor) ++reach.end;
    return reach;
}

}  // namespace plumb::stability
