#include "platform/audio_device.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <SDL.h>
#include <SDL_mixer.h>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr int kRate = 44100;   // samples a second
constexpr int kSamples = 512;  // samples in a buffer: 12 ms of delay
constexpr int kVoices = 32;
constexpr float kMaxSeconds = 60.0f;

int toMixVolume(float volume) {
    return static_cast<int>(std::clamp(volume == volume ? volume : 0.0f, 0.0f, 1.0f) * MIX_MAX_VOLUME + 0.5f);
}

/// Linear: the far side is attenuated, the near side keeps its volume.
void setPan(int channel, float pan) {
    const float clamped = std::clamp(pan == pan ? pan : 0.0f, -1.0f, 1.0f);
    const auto side = [](float volume) { return static_cast<Uint8>(std::min(volume, 1.0f) * 255.0f + 0.5f); };
    Mix_SetPanning(channel, side(1.0f - clamped), side(1.0f + clamped));
}

int toMilliseconds(float seconds) { return static_cast<int>(std::clamp(seconds, 0.0f, 60.0f) * 1000.0f); }

class SdlAudioDevice final : public AudioDevice {
public:
    ~SdlAudioDevice() override {
        Mix_HaltChannel(-1);
        freeMusic();
        for (Mix_Chunk* chunk : chunks_) Mix_FreeChunk(chunk);
        Mix_CloseAudio();
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }

    Result<SoundHandle> load(std::string_view wav, std::string_view where) override {
        const Result<WavHeader> header = readWavHeader(wav, where);
        if (!header) return header.error();
        if (header->seconds > kMaxSeconds) {
            return Error{std::string{where},
                         format("the sound lasts {} s, the limit is {}", header->seconds, kMaxSeconds),
                         "play it as music"};
        }
        Mix_Chunk* chunk = Mix_LoadWAV_RW(SDL_RWFromConstMem(wav.data(), static_cast<int>(wav.size())), 1);
        if (chunk == nullptr) {
            return Error{std::string{where}, format("the sound is damaged ({})", Mix_GetError()),
                         "save it again as WAV"};
        }
        const auto free = std::find(chunks_.begin(), chunks_.end(), nullptr);
        if (free == chunks_.end())
            return chunks_.push_back(chunk), static_cast<SoundHandle>(chunks_.size() - 1);
        *free = chunk;
        return static_cast<SoundHandle>(free - chunks_.begin());
    }

    void unload(SoundHandle sound) override {
        if (Mix_Chunk* chunk = chunkOf(sound)) {
            Mix_FreeChunk(chunk);  // stops the voices that play it
            chunks_[static_cast<std::size_t>(sound)] = nullptr;
        }
    }

    Voice play(SoundHandle sound, float volume, float pan, bool looped) override {
        Mix_Chunk* chunk = chunkOf(sound);
        if (chunk == nullptr) return -1;
        const int channel = Mix_PlayChannel(-1, chunk, looped ? -1 : 0);
        if (channel >= 0) adjust(channel, volume, pan);
        return channel;
    }

    void adjust(Voice voice, float volume, float pan) override {
        if (voice < 0) return;
        Mix_Volume(voice, toMixVolume(volume));
        setPan(voice, pan);
    }
    void stop(Voice voice) override {
        if (voice >= 0) Mix_HaltChannel(voice);
    }
    [[nodiscard]] bool isPlaying(Voice voice) const override { return voice >= 0 && Mix_Playing(voice) != 0; }

    Result<Done> playMusic(std::string_view bytes, std::string_view where, bool looped, float fade) override {
        freeMusic();
        musicBytes_ = bytes;
        music_ =
            Mix_LoadMUS_RW(SDL_RWFromConstMem(musicBytes_.data(), static_cast<int>(musicBytes_.size())), 1);
        if (music_ == nullptr || Mix_FadeInMusic(music_, looped ? -1 : 1, toMilliseconds(fade)) != 0) {
            return Error{std::string{where}, format("the music cannot be played ({})", Mix_GetError()),
                         "save it again as OGG or WAV"};
        }
        return Done{};
    }
    void setMusicVolume(float volume) override { Mix_VolumeMusic(toMixVolume(volume)); }
    void stopMusic(float fade) override {
        if (fade > 0.0f) {
            Mix_FadeOutMusic(toMilliseconds(fade));
        } else {
            freeMusic();
        }
    }

    void setPaused(bool paused) override {
        paused ? Mix_Pause(-1) : Mix_Resume(-1);
        paused ? Mix_PauseMusic() : Mix_ResumeMusic();
    }

private:
    [[nodiscard]] Mix_Chunk* chunkOf(SoundHandle sound) const {
        const auto index = static_cast<std::size_t>(sound);
        return sound >= 0 && index < chunks_.size() ? chunks_[index] : nullptr;
    }

    void freeMusic() {
        Mix_HaltMusic();
        if (music_ != nullptr) Mix_FreeMusic(music_);
        music_ = nullptr;
    }

    std::vector<Mix_Chunk*> chunks_;  // by handle; null for unloaded sounds
    std::string musicBytes_;          // kept, because music is streamed from it
    Mix_Music* music_ = nullptr;
};

}  // namespace

Result<std::unique_ptr<AudioDevice>> openAudioDevice() {
    const auto failure = [](const char* why) {
        return Error{"audio", format("no sound device ({})", why), "the game runs without sound"};
    };
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return failure(SDL_GetError());
    if (Mix_OpenAudio(kRate, AUDIO_S16SYS, 2, kSamples) != 0) {
        const std::string why = Mix_GetError();
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
        return failure(why.c_str());
    }
    Mix_AllocateChannels(kVoices);
    return std::unique_ptr<AudioDevice>{std::make_unique<SdlAudioDevice>()};
}

}  // namespace plumb
