#include "audio/mixer.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "core/random.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::string little(std::uint32_t value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
    return bytes;
}

/// Returns a WAV file of silence: 16 bits, mono, 8000 Hz.
std::string wavOf(std::uint32_t samples) {
    const std::uint32_t bytes = samples * 2;
    return "RIFF" + little(36 + bytes, 4) + "WAVEfmt " + little(16, 4) + little(1, 2) + little(1, 2) +
           little(8000, 4) + little(16000, 4) + little(2, 2) + little(16, 2) + "data" + little(bytes, 4) +
           std::string(bytes, '\0');
}

/// An audio device that records every call.
class ListeningDevice final : public AudioDevice {
public:
    explicit ListeningDevice(std::vector<std::string>& calls) : calls_{calls} {}

    Result<SoundHandle> load(std::string_view wav, std::string_view where) override {
        const Result<WavHeader> header = readWavHeader(wav, where);
        if (!header) return header.error();
        calls_.push_back("load " + std::string{where});
        return loaded_++;
    }
    void unload(SoundHandle) override { calls_.push_back("unload"); }
    Voice play(SoundHandle sound, float volume, float pan, bool looped) override {
        calls_.push_back(format("play {} {} {}{}", sound, volume, pan, looped ? " looped" : ""));
        return 0;
    }
    void adjust(Voice, float, float) override {}
    void stop(Voice) override { calls_.push_back("stop"); }
    [[nodiscard]] bool isPlaying(Voice) const override { return false; }
    Result<Done> playMusic(std::string_view, std::string_view where, bool, float) override {
        calls_.push_back("music " + std::string{where});
        return Done{};
    }
    void setMusicVolume(float volume) override { calls_.push_back(format("music volume {}", volume)); }
    void stopMusic(float) override { calls_.push_back("stop music"); }
    void setPaused(bool) override {}

private:
    std::vector<std::string>& calls_;
    SoundHandle loaded_ = 0;
};

class MixerTest : public ::testing::Test {
protected:
    void SetUp() override {
        assets_.logging = false;
        before_ = setLogSink([this](const LogLine& line) { log_.push_back(line.text); });
        ASSERT_TRUE(writeFile(folder_.path / "jump.wav", wavOf(100)).ok());
        ASSERT_TRUE(writeFile(folder_.path / "bad.wav", "no sound").ok());
        jump_ = assets_.loadSound("jump.wav");
        bad_ = assets_.loadSound("bad.wav");
        missing_ = assets_.loadSound("missing.wav");
    }
    void TearDown() override { setLogSink(before_); }

    Mixer::OpenDevice listening() {
        return [this]() -> Result<std::unique_ptr<AudioDevice>> {
            ++opened_;
            return std::unique_ptr<AudioDevice>{std::make_unique<ListeningDevice>(calls_)};
        };
    }

    test::TemporaryFolder folder_;
    AssetStore assets_{folder_.path};
    std::vector<std::string> calls_;
    std::vector<std::string> log_;
    LogSink before_;
    int opened_ = 0;
    SoundId jump_;
    SoundId bad_;
    SoundId missing_;
};

TEST_F(MixerTest, theFirstSoundOpensTheDeviceAndItsFileIsLoadedOnce) {
    Mixer mixer{assets_, listening()};
    mixer.setMasterVolume(0.5f);
    EXPECT_EQ(opened_, 0);

    mixer.play(jump_, {.volume = 0.5f, .pan = -1.0f});
    mixer.play(jump_, {.looped = true});

    EXPECT_EQ(opened_, 1);
    EXPECT_EQ(calls_, (std::vector<std::string>{"load jump.wav", "play 0 0.25 -1", "play 0 0.5 0 looped"}));
}

TEST_F(MixerTest, withoutADeviceTheGameIsSilentAndLogsOneWarning) {
    int asked = 0;
    Mixer mixer{assets_, [&]() -> Result<std::unique_ptr<AudioDevice>> {
                    ++asked;
                    return Error{"audio", "no sound device", "the game runs without sound"};
                }};
    for (int i = 0; i < 3; ++i) EXPECT_EQ(mixer.play(jump_), -1);
    mixer.playMusic(jump_);
    mixer.setVolume(SoundGroup::Music, 0.2f);
    mixer.stopMusic();
    mixer.stop(0);
    mixer.setPaused(true);

    EXPECT_EQ(asked, 1);
    EXPECT_EQ(log_.size(), 1u);
}

TEST_F(MixerTest, aHeadlessMixerNeverOpensADevice) {
    Mixer mixer{assets_, nullptr};
    EXPECT_EQ(mixer.play(jump_), -1);
    EXPECT_FALSE(mixer.isOpen());
}

