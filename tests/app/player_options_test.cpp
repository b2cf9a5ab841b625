#include "app/player_options.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"

namespace plumb {
namespace {

Result<PlayerOptions> parsed(const std::vector<const char*>& arguments) {
    return parsePlayerOptions(arguments);
}

TEST(PlayerOptions, optionsTakeTheirValueAsNextArgumentOrAfterAnEqualsSign) {
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
    EXPECT_EQ(options.error().text(), "command line: unknown option \"--headles\"; did you mean --headless?");
}

TEST(PlayerOptions, aWrongValueIsReportedWithTheValidValues) {
    EXPECT_EQ(parsed({"--scale", "17"}).error().text(),
              "command line: invalid value \"17\" for --scale; write --scale N: window size in multiples of "
              "the game's resolution, 1..16");
    EXPECT_EQ(parsed({"--seed"}).error().text(),
              "command line: --seed needs a value; write --seed N: seed of the game's random numbers");
}

TEST(PlayerOptions, screenshotsAreRejectedInHeadlessMode) {
    EXPECT_EQ(parsed({"--headless", "--screenshot", "a.png"}).error().text(),
              "command line: --screenshot needs rendered frames, but --headless renders none; leave out "
              "--headless: without a display the game renders offscreen");
    EXPECT_FALSE(parsed({"--capture", "frames", "--headless"}).ok());
    EXPECT_FALSE(parsed({"--headless", "--physics-view", "all"}).ok());
    EXPECT_FALSE(parseGameOptions(std::vector{"--headless", "--screenshot=a.png"}).ok());
    EXPECT_TRUE(parsed({"--screenshot", "a.png"}).ok());
}

TEST(PlayerOptions, aPictureIsPngAndTheErrorSaysSo) {
    EXPECT_EQ(parsed({"--screenshot", "a.jpg"}).error().text(),
              "command line: invalid value \"a.jpg\" for --screenshot; write --screenshot FILE.png: save the "
              "last frame as a PNG image; no other format");
}

TEST(PlayerOptions, whatWouldMakeAReplayAnotherGameIsRefusedWithTheReason) {
    for (const std::vector<const char*>& words : std::vector<std::vector<const char*>>{
             {"--scene", "level2"}, {"--seed", "1"}, {"--all-effects"}, {"--effects"}, {"--benchmark"}}) {
        EXPECT_TRUE(parsed(words).ok()) << words.front();
        std::vector<const char*> both = words;
        both.insert(both.begin(), {"--replay", "a.replay"});
        const auto options = parsed(both);
        ASSERT_FALSE(options.ok()) << words.front();
        EXPECT_NE(options.error().what.find(format("{} cannot be used with --replay: ", words.front())),
                  std::string::npos)
            << options.error().text();
        EXPECT_NE(options.error().remedy.find(format("leave out {}", words.front())), std::string::npos);
    }
    EXPECT_EQ(parsed({"--record", "a.replay", "--all-effects"}).error().text(),
              "command line: --all-effects cannot be used with --record: which effects run is part of the "
              "state, so every hash differs, even where results do not; leave out --all-effects or --record");
    EXPECT_FALSE(parsed({"--crash-reports", "reports", "--all-effects"}).ok());
    EXPECT_TRUE(parsed({"--replay", "a.replay", "--crash-reports", "reports"}).ok());
    EXPECT_EQ(parsed({"--link", "#r=x", "--seed", "7"}).error().text(),
              "command line: --seed cannot be used with --link: a replay uses the seed that was recorded; "
              "leave out "
              "--seed or --link");
    EXPECT_FALSE(parsed({"--link", "#r=x", "--replay", "a.replay"}).ok()) << "only one run can be replayed";
    EXPECT_FALSE(parsed({"--print-link", "--all-effects"}).ok());
    EXPECT_TRUE(parsed({"--link", "#r=x", "--record", "b.replay", "--print-link"}).ok());
    EXPECT_TRUE(parsed({"--record", "a.replay", "--seed", "7", "--scene", "level2"}).ok());
    EXPECT_TRUE(parsed({"--replay", "a.replay", "--record", "b.replay", "--frames", "9", "--headless"}).ok());
    EXPECT_FALSE(parseGameOptions(std::vector{"--replay=a.replay", "--seed=3"}).ok());
}

TEST(PlayerOptions, theHelpStandsInColumnsThatFitATerminal) {
    const std::string usage = playerUsage();
    ASSERT_EQ(usage.find("usage: plumb-player [PROJECT] [options]\n\n"), 0u);
    const std::vector<std::string_view> lines =
        split(trimmed(std::string_view{usage}.substr(usage.find("\n\n"))), '\n');
    EXPECT_GT(lines.size(), 18u);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_LE(lines[i].size(), 80u) << lines[i];
        ASSERT_GT(lines[i].size(), 26u) << lines[i];
        EXPECT_EQ(lines[i][25], ' ') << lines[i];
        EXPECT_NE(lines[i][26], ' ') << lines[i];
    }
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
                                                                   {"--threads", "65"},
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
         {"--scene",       "--headless",     "--frames",       "--hash",  "--hash-every", "--screenshot",
          "--capture",     "--record",       "--replay",       "--link",  "--print-link", "--effects",
          "--all-effects", "--benchmark",    "--seed",         "--scale", "--fullscreen", "--entities",
          "--window",      "--physics-view", "--crash-reports"}) {
        EXPECT_NE(playerUsage().find(name), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace plumb
