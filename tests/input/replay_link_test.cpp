#include "input/replay_link.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "codec/base64.hpp"
#include "codec/range_coder.hpp"
#include "core/hash.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "input/link_format.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

using link_format::linkOfStream;

std::int16_t anyNumber(Random& random) {
    return static_cast<std::int16_t>(static_cast<int>(random.below(65536)) - 32768);
}

/// Changes a part of the input as a player does, or to anything.
void change(InputFrame& frame, Random& random) {
    PadFrame& pad = frame.pads[random.below(kPadCount)];
    switch (random.below(10)) {
        case 0:
        case 1:
        case 2: {
            const auto key = static_cast<Key>(1 + random.below(random.below(4) == 0 ? kKeyCount - 1 : 6));
            frame.set(key, !frame.has(key));
            return;
        }
        case 3:
            frame.mouseButtons ^= static_cast<std::uint16_t>(1u << random.below(kMouseButtonCount));
            return;
        case 4: frame.mouseX = anyNumber(random), frame.mouseY = anyNumber(random); return;
        case 5: frame.wheelX = anyNumber(random), frame.wheelY = anyNumber(random); return;
        case 6: frame.connectedPads ^= static_cast<std::uint16_t>(1u << random.below(kPadCount)); return;
        case 7: pad.buttons ^= static_cast<std::uint16_t>(1u << random.below(kPadButtonCount)); return;
        case 8: frame.saves ^= 1u << random.below(kSaveSlots); return;
        default: pad.axes[random.below(kPadAxisCount)] = anyNumber(random); return;
    }
}

/// A recording of random input. @param ticks  at least
Recorder randomRun(std::uint64_t seed, std::uint64_t ticks) {
    Random random = Random::seeded(seed);
    Recorder recorder;
    recorder.replay.project = seed % 5 == 0 ? "" : "Ωmega \"Caves\"";
    recorder.replay.engine = "0.1.0";
    recorder.replay.scene = "scenes/title.scene.json";
    recorder.replay.keys = seed % 3 == 0 ? R"({"actions":{"Jump":["K","Pad A"]}})" : "";
    recorder.replay.seed = random.next64();
    InputFrame frame;
    while (recorder.ticks() < ticks) {
        for (std::uint32_t n = random.below(4); n > 0; --n) change(frame, random);
        for (std::uint32_t n = 1 + random.below(random.below(3) == 0 ? 300 : 20); n > 0; --n)
            recorder.record(frame);
    }
    if (random.below(2) == 0) recorder.check(random.next64());
    return recorder;
}

Replay readBack(const Replay& replay) {
    const Result<std::string> link = linkOf(replay);
    if (!link) return ADD_FAILURE() << link.error().text(), Replay{};
    const Result<Replay> read = replayOfLink(*link);
    if (!read) return ADD_FAILURE() << read.error().text(), Replay{};
    return *read;
}

std::string errorOf(std::string_view text) {
    const Result<Replay> replay = replayOfLink(text);
    return replay.ok() ? "no error" : replay.error().text();
}

TEST(ReplayLink, aReplayReadsBackTheSameOverRandomRunsOfUpToFiveMinutes) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        const Replay replay = randomRun(seed, seed % 20 == 0 ? 5 * 3600 : seed * 3).replay;
        ASSERT_EQ(readBack(replay), replay);
    }
}

TEST(ReplayLink, aWriterGivesTheLinkOfEveryTickOfARun) {
    const Replay replay = randomRun(3, 400).replay;
    LinkWriter writer{replay};
    Recorder recorder;
    recorder.replay = replay;
    recorder.replay.runs.clear();
    recorder.replay.checkpoints.clear();
    ReplayPlayer player{replay};
    while (const InputFrame* frame = player.next()) {
        writer.record(*frame);
        recorder.record(*frame);
        Replay wanted = recorder.replay;
        wanted.checkpoints = {{player.tick(), mixBits(player.tick())}};
        const Result<Replay> read = replayOfLink(*writer.link(mixBits(player.tick())));
        ASSERT_TRUE(read) << read.error().text();
        ASSERT_EQ(*read, wanted);
    }
    EXPECT_EQ(writer.ticks(), replay.ticks());
}

