#include "physics/measure/snapshot.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include "core/hash.hpp"

namespace plumb::physics {

namespace {

using Bytes = std::vector<std::uint8_t>;
using Parts = std::vector<Bytes>;

void append(Bytes& to, const void* from, std::size_t count) {
    const auto* at = static_cast<const std::uint8_t*>(from);
    to.insert(to.end(), at, at + count);
}

/// Passes the whole state to an archive, in the order of the hash. The bindings name every member, so that a
/// new member causes a compile error. Hashes skip later members with default values: old hashes remain.
template <class Archive, class AnyWorld>
void visit(Archive& archive, AnyWorld& world) {
    auto& [settings, bodies, shapes, joints, fields, softBodies, awake, moved, altered, contacts, sleepers,
           initialOverlaps, events, brokenJoints, strainedJoints, fellAsleep, quarantined, quarantinedSoft,
           qualityCallers, newJoints, filtersStale, islandsStale, islandsAge, manifest, gravityOfLastStep,
           steps, stepLength, work] = world;
    archive.values(settings);
    auto& [pose, motion, mass, info, controllers, energies, drives, freeBodies, dyingBodies] = bodies;
    archive.lists(pose, motion, mass, info, drives.rows, drives.free, freeBodies, dyingBodies);
    if (Archive::kIsExact || !controllers.empty()) archive.lists(controllers);
    if (Archive::kIsExact || !energies.empty()) archive.lists(energies);
    auto& [geometry, bounds, filter, motions, shapeInfo, extras, freeShapes, dyingShapes, corners,
           freeCorners] = shapes;
    archive.lists(geometry, bounds, filter, motions, shapeInfo, extras.rows, extras.free, freeShapes,
                  dyingShapes, corners);
    for (auto& free : freeCorners) archive.lists(free);
    auto& [hot, definition, awakeJoints, freeJoints] = joints;
    archive.lists(hot, awakeJoints, freeJoints, definition, fields.all, fields.free);
    archive.resize(softBodies.all);
    for (auto& soft : softBodies.all) {
        auto& [particles, links, ring, touches, area, areaCompliance, radius, damping, friction, layers, mask,
               generation, substeps, isAlive] = soft;
        archive.lists(particles, links, ring, touches);
        archive.values(area, areaCompliance, radius, damping, friction, layers, mask, generation, substeps,
                       isAlive);
    }
    archive.lists(softBodies.free, awake, moved, contacts);
    if (Archive::kIsExact || !altered.empty()) archive.lists(altered);
    auto& [islands, freeIslands, sleeping, nextContact, freeContacts, nextBody, islandOf] = sleepers;
    archive.lists(islands, freeIslands, sleeping, nextContact, freeContacts, nextBody, islandOf,
                  initialOverlaps);
    // Omits events, on which the next step does not depend.
    archive.values(qualityCallers, newJoints, filtersStale, islandsStale, islandsAge, gravityOfLastStep,
                   steps, manifest);
    if (Archive::kIsExact) archive.values(stepLength);
}

/// True for types without padding; with padding, this is not a constant expression and does not compile.
template <class T>
constexpr bool isDense() {
    unsigned sum = 0;
    for (const unsigned char byte : std::bit_cast<std::array<unsigned char, sizeof(T)>>(T{})) sum += byte;
    return sum < sizeof(T) * 256;
}

/// Hashes lists as raw bytes, except types that have or had padding: these value by value.
class HashArchive {
public:
    static constexpr bool kIsExact = false;

    template <class... T>
    void values(const T&... all) {
        (add(all), ...);
    }
    template <class T>
    void resize(const std::vector<T>&) {}
    template <class... T>
    void lists(const std::vector<T>&... all) {
        (addList(all), ...);
    }
    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

private:
    template <class T>
    static constexpr bool kByValue =
        std::is_same_v<T, JointDefinition> || std::is_same_v<T, Field> || std::is_same_v<T, SoftParticle> ||
        std::is_same_v<T, SoftLink> || std::is_same_v<T, SoftTouch> || std::is_same_v<T, InitialOverlap>;

