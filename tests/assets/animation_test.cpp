#include "assets/animation.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/damage.hpp"

namespace plumb {
namespace {

constexpr std::string_view kFull = R"({
  "format": 1,
  "image": "assets/player.png",
  "frameSize": [24, 32],
  "clips": [
    {"name": "idle", "loop": "pingPong", "frames": [{"cell": [0, 0], "seconds": 0.5}]},
    {
      "name": "run",
      "loop": "loop",
      "frames": [{"cell": [0, 1], "seconds": 0.08, "event": "step"}, {"cell": [1, 1], "seconds": 0.08}]
    }
  ],
  "parameters": [{"name": "speed", "kind": "float", "default": 0}, {"name": "hit", "kind": "trigger", "default": 0}],
  "states": [{"name": "idle", "clip": "idle"}, {"name": "run", "clip": "run", "speed": 1.5}],
  "transitions": [
    {"from": "*", "to": "idle", "when": [{"parameter": "hit", "is": "==", "value": 1}], "afterEnd": true},
    {"from": "idle", "to": "run", "when": [{"parameter": "speed", "is": ">=", "value": 5}]}
  ]
}
)";

AnimationSet parsed(std::string_view text, std::vector<Error>& problems) {
    const Result<AnimationSet> result = parseAnimationSet(text, "player.anim.json", problems);
    EXPECT_TRUE(result.ok()) << text;
    return result.ok() ? *result : AnimationSet{};
}

TEST(AnimationSet, everyPropertyIsReadAndWrittenBackByteForByte) {
    std::vector<Error> problems;
    const AnimationSet set = parsed(kFull, problems);

    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(writeAnimationSet(set), kFull);
    EXPECT_EQ(set.clips[1].frames[0].event, "step");
    EXPECT_EQ(set.states[1].clip, set.findClip("run"));
    EXPECT_EQ(set.transitions[0].from, AnimationTransition::kAnyState);
    EXPECT_EQ(set.findState("none"), -1);
}

TEST(AnimationSet, samplePlayerAnimationsAreIdleRunAndJumpOnASheetOfFourCells) {
    const AnimationSet set = animationSetOf(playerAnimations);

    for (const char* name : {"idle", "run", "jump"}) EXPECT_GE(set.findClip(name), 0) << name;
    for (const Animation& clip : set.clips) {
        EXPECT_FALSE(clip.frames.empty());
        for (const AnimationFrame& frame : clip.frames) EXPECT_LT(frame.cellX, 4);
    }
}

TEST(AnimationSet, invalidPartsAreReportedAndIgnored) {
    const std::string_view wrong[] = {R"({"clips": 1})",
                                      R"({"clips": [{"name": "a", "frames": []}]})",
                                      R"({"clips": [{"frames": [{"cell": [-1, 0]}]}]})",
                                      R"({"clips": [{"frames": [{"seconds": 0}]}]})",
                                      R"({"clips": [{"loop": "forever", "frames": [{}]}]})",
                                      R"({"states": [{"name": "a", "clip": "none"}]})",
                                      R"({"frameSize": [-1, 4]})",
                                      R"({"frameSize": [1e20, 4]})",
                                      R"({"parameters": [{"name": "a", "kind": "int"}]})",
                                      R"({"parameters": [{"default": "x"}]})",
                                      R"({"clip": []})",
                                      R"({"transitions": [{"from": "*", "to": "nowhere"}]})"};
    for (const std::string_view text : wrong) {
        std::vector<Error> problems;
        const AnimationSet set = parsed(text, problems);
        EXPECT_EQ(problems.size(), 1u) << text;
        EXPECT_TRUE(set.transitions.empty());
        EXPECT_TRUE(set.states.empty());
    }
}

TEST(AnimationSet, aTransitionWithAnInvalidConditionIsIgnored) {
    std::string text{kFull};
    text.replace(text.find("\"parameter\": \"speed\""), 20, "\"parameter\": \"speex\"");
    std::vector<Error> problems;

    EXPECT_EQ(parsed(text, problems).transitions.size(), 1u);

    EXPECT_EQ(problems.size(), 1u);
}

TEST(AnimationSet, randomMutationsNeverCrashAndReadFilesAreWrittenBackUnchanged) {
    Random random = Random::seeded(3);
    for (int i = 0; i < 3000; ++i) {
        const std::string text = test::withWrongBytes(std::string{kFull}, random);
        std::vector<Error> problems;
        const Result<AnimationSet> read = parseAnimationSet(text, "x", problems);
        if (!read.ok()) continue;
        const std::string written = writeAnimationSet(*read);
        const Result<AnimationSet> again = parseAnimationSet(written, "x", problems);
        ASSERT_TRUE(again.ok()) << written;
        ASSERT_EQ(writeAnimationSet(*again), written);
    }
}

}  // namespace
}  // namespace plumb