TEST(ReplayLink, theTextMayBeAWholeAddressOrItsEnd) {
    const Replay replay = randomRun(1, 100).replay;
    const std::string link = *linkOf(replay);
    ASSERT_EQ(link.substr(0, 3), "#r=");
    for (const std::string& text :
         {link, link.substr(1), link.substr(3), "https://example.org/game/?args=--hash" + link, link + "\n",
          link + "&x=1"})
        EXPECT_EQ(*replayOfLink(text), replay) << text;
    EXPECT_EQ(link.find_first_not_of("#=-_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"),
              std::string::npos)
        << "other characters are changed in addresses and messages";
}

TEST(ReplayLink, aLinkThatAMailHasBrokenOrEscapedIsTheSame) {
    Random random = Random::seeded(5);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Replay replay = randomRun(seed, 100).replay;
        std::string link = linkOf(replay)->substr(3);
        for (int breaks = 0; breaks < 5; ++breaks) {
            const char* space[] = {" ", "\n", "\r\n", "\t", "%20", "%0A", "%0D%0A", "\n  "};
            // Not into an earlier escape.
            const std::size_t at =
                random.below(static_cast<std::uint32_t>(std::min(link.size(), link.find('%'))));
            link.insert(at, space[random.below(std::size(space))]);
        }
        for (const char* start :
             {"#r=", "%23r=", "r=", "https://example.org/game/#r=", "https://example.org/%23r="}) {
            const Result<Replay> read = replayOfLink(start + link);
            ASSERT_TRUE(read.ok()) << read.error().text() << "\n" << start << link;
            EXPECT_EQ(*read, replay);
        }
        EXPECT_EQ(*replayOfLink(*linkOf(replay) + " is my run"), replay);
    }
}

TEST(ReplayLink, whatIsNoLinkIsReportedWithTheReason) {
    EXPECT_EQ(errorOf(""), "link: the link is empty; give the text from #r= on");
    EXPECT_EQ(errorOf("https://example.org/#r="), "link: the link is empty; give the text from #r= on");
    EXPECT_EQ(errorOf("https://example.org/game"),
              "link: the address contains no replay; it must end with #r=...");
    EXPECT_EQ(errorOf("#r=a*b"),
              "link: the link is damaged or incomplete: character 2 is not a base64 digit; copy the whole "
              "link again");
    EXPECT_EQ(errorOf("#r=a+b="),
              "link: the link is damaged or incomplete: character 2 is not a base64url digit; copy the whole "
              "link again");
    EXPECT_EQ(errorOf("#r=AQID"), "link: the link is incomplete; copy the whole link again");
    EXPECT_EQ(errorOf("#r=AgIDBAUGBw"), "link: the link is damaged or incomplete; copy the whole link again");
    EXPECT_EQ(errorOf("#r=AwIDBAUGBw"),
              "link: the link has version 3, this program reads 2; play it with the version of the "
              "game that made it");
    EXPECT_EQ(
        errorOf("#r=" + std::string(kMaxLinkBytes + 1, 'A')),
        format("link: the link has {} characters; the longest have {}", kMaxLinkBytes + 1, kMaxLinkBytes));
}

TEST(ReplayLink, noBeginningOfALinkIsAccepted) {
    const std::string link = *linkOf(randomRun(2, 600).replay);
    for (std::size_t size = 0; size < link.size(); ++size)
        ASSERT_NE(errorOf(link.substr(0, size)), "no error") << size << " of " << link.size();
}

TEST(ReplayLink, anEditedLinkIsRefusedOrTheSame) {
    Random random = Random::seeded(11);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Replay replay = randomRun(seed, 200).replay;
        const std::string link = *linkOf(replay);
        for (int round = 0; round < 50; ++round) {
            const std::string edited =
                round % 2 == 0 ? test::withWrongBytes(link, random) : test::damaged(link, random);
            const Result<Replay> read = replayOfLink(edited);
            ASSERT_TRUE(!read || *read == replay) << edited;
        }
    }
}

TEST(ReplayLink, aLinkMadeOnPurposeIsAReplayOrAnError) {
    Random random = Random::seeded(5);
    std::size_t read = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        const std::string link = *linkOf(randomRun(seed, 100).replay);
        std::string stream = bytesFromBase64Url(link.substr(3), "link")->substr(5);
        const std::size_t names =
            std::min<std::size_t>(45, stream.size() / 2);  // mostly, the input is damaged
        const auto others = static_cast<std::uint32_t>(stream.size() - names);
        for (std::uint32_t n = random.below(3) + 1; n > 0; --n)
            stream[names + random.below(others)] = static_cast<char>(random.next());
        const Result<Replay> replay = replayOfLink(linkOfStream(stream));
        if (!replay) continue;
        ++read;
        ASSERT_LE(replay->ticks(), Replay::kMaxTicks);
        ASSERT_LE(replay->runs.size(), kMaxLinkRuns);
        const Result<Replay> again = parseReplay(writeReplay(*replay), "again");
        ASSERT_TRUE(again) << again.error().text();
        ASSERT_EQ(again->runs, replay->runs);
    }
    EXPECT_GT(read, 40u) << "this test must reach what follows the checks";
}

