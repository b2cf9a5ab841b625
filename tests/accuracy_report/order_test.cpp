#include "tests/accuracy/report/order.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace plumb::accuracy {
namespace {

std::vector<Sample> samplesOf(double power, double floor = 0.0) {
    std::vector<Sample> samples;
    for (double n = 1.0; n <= 64.0; n *= 2.0)
        samples.push_back({n, std::max(3.0 * std::pow(n, -power), floor)});
    return samples;
}

TEST(Order, isTheExponentOfAPowerLaw) {
    for (const double power : {0.5, 1.0, 2.0, 4.0}) {
        const Order order = orderOf(samplesOf(power));
        EXPECT_NEAR(order.power, power, 1e-9);
        EXPECT_EQ(order.points, 7);
        EXPECT_EQ(order.floorFrom, 0.0);
    }
}

TEST(Order, isFittedAboveTheFloorAndReportsTheFloor) {
    const Order order = orderOf(samplesOf(2.0, 0.008));  // the floor is reached between 16 and 32 substeps
    EXPECT_NEAR(order.power, 2.0, 1e-9);
    EXPECT_EQ(order.first, 1.0);
    EXPECT_EQ(order.last, 16.0);
    EXPECT_EQ(order.floor, 0.008);
    EXPECT_EQ(order.floorFrom, 32.0);
}

TEST(Order, ignoresASteepStartBeforeTheStraightPart) {
    std::vector<Sample> samples = samplesOf(2.0);
    samples[0].error = 1.0e4;
    const Order order = orderOf(samples);
    EXPECT_NEAR(order.power, 2.0, 1e-9);
    EXPECT_EQ(order.first, 2.0);
    EXPECT_EQ(order.last, 64.0);
    EXPECT_EQ(order.floorFrom, 0.0);
}

TEST(Order, ofTwoStraightPartsBeforeAFloorIsThatOfTheFirst) {
    const std::vector<Sample> samples{{1, 64.0}, {2, 8.0}, {4, 1.0}, {8, 0.5}, {16, 0.25}, {32, 0.25}};
    const Order order = orderOf(samples);
    EXPECT_NEAR(order.power, 3.0, 1e-9);
    EXPECT_EQ(order.last, 4.0);
    EXPECT_EQ(order.floor, 0.25);
}

TEST(Order, ignoresInfiniteErrorsAndErrorsOfZero) {
    std::vector<Sample> samples = samplesOf(2.0);
    samples[0].error = std::numeric_limits<double>::infinity();
    samples[6].error = 0.0;
    const Order order = orderOf(samples);
    EXPECT_NEAR(order.power, 2.0, 1e-9);
    EXPECT_EQ(order.points, 5);
    EXPECT_EQ(order.first, 2.0);
}

TEST(Order, ofConstantErrorsIsAboutZero) {
    const std::vector<Sample> samples{{1, 1.0}, {2, 1.1}, {4, 0.95}, {8, 1.02}, {16, 1.0}};
    const Order order = orderOf(samples);
    EXPECT_NEAR(order.power, 0.0, 0.05);
    EXPECT_EQ(order.points, 5);
    EXPECT_EQ(order.floorFrom, 0.0);
}

TEST(Order, ofASinglePointIsUnknown) { EXPECT_EQ(orderOf(std::vector<Sample>{{1, 1.0}}).points, 0); }

TEST(ParetoFront, containsSamplesNotBeatenInBothEffortAndError) {
    //                                 slow, exact | worse than 2 | fast | as 2, slower | diverged
    const std::vector<Sample> samples{{9.0, 0.1}, {5.0, 2.0}, {4.0, 1.0},
                                      {1.0, 7.0}, {6.0, 1.0}, {0.5, INFINITY}};
    EXPECT_EQ(paretoFront(samples), (std::vector<std::size_t>{3, 2, 0}));
    EXPECT_TRUE(paretoFront({}).empty());
    const std::vector<Sample> alike{{1.0, 1.0}, {2.0, 0.995}, {3.0, 0.5}};
    EXPECT_EQ(paretoFront(alike), (std::vector<std::size_t>{0, 2}));
}

}  // namespace
}  // namespace plumb::accuracy
