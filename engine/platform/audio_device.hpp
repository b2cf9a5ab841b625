#pragma once

#include <memory>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// A place that sound goes to. An interface, so that tests listen in.
class AudioDevice {
public:
    using SoundHandle = int;  ///< a loaded sound of this device, from 0
    using Voice = int;        ///< a sound that plays; -1 for none

    virtual ~AudioDevice() = default;

    /// Takes a WAV file of at most a minute into memory, ready to play.
    /// @error  not a WAV, too long, damaged
    virtual Result<SoundHandle> load(std::string_view wav, std::string_view where) = 0;
    virtual void unload(SoundHandle sound) = 0;

    /// @param volume  ratio, 0..1
    /// @param pan     -1 left .. 1 right
    /// @return        -1 when all voices are taken: the sound is left out
    virtual Voice play(SoundHandle sound, float volume, float pan, bool looped) = 0;
    virtual void adjust(Voice voice, float volume, float pan) = 0;
    virtual void stop(Voice voice) = 0;
    [[nodiscard]] virtual bool isPlaying(Voice voice) const = 0;

    /// Streams WAV, OGG, MP3 or FLAC in place of the music before. `bytes` are copied.
    /// @param fade  s until it has its volume
    virtual Result<Done> playMusic(std::string_view bytes, std::string_view where, bool looped,
                                   float fade) = 0;
    virtual void setMusicVolume(float volume) = 0;
    virtual void stopMusic(float fade) = 0;

    virtual void setPaused(bool paused) = 0;
};

/// Opens the machine's loudspeakers.
/// @error  there are none, or another program holds them
Result<std::unique_ptr<AudioDevice>> openAudioDevice();

/// What a WAV file states about itself.
struct WavHeader {
    int channels = 0;
    int rate = 0;  ///< samples a second
    float seconds = 0.0f;
};

/// Reads the header alone; nothing is decoded.
/// @error  not a WAV, cut off, senseless numbers
Result<WavHeader> readWavHeader(std::string_view bytes, std::string_view where);

}  // namespace plumb
