#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/physics/support/random_scene.hpp"

// Runs random extreme worlds (random_scene.hpp). Environment variable PLUMB_SCENES: number of scenes.

namespace plumb::physics {
namespace {

int wantedScenes() {
    const char* asked = std::getenv("PLUMB_SCENES");
    return asked != nullptr ? std::atoi(asked) : 2000;
}

TEST(RandomScenes, stayFinite) {
    int contacts = 0, plain = 0, refused = 0;
    const int scenes = wantedScenes();
    for (int i = 0; i < scenes; ++i) {
        RandomScene scene{static_cast<std::uint64_t>(i)};
        scene.run();
        ASSERT_TRUE(scene.isSound()) << "scene " << i;
        contacts += scene.contacts() > 0 ? 1 : 0;
        plain += scene.isPlain() && scene.contacts() > 0 ? 1 : 0;
        refused += scene.refused() > 0 ? 1 : 0;
        if (scenes >= 100000 && i % 50000 == 49999) std::printf("%d of %d scenes\n", i + 1, scenes);
    }
    EXPECT_GT(contacts, scenes / 3) << "hardly any contacts";
    EXPECT_GT(plain, scenes / 20);
    EXPECT_GT(refused, scenes / 20) << "hardly any invalid input was rejected";
}

}  // namespace
}  // namespace plumb::physics
