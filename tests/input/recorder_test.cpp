#include "input/recorder.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

InputFrame randomFrame(Random& random) {
    InputFrame frame;
    for (std::uint32_t n = random.below(4); n > 0; --n)
        frame.set(static_cast<Key>(1 + random.below(kKeyCount - 1)), true);
    const auto number = [&] {
        return static_cast<std::int16_t>(static_cast<int>(random.below(65535)) - 32767);
    };
    if (random.below(2) == 0) frame.mouseX = number(), frame.mouseY = number();
    if (random.below(4) == 0) frame.wheelY = number();
    frame.mouseButtons = static_cast<std::uint16_t>(random.below(1u << kMouseButtonCount));
    frame.connectedPads = static_cast<std::uint16_t>(random.below(16));
    for (PadFrame& pad : frame.pads) {
        if (random.below(2) == 0) continue;
        pad.buttons = static_cast<std::uint16_t>(random.below(1u << kPadButtonCount));
        for (std::int16_t& axis : pad.axes) axis = number();
    }
    return frame;
}

Recorder randomRecording(std::uint64_t seed) {
    Random random = Random::seeded(seed);
    Recorder recorder;
    recorder.replay.project = "Sky Caves";
    recorder.replay.engine = "0.1.0";
    recorder.replay.scene = "scenes/title.scene.json";
    recorder.replay.seed = random.next64();
    for (std::uint32_t n = random.below(40); n > 0; --n) {
        const InputFrame frame = randomFrame(random);
        for (std::uint32_t ticks = 1 + random.below(20); ticks > 0; --ticks) recorder.record(frame);
        if (random.below(2) == 0) recorder.check(random.next64());
    }
    return recorder;
}

TEST(Recorder, aReplayReadsBackTheSameOverRandomInput) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const Replay replay = randomRecording(seed).replay;

        const Result<Replay> read = parseReplay(writeReplay(replay), "x.replay");

        ASSERT_TRUE(read.ok()) << read.error().text();
        ASSERT_EQ(*read, replay);
        ASSERT_EQ(writeReplay(*read), writeReplay(replay));
    }
}

TEST(Recorder, thePlayerReturnsTheFrameAndCheckpointOfEveryTick) {
    Recorder recorder;
    std::vector<InputFrame> frames;
    Random random = Random::seeded(3);
    for (int i = 0; i < 500; ++i) {
        frames.push_back(i % 7 == 0 || frames.empty() ? randomFrame(random) : frames.back());
        recorder.record(frames.back());
        if (i % 50 == 49) recorder.check(static_cast<std::uint64_t>(i));
    }

    ReplayPlayer player{recorder.replay};
    for (int i = 0; i < 500; ++i) {
        const InputFrame* frame = player.next();
        ASSERT_NE(frame, nullptr);
        ASSERT_EQ(*frame, frames[static_cast<std::size_t>(i)]);
        const HashCheck* check = player.checkpoint();
        ASSERT_EQ(check != nullptr, i % 50 == 49);
        if (check != nullptr) {
            EXPECT_EQ(check->hash, static_cast<std::uint64_t>(i));
        }
    }
    EXPECT_EQ(player.next(), nullptr);
    EXPECT_EQ(recorder.ticks(), 500u);
}

TEST(Recorder, aTickIsCheckedOnce) {
    Recorder recorder;
    recorder.record({});
    recorder.check(7);
    recorder.check(7);  // of the last tick, at the end of the game
    ASSERT_EQ(recorder.replay.checkpoints.size(), 1u);
    EXPECT_EQ(recorder.replay.checkpoints[0].tick, 1u);
}

