#include "scene/particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/random.hpp"
#include "math/angle.hpp"
#include "math/portable.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {
namespace {

using Column = std::vector<float> Particles::*;
constexpr std::array<Column, 9> kColumns{&Particles::x,         &Particles::y,        &Particles::velocityX,
                                         &Particles::velocityY, &Particles::progress, &Particles::pace,
                                         &Particles::size,      &Particles::turn,     &Particles::spin};
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ull;  // 2^64 / golden ratio: spreads similar seeds

std::uint64_t wordOf(EntityId entity) { return std::uint64_t{entity.index} << 32 | entity.generation; }

/// Returns a seed from the stable id, so that a scene looks the same each time it is played.
std::uint64_t seedOf(const World& world, EntityId entity) {
    const auto* scene = world.find<SceneEntity>(entity);
    return mixBits(scene != nullptr && scene->id != 0 ? scene->id : wordOf(entity) ^ kGolden);
}

/// Returns the capacity for an emitter: the maximum number of particles alive at once, and a few spare ones.
std::uint32_t roomFor(const ParticleEmitter& emitter) {
    constexpr double kSpare = 8.0;
    const double life = double{emitter.lifetime} * (1.0 + double{emitter.lifetimeSpread}) + 1.0 / 60.0;
    const double turns =
        emitter.loop ? std::ceil(life / std::max(double{emitter.duration}, 0.05)) + 1.0 : 1.0;
    const double most = std::max(0.0, double{emitter.rate} * life + double(emitter.burst) * turns) + kSpare;
    return static_cast<std::uint32_t>(std::min(most, static_cast<double>(std::max(emitter.maximum, 1))));
}

void moveTo(Particles& particles, ParticleStream& stream, std::uint32_t first) {
    for (const Column column : kColumns) {
        float* const values = (particles.*column).data();
        std::memmove(values + first, values + stream.first, stream.count * sizeof(float));
    }
    stream.first = first;
}

void resize(Particles& particles, std::size_t places) {
    for (const Column column : kColumns) (particles.*column).resize(places);
}

/// Assigns every stream a range of its capacity and moves its particles there, in place: first the streams
/// that move to lower indices, in ascending order, then those that move to higher ones, in descending order.
/// As the order of streams is kept, no move overwrites particles that have not moved yet.
void layOut(Particles& particles) {
    std::vector<ParticleStream>& streams = particles.streams;
    std::erase_if(streams, [](const ParticleStream& stream) { return !stream.wanted; });
    std::sort(streams.begin(), streams.end(),
              [](const ParticleStream& a, const ParticleStream& b) { return a.emitter < b.emitter; });
    std::uint32_t end = 0;
    for (ParticleStream& stream : streams) {
        if (end < stream.first) moveTo(particles, stream, end);
        end += stream.capacity;
    }
    const std::size_t places = end;
    if (places > particles.x.size()) resize(particles, places);
    for (auto stream = streams.rbegin(); stream != streams.rend(); ++stream) {
        end -= stream->capacity;
        if (end > stream->first) moveTo(particles, *stream, end);
    }
    resize(particles, places);
}

void move(Particles& particles, const ParticleStream& stream, const ParticleTravel& travel, float dt) {
    float* const x = particles.x.data() + stream.first;
    float* const y = particles.y.data() + stream.first;
    float* const velocityX = particles.velocityX.data() + stream.first;
    float* const velocityY = particles.velocityY.data() + stream.first;
    float* const progress = particles.progress.data() + stream.first;
    const float* const pace = particles.pace.data() + stream.first;
    // One loop per array, so that compilers vectorize it.
    for (std::uint32_t i = 0; i < stream.count; ++i) {
        x[i] += velocityX[i] * travel.reach + travel.fall.x;
        velocityX[i] = velocityX[i] * travel.keep + travel.pull.x;
    }
    for (std::uint32_t i = 0; i < stream.count; ++i) {
        y[i] += velocityY[i] * travel.reach + travel.fall.y;
        velocityY[i] = velocityY[i] * travel.keep + travel.pull.y;
    }
    for (std::uint32_t i = 0; i < stream.count; ++i) progress[i] += pace[i] * dt;
}

/// Removes expired particles. The others keep their order, so that drawing does not flicker. Whole runs of
/// survivors are moved at once, as few particles expire in a tick.
void removeExpired(Particles& particles, ParticleStream& stream) {
    const float* const progress = particles.progress.data();
    const std::uint32_t end = stream.first + stream.count;
    const auto lives = [progress](std::uint32_t i) { return progress[i] < 1.0f; };
    std::uint32_t kept = stream.first;
    while (kept < end && lives(kept)) ++kept;
    for (std::uint32_t i = kept; i < end;) {
        while (i < end && !lives(i)) ++i;
        const std::uint32_t start = i;
        while (i < end && lives(i)) ++i;
        const std::uint32_t run = i - start;
        if (run == 0) break;
        for (const Column column : kColumns) {
            float* const values = (particles.*column).data();
            std::memmove(values + kept, values + start, run * sizeof(float));
        }
        kept += run;
    }
    stream.count = kept - stream.first;
}

Vec2 placeIn(const ParticleEmitter& emitter, Random& random) {
    const float a = random.unit();
    const float b = random.unit();
    switch (emitter.area) {
        case EmitterArea::Point: break;
        case EmitterArea::Box: return {(a - 0.5f) * emitter.areaSize.x, (b - 0.5f) * emitter.areaSize.y};
        case EmitterArea::Circle: {
            const SinCos direction = sinCos(kTau * b);
            return Vec2{direction.cos, direction.sin} * (emitter.areaRadius * std::sqrt(a));
        }
    }
    return {};
}

/// Returns a random value from `value * (1 - spread)` to `value * (1 + spread)`.
float spreadOut(float value, float spread, Random& random) {
    return value * (1.0f + spread * random.between(-1.0f, 1.0f));
}

/// Emits a particle if there is capacity. @param age  s, age at the end of the step; may exceed the step
void send(Particles& particles, ParticleStream& stream, const EmitterStep& step, float age) {
    const ParticleEmitter& emitter = step.emitter;
    Random random{mixBits(stream.seed + kGolden * stream.born++)};
    const std::uint32_t most =
        std::min(stream.capacity, static_cast<std::uint32_t>(std::max(emitter.maximum, 1)));
    if (stream.count >= most) return;
    const float lifetime = std::max(spreadOut(emitter.lifetime, emitter.lifetimeSpread, random), 0.001f);
    if (age >= lifetime) return;
    const float angle = emitter.direction + emitter.spread * (random.unit() - 0.5f);
    const float speed = spreadOut(emitter.speed, emitter.speedSpread, random);
    const SinCos way = sinCos(angle);
    Vec2 velocity = Vec2{way.cos, way.sin} * speed;
    Vec2 place = placeIn(emitter, random);
    float size = spreadOut(1.0f, emitter.sizeSpread, random);
    float turn = emitter.randomTurn ? random.between(-kPi, kPi) : 0.0f;
    const float spin = emitter.spin + emitter.spinSpread * random.between(-1.0f, 1.0f);
    if (emitter.space == ParticleSpace::World) {
        const float when = std::clamp(1.0f - age / step.dt, 0.0f, 1.0f);
        const float rotation = lerpAngle(step.from.rotation, step.to.rotation, when);
        const Vec2 scale = lerp(step.from.scale, step.to.scale, when);
        place = lerp(step.from.position, step.to.position, when) + rotated(scaled(place, scale), rotation);
        velocity = rotated(velocity, rotation);
        turn += rotation;
        size *= std::fabs(scale.y);
    }
    const ParticleTravel travel =
        ParticleTravel::over(age, gravityIn(emitter, step.to, step.gravity), emitter.drag);
    place += velocity * travel.reach + travel.fall;
    velocity = velocity * travel.keep + travel.pull;
    const std::uint32_t i = stream.first + stream.count++;
    particles.x[i] = place.x;
    particles.y[i] = place.y;
    particles.velocityX[i] = velocity.x;
    particles.velocityY[i] = velocity.y;
    particles.progress[i] = age / lifetime;
    particles.pace[i] = 1.0f / lifetime;
    particles.size[i] = size;
    particles.turn[i] = turn;
    particles.spin[i] = spin * lifetime;
}

/// Emits the particles that an emitter running forever would have alive now.
void sendPast(Particles& particles, ParticleStream& stream, const EmitterStep& step) {
    const ParticleEmitter& emitter = step.emitter;
    if (!(emitter.rate > 0.0f)) return;
    const float longest = emitter.lifetime * (1.0f + emitter.lifetimeSpread);
    const float most = std::min(emitter.rate * longest, static_cast<float>(emitter.maximum));
    for (auto i = static_cast<int>(most); i > 0; --i)
        send(particles, stream, step, step.dt + static_cast<float>(i) / emitter.rate);
}

void sendDue(Particles& particles, ParticleStream& stream, const EmitterStep& step) {
    const ParticleEmitter& emitter = step.emitter;
    if (!emitter.playing) {
        stream.begun = false;
        return;
    }
    if (!stream.begun) {
        stream.begun = true;
        stream.time = 0.0f;
        stream.owed = 0.0f;
        if (emitter.loop && emitter.prewarm) sendPast(particles, stream, step);
        for (int i = 0; i < emitter.burst; ++i) send(particles, stream, step, step.dt);
    }
    if (!emitter.loop && stream.time >= emitter.duration) return;
    const float span = emitter.loop ? step.dt : std::min(step.dt, emitter.duration - stream.time);
    const float due = stream.owed + emitter.rate * span;
    const float whole = std::floor(due);
    for (float i = 1.0f; i <= whole; i += 1.0f)
        send(particles, stream, step, step.dt - (i - stream.owed) / emitter.rate);
    stream.owed = due - whole;
    stream.time += step.dt;
    if (!emitter.loop || stream.time < emitter.duration) return;
    stream.time = std::min(stream.time - emitter.duration, step.dt);  // `duration` may just have been reduced
    for (int i = 0; i < emitter.burst; ++i) send(particles, stream, step, stream.time);
}

}  // namespace

