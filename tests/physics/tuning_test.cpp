#include "physics/tuning.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "physics/simulation.hpp"
#include "tests/physics/support/golden_scenes.hpp"
#include "tests/support/tunable.hpp"

// Constants that can be changed in a build with PLUMB_TUNABLE: ./plumb accuracy --tuning.

namespace plumb::physics {
namespace {

std::uint64_t hashOfScene(const char* name) {
    for (const test::GoldenScene& scene : test::goldenScenes()) {
        if (std::string{scene.name} != name) continue;
        World world = scene.build();
        for (int i = 0; i < scene.steps; ++i) {
            if (scene.before != nullptr) scene.before(world, i);
            step(world, 1.0f / 60.0f);
        }
        return physics::hashOf(world);
    }
    return 0;
}

TEST(Tuning, changesResultsInTunableBuilds) {
    if (tuning::constants == nullptr) GTEST_SKIP() << "the constants of this build are fixed";
    std::set<std::string> names;
    const tuning::Constant* turn = nullptr;
    for (const tuning::Constant* constant = tuning::constants; constant != nullptr;
         constant = constant->next) {
        EXPECT_TRUE(names.insert(constant->name).second) << constant->name;
        EXPECT_NE(constant->value, 0.0) << constant->name << ": halving and doubling 0 has no effect";
        EXPECT_STRNE(constant->unit, "") << constant->name;
        EXPECT_STRNE(constant->derivation, "") << constant->name;
        if (std::string{constant->name} == "kMaxTurn") turn = constant;
    }
    ASSERT_NE(turn, nullptr);
    const std::uint64_t usual = hashOfScene("tumbler");
    turn->set(0.5 * turn->value);
    const std::uint64_t other = hashOfScene("tumbler");
    turn->set(turn->value);
    EXPECT_NE(other, usual);
    EXPECT_EQ(hashOfScene("tumbler"), usual) << "the default value must be restored";
}

}  // namespace
}  // namespace plumb::physics
