#include "app/benchmark.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Benchmark, theTableBeginsWithTheRowsOfTheSeed) {
    BenchmarkResult result;
    result.entities = 10000;
    result.systemsMs = 2.3;
    result.broadMs = 0.8;
    result.narrowMs = 1.1;
    result.renderMs = 1.5;
    result.contacts = 12;
    const std::string table = benchmarkTable(result);
    EXPECT_EQ(table,
              "Entities: 10000\n"
              "Systems Update: 2.30ms\n"
              "Collision Broad Phase: 0.80ms\n"
              "Collision Narrow Phase: 1.10ms\n"
              "Render: 1.50ms\n"
              "Total Frame: 5.70ms (175 FPS theoretical)\n"
              "\n"
              "Contacts Begun: 12\n");

    result.drawCalls = 1;
    result.window = {640, 360};
    result.frameTimes = frameTimesOf(std::vector<double>{0.004, 0.006});
    EXPECT_EQ(benchmarkTable(result), table +
                                          "Draw Calls: 1\n"
                                          "Window: 640x360\n"
                                          "Frame Rate: 200.0 FPS over 2 frames\n"
                                          "Frame Time: 4.00ms median, 6.00ms 95%, 6.00ms 99%\n");
}

TEST(Benchmark, allItsEntitiesMoveAndCollide) {
    const BenchmarkResult result = runBenchmark({.entities = 100, .frames = 60}, nullptr);
    EXPECT_EQ(result.entities, 100);
    EXPECT_GT(result.contacts, 20u);
    EXPECT_EQ(result.frameTimes.frames, 0u);
}

TEST(FrameTimes, aPercentileIsTheTimeNotExceededByThatShareOfFrames) {
    std::vector<double> seconds;
    for (int i = 100; i > 0; --i) seconds.push_back(0.001 * i);
    const FrameTimes times = frameTimesOf(seconds);
    EXPECT_EQ(times.frames, 100u);
    EXPECT_DOUBLE_EQ(times.medianMs, 50.0);
    EXPECT_DOUBLE_EQ(times.slow95Ms, 95.0);
    EXPECT_DOUBLE_EQ(times.slow99Ms, 99.0);
    EXPECT_NEAR(times.framesPerSecond(), 1000.0 / 50.5, 1e-9);
    EXPECT_EQ(frameTimesOf({}).framesPerSecond(), 0.0);
}

}  // namespace
}  // namespace plumb