ParticleStream* Particles::find(EntityId emitter) {
    const auto at = std::lower_bound(
        streams.begin(), streams.end(), emitter,
        [](const ParticleStream& stream, EntityId wanted) { return stream.emitter < wanted; });
    return at != streams.end() && at->emitter == emitter ? &*at : nullptr;
}

std::size_t Particles::alive() const {
    std::size_t count = 0;
    for (const ParticleStream& stream : streams) count += stream.count;
    return count;
}

void Particles::archive(StateArchive& archive) {
    archive.list(streams);
    for (const Column column : kColumns) archive.list(this->*column);
    const bool fits = std::all_of(streams.begin(), streams.end(), [&](const ParticleStream& stream) {
        return std::uint64_t{stream.first} + stream.capacity <= x.size() && stream.count <= stream.capacity;
    });
    const bool isWhole = std::all_of(kColumns.begin(), kColumns.end(),
                                     [&](Column column) { return (this->*column).size() == x.size(); });
    if (!fits || !isWhole) archive.fail();
}

void Particles::addTo(Hasher& hasher) const {
    LaneHasher lanes;
    for (const ParticleStream& stream : streams) {
        hasher.add(wordOf(stream.emitter));
        hasher.add(stream.seed);
        hasher.add(std::uint64_t{stream.born} << 32 | stream.count);
        hasher.add(stream.time);
        hasher.add(stream.owed);
        hasher.add(std::uint64_t{stream.begun});
        for (const Column column : kColumns)
            lanes.addBytes((this->*column).data() + stream.first, stream.count * sizeof(float));
    }
    hasher.add(lanes.value());
}