    template <class T>
    void addList(const std::vector<T>& list) {
        if constexpr (kByValue<T>) {
            for (const T& each : list) add(each);
        } else {
            static_assert(isDense<T>());
            hash_.addBytes(list.data(), list.size() * sizeof(T));
        }
    }

    static std::uint64_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value); }
    void add(float value) { hash_.add(bitsOf(value)); }
    void add(double value) { hash_.add(std::bit_cast<std::uint64_t>(value)); }
    void add(Vec2 value) { hash_.add(bitsOf(value.x) << 32 | bitsOf(value.y)); }
    void add(const WorldPosition& value) { values(value.x, value.y); }
    template <class Thing>
    void add(Id<Thing> id) {
        hash_.add(std::uint64_t{id.index} << 32 | id.generation);
    }
    template <class T>
    requires std::is_integral_v<T> || std::is_enum_v<T>
    void add(T value) { hash_.add(static_cast<std::uint64_t>(value)); }

    void add(const Manifest& manifest) {
        static_assert(isDense<Manifest>());
        hash_.addBytes(&manifest, sizeof manifest);
    }
    void add(const Settings& settings) {
        const auto& [gravity, integrator, broadPhase, quality, iterations, automaticQuality, tolerance,
                     directJoints, contactStiffness, jointStiffness, contactDampingRatio, jointDampingRatio,
                     pushSpeed, deepPushRate, slop, speculativeDistance, recycleDistance, boundsMargin,
                     bounceSpeed, sleepTime, maxSpeed, continuous, sleeping, stayEvents] = settings;
        values(gravity, integrator, broadPhase, quality, iterations, automaticQuality, directJoints,
               contactStiffness, jointStiffness, contactDampingRatio, jointDampingRatio, pushSpeed,
               deepPushRate, slop, speculativeDistance, recycleDistance, boundsMargin, bounceSpeed, sleepTime,
               maxSpeed, continuous, sleeping, stayEvents);
        if (tolerance != 0.0f) values(tolerance);  // as in visit()
    }
    void add(const JointDefinition& definition) {
        const auto& [kind, a, b, anchorA, anchorB, axis, referenceAngle, length, ratio, groundA, groundB,
                     target, offset, velocity, jointA, jointB, limit, motor, spring, maxForce, maxTorque,
                     breakForce, breakTorque, reportForce, reportTorque, hertz, dampingRatio,
                     collideConnected, quality, user] = definition;
        values(kind, a, b, anchorA, anchorB, axis, referenceAngle, length, ratio, groundA, groundB, target,
               offset, jointA, jointB, maxForce, maxTorque, breakForce, breakTorque, hertz, dampingRatio,
               collideConnected, quality, user);
        const auto& [limitOn, lower, upper] = limit;
        const auto& [motorOn, speed, mostForce] = motor;
        const auto& [springOn, springHertz, springDamping, rest] = spring;
        values(limitOn, lower, upper, motorOn, speed, mostForce, springOn, springHertz, springDamping, rest);
        const JointDefinition usual;
        if (velocity != usual.velocity) values(velocity);  // as in visit()
        if (reportForce != usual.reportForce || reportTorque != usual.reportTorque)
            values(reportForce, reportTorque);
    }
    void add(const Field& field) {
        const auto& [definition, fieldGeneration, fieldIsAlive] = field;
        const auto& [kind, region, replacesGravity, linear, layers, place, half, radius, acceleration,
                     velocity, strength, damping, length, density, linearDrag, angularDrag, gust, gustSteps,
                     seed, a, b, anchorA, anchorB] = definition;
        values(kind, region, replacesGravity, linear, layers, place, half, radius, acceleration, velocity,
               strength, damping, length, density, linearDrag, angularDrag, gust, gustSteps, seed, a, b,
               anchorA, anchorB, fieldGeneration, fieldIsAlive);
    }
    void add(const SoftParticle& particle) {
        const auto& [place, before, velocity, inverseMass, mass] = particle;
        values(place, before, velocity, inverseMass, mass);
    }
    void add(const SoftLink& link) {
        const auto& [a, b, length, compliance, isEdge] = link;
        values(a, b, length, compliance, isEdge);
    }
    void add(const SoftTouch& touch) {
        const auto& [particle, shape, force] = touch;
        values(particle, shape, force);
    }
    void add(const InitialOverlap& overlap) {
        const auto& [pair, hidden] = overlap;
        values(pair, hidden);
    }

