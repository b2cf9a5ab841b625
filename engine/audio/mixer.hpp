#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "assets/asset_store.hpp"
#include "audio/sound_queue.hpp"
#include "platform/audio_device.hpp"

namespace plumb {

enum class SoundGroup : std::uint8_t { Effects, Interface, Music, Count };

/// How a sound is played.
struct SoundSettings {
    float volume = 1.0f;  ///< ratio, 0..1
    float pan = 0.0f;     ///< -1 left .. 1 right
    SoundGroup group = SoundGroup::Effects;
    bool looped = false;
};

/// Plays the sounds of a project. The device is opened when the first one is played; where there is none the
/// game is silent and nothing else changes.
class Mixer {
public:
    using OpenDevice = std::function<Result<std::unique_ptr<AudioDevice>>()>;

    /// @param assets  must outlive this
    /// @param open    opens the device; an empty one keeps the mixer silent, as --headless does
    explicit Mixer(AssetStore& assets, OpenDevice open = openAudioDevice);

    /// @return the voice, to stop or adjust a looped sound; -1 when nothing plays
    AudioDevice::Voice play(SoundId sound, const SoundSettings& settings = {});
    void stop(AudioDevice::Voice voice);

    /// Plays one looped piece in place of the one before; the same piece goes on.
    void playMusic(SoundId music, float volume = 1.0f, float fadeSeconds = 0.5f);
    void stopMusic(float fadeSeconds = 0.5f);

    /// Plays what the simulation asked for, and empties the queue.
    void play(SoundQueue& queue);

    void setVolume(SoundGroup group, float volume);  ///< ratio, 0..1
    void setMasterVolume(float volume);              ///< ratio, 0..1
    [[nodiscard]] float volume(SoundGroup group) const { return volumes_[static_cast<std::size_t>(group)]; }
    [[nodiscard]] float masterVolume() const { return master_; }

    void setPaused(bool paused);

    /// Opens the device now, before anything is played.
    void open() { ready(); }
    /// True once a device is open.
    [[nodiscard]] bool isOpen() const { return device_ != nullptr; }

private:
    struct Loaded {
        SoundId sound;
        std::uint32_t revision = 0;            // of the file that was loaded
        AudioDevice::SoundHandle handle = -1;  // -1: it cannot be played
    };

    bool ready();
    AudioDevice::SoundHandle handleOf(SoundId sound);
    void applyMusicVolume();

    AssetStore& assets_;
    OpenDevice open_;
    std::unique_ptr<AudioDevice> device_;
    std::vector<Loaded> loaded_;
    std::array<float, static_cast<std::size_t>(SoundGroup::Count)> volumes_{1.0f, 1.0f, 1.0f};
    float master_ = 1.0f;
    SoundId music_;
    float musicVolume_ = 1.0f;
    bool paused_ = false;
};

}  // namespace plumb