ParticleTravel ParticleTravel::over(float seconds, Vec2 gravity, float drag) {
    const double q = std::max(double{drag} * double{seconds}, 0.0);
    double reach = 0.0;  // (1 - e^-q) / q
    double fall = 0.0;   // (1 - reach) / q
    double keep = 1.0;
    if (q < 0.25) {
        // Power series, as the closed formulas lose all precision near 0.
        double term = 1.0;
        for (int n = 1; n <= 9; ++n) {
            reach += term;
            term *= -q / (n + 1);
            fall -= term / (q > 0.0 ? q : 1.0);
        }
        if (q == 0.0) fall = 0.5;
        keep = 1.0 - q * reach;
    } else {
        keep = double{exponential(static_cast<float>(-q))};
        reach = (1.0 - keep) / q;
        fall = (1.0 - reach) / q;
    }
    ParticleTravel travel;
    travel.keep = static_cast<float>(keep);
    travel.reach = static_cast<float>(reach * double{seconds});
    travel.pull = gravity * travel.reach;
    travel.fall = gravity * static_cast<float>(fall * double{seconds} * double{seconds});
    return travel;
}

Vec2 particleGravity(const World& world) {
    for (auto [entity, scene] : world.query<const ScenePhysics>()) return scene.gravity;
    const auto* settings = world.findResource<PhysicsSettings>();
    return settings != nullptr ? settings->gravity : PhysicsSettings::kGravity;
}