    LaneHasher hash_;
};

struct Writer {
    static constexpr bool kIsExact = true;
    Parts parts;

    template <class... T>
    void values(const T&... all) {
        parts.emplace_back();
        (append(parts.back(), &all, sizeof all), ...);
    }
    template <class T>
    void resize(const std::vector<T>& list) {
        values(std::uint64_t{list.size()});
    }
    template <class... T>
    void lists(const std::vector<T>&... all) {
        (write(all), ...);
    }

private:
    template <class T>
    void write(const std::vector<T>& list) {
        static_assert(std::is_trivially_copyable_v<T>);
        values(std::uint64_t{sizeof(T)});  // may differ in another version of the library
        append(parts.back(), list.data(), list.size() * sizeof(T));
    }
};

class Reader {
public:
    static constexpr bool kIsExact = true;

    explicit Reader(const Parts& parts) : parts_{parts} {}
    [[nodiscard]] bool good() const { return ok_; }
    [[nodiscard]] bool ok() const { return ok_ && next_ == parts_.size(); }

    template <class... T>
    void values(T&... all) {
        const auto& part = next();
        ok_ = ok_ && part.size() == (sizeof(T) + ...);
        std::size_t at = 0;
        if (ok_) ((std::memcpy(&all, part.data() + at, sizeof all), at += sizeof all), ...);
    }
    template <class T>
    void resize(std::vector<T>& list) {
        std::uint64_t count = 0;
        values(count);
        ok_ = ok_ && count <= parts_.size();  // each element has separate parts
        if (ok_) list.resize(count);
    }
    template <class... T>
    void lists(std::vector<T>&... all) {
        (read(all), ...);
    }

    const Bytes& next() {
        static const Bytes kNothing;
        ok_ = ok_ && next_ < parts_.size();
        return ok_ ? parts_[next_++] : kNothing;
    }

private:
    template <class T>
    void read(std::vector<T>& list) {
        const auto& part = next();
        std::uint64_t size = 0;
        if (part.size() >= sizeof size) std::memcpy(&size, part.data(), sizeof size);
        const std::size_t bytes = part.size() - sizeof size;
        ok_ = ok_ && size == sizeof(T) && bytes % sizeof(T) == 0;
        list.resize(ok_ ? bytes / sizeof(T) : 0);
        if (!list.empty()) std::memcpy(list.data(), part.data() + sizeof size, bytes);
    }

    const Parts& parts_;
    std::size_t next_ = 0;
    bool ok_ = true;
};

Parts partsOf(const World& world) {
    Writer writer;
    visit(writer, world);
    return std::move(writer.parts);
}

Error broken() {
    return {"worldFrom", "the data is corrupted or of another library version", "save it again"};
}

Result<World> worldOf(const Parts& parts) {
    World world;
    Reader reader{parts};
    visit(reader, world);
    if (!reader.ok()) return broken();
    return world;
}

constexpr std::uint64_t kFormat = 3;

/// Serializes the format number, the parts with their sizes, and a checksum.
Bytes joined(const Parts& parts) {
    Bytes bytes;
    const auto addNumber = [&](std::uint64_t number) { append(bytes, &number, sizeof number); };
    addNumber(kFormat);
    for (const auto& part : parts) {
        addNumber(part.size());
        append(bytes, part.data(), part.size());
    }
    LaneHasher hasher;
    hasher.addBytes(bytes.data(), bytes.size());
    addNumber(hasher.value());
    return bytes;
}