TEST_F(MixerTest, missingAndDamagedSoundsAreSilentAndADamagedOneIsReportedOnce) {
    Mixer mixer{assets_, listening()};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(mixer.play(bad_), -1);
        EXPECT_EQ(mixer.play(missing_), -1);
        EXPECT_EQ(mixer.play(SoundId{}), -1);
    }
    EXPECT_TRUE(calls_.empty());
    EXPECT_EQ(log_.size(), 1u);
}

TEST_F(MixerTest, aChangedSoundFileIsLoadedAgain) {
    Mixer mixer{assets_, listening()};
    mixer.play(jump_);
    ASSERT_TRUE(writeFile(folder_.path / "jump.wav", wavOf(200)).ok());
    EXPECT_EQ(assets_.pollChanges().size(), 1u);
    mixer.play(jump_);

    EXPECT_EQ(calls_, (std::vector<std::string>{"load jump.wav", "play 0 1 0", "unload", "load jump.wav",
                                                "play 1 1 0"}));
}

TEST_F(MixerTest, groupsAndMasterScaleTheMusicToo) {
    Mixer mixer{assets_, listening()};
    mixer.playMusic(jump_, 0.5f);
    mixer.playMusic(jump_, 0.5f);
    mixer.setVolume(SoundGroup::Music, 0.5f);
    mixer.stopMusic();

    EXPECT_EQ(calls_, (std::vector<std::string>{"music volume 0.5", "music jump.wav", "music volume 0.5",
                                                "music volume 0.25", "stop music"}));
}

TEST_F(MixerTest, aTickThatIsRepeatedPlaysItsSoundsOnce) {
    Mixer mixer{assets_, listening()};
    SoundQueue queue;
    const auto runTick = [&](std::uint64_t tick) {
        if (tick % 2 == 0) queue.add({tick, jump_, 1.0f, 0.0f});
        mixer.play(queue);
    };
    for (std::uint64_t tick = 0; tick < 10; ++tick) runTick(tick);
    for (std::uint64_t tick = 4; tick < 12; ++tick) runTick(tick);  // a rollback of six ticks

    EXPECT_EQ(std::count(calls_.begin(), calls_.end(), "play 0 1 0"), 6);
}

TEST_F(MixerTest, soundsPlayAgainAfterALongRewindOrAReset) {
    SoundQueue queue;
    queue.add({5000, jump_});
    queue.add({0, jump_});
    EXPECT_EQ(queue.waiting().size(), 1u);
    EXPECT_EQ(queue.waiting()[0].tick, 0u);
    queue.reset();
    queue.add({0, jump_});
    EXPECT_EQ(queue.waiting().size(), 1u);
    for (std::uint64_t tick = 0; tick < 2000; ++tick) queue.add({tick, jump_});
    EXPECT_EQ(queue.waiting().size(), 2000u);
}

TEST_F(MixerTest, theRealDevicePlaysAndStopsWithTheDummyDriver) {
    ::setenv("SDL_AUDIODRIVER", "dummy", 1);
    Mixer mixer{assets_};
    const AudioDevice::Voice voice = mixer.play(jump_, {.pan = 0.5f, .looped = true});
    EXPECT_TRUE(mixer.isOpen());
    EXPECT_GE(voice, 0);
    mixer.playMusic(jump_);
    mixer.setPaused(true);
    mixer.setPaused(false);
    mixer.stop(voice);
    mixer.stopMusic();
    EXPECT_EQ(mixer.play(bad_), -1);
}

TEST(WavHeader, sizeAndLengthAreReadAndInvalidHeadersRejected) {
    const std::string wav = wavOf(8000);
    const Result<WavHeader> header = readWavHeader(wav, "x.wav");
    ASSERT_TRUE(header.ok());
    EXPECT_EQ(header->channels, 1);
    EXPECT_EQ(header->rate, 8000);
    EXPECT_EQ(header->seconds, 1.0f);
    for (std::size_t length = 0; length < 60; ++length)
        EXPECT_FALSE(readWavHeader(wav.substr(0, length), "x").ok());

    Random random = Random::seeded(4);
    for (int i = 0; i < 20000; ++i) {
        const Result<WavHeader> read = readWavHeader(test::withWrongBytes(wav.substr(0, 64), random), "x");
        EXPECT_TRUE(!read.ok() || (read->rate >= 4000 && read->channels >= 1 && read->channels <= 8));
    }
}

}  // namespace
}  // namespace plumb