Vec2 gravityIn(const ParticleEmitter& emitter, const Pose& pose, Vec2 gravity) {
    if (emitter.space == ParticleSpace::World) return gravity * emitter.gravity;
    const Vec2 turned = rotated(gravity * emitter.gravity, -pose.rotation);
    return {pose.scale.x != 0.0f ? turned.x / pose.scale.x : 0.0f,
            pose.scale.y != 0.0f ? turned.y / pose.scale.y : 0.0f};
}

void followEmitters(Particles& particles, const World& world, std::span<const EntityId> emitters) {
    for (ParticleStream& stream : particles.streams) stream.wanted = false;
    bool changed = false;
    const std::size_t known = particles.streams.size();
    for (const EntityId entity : emitters) {
        const auto* emitter = world.find<ParticleEmitter>(entity);
        if (emitter == nullptr) continue;
        const std::uint32_t room = roomFor(*emitter);
        // New streams are appended after the sorted ones until all emitters were visited.
        const auto end = particles.streams.begin() + static_cast<std::ptrdiff_t>(known);
        const auto at = std::lower_bound(
            particles.streams.begin(), end, entity,
            [](const ParticleStream& stream, EntityId wanted) { return stream.emitter < wanted; });
        if (at == end || at->emitter != entity) {
            ParticleStream stream;
            stream.emitter = entity;
            stream.seed = seedOf(world, entity);
            stream.wanted = true;
            stream.capacity = room;
            particles.streams.push_back(stream);
            changed = true;
            continue;
        }
        at->wanted = true;
        changed |= at->capacity < room;
        at->capacity = std::max(at->capacity, room);
        at->count = std::min(at->count, static_cast<std::uint32_t>(std::max(emitter->maximum, 1)));
    }
    changed |= std::any_of(particles.streams.begin(), particles.streams.end(),
                           [](const ParticleStream& stream) { return !stream.wanted; });
    if (changed) layOut(particles);
}

void stepStream(Particles& particles, ParticleStream& stream, const EmitterStep& step) {
    const Vec2 gravity = gravityIn(step.emitter, step.to, step.gravity);
    move(particles, stream, ParticleTravel::over(step.dt, gravity, step.emitter.drag), step.dt);
    removeExpired(particles, stream);
    sendDue(particles, stream, step);
}

void burstStream(Particles& particles, ParticleStream& stream, const EmitterStep& step, int count) {
    for (int i = 0; i < count; ++i) send(particles, stream, step, 0.0f);
}

}  // namespace plumb
