#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/cpu.hpp"
#include "core/task_pool.hpp"
#include "physics/simulation.hpp"
#include "tests/physics/support/golden_scenes.hpp"
#include "tests/support/places.hpp"

// On all machines, the state hash of each golden scene must equal the one in tests/replay/physics.golden.

namespace plumb::physics {
namespace {

using test::GoldenScene;
using test::goldenScenes;

std::map<std::string, std::string> readGoldens() {
    std::map<std::string, std::string> goldens;
    std::ifstream file{plumb::test::sourceFolder() / "tests/replay/physics.golden"};
    for (std::string name, hash; file >> name >> hash;) goldens[name] = hash;
    return goldens;
}

std::string inDigits(std::uint64_t hash) {
    std::string text(16, '0');
    for (int i = 15; i >= 0; --i, hash >>= 4)
        text[static_cast<std::size_t>(i)] = "0123456789abcdef"[hash & 15];
    return text;
}

/// Parameters of a run of a golden scene, and values observed in it.
struct Course {
    StepOptions options;
    bool rewinds = false;    // takes a snapshot every seventh step, continues, and restores it
    int touching = 0;        // out: number of touching contacts, summed over all steps
    std::size_t joints = 0;  // out: number of joints at the end
};

std::string hashOf(const GoldenScene& scene, Course& course) {
    World world = scene.build();
    World saved;
    const auto advance = [&](int i) {
        if (scene.before != nullptr) scene.before(world, i);
        step(world, 1.0f / 60.0f, course.options);
    };
    for (int i = 0; i < scene.steps; ++i) {
        if (course.rewinds && i % 7 == 0) {
            saved = world;
            for (int ahead = 0; ahead < 3; ++ahead) advance(i + ahead);
            world = saved;
        }
        advance(i);
        for (const Contact& contact : world.contacts)
            course.touching += (contact.flags & kTouching) != 0 ? 1 : 0;
    }
    course.joints = world.joints.size();
    return inDigits(physics::hashOf(world));
}

std::string hashOf(const GoldenScene& scene, const StepOptions& options = {}) {
    Course course{.options = options};
    return hashOf(scene, course);
}

class Golden : public testing::TestWithParam<std::size_t> {
protected:
    const GoldenScene& scene = goldenScenes()[GetParam()];
    std::string golden = readGoldens()[scene.name];
};

TEST_P(Golden, isTheHashOfTheScene) {
    Course course;
    EXPECT_EQ(hashOf(scene, course), golden)
        << "If this change is meant to change results, run ./plumb test --record and commit "
           "tests/replay/physics.golden; otherwise it is a regression.";
    EXPECT_EQ(course.joints > 0, scene.joints);
    EXPECT_EQ(course.touching > 50, scene.contacts) << course.touching;
}

TEST_P(Golden, isTheSameWithAnyNumberOfThreads) {
    for (const int threads : {2, 4, 16}) {
        TaskPool pool{threads};
        EXPECT_EQ(hashOf(scene, {.pool = &pool, .minimumWork = 0}), golden) << threads;
    }
}

TEST_P(Golden, isTheSameWithAnyInstructionSet) {
    const SimdWidth widest = simdWidth();
    for (const SimdWidth width : {SimdWidth::Scalar, SimdWidth::Sse2, SimdWidth::Avx2, SimdWidth::Neon}) {
        if (!setSimdWidth(width)) continue;
        EXPECT_EQ(hashOf(scene), golden) << static_cast<int>(width);
    }
    setSimdWidth(widest);
}

TEST_P(Golden, isTheSameIfASnapshotIsRestoredEverySeventhStep) {
    Course course{.rewinds = true};
    EXPECT_EQ(hashOf(scene, course), golden);
}

std::vector<std::size_t> numbers() {
    std::vector<std::size_t> numbers(goldenScenes().size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    return numbers;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(numbers()),
                         [](const auto& tested) { return std::string{goldenScenes()[tested.param].name}; });

}  // namespace
}  // namespace plumb::physics
