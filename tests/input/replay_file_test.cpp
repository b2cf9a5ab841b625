#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "input/recorder.hpp"

namespace plumb {
namespace {

const std::string kHead = "plumb-replay 1\n";

/// The whole text of the error, or "no error".
std::string errorOf(std::string_view text) {
    const Result<Replay> replay = parseReplay(text, "run.replay");
    return replay.ok() ? "no error" : replay.error().text();
}

/// The error in the second line of a replay.
std::string lineError(const std::string& what) {
    return "run.replay:2: " + what + "; record it again, or correct the line";
}

TEST(ReplayFile, theFirstLineNamesTheFormat) {
    const std::string none = "run.replay:1: the file is not a replay; record it again";
    const std::string number = "run.replay:1: the replay has no valid format number; record it again";
    for (const char* text : {"", "x", "plumb-replay", "plumb-replay1\nend 0\n", "plumb-replayx 1\nend 0\n",
                             " plumb-replay 1\nend 0\n"})
        EXPECT_EQ(errorOf(text), none) << text;
    for (const char* text : {"plumb-replay ", "plumb-replay x\nend 0\n", "plumb-replay 0\nend 0\n",
                             "plumb-replay -1\nend 0\n", "plumb-replay 1000001\nend 0\n"})
        EXPECT_EQ(errorOf(text), number) << text;
    EXPECT_EQ(errorOf("plumb-replay 3\nend 0\n"),
              "run.replay:1: the replay has format 3, this program reads up to 2; record it again");
    EXPECT_EQ(errorOf("plumb-replay 1000000\nend 0\n"),
              "run.replay:1: the replay has format 1000000, this program reads up to 2; record it again");
    EXPECT_EQ(errorOf("plumb-replay 1\nend 0"), "no error") << "without a line break at the end";
    EXPECT_EQ(errorOf("plumb-replay 1\r\nend 0\r\n"), "no error");
}

TEST(ReplayFile, whatIsNoTextOrTooLargeIsNotRead) {
    EXPECT_EQ(errorOf(kHead + "project \xff\nend 0\n"),
              "run.replay:0: the text is not UTF-8; record it again");
    // Only the first byte is touched, so that the memory is only reserved.
    const std::unique_ptr<char[]> memory{new char[Replay::kMaxBytes + 1]};
    memory[0] = '\xff';
    EXPECT_EQ(errorOf({memory.get(), Replay::kMaxBytes}),
              "run.replay:0: the text is not UTF-8; record it again");
    EXPECT_EQ(errorOf({memory.get(), Replay::kMaxBytes + 1}),
              "run.replay:0: the file is too large; record less");
}

TEST(ReplayFile, aDamagedReportOfACrashIsNotToBeRecordedAgain) {
    for (const char* text : {"plumb-replay 2\npacked 9\nx\nend 1\n", "plumb-replay 2\ncrash x\n",
                             "plumb-replay 2\nwrong\nend 0\n"}) {
        EXPECT_NE(errorOf(text).find("get the report again from the player"), std::string::npos)
            << errorOf(text);
        EXPECT_EQ(errorOf(text).find("record it again"), std::string::npos) << errorOf(text);
    }
}

TEST(ReplayFile, theLastLineHasTheNumberOfTicks) {
    const std::string open = "the file has no \"end\" line: it is incomplete; record it again";
    EXPECT_EQ(errorOf(kHead), "run.replay:1: " + open);
    EXPECT_EQ(errorOf(kHead + "5\n3 +A\n"), "run.replay:3: " + open);
    EXPECT_EQ(
        errorOf(kHead + "5\n3 +A\nend 7\n"),
        "run.replay:4: expected 8, the number of ticks in the lines above; record it again, or correct the "
        "line");
    EXPECT_EQ(errorOf(kHead + "end\n"), lineError("expected 0, the number of ticks in the lines above"));
    EXPECT_EQ(errorOf(kHead + "end 0\n \n\n"), "no error");
    EXPECT_EQ(errorOf(kHead + "end 0\nmore\n"),
              "run.replay:2: there is text after the \"end\" line; remove it");
}

TEST(ReplayFile, everyOtherLineIsReportedWithItsReason) {
    const std::string check = "expected a tick and a hash after \"check\"";
    const std::string x40(40, 'x');
    const struct {
        std::string line;
        std::string what;
    } cases[] = {
        {"", "the line is empty"},
        {"/5", "unknown keyword \"/5\""},
        {":5", "unknown keyword \":5\""},
        {"what 5", "unknown keyword \"what\""},
        {"5x", "expected 1 to 5184000 ticks"},
        {x40 + "y 5", "unknown keyword \"" + x40 + "\""},
        {"project " + std::string(1025, 'x'), "the name is longer than 1024 bytes"},
        {"seed", "the seed is not a hexadecimal number"},
        {"seed 0x5", "the seed is not a hexadecimal number"},
        {"check", check},
        {"check 5", check},
        {"check 5 x", check},
        {"check x 5", check},
        {"check -1 5", check},
        {"check 5184001 5", check},
        {"0 +A", "expected 1 to 5184000 ticks"},
        {"5184001", "expected 1 to 5184000 ticks"},
        {"99999999999999999999", "expected 1 to 5184000 ticks"},
    };
    for (const auto& test : cases) EXPECT_EQ(errorOf(kHead + test.line + "\nend 0\n"), lineError(test.what));
    EXPECT_EQ(errorOf(kHead + "9\n5183992 +A\nend 5184001\n"),
              "run.replay:3: expected 1 to 5183991 ticks; record it again, or correct the line");
    EXPECT_EQ(errorOf(kHead + "9\n5183991 +A\nend 5184000\n"), "no error");
    EXPECT_EQ(
        errorOf(kHead + "check 7 1\ncheck 7 2\nend 0\n"),
        "run.replay:3: the checks are not in order of their ticks; record it again, or correct the line");
    EXPECT_EQ(errorOf(kHead + "check 7 1\ncheck 8 2\ncheck 5184000 3\nend 0\n"), "no error");
}

TEST(ReplayFile, invalidChangesOfTheInputAreReported) {
    for (const char* word : {"",
                             "+",
                             "-",
                             "A",
                             "x",
                             "=",
                             "=1",
                             "+Nothing",
                             "-A",
                             "+Mouse",
                             "+Mouse.",
                             "+Mouse.Up",
                             "-Mouse.Left",
                             "+Gamepad",
                             "+Gamepad0",
                             "+Gamepad5",
                             "+Gamepat1",
                             "Joystic1.LeftX=1",
                             "-Gamepad1",
                             "+Gamepad1.",
                             "+Gamepad1x",
                             "+Gamepad1xA",
                             "+Gamepad1.Q",
                             "-Gamepad1.A",
                             "+Gamepad0.A",
                             "+Gamepad5.A",
                             "+Gamepad1.LeftX",
                             "mouse",
                             "mouse=",
                             "mouse=1",
                             "mouse=,",
                             "mouse=1,",
                             "mouse=,1",
                             "mouse=x,1",
                             "mouse=1,x",
                             "mouse=1,2,3",
                             "mouse=32768,0",
                             "mouse=0,-32769",
                             "wheel=1",
                             "wheel=1,x",
                             "LeftX=1",
                             "Gamepad1=1",
                             "Gamepad1.=1",
                             "Gamepad1.A=1",
                             "Gamepad1.LeftX=",
                             "Gamepad1.LeftX=x",
                             "Gamepad1.LeftX=1.5",
                             "Gamepad1.LeftX=32768",
                             "Gamepad5.LeftX=1"}) {
        EXPECT_EQ(errorOf(kHead + "5 " + word + "\nend 5\n"),
                  lineError(format("\"{}\" is not a valid change of the input", word)));
    }
    EXPECT_EQ(errorOf(kHead + "1 +A +A\nend 1\n"), lineError("\"+A\" is not a valid change of the input"))
        << "it is held already";
    EXPECT_EQ(errorOf(kHead + "1  +A\nend 1\n"), lineError("\"\" is not a valid change of the input"));
    const std::string long40 = "+" + std::string(39, 'x');
    EXPECT_EQ(errorOf(kHead + "1 " + long40 + "y\nend 1\n"),
              lineError("\"" + long40 + "\" is not a valid change of the input"));
}

TEST(ReplayFile, changesAreReadAndWrittenAsText) {
    InputFrame first;
    first.set(Key::A, true);
    first.set(Key::Menu, true);
    first.mouseButtons = 1u | 1u << static_cast<unsigned>(MouseButton::X2);
    first.mouseX = -3;
    first.mouseY = 32'767;
    first.wheelX = 5;
    first.wheelY = -32'767;
    first.connectedPads = 1u | 1u << 3;
    first.pads[0].buttons = 1;
    first.pads[0].axes[0] = 7;
    first.pads[3].buttons = 1u << static_cast<unsigned>(PadButton::Right);
    first.pads[3].axes[kPadAxisCount - 1] = -8;
    Replay replay;
    replay.project = std::string(1024, 'p');
    replay.engine = "1.2";
    replay.scene = "a b.scene.json";
    replay.seed = 0x123456789abcdef0u;
    replay.runs = {{first, 3}, {InputFrame{}, 4}};
    replay.checkpoints = {{0, 1}, {7, 0xffffffffffffffffu}};
    const std::string text =
        "plumb-replay 1\nproject " + replay.project +
        "\nengine 1.2\nscene a b.scene.json\nseed 123456789abcdef0\n"
        "3 +A +Menu +Mouse.Left +Mouse.X2 mouse=-3,32767 wheel=5,-32767 +Gamepad1 +Gamepad1.A "
        "Gamepad1.LeftX=7 "
        "+Gamepad4 +Gamepad4.Right Gamepad4.RightTrigger=-8\n"
        "4 -A -Menu -Mouse.Left -Mouse.X2 mouse=0,0 wheel=0,0 -Gamepad1 -Gamepad1.A Gamepad1.LeftX=0 "
        "-Gamepad4 -Gamepad4.Right Gamepad4.RightTrigger=0\n"
        "check 0 0000000000000001\ncheck 7 ffffffffffffffff\nend 7\n";
    EXPECT_EQ(writeReplay(replay), text);
    const Result<Replay> read = parseReplay(text, "run.replay");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(*read, replay);
}

TEST(ReplayFile, anyFrameReadsBack) {
    InputFrame least;
    least.setMouse({-1e9f, -1e9f});  // far outside the window, as after it was made very small
    least.wheelX = least.wheelY = -32'768;
    for (PadFrame& pad : least.pads) pad.axes.fill(-32'768);
    InputFrame most;
    for (std::size_t i = 1; i < kKeyCount; ++i) most.set(static_cast<Key>(i), true);
    most.setMouse({1e9f, 1e9f});
    most.mouseButtons = (1u << kMouseButtonCount) - 1;
    most.connectedPads = (1u << kPadCount) - 1;
    for (PadFrame& pad : most.pads) {
        pad.buttons = (1u << kPadButtonCount) - 1;
        pad.axes.fill(32'767);
    }
    Replay replay;
    replay.runs = {{least, 1}, {most, 2}, {InputFrame{}, 3}};
    const Result<Replay> read = parseReplay(writeReplay(replay), "run.replay");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(*read, replay);
}

TEST(ReplayFile, aLongOrStrangeNameIsWrittenOnOneLineThatReadsBack) {
    const struct {
        std::string name;
        std::string read;
    } cases[] = {{"tab\tbreak\nunit\x1f|", "tab break unit |"},
                 {"space delete\x7f größe", "space delete\x7f größe"},
                 {std::string(1024, 'x'), std::string(1024, 'x')},
                 {std::string(1025, 'x'), std::string(1024, 'x')},
                 {std::string(1022, 'x') + "öö", std::string(1022, 'x') + "ö"},
                 {std::string(1023, 'x') + "ö", std::string(1023, 'x')},
                 {std::string(1022, 'x') + "€", std::string(1022, 'x')}};
    for (const auto& test : cases) {
        Replay replay;
        replay.project = replay.engine = replay.scene = test.name;
        const Result<Replay> read = parseReplay(writeReplay(replay), "run.replay");
        ASSERT_TRUE(read.ok()) << read.error().text();
        EXPECT_EQ(read->project, test.read);
        EXPECT_EQ(read->engine, test.read);
        EXPECT_EQ(read->scene, test.read);
    }
}

TEST(ReplayFile, linesWithoutAChangeAreJoinedAndRunsWithoutTicksAreNotWritten) {
    const Result<Replay> read = parseReplay(kHead + "5\n3\n2 +A\n1 -A +A\n4 -A\nend 15\n", "run.replay");
    ASSERT_TRUE(read.ok()) << read.error().text();
    InputFrame held;
    held.set(Key::A, true);
    EXPECT_EQ(read->runs, (std::vector<InputRun>{{InputFrame{}, 8}, {held, 3}, {InputFrame{}, 4}}));
    EXPECT_EQ(read->ticks(), 15u);

    Replay replay;
    replay.runs = {{held, 0}, {InputFrame{}, 5}, {held, 0}, {held, 1}, {InputFrame{}, 0}};
    EXPECT_EQ(writeReplay(replay),
              kHead + "project \nengine \nscene \nseed 0000000000000001\n5\n1 +A\nend 6\n");
}

TEST(ReplayPlayerTest, runsWithoutTicksAreSkippedAndTheEndStaysTheEnd) {
    InputFrame frames[4];
    for (std::size_t i = 0; i < 4; ++i) frames[i].mouseX = static_cast<std::int16_t>(i);
    Replay replay;
    replay.runs = {{frames[0], 0}, {frames[1], 2}, {frames[2], 0},
                   {frames[0], 0}, {frames[3], 1}, {frames[0], 0}};
    replay.runs.pop_back();  // what follows the runs in memory is no run
    replay.checkpoints = {{0, 10}, {2, 12}, {3, 13}};
    ReplayPlayer player{replay};
    EXPECT_EQ(player.tick(), 0u);
    ASSERT_NE(player.checkpoint(), nullptr);
    EXPECT_EQ(player.checkpoint()->hash, 10u);
    const int order[] = {1, 1, 3};
    for (std::size_t i = 0; i < 3; ++i) {
        const InputFrame* frame = player.next();
        ASSERT_NE(frame, nullptr);
        EXPECT_EQ(frame->mouseX, order[i]);
        EXPECT_EQ(player.tick(), i + 1);
        ASSERT_EQ(player.checkpoint() != nullptr, i > 0);
        if (i > 0) {
            EXPECT_EQ(player.checkpoint()->hash, 11 + i);
        }
    }
    for (int i = 0; i < 3; ++i) EXPECT_EQ(player.next(), nullptr);
    EXPECT_EQ(player.tick(), 3u);
    const Replay none;
    EXPECT_EQ(ReplayPlayer{none}.next(), nullptr);
}

TEST(RecorderTest, checksAreKeptUpToTheLimitAndOncePerTick) {
    Recorder recorder;
    recorder.check(5);
    recorder.check(6);  // still before the first tick
    EXPECT_EQ(recorder.replay.checkpoints, (std::vector<HashCheck>{{0, 5}}));
    recorder.record({});
    recorder.check(7);
    recorder.record({});
    recorder.record({});
    recorder.check(8);
    EXPECT_EQ(recorder.replay.checkpoints, (std::vector<HashCheck>{{0, 5}, {1, 7}, {3, 8}}));

    recorder.replay.checkpoints.assign(Replay::kMaxCheckpoints - 1, HashCheck{});
    recorder.check(9);
    ASSERT_EQ(recorder.replay.checkpoints.size(), Replay::kMaxCheckpoints);
    EXPECT_EQ(recorder.replay.checkpoints.back(), (HashCheck{3, 9}));
    recorder.record({});
    recorder.check(10);
    EXPECT_EQ(recorder.replay.checkpoints.size(), Replay::kMaxCheckpoints);
}

}  // namespace
}  // namespace plumb
