#include "tests/accuracy/web/lab.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "tests/accuracy/report/sweep.hpp"

namespace plumb::accuracy {
namespace {

const Experiment& scene(std::string_view name) { return *findExperiment(name); }

TEST(Recording, hasThePosesOfEachStepRelativeToTheFirstMovingBody) {
    const Recording fall = record(scene("freefall"), Method{});
    ASSERT_EQ(fall.moments, 121) << "two seconds and the start";
    ASSERT_EQ(fall.bodies.size(), 1u);
    ASSERT_EQ(fall.poses.size(), 3u * 121u);
    for (int moment = 0; moment < fall.moments; ++moment) {
        const double time = moment / 60.0;
        EXPECT_NEAR(fall.poses[static_cast<std::size_t>(3 * moment + 1)], -0.5 * kGravity * time * time,
                    1e-4);
    }
}

TEST(Recording, ofABodyFarAwayIsAsExactAsOneAtTheOrigin) {
    const Recording far = record(scene("farpyramid"), Method{});
    double least = 1.0;
    for (std::size_t i = 0; i < far.bodies.size(); ++i) {
        for (std::size_t other = 0; other < i; ++other)
            least = std::min(
                least, std::hypot(static_cast<double>(far.poses[3 * i] - far.poses[3 * other]),
                                  static_cast<double>(far.poses[3 * i + 1] - far.poses[3 * other + 1])));
        EXPECT_LT(std::fabs(far.poses[3 * i]), 1000.0f);
    }
    EXPECT_GT(least, 0.4) << "boxes of a pyramid 100 km away";
}

TEST(Recording, changesNoResult) {
    for (const std::string_view name : {"stack20", "chain100", "bounces"}) {
        Lab lab;
        const std::string before = lab.measure(name, Method{}, 0.0);
        static_cast<void>(lab.record(name, Method{}));
        const auto errors = [](std::string_view json) {
            std::string found;
            for (std::size_t at = json.find("\"error\": "); at != std::string_view::npos;
                 at = json.find("\"error\": ", at + 1))
                found += json.substr(at, json.find(',', at) - at);
            return found;
        };
        EXPECT_EQ(errors(lab.measure(name, Method{}, 0.0)), errors(before));
        std::string expected;
        for (const Row& row : runOne(scene(name), Method{}, {.runs = 1}))
            expected += format("\"error\": {}", shortestText(row.error));
        EXPECT_EQ(errors(before), expected);
    }
}

TEST(Lab, hasTextsOfAllScenesWithAKnownResult) {
    const std::string json = Lab::scenesJson();
    for (const Experiment& experiment : allExperiments()) {
        const bool found = json.find(format("\"name\":\"{}\"", experiment.name)) != std::string::npos;
        EXPECT_EQ(found, !experiment.has(kNoExactAnswer)) << experiment.name;
    }
    EXPECT_EQ(json.find("\"title\":\"\""), std::string::npos);
}

TEST(Lab, drawsWhatWasMeasuredOnceForEachMethod) {
    Lab lab;
    EXPECT_EQ(lab.chart("pendulum"), "");
    for (const int substeps : {4, 1, 4, 16})
        static_cast<void>(lab.measure("pendulum", methodOf(substeps, 1, true), 0.0));
    const std::string svg = lab.chart("pendulum");
    EXPECT_TRUE(startsWith(svg, "<svg"));
    for (const std::string_view substeps : {">1<", ">4: default<", ">16<"}) {
        const std::size_t first = svg.find(substeps);
        ASSERT_NE(first, std::string::npos) << substeps;
    }
    EXPECT_EQ(lab.measure("pit1000", Method{}, 0.0), "[]") << "it has no exact answer";
    EXPECT_EQ(lab.record("nothing", Method{}), "null");
}

TEST(Lab, methodsHaveTheQualityOfTheirSubsteps) {
    for (int quality = 0; quality <= physics::kMaxQuality; ++quality)
        EXPECT_EQ(methodOf(1 << quality, 1, true).quality, quality);
    EXPECT_EQ(methodOf(0, 1, true).quality, physics::kQualityOfWorld);
    EXPECT_EQ(methodOf(4, 1, true), Method{});
}

}  // namespace
}  // namespace plumb::accuracy
