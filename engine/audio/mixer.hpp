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

/// Parameters for playing a sound.
struct SoundSettings {
    float volume = 1.0f;  ///< ratio, 0..1
    float pan = 0.0f;     ///< -1 left .. 1 right
    SoundGroup group = SoundGroup::Effects;
    bool looped = false;
};

/// Plays the sounds of a project. The audio device is opened when the first sound is played. Without a
/// device the game is silent; everything else works as usual.
class Mixer {
public:
    using OpenDevice = std::function<Result<std::unique_ptr<AudioDevice>>()>;

    /// @param assets  must outlive this
    /// @param open    opens the device; an empty function keeps the mixer silent, as --headless does
    explicit Mixer(AssetStore& assets, OpenDevice open = openAudioDevice);

    /// @return the voice, to stop or adjust a looped sound; -1 if the sound is not played
    AudioDevice::Voice play(SoundId sound, const SoundSettings& settings = {});
    void stop(AudioDevice::Voice voice);

    /// Plays looped music instead of the current one; if it is playing already, it continues.
    void playMusic(SoundId music, float volume = 1.0f, float fadeSeconds = 0.5f);
    void stopMusic(float fadeSeconds = 0.5f);

    /// Plays the sounds that the simulation requested, and clears the queue.
    void play(SoundQueue& queue);

    void setVolume(SoundGroup group, float volume);  ///< ratio, 0..1
    void setMasterVolume(float volume);              ///< ratio, 0..1
    [[nodiscard]] float volume(SoundGroup group) const { return volumes_[static_cast<std::size_t>(group)]; }
    [[nodiscard]] float masterVolume() const { return master_; }

    void setPaused(bool paused);

    /// Opens the device now instead of with the first sound.
    void open() { ready(); }
    /// True once a device is open.
    [[nodiscard]] bool isOpen() const { return device_ != nullptr; }

private:
    struct Loaded {
        SoundId sound;
        std::uint32_t revision = 0;            // revision of the loaded file
        AudioDevice::SoundHandle handle = -1;  // -1: the sound cannot be played
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
