#include "tests/accuracy/stability/score.hpp"

#include <array>
#include <limits>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace plumb::stability {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// All figures that are errors.
constexpr std::array<double Figures::*, 4> kErrors{&Figures::penetration, &Figures::joints, &Figures::off,
                                                   &Figures::residual};

Score scoreOfError(double Figures::*figure, double value) {
    Figures figures;
    figures.*figure = value;
    return scoreOf(figures);
}

TEST(StabilityScore, isDeterminedByTheLargestError) {
    for (double Figures::*const figure : kErrors) {
        EXPECT_EQ(scoreOfError(figure, 0.0), Score::Exact);
        EXPECT_EQ(scoreOfError(figure, 0.001), Score::Exact);
        EXPECT_EQ(scoreOfError(figure, 0.0011), Score::Close);
        EXPECT_EQ(scoreOfError(figure, 0.01), Score::Close);
        EXPECT_EQ(scoreOfError(figure, 0.011), Score::Soft);
        EXPECT_EQ(scoreOfError(figure, 0.1), Score::Soft);
        EXPECT_EQ(scoreOfError(figure, 0.11), Score::Wrong);
        EXPECT_EQ(scoreOfError(figure, 1.0e6), Score::Wrong);
    }
    EXPECT_EQ(scoreOf(Figures{.penetration = 0.0005, .residual = 0.05}), Score::Soft);
}

TEST(StabilityScore, nonFiniteNumbersEnergyGainAndExcessSpeedBlowUp) {
    for (double Figures::*const figure : kErrors) {
        EXPECT_EQ(scoreOfError(figure, kNan), Score::BlowsUp);
        EXPECT_EQ(scoreOfError(figure, kInf), Score::BlowsUp);
    }
    EXPECT_EQ(scoreOf(Figures{.finite = false}), Score::BlowsUp);
    EXPECT_EQ(scoreOf(Figures{.energyGain = 0.01}), Score::Exact);
    EXPECT_EQ(scoreOf(Figures{.energyGain = 0.0101}), Score::BlowsUp);
    EXPECT_EQ(scoreOf(Figures{.energyGain = kNan}), Score::BlowsUp);
    EXPECT_EQ(scoreOf(Figures{.energyGain = -0.9}), Score::Exact);
    EXPECT_EQ(scoreOf(Figures{.speeding = 2.0}), Score::Exact);
    EXPECT_EQ(scoreOf(Figures{.speeding = 2.01}), Score::BlowsUp);
    EXPECT_EQ(scoreOf(Figures{.speeding = kNan}), Score::BlowsUp);
}

TEST(StabilityScore, namesTheDecisiveFigure) {
    EXPECT_EQ(reasonOf(Figures{.penetration = 0.05}), "overlap of 5.0 %");
    EXPECT_EQ(reasonOf(Figures{.joints = 0.005}), "joints open by 0.500 %");
    EXPECT_EQ(reasonOf(Figures{.penetration = 0.1, .off = 0.5}), "off by 50 %");
    EXPECT_EQ(reasonOf(Figures{.residual = 0.25}), "residual speed of 25 % of a fall");
    EXPECT_EQ(reasonOf(Figures{.off = 3.0, .energyGain = 0.7}), "energy grew by 70 %");
    EXPECT_EQ(reasonOf(Figures{.speeding = 2.5}), "2.5 times the maximum expected speed");
    EXPECT_EQ(reasonOf(Figures{.off = kNan}), "a number is not finite");
}

TEST(StabilityScore, everyScoreHasAUniqueSignAndColour) {
    std::set<char> signs;
    std::set<std::string_view> fills;
    for (int i = 0; i < static_cast<int>(Score::Count); ++i) {
        const auto score = static_cast<Score>(i);
        signs.insert(infoOf(score).sign);
        fills.insert(infoOf(score).fill);
        EXPECT_EQ(scoreOf(infoOf(score).sign), score);
        EXPECT_FALSE(infoOf(score).rule.empty());
    }
    EXPECT_EQ(signs.size(), static_cast<std::size_t>(Score::Count));
    EXPECT_EQ(fills.size(), static_cast<std::size_t>(Score::Count));
    EXPECT_EQ(scoreOf('?'), Score::BlowsUp);
}

TEST(StabilityScore, aRangeIsContiguousAroundTheEasiestColumn) {
    constexpr Score X = Score::BlowsUp, W = Score::Wrong, S = Score::Soft, E = Score::Exact;
    const std::array<Score, 6> row{E, S, W, E, X, E};
    EXPECT_EQ(reachOf(row, 0, S), (Reach{0, 2}));
    EXPECT_EQ(reachOf(row, 0, E), (Reach{0, 1}));
    EXPECT_EQ(reachOf(row, 1, W), (Reach{0, 4}));
    EXPECT_EQ(reachOf(row, 3, S), (Reach{3, 4}));
    EXPECT_TRUE(reachOf(row, 2, S).none());
    EXPECT_EQ(reachOf(row, 5, X), (Reach{0, 6}));
    EXPECT_TRUE(reachOf(row, 6, X).none());
}

}  // namespace
}  // namespace plumb::stability
