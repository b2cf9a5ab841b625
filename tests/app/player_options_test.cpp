#include "app/player_options.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace plumb {
namespace {

Result<PlayerOptions> parsed(const std::vector<const char*>& arguments) {
    return parsePlayerOptions(arguments);
}

TEST(PlayerOptions, everyOptionIsReadWithItsValueBehindItOrAfterAnEqualsSign) {
    const auto options = parsed({"projects/mine", "--frames", "600", "--seed=7", "--headless", "--hash",
                                 "--scale", "3", "--entities", "1000", "--window=640x360"});

    ASSERT_TRUE(options.ok());
    EXPECT_EQ(options->project, "projects/mine");
    EXPECT_EQ(options->frames, 600);
    EXPECT_EQ(options->seed, 7u);
    EXPECT_TRUE(options->headless);
    EXPECT_TRUE(options->hash);
    EXPECT_EQ(options->scale, 3);
    EXPECT_EQ(options->entities, 1000);
    EXPECT_EQ(options->window, (PixelSize{640, 360}));
}

TEST(PlayerOptions, aMistypedOptionNamesTheClosestOne) {
    const auto options = parsed({"--headles"});

    ASSERT_FALSE(options.ok());
    EXPECT_EQ(options.error().text(),
              "command line: there is no option \"--headles\"; did you mean --headless?");
}

TEST(PlayerOptions, wrongAndMissingValuesAreErrorsWithARemedy) {
    for (const auto& wrong : std::vector<std::vector<const char*>>{{"--frames", "many"},
                                                                   {"--frames", "-1"},
                                                                   {"--frames"},
                                                                   {"--scale", "17"},
                                                                   {"--entities", "0"},
                                                                   {"--window", "640"},
                                                                   {"--window", "0x360"},
                                                                   {"--window", "640x99999"},
                                                                   {"--hash-every", "0"},
                                                                   {"--seed", "-3"},
                                                                   {"--screenshot", ""},
                                                                   {"--physics-view", "shape"},
                                                                   {"--physics-view"},
                                                                   {"a", "b"}}) {
        const auto options = parsed(wrong);
        ASSERT_FALSE(options.ok()) << wrong.front();
        EXPECT_FALSE(options.error().remedy.empty());
    }
}

TEST(PlayerOptions, theHelpNamesEveryLayerOfThePhysics) {
    for (const PhysicsLayer& layer : physicsLayers()) {
        EXPECT_NE(playerUsage().find(layer.name), std::string::npos) << layer.name;
    }
    const auto options = parsed({"--physics-view", "joints,islands"});
    ASSERT_TRUE(options.ok());
    EXPECT_EQ(options->physicsView.shown().layers, *physicsLayersNamed("islands,joints"));
}

TEST(PlayerOptions, theUsageListsEveryOption) {
    for (const char* name :
         {"--scene", "--headless", "--frames", "--hash", "--hash-every", "--screenshot", "--capture",
          "--record", "--replay", "--effects", "--all-effects", "--benchmark", "--seed", "--scale",
          "--fullscreen", "--entities", "--window", "--physics-view"}) {
        EXPECT_NE(playerUsage().find(name), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace plumb