TEST(Recorder, beyondTheMostChangesNothingIsRecordedAtAWrongTick) {
    Recorder recorder;
    InputFrame frame;
    for (std::size_t i = 0; i < Replay::kMaxRuns; ++i) {
        frame.set(Key::A, i % 2 == 0);
        recorder.record(frame);
    }
    recorder.check(1);
    EXPECT_FALSE(recorder.full());
    InputFrame other = frame;
    other.set(Key::B, true);
    recorder.record(other);
    EXPECT_TRUE(recorder.full());
    recorder.record(frame);
    recorder.check(2);
    EXPECT_EQ(recorder.ticks(), Replay::kMaxRuns);
    ASSERT_EQ(recorder.replay.checkpoints.size(), 1u);
    EXPECT_EQ(recorder.replay.checkpoints[0], (HashCheck{Replay::kMaxRuns, 1}));
}

TEST(Recorder, theFileListsInputChangesAsText) {
    Recorder recorder;
    recorder.replay.project = "Sky\nCaves";
    recorder.replay.seed = 42;
    InputFrame frame;
    for (int i = 0; i < 30; ++i) recorder.record(frame);
    frame.set(Key::Right, true);
    for (int i = 0; i < 12; ++i) recorder.record(frame);
    frame.set(Key::Right, false);
    frame.mouseX = 120;
    frame.pads[0].axes[0] = -32767;
    recorder.record(frame);

    EXPECT_EQ(writeReplay(recorder.replay),
              "plumb-replay 1\nproject Sky Caves\nengine \nscene \nseed 000000000000002a\n"
              "30\n12 +Right\n1 -Right mouse=120,0 Gamepad1.LeftX=-32767\nend 43\n");
}

TEST(Recorder, invalidReplaysAreRejectedWithTheLine) {
    const std::string head = "plumb-replay 1\n";
    const std::string broken[] = {"",
                                  "x",
                                  "plumb-replay",
                                  "plumb-replay \n",
                                  "plumb-replay 3\nend 0\n",
                                  "plumb-replay 0\nend 0\n",
                                  head,
                                  head + "end 1\n",
                                  head + "end\n",
                                  head + "5 +Right\nend 4\n",
                                  head + "0 +Right\nend 0\n",
                                  head + "-1\nend 0\n",
                                  head + "5 +Nothing\nend 5\n",
                                  head + "5 -Right\nend 5\n",
                                  head + "5 +Right\n1 +Right\nend 6\n",
                                  head + "5  +Right\nend 5\n",
                                  head + "5 mouse=1\nend 5\n",
                                  head + "5 mouse=40000,0\nend 5\n",
                                  head + "5 Gamepad9.LeftX=1\nend 5\n",
                                  head + "5 Gamepad1.=1\nend 5\n",
                                  head + "5 +Gamepad1.\nend 5\n",
                                  head + "\nend 0\n",
                                  head + "what 5\nend 0\n",
                                  head + "seed x\nend 0\n",
                                  head + "check 5\nend 0\n",
                                  head + "check 5 1\ncheck 5 2\nend 0\n",
                                  head + "end 0\nmore",
                                  head + "99999999999\nend 99999999999\n",
                                  head + "5184000\n1\nend 5184001\n",
                                  head + "99999999999999999999\nend 0\n",
                                  head + "project \xff\nend 0\n",
                                  head + "project " + std::string(2000, 'x') + "\nend 0\n"};
    for (const std::string& text : broken) {
        const Result<Replay> result = parseReplay(text, "x.replay");
        ASSERT_FALSE(result.ok()) << text;
        EXPECT_EQ(result.error().where.substr(0, 9), "x.replay:");
        EXPECT_FALSE(result.error().what.empty());
        EXPECT_FALSE(result.error().remedy.empty());
    }
    EXPECT_TRUE(parseReplay(head + "5184000 +Right\r\nend 5184000\n", "x").ok());
}

TEST(Recorder, everyTruncatedReplayIsRejected) {
    const std::string text = writeReplay(randomRecording(7).replay);
    for (std::size_t length = 0; length + 1 < text.size(); length += 11) {
        const Result<Replay> cut = parseReplay(text.substr(0, length), "x");
        // A last line without its last digits may be another valid number, which contradicts the ticks
        // before.
        ASSERT_FALSE(cut.ok()) << length;
    }
}

