#include "physics/measure/snapshot.hpp"

#include <algorithm>
#include <cstring>

#include "core/hash.hpp"

namespace plumb::physics {

namespace {

using Parts = std::vector<std::vector<std::uint8_t>>;

/// Hands the whole state to an archive. The bindings name every member: a new one does not compile.
template <class Archive>
void visit(Archive& archive, World& world) {
    auto& [settings, bodies, shapes, joints, fields, softBodies, awake, moved, altered, contacts, sleepers,
           initialOverlaps, events, brokenJoints, strainedJoints, fellAsleep, quarantined, qualityCallers,
           newJoints, filtersStale, islandsStale, islandsAge, manifest, gravityOfLastStep, steps, stepLength,
           isAsking, work] = world;
    archive.values(settings, qualityCallers, newJoints, filtersStale, islandsStale, islandsAge, manifest,
                   gravityOfLastStep, steps, stepLength);
    archive.lists(awake, moved, altered, contacts, initialOverlaps);
    auto& [pose, motion, mass, info, controllers, energies, drives, freeBodies, dyingBodies] = bodies;
    archive.lists(pose, motion, mass, info, controllers, energies, drives.rows, drives.free, freeBodies,
                  dyingBodies);
    auto& [geometry, bounds, filter, motions, shapeInfo, extras, freeShapes, dyingShapes, corners,
           freeCorners] = shapes;
    archive.lists(geometry, bounds, filter, motions, shapeInfo, extras.rows, extras.free, freeShapes,
                  dyingShapes, corners);
    for (std::vector<std::uint32_t>& free : freeCorners) archive.lists(free);
    auto& [hot, definition, awakeJoints, freeJoints] = joints;
    archive.lists(hot, definition, awakeJoints, freeJoints);
    auto& [islands, freeIslands, sleeping, nextContact, freeContacts, nextBody, islandOf] = sleepers;
    archive.lists(islands, freeIslands, sleeping, nextContact, freeContacts, nextBody, islandOf);
    archive.lists(fields.all, fields.free, softBodies.free);
    archive.resize(softBodies.all);
    for (SoftBody& soft : softBodies.all) {
        auto& [particles, links, ring, touches, area, areaCompliance, radius, damping, friction, layers, mask,
               generation, substeps, isAlive] = soft;
        archive.lists(particles, links, ring, touches);
        archive.values(area, areaCompliance, radius, damping, friction, layers, mask, generation, substeps,
                       isAlive);
    }
}

class Writer {
public:
    Parts parts;

    template <class... T>
    void values(T&... all) {
        parts.emplace_back();
        (append(&all, sizeof all), ...);
    }
    template <class T>
    void resize(std::vector<T>& list) {
        std::uint64_t count = list.size();
        values(count);
    }
    template <class... T>
    void lists(std::vector<T>&... all) {
        static_assert((std::is_trivially_copyable_v<T> && ...));
        ((parts.emplace_back(), append(all.data(), all.size() * sizeof(T))), ...);
    }

private:
    void append(const void* from, std::size_t bytes) {
        const auto* at = static_cast<const std::uint8_t*>(from);
        parts.back().insert(parts.back().end(), at, at + bytes);
    }
};

class Reader {
public:
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
        ok_ = ok_ && count <= parts_.size();  // each has parts of its own
        if (ok_) list.resize(count);
    }
    template <class... T>
    void lists(std::vector<T>&... all) {
        (read(all), ...);
    }

private:
    const std::vector<std::uint8_t>& next() {
        static const std::vector<std::uint8_t> kEmpty;
        ok_ = ok_ && next_ < parts_.size();
        return ok_ ? parts_[next_++] : kEmpty;
    }
    template <class T>
    void read(std::vector<T>& list) {
        const auto& part = next();
        ok_ = ok_ && part.size() % sizeof(T) == 0;
        if (!ok_ || part.empty()) return list.clear();
        list.resize(part.size() / sizeof(T));
        std::memcpy(list.data(), part.data(), part.size());
    }

    const Parts& parts_;
    std::size_t next_ = 0;
    bool ok_ = true;
};

Parts partsOf(const World& world) {
    Writer writer;
    visit(writer, const_cast<World&>(world));  // a Writer only reads
    return std::move(writer.parts);
}

Error broken() {
    return {"worldFrom", "the bytes are not of this version of the library, or damaged", "save them anew"};
}

Result<World> worldOf(const Parts& parts) {
    World world;
    Reader reader{parts};
    visit(reader, world);
    if (!reader.ok()) return broken();
    return world;
}

/// Changes with the layout of the state and the byte order of the machine.
std::uint64_t versionOf() {
    constexpr std::uint64_t kFormat = 1;
    Hasher hasher;
    for (const std::size_t size : {sizeof(World), sizeof(Settings), sizeof(BodyInfo), sizeof(ShapeInfo),
                                   sizeof(Geometry), sizeof(Joint), sizeof(JointDefinition), sizeof(Contact),
                                   sizeof(Field), sizeof(SoftParticle), sizeof(Filter)})
        hasher.add(std::uint64_t{size});
    return hasher.value() ^ kFormat;
}

/// Version, the parts with their sizes, and a checksum.
std::vector<std::uint8_t> joined(const Parts& parts) {
    std::vector<std::uint8_t> bytes;
    const auto add = [&](const void* from, std::size_t count) {
        const auto* at = static_cast<const std::uint8_t*>(from);
        bytes.insert(bytes.end(), at, at + count);
    };
    const auto addNumber = [&](std::uint64_t number) { add(&number, sizeof number); };
    addNumber(versionOf());
    for (const auto& part : parts) {
        addNumber(part.size());
        add(part.data(), part.size());
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
    if (checksum != hasher.value() || take() != versionOf()) return broken();
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
        return Error{"WorldRecording::replay", "there are only " + std::to_string(steps_.size()) + " steps",
                     "ask for no more than steps()"};
    Result<World> world = worldOf(start_);
    for (std::size_t i = 0; world && i < count; ++i) {
        if (!steps_[i].changes.empty()) {
            Parts parts = partsOf(*world);
            for (const auto& [part, content] : steps_[i].changes) {
                parts.resize(std::max(parts.size(), part + 1));
                parts[part] = content;
            }
            world = worldOf(parts);
            if (!world) return world;
        }
        physics::step(*world, steps_[i].dt, options);
        if (hashOf(*world) != steps_[i].hash)
            return Error{"WorldRecording::replay", "step " + std::to_string(i) + " gave another state",
                         "pass the hooks of the recording, and change the world only between its steps"};
    }
    return world;
}

std::vector<std::uint8_t> WorldRecording::toBytes() const {
    Writer writer;
    std::uint64_t count = start_.size();
    writer.values(count);
    writer.parts.insert(writer.parts.end(), start_.begin(), start_.end());
    for (const Step& step : steps_) {
        count = step.changes.size();
        writer.values(step.hash, step.dt, count);
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
    for (; count > 0 && reader.good(); --count) reader.lists(recording.start_.emplace_back());
    while (reader.good() && !reader.ok()) {
        Step& step = recording.steps_.emplace_back();
        reader.values(step.hash, step.dt, count);
        for (; count > 0 && reader.good(); --count) {
            auto& [part, content] = step.changes.emplace_back();
            reader.values(part);
            reader.lists(content);
        }
    }
    if (!reader.ok()) return broken();
    return recording;
}

}  // namespace plumb::physics