Result<Parts> split(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kNumber = sizeof(std::uint64_t);
    const auto take = [&] {
        std::uint64_t number = 0;
        std::memcpy(&number, bytes.data(), kNumber);
        bytes = bytes.subspan(kNumber);
        return number;
    };
    if (bytes.size() < 2 * kNumber) return broken();
    LaneHasher hasher;
    hasher.addBytes(bytes.data(), bytes.size() - kNumber);
    std::uint64_t checksum = 0;
    std::memcpy(&checksum, bytes.data() + bytes.size() - kNumber, kNumber);
    if (checksum != hasher.value() || take() != kFormat) return broken();
    Parts parts;
    while (bytes.size() >= 2 * kNumber) {
        const std::uint64_t size = take();
        if (size > bytes.size() - kNumber) return broken();
        parts.emplace_back(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        bytes = bytes.subspan(size);
    }
    return parts;
}

}  // namespace

std::uint64_t hashOf(const World& world) {
    HashArchive hash;
    visit(hash, world);
    return hash.value();
}

void addTo(Hasher& hasher, const World& world) { hasher.add(hashOf(world)); }

std::size_t stateBytes(const World& world) {
    std::size_t bytes = sizeof(World);
    for (const auto& part : partsOf(world)) bytes += part.size();
    return bytes;
}

std::vector<std::uint8_t> toBytes(const World& world) { return joined(partsOf(world)); }

Result<World> worldFrom(std::span<const std::uint8_t> bytes) {
    const Result<Parts> parts = split(bytes);
    if (!parts) return parts.error();
    return worldOf(*parts);
}

WorldRecording::WorldRecording(const World& world) : start_{partsOf(world)}, last_{start_} {}

void WorldRecording::step(World& world, float dt, const StepOptions& options) {
    Step& done = steps_.emplace_back(Step{0, dt, {}});
    const Parts now = partsOf(world);
    last_.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] != last_[i]) done.changes.push_back({i, now[i]});
    }
    physics::step(world, dt, options);
    done.hash = hashOf(world);
    last_ = partsOf(world);
}

Result<World> WorldRecording::replay(std::size_t count, const StepOptions& options) const {
    if (count > steps_.size())
        return Error{"WorldRecording::replay", "it recorded only " + std::to_string(steps_.size()) + " steps",
                     "pass at most steps() as count"};
    Result<World> world = worldOf(start_);
    for (std::size_t i = 0; world && i < count; ++i) {
        if (!steps_[i].changes.empty()) {
            Parts parts = partsOf(*world);
            for (const auto& [part, content] : steps_[i].changes) {
                parts.resize(std::max<std::size_t>(parts.size(), part + 1));
                parts[part] = content;
            }
            world = worldOf(parts);
            if (!world) return world;
        }
        physics::step(*world, steps_[i].dt, options);
        if (hashOf(*world) != steps_[i].hash)
            return Error{"WorldRecording::replay",
                         "step " + std::to_string(i) + " gave another state than recorded",
                         "use the hooks of the recording, and change the world only between its steps"};
    }
    return world;
}

std::vector<std::uint8_t> WorldRecording::toBytes() const {
    Writer writer;
    writer.values(std::uint64_t{start_.size()});
    writer.parts.insert(writer.parts.end(), start_.begin(), start_.end());
    for (const Step& step : steps_) {
        writer.values(step.hash, step.dt, std::uint64_t{step.changes.size()});
        for (const auto& [part, content] : step.changes) {
            writer.values(part);
            writer.parts.push_back(content);
        }
    }
    return joined(writer.parts);
}

Result<WorldRecording> WorldRecording::from(std::span<const std::uint8_t> bytes) {
    const Result<Parts> parts = split(bytes);
    if (!parts) return parts.error();
    WorldRecording recording;
    Reader reader{*parts};
    std::uint64_t count = 0;
    reader.values(count);
    for (; count > 0 && reader.good(); --count) recording.start_.push_back(reader.next());
    while (reader.good() && !reader.ok()) {
        Step& step = recording.steps_.emplace_back();
        reader.values(step.hash, step.dt, count);
        for (; count > 0 && reader.good(); --count) {
            auto& [part, content] = step.changes.emplace_back();
            reader.values(part);
            content = reader.next();
        }
    }
    if (!reader.ok()) return broken();
    return recording;
}

}  // namespace plumb::physics