TEST(Recorder, randomMutationsNeverCrashAndReadFilesAreWrittenBackUnchanged) {
    const std::string good = writeReplay(randomRecording(11).replay);
    Random random = Random::seeded(1);
    for (int i = 0; i < 800; ++i) {
        const std::string text = test::withWrongBytes(good, random);
        const Result<Replay> read = parseReplay(text, "x");
        if (!read.ok()) continue;
        ASSERT_TRUE(parseReplay(writeReplay(*read), "x").ok());
    }
}

TEST(RecordingFile, isTheWholeReplayAfterEveryUpdate) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const test::TemporaryFolder folder;
        const Path path = folder.path / "deep" / "run.replay";
        Random random = Random::seeded(seed);
        Recorder recorder;
        recorder.replay.project = "Sky Caves";
        recorder.replay.seed = random.next64();
        Result<RecordingFile> file = RecordingFile::create(path, recorder.replay);
        ASSERT_TRUE(file.ok()) << file.error().text();
        ASSERT_EQ(*loadReplay(path), recorder.replay);
        InputFrame frame;
        for (int i = 0; i < 150; ++i) {
            if (random.below(3) == 0) frame = randomFrame(random);
            // More than one tick between two updates, or none.
            for (std::uint32_t ticks = random.below(4); ticks > 0; --ticks) recorder.record(frame);
            if (random.below(5) == 0) recorder.check(random.next64());
            ASSERT_TRUE(file->update(recorder).ok());
            const Result<Replay> read = loadReplay(path);
            ASSERT_TRUE(read.ok()) << read.error().text();
            ASSERT_EQ(*read, recorder.replay) << i;
        }
    }
}

TEST(RecordingFile, onAFullDiskItKeepsTheTicksThatTheErrorNames) {
    const test::TemporaryFolder folder;
    const Path path = folder.path / "run.replay";
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Recorder recorder;
        Result<RecordingFile> file = RecordingFile::create(path, recorder.replay);
        ASSERT_TRUE(file.ok());
        const test::FileSizeLimit limit{std::filesystem::file_size(path) + random.below(400)};
        Replay written = recorder.replay;
        Result<Done> done{Done{}};
        for (InputFrame frame; done.ok() && recorder.ticks() < 2000;) {
            if (random.below(8) == 0) frame = randomFrame(random);
            recorder.record(frame);
            if (random.below(8) == 0) recorder.check(random.next64());
            done = file->update(recorder);
            if (done.ok()) written = recorder.replay;
        }
        const Result<Replay> read = loadReplay(path);
        ASSERT_TRUE(read.ok()) << read.error().text();
        ASSERT_EQ(*read, written);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().where, path.generic_string());
        EXPECT_EQ(done.error().what.find(format("the recording ends after {} ticks: ", read->ticks())), 0u)
            << done.error().text();
    }
}

TEST(RecordingFile, thatCannotBeCreatedIsAnErrorWithTheReason) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder.path / "file", "x").ok());
    const Result<RecordingFile> file = RecordingFile::create(folder.path / "file" / "run.replay", {});
    ASSERT_FALSE(file.ok());
    EXPECT_FALSE(file.error().remedy.empty());
}

TEST(Recorder, aSavedReplayLoadsAndAMissingOneIsAnError) {
    const test::TemporaryFolder folder;
    const Replay replay = randomRecording(2).replay;
    ASSERT_TRUE(writeFile(folder.path / "a" / "run.replay", writeReplay(replay)).ok());

    EXPECT_EQ(*loadReplay(folder.path / "a" / "run.replay"), replay);
    EXPECT_FALSE(loadReplay(folder.path / "none.replay").ok());
}

}  // namespace
}  // namespace plumb
