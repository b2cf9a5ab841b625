#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "core/text.hpp"
#include "ecs/saved_type.hpp"
#include "ecs/world.hpp"
#include "reflect/convert_component.hpp"
#include "reflect/type_registry.hpp"

// The state of a world as bytes, for the file of a saved game: World::toBytes() and World::snapshotFrom().

namespace plumb {
namespace {

constexpr std::uint32_t kFormat = 3;

Error notAState() {
    return {"saved game", "the state in it is damaged or was written by another version of the engine",
            "load another saved game"};
}

/// The entities of a state: generations by index, and the indices to reuse.
struct SavedEntities {
    std::vector<std::uint32_t> generations;
    std::vector<std::uint32_t> free;
    std::uint32_t retired = 0;

    void archive(StateArchive& archive) {
        archive.list(generations);
        archive.list(free);
        archive.number(retired);
    }
    [[nodiscard]] std::size_t used() const { return generations.size() - 1; }
    [[nodiscard]] bool livesAt(std::uint32_t index) const {
        return index < generations.size() && (generations[index] & 1u) != 0;
    }
    [[nodiscard]] bool isValid(std::uint32_t mostEntities) const {
        if (generations.empty() || generations[0] != 0 || generations.size() + 1 > mostEntities) return false;
        std::vector<bool> seen(generations.size());
        for (const std::uint32_t index : free) {
            if (index == 0 || index >= seen.size() || livesAt(index) || seen[index]) return false;
            seen[index] = true;
        }
        const auto living = static_cast<std::size_t>(std::count_if(
            generations.begin(), generations.end(), [](std::uint32_t g) { return (g & 1u) != 0; }));
        return living + free.size() + retired == used();
    }
};

/// The components of one type.
struct SavedPool {
    const ComponentType* type = nullptr;  ///< null: this program does not have it
    std::uint32_t disorder = 0;
    std::vector<std::uint32_t> owners;  ///< indices of entities, in the order of the components
    std::vector<std::byte> column;      ///< components of `type`
};

bool areValid(const std::vector<std::uint32_t>& owners, const SavedEntities& entities) {
    std::vector<bool> seen(entities.generations.size());
    for (const std::uint32_t owner : owners) {
        if (owner == 0 || !entities.livesAt(owner) || seen[owner]) return false;
        seen[owner] = true;
    }
    return true;
}

const ComponentType* typeFor(const TypeRegistry* types, std::string_view name) {
    const TypeInfo* const described = types == nullptr ? nullptr : types->find(name);
    return described != nullptr ? &componentTypeOf(*described) : findComponentType(name);
}

/// Converts components of a saved type to the present one.
void convertColumn(SavedPool& pool, const TypeInfo& saved) {
    const TypeInfo& now = pool.type->info;
    if (sameFields(saved, now)) return;
    const std::vector<std::byte> before = std::exchange(pool.column, {});
    pool.column.resize(pool.owners.size() * now.size);
    for (std::size_t i = 0; i < pool.owners.size() && now.size > 0; ++i) {
        std::byte* const component = pool.column.data() + i * now.size;
        now.construct(component);
        if (saved.size > 0) convertComponent(saved, before.data() + i * saved.size, now, component);
    }
}

/// Why components of a saved type cannot become those of this program; empty if they can.
std::string whyLeftOut(const SavedType& saved, const ComponentType* now) {
    if (now == nullptr) return "this version of the game does not have this component";
    if (sameFields(saved.info, now->info)) return {};
    const bool fromNothing = !now->info.fields.empty() || now->info.size == 0;
    if (!fromNothing)
        return "the component has another size in this version of the game and no described fields";
    if (now->info.size > 0 && now->info.defaults.empty()) return "the component has no default value";
    return {};
}

SavedPool readPool(StateArchive& archive, const TypeRegistry* types, std::vector<Error>& problems) {
    SavedType saved;
    SavedPool pool;
    readType(archive, saved);
    archive.number(pool.disorder);
    archive.list(pool.owners);
    archive.list(pool.column);
    if (pool.column.size() != pool.owners.size() * saved.info.size) archive.fail();
    if (!archive.ok()) return pool;
    pool.type = typeFor(types, saved.name);
    if (std::string why = whyLeftOut(saved, pool.type); !why.empty()) {
        if (!pool.owners.empty())
            problems.push_back({format("component {}", saved.name), std::move(why),
                                format("{} entities were loaded without it", pool.owners.size())});
        pool.type = nullptr;
        return pool;
    }
    convertColumn(pool, saved.info);
    return pool;
}

/// The image that Storage::restore() takes.
StorageImage imageOf(const SavedEntities& entities, const std::vector<SavedPool>& pools) {
    StorageImage image;
    image.used = static_cast<std::uint32_t>(entities.used());
    image.freeCount = static_cast<std::uint32_t>(entities.free.size());
    image.retired = entities.retired;
    std::vector<EntityRecord> records(entities.generations.size());
    for (std::size_t i = 0; i < records.size(); ++i) records[i].generation = entities.generations[i];
    std::size_t bytes = records.size() * sizeof(EntityRecord) + entities.free.size() * sizeof(std::uint32_t);
    for (const SavedPool& pool : pools) {
        const std::uint64_t bit = std::uint64_t{1} << std::min<std::size_t>(image.pools.size(), 63);
        image.pools.push_back({pool.type, static_cast<std::uint32_t>(pool.owners.size()), pool.disorder});
        for (const std::uint32_t owner : pool.owners) records[owner].mask |= bit;
        bytes += pool.owners.size() * sizeof(std::uint32_t) + pool.column.size();
    }
    image.bytes.prepare(bytes);
    image.bytes.append(records.data(), records.size() * sizeof(EntityRecord));
    image.bytes.append(entities.free.data(), entities.free.size() * sizeof(std::uint32_t));
    for (const SavedPool& pool : pools) {
        image.bytes.append(pool.owners.data(), pool.owners.size() * sizeof(std::uint32_t));
        image.bytes.append(pool.column.data(), pool.column.size());
    }
    return image;
}

void writeStorage(StateArchive& archive, const Storage& storage, const StorageImage& image) {
    SavedEntities entities;
    const std::byte* from = image.bytes.data();
    const auto* records = storage.records();
    for (std::uint32_t i = 0; i <= image.used; ++i) entities.generations.push_back(records[i].generation);
    from += (std::size_t{image.used} + 1) * sizeof(EntityRecord);
    entities.free.resize(image.freeCount);
    if (image.freeCount > 0) std::memcpy(entities.free.data(), from, image.freeCount * sizeof(std::uint32_t));
    entities.retired = image.retired;
    entities.archive(archive);
    archive.count(image.pools.size());
    for (const std::unique_ptr<Pool>& pool : storage.pools()) {
        writeType(archive, pool->type->name, pool->type->info);
        std::uint32_t disorder = pool->disorder;
        archive.number(disorder);
        std::vector<std::uint32_t> owners(pool->dense, pool->dense + pool->count);
        archive.list(owners);
        const std::size_t bytes = std::size_t{pool->count} * pool->stride;
        std::vector<std::byte> column(bytes);
        if (bytes > 0) std::memcpy(column.data(), pool->column, bytes);
        archive.list(column);
    }
}

}  // namespace

std::string World::toBytes(std::vector<Error>& problems) const {
    std::string bytes;
    if (storage_.refusedInLoop("toBytes()")) return bytes;
    StateArchive archive = StateArchive::writer(bytes);
    std::uint32_t format = kFormat;
    archive.number(format);
    std::uint64_t now = tick, clock = storage_.clock();
    archive.number(now);
    archive.number(clock);
    archive.count(texts_.size());
    for (std::string text : texts_.all()) archive.text(text);
    StorageImage image;
    storage_.save(image);
    writeStorage(archive, storage_, image);
    TileStore{tiles_}.archive(archive);
    resources_.write(archive, problems);
    events_.write(archive, problems);
    return bytes;
}

Result<StorageImage> World::imageFrom(StateArchive& archive, std::vector<Error>& problems) const {
    SavedEntities entities;
    entities.archive(archive);
    if (!archive.ok() || !entities.isValid(storage_.maxEntities())) return notAState();
    const std::size_t count = archive.count(0);
    if (count > kMaxTypes) return notAState();
    std::vector<SavedPool> pools;
    for (std::size_t i = 0; i < count; ++i) {
        SavedPool pool = readPool(archive, types_, problems);
        if (!archive.ok() || !areValid(pool.owners, entities)) return notAState();
        const bool isKnown = std::any_of(pools.begin(), pools.end(),
                                         [&](const SavedPool& other) { return other.type == pool.type; });
        if (pool.type != nullptr && !isKnown) pools.push_back(std::move(pool));
    }
    return imageOf(entities, pools);
}

Result<Snapshot> World::snapshotFrom(std::string_view bytes, std::vector<Error>& problems) const {
    StateArchive archive = StateArchive::reader(bytes);
    std::uint32_t format = 0;
    archive.number(format);
    Snapshot snapshot;
    std::uint64_t clock = 0;
    archive.number(snapshot.tick_);
    archive.number(clock);
    if (format != kFormat) return notAState();
    const std::size_t texts = archive.count(0);
    for (std::size_t i = 0; i < texts && archive.ok(); ++i) {
        std::string text;
        archive.text(text);
        snapshot.texts_.add(text);
    }
    Result<StorageImage> image = imageFrom(archive, problems);
    if (!image) return image.error();
    snapshot.storage_ = std::move(*image);
    snapshot.storage_.clock = clock;
    snapshot.tiles_.archive(archive);
    snapshot.resources_ = resources_.read(archive, problems);
    snapshot.inboxes_ = events_.read(archive, problems);
    if (!archive.ok() || archive.left() > 0) return notAState();
    return snapshot;
}

}  // namespace plumb