/// A stream of one tick with this change of the input.
std::string streamOf(const link_format::Change& change) {
    RangeEncoder encoder;
    const auto model = std::make_unique<link_format::LinkModel>();
    std::string empty;
    for (int name = 0; name < 4; ++name) model->code(encoder, empty);  // the keys, too
    encoder.bits(1, 64);
    model->code(encoder, change, link_format::Part::End, {});
    model->endList(encoder, link_format::Part::Key, {});
    model->codeTicks(encoder, 1);
    model->code(encoder, link_format::Change{}, link_format::Part::End, {});
    encoder.bits(0, 1);
    return encoder.finish();
}

TEST(ReplayLink, inputThatNoDeviceGivesIsRefused) {
    using link_format::Change, link_format::Part;
    EXPECT_EQ(errorOf(linkOfStream(streamOf({Part::Key, 1}))), "no error");
    std::vector<Change> impossible{{Part::Key, 0},
                                   {Part::Key, kKeyCount},
                                   {Part::MouseButton, kMouseButtonCount},
                                   {Part::PadButton, kPadButtonCount}};
    for (unsigned part = link_format::kParts; part < 16; ++part)
        impossible.push_back({static_cast<Part>(part)});
    for (const Change& change : impossible)
        EXPECT_EQ(errorOf(linkOfStream(streamOf(change))),
                  "link: the link has input that no device gives; copy the whole link again")
            << static_cast<unsigned>(change.part) << ", " << change.index;
}

TEST(ReplayLink, aStreamOfZerosEnds) {
    EXPECT_EQ(errorOf(linkOfStream({})), "link: the link is incomplete; copy the whole link again");
    for (const std::size_t size : {0u, 1u, 1000u, 89000u})
        EXPECT_NE(errorOf(linkOfStream(std::string(size, '\0'))), "no error") << size;
}

TEST(ReplayLink, aRunThatIsTooLongHasNone) {
    Random random = Random::seeded(9);
    LinkWriter writer{Replay{}};
    InputFrame frame;
    std::uint64_t ticks = 0;
    while (writer.ticks() == ticks) {
        for (std::int16_t& axis : frame.pads[0].axes) axis = anyNumber(random);
        ASSERT_TRUE(ticks != 1000 || writer.link({}).ok());
        writer.record(frame);
        ++ticks;
    }
    EXPECT_EQ(writer.link({}).error().text(),
              format("link: after {} ticks the run is too long for a link; record it "
                     "to a file: --record FILE",
                     writer.ticks()));
    EXPECT_GT(writer.ticks(), 5000u);
}

/// Bytes of a link per minute of the replays of the projects, which are played.
TEST(ReplayLink, aMinuteOfARealGameTakesAtMostTwoKilobytes) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::sourceFolder() / "tests/replay")) {
        if (entry.path().extension() != ".replay") continue;
        ++count;
        const Result<Replay> replay = loadReplay(entry.path());
        ASSERT_TRUE(replay) << replay.error().text();
        const Result<std::string> link = linkOf(*replay);
        ASSERT_TRUE(link) << link.error().text();
        const double minutes = static_cast<double>(replay->ticks()) / 3600.0;
        const double perMinute = static_cast<double>(link->size()) / minutes;
        std::printf("%-18s %6.2f min  %5zu runs  %5zu B  %6.0f B/min\n",
                    entry.path().filename().string().c_str(), minutes, replay->runs.size(), link->size(),
                    perMinute);
        // The names and the hash take about 100 bytes, whatever the length is.
        EXPECT_LE(static_cast<double>(link->size()), 110.0 + 2048.0 * minutes) << entry.path();
        EXPECT_EQ(replayOfLink(*link)->runs, replay->runs);
    }
    EXPECT_GE(count, 5u);
}

}  // namespace
}  // namespace plumb
