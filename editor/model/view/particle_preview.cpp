#include "editor/model/view/particle_preview.hpp"

#include <algorithm>
#include <utility>

#include "ecs/hierarchy.hpp"

namespace plumb::editor {
namespace {

constexpr int kMostSteps = 6;  // maximum steps per frame; after a slow frame the rest is skipped
constexpr int kHandful = 30;   // number of particles of a burst if the emitter defines none

/// Returns a copy of the emitter with `playing` set, because the preview always emits.
ParticleEmitter sending(const ParticleEmitter& emitter) {
    ParticleEmitter copy = emitter;
    copy.playing = true;
    return copy;
}

EmitterStep stepOf(const World& world, EntityId entity, const ParticleEmitter& emitter, float dt) {
    const Pose pose = worldPose(world, entity);
    return {emitter, pose, pose, particleGravity(world), dt};
}

}  // namespace

void ParticlePreview::clear() {
    particles_ = {};
    emitters_.clear();
    seen_ = {};
    rest_ = 0.0;
}

void ParticlePreview::restart() {
    particles_ = {};
    rest_ = kStep;
}

void ParticlePreview::findEmitters(const Document& document) {
    const Seen now{document.selection.revision(), document.sceneRevision};
    if (std::exchange(seen_, now) == now) return;
    std::vector<EntityId> found;
    const World& world = document.world;
    std::vector<EntityId> selected;
    for (const ObjectId id : document.selection.all()) selected.push_back(document.find(id));
    std::sort(selected.begin(), selected.end());
    for (auto [entity, emitter] : world.query<const ParticleEmitter>(withPaused)) {
        for (EntityId above = entity; above; above = parentOf(world, above)) {
            if (!std::binary_search(selected.begin(), selected.end(), above)) continue;
            found.push_back(entity);
            break;
        }
    }
    std::sort(found.begin(), found.end());
    if (found == emitters_) return;
    emitters_ = std::move(found);
    restart();
}

void ParticlePreview::step(const World& world) {
    const auto dt = static_cast<float>(kStep);
    followEmitters(particles_, world, emitters_);
    for (ParticleStream& stream : particles_.streams) {
        const ParticleEmitter emitter = sending(world.get<ParticleEmitter>(stream.emitter));
        const bool over =
            stream.begun && !emitter.loop && stream.time >= emitter.duration && stream.count == 0;
        if (over) stream.begun = false;
        stepStream(particles_, stream, stepOf(world, stream.emitter, emitter, dt));
    }
}

void ParticlePreview::advance(const Document& document, double seconds) {
    findEmitters(document);
    if (emitters_.empty()) return;
    rest_ = std::min(rest_ + seconds, kMostSteps * kStep);
    while (rest_ >= kStep) {
        rest_ -= kStep;
        step(document.world);
    }
}

void ParticlePreview::burst(const Document& document) {
    for (ParticleStream& stream : particles_.streams) {
        const auto* found = document.world.find<ParticleEmitter>(stream.emitter);
        if (found == nullptr) continue;
        const ParticleEmitter emitter = sending(*found);
        burstStream(particles_, stream,
                    stepOf(document.world, stream.emitter, emitter, static_cast<float>(kStep)),
                    emitter.burst > 0 ? emitter.burst : kHandful);
    }
}

}  // namespace plumb::editor
