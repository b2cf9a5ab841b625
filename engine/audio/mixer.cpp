#include "audio/mixer.hpp"

#include <algorithm>
#include <utility>

#include "core/log.hpp"

namespace plumb {
namespace {

float ratio(float value) { return value == value ? std::clamp(value, 0.0f, 1.0f) : 0.0f; }

}  // namespace

Mixer::Mixer(AssetStore& assets, OpenDevice open) : assets_{assets}, open_{std::move(open)} {}

/// Tries once, at the first call, to open the device. @return true if a device is open
bool Mixer::ready() {
    if (device_ == nullptr && open_) {
        Result<std::unique_ptr<AudioDevice>> opened = std::exchange(open_, nullptr)();
        if (opened) {
            device_ = std::move(*opened);
            device_->setPaused(paused_);
        } else {
            logNote("Audio", "{}", opened.error().text());
        }
    }
    return device_ != nullptr;
}

AudioDevice::SoundHandle Mixer::handleOf(SoundId sound) {
    const std::uint32_t revision = assets_.revisionOf(AssetKind::Sound, sound.path);
    auto at =
        std::find_if(loaded_.begin(), loaded_.end(), [&](const Loaded& item) { return item.sound == sound; });
    // Revision 0: the file was unloaded with its scene. The loaded sound is still played.
    if (at != loaded_.end() && (at->revision == revision || revision == 0)) return at->handle;
    if (at == loaded_.end()) at = loaded_.insert(loaded_.end(), Loaded{sound});
    if (at->handle >= 0) device_->unload(at->handle);
    at->handle = -1;
    at->revision = revision;
    const FileBytes* file = assets_.find(sound);
    if (file == nullptr || file->bytes.empty()) return -1;  // the store has reported that it is missing
    const Result<AudioDevice::SoundHandle> handle = device_->load(file->bytes, assets_.pathOf(sound));
    if (handle) {
        at->handle = *handle;
    } else {
        logWarning("Audio", handle.error());
    }
    return at->handle;
}

AudioDevice::Voice Mixer::play(SoundId sound, const SoundSettings& settings) {
    if (sound.empty() || !ready()) return -1;
    const AudioDevice::SoundHandle handle = handleOf(sound);
    if (handle < 0) return -1;
    const float volume =
        ratio(settings.volume) * volumes_[static_cast<std::size_t>(settings.group)] * master_;
    return device_->play(handle, volume, settings.pan, settings.looped);
}

void Mixer::play(SoundQueue& queue) {
    for (const SoundEvent& event : queue.waiting())
        play(event.sound, {.volume = event.volume, .pan = event.pan});
    queue.clear();
}

void Mixer::stop(AudioDevice::Voice voice) {
    if (device_ != nullptr) device_->stop(voice);
}

void Mixer::playMusic(SoundId music, float volume, float fadeSeconds) {
    musicVolume_ = ratio(volume);
    if (music == music_) return applyMusicVolume();
    if (music.empty()) return stopMusic(fadeSeconds);
    music_ = music;
    const FileBytes* file = assets_.find(music);
    if (file == nullptr || file->bytes.empty() || !ready()) return;
    applyMusicVolume();
    const Result<Done> playing = device_->playMusic(file->bytes, assets_.pathOf(music), true, fadeSeconds);
    if (!playing) logWarning("Audio", playing.error());
}

void Mixer::stopMusic(float fadeSeconds) {
    music_ = {};
    if (device_ != nullptr) device_->stopMusic(fadeSeconds);
}

void Mixer::applyMusicVolume() {
    if (device_ != nullptr) device_->setMusicVolume(musicVolume_ * volume(SoundGroup::Music) * master_);
}

void Mixer::setVolume(SoundGroup group, float volume) {
    volumes_[static_cast<std::size_t>(group)] = ratio(volume);
    applyMusicVolume();
}

void Mixer::setMasterVolume(float volume) {
    master_ = ratio(volume);
    applyMusicVolume();
}

void Mixer::setPaused(bool paused) {
    paused_ = paused;
    if (device_ != nullptr) device_->setPaused(paused);
}

}  // namespace plumb
