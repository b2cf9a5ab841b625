#pragma once

#include <memory>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// An output for sound. An interface, so that tests can record what is played.
class AudioDevice {
public:
    using SoundHandle = int;  ///< index of a loaded sound of this device
    using Voice = int;        ///< a sound that is playing; -1 for none

    virtual ~AudioDevice() = default;

    /// Loads a WAV file of at most a minute into memory, ready to play.
    /// @error  not a WAV, too long, damaged
    virtual Result<SoundHandle> load(std::string_view wav, std::string_view where) = 0;
    virtual void unload(SoundHandle sound) = 0;

    /// @param volume  ratio, 0..1
    /// @param pan     -1 left .. 1 right
    /// @return -1 if all voices are in use: the sound is not played
    virtual Voice play(SoundHandle sound, float volume, float pan, bool looped) = 0;
    virtual void adjust(Voice voice, float volume, float pan) = 0;
    virtual void stop(Voice voice) = 0;
    [[nodiscard]] virtual bool isPlaying(Voice voice) const = 0;

    /// Streams WAV, OGG, MP3 or FLAC instead of the previous music. `bytes` are copied.
    /// @param fade  s until it has full volume
    virtual Result<Done> playMusic(std::string_view bytes, std::string_view where, bool looped,
                                   float fade) = 0;
    virtual void setMusicVolume(float volume) = 0;  ///< ratio, 0..1
    virtual void stopMusic(float fade) = 0;         ///< @param fade  s until it is silent

    virtual void setPaused(bool paused) = 0;
};

/// Opens the sound output of the machine.
/// @error there is no device, or another program uses it
Result<std::unique_ptr<AudioDevice>> openAudioDevice();

/// The properties of a sound in the header of a WAV file.
struct WavHeader {
    int channels = 0;
    int rate = 0;  ///< samples a second
    float seconds = 0.0f;
};

/// Reads the header only; decodes nothing.
/// @error not a WAV, truncated, invalid numbers
Result<WavHeader> readWavHeader(std::string_view bytes, std::string_view where);

}  // namespace plumb
