#include "ecs/world.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/assert.hpp"
#include "core/crash.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "reflect/convert_component.hpp"
#include "reflect/type_key.hpp"
#include "reflect/type_registry.hpp"

namespace plumb {

namespace {

/// Worlds of up to this many entities are sorted by cluster() while they run. In larger ones that would
/// be a noticeable delay (about 10 ns per component), so they are sorted when they are loaded.
constexpr std::size_t kTidyEntities = 32768;

}  // namespace

std::uint32_t nextQueryKey() {
    static std::atomic<std::uint32_t> next{0};
    return next++;
}

World::World() {
    storage_.watch(typeKey<Parent>());
    storage_.watch(typeKey<Children>());
    storage_.pool<Paused>();  // created early, because every query refers to it
}

void World::leaveFamily(EntityId id) { plumb::leaveFamily(*this, id); }

void World::beginTick() {
    ++tick;
    events_.clear();
    reportMissed();
    dropUnusedTiles();
    // Not while entities are paused, because they must keep their order.
    const bool tidy = !storage_.iterating() && entityCount() <= kTidyEntities && count<Paused>() == 0;
    if (tidy && storage_.fragmented()) storage_.cluster();
}

void World::dropUnusedTiles() {
    if (tiles_.size() == 0) return;
    tiles_.unmarkAll();
    for (const std::unique_ptr<Pool>& pool : storage_.pools()) {
        if (!pool->type->namesTiles) continue;
        for (const FieldInfo& field : pool->type->info.fields) {
            if (field.kind != FieldKind::Tiles) continue;
            eachOf(pool->type->info, [&](EntityId, const void* component) {
                tiles_.mark(*static_cast<const TilesId*>(field.in(component)));
            });
        }
    }
    tiles_.dropUnmarked();
}

std::vector<EntityId> World::entities() const {
    std::vector<EntityId> ids;
    ids.reserve(entityCount());
    for (std::uint32_t index = 1; index <= storage_.usedIndices(); ++index) {
        if (storage_.livesAt(index)) ids.push_back(storage_.idAt(index));
    }
    return ids;
}

// types known at run time

namespace {

/// Tags have no memory, but callers check for null: all share this address.
std::byte tagAddress;

}  // namespace

void* World::find(const TypeInfo& type, EntityId id) {
    Pool* const pool = storage_.findPool(type.key);
    if (pool == nullptr || !pool->has(id)) return nullptr;
    if (pool->stride == 0) return &tagAddress;
    const std::uint32_t position = pool->sparse[id.index].position;
    pool->stamp(position, 1, storage_.clock());
    return pool->at(position);
}

const void* World::find(const TypeInfo& type, EntityId id) const {
    const Pool* const pool = storage_.findPool(type.key);
    if (pool == nullptr || !pool->has(id)) return nullptr;
    return pool->stride == 0 ? &tagAddress : pool->at(pool->sparse[id.index].position);
}

bool World::has(const TypeInfo& type, EntityId id) const {
    const Pool* const pool = storage_.findPool(type.key);
    return pool != nullptr && pool->has(id);
}

std::size_t World::count(const TypeInfo& type) const {
    const Pool* const pool = storage_.findPool(type.key);
    return pool == nullptr ? 0 : pool->size();
}

void* World::add(const TypeInfo& type, EntityId id) {
    Pool& pool = storage_.pool(type);
    if (!storage_.alive(id)) {
        reportMissing(this, id, type.key);
        return nullptr;
    }
    pool.makeRoom(id.index);
    if (!pool.has(id)) storage_.append(pool, id);
    if (pool.stride == 0) return &tagAddress;
    void* const memory = find(type, id);
    PLUMB_ASSERT(!type.defaults.empty(), "a component added by its TypeInfo needs a default constructor");
    type.construct(memory);
    return memory;
}

void World::remove(const TypeInfo& type, EntityId id) {
    Pool* const pool = storage_.findPool(type.key);
    if (pool != nullptr && pool->has(id)) storage_.erase(*pool, id, pool->stride);
}

void World::convert(const TypeInfo& before, const TypeInfo* now) {
    if (storage_.refusedInLoop("convert()")) return;
    Pool* const pool = storage_.findPool(before.key);
    if (pool == nullptr) return;
    std::vector<EntityId> owners;
    owners.reserve(pool->count);
    for (std::uint32_t position = 0; position < pool->count; ++position)
        owners.push_back(storage_.idAt(pool->dense[position]));
    const std::vector<std::byte> bytes(pool->column, pool->column + std::size_t{pool->stride} * pool->count);
    const std::size_t stride = pool->stride;
    for (auto owner = owners.rbegin(); owner != owners.rend(); ++owner)
        storage_.erase(*pool, *owner, pool->stride);
    if (now == nullptr || now->key != before.key) storage_.forget(*pool);
    if (now == nullptr) return;
    if (now->key == before.key) storage_.renew(*pool, componentTypeOf(*now));
    for (std::size_t i = 0; i < owners.size(); ++i) {
        void* const component = add(*now, owners[i]);
        if (now->size != 0) convertComponent(before, bytes.data() + stride * i, *now, component);
    }
}

void World::dropReloadable() {
    if (storage_.refusedInLoop("dropReloadable()")) return;
    resources_.dropReloadable();
    events_.dropReloadable();
    for (std::size_t i = 0; i < storage_.pools().size(); ++i) {
        const TypeInfo& type = storage_.pools()[i]->type->info;
        const bool described = types_ != nullptr && types_->find(type.key) != nullptr;
        if (isReloadable(type.key) && !described) convert(TypeInfo{type}, nullptr);
    }
    storage_.dropCaches();
}

void World::reportAllMissed() {
    for (std::uint64_t i = 0; i < Missed::kSlots; ++i) {
        if ((missed_.slots >> i & 1) == 0) continue;
        const std::uint64_t id = missed_.ids[i];
        reportMissing(this, {static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(id >> 32)},
                      static_cast<TypeKey>(missed_.keys[i]));
    }
    missed_.slots = 0;
}

void reportMissing(const World* world, EntityId id, TypeKey key) {
    const ComponentType* const type = findComponentType(key);
    const std::string name{type != nullptr ? std::string_view{type->name} : typeNameOf(key)};
    const std::string_view system = Running::current;
    Reports* const reports = world != nullptr ? &world->reports() : Reports::current;
    if (reports != nullptr && !reports->isFirst(system, name)) return;
    const bool isEmpty = world == nullptr || id.index == 0;
    const std::string entity = isEmpty ? "the empty handle"
                                       : format("entity {} (generation {}), {}", id.index, id.generation,
                                                world->alive(id) ? "an entity that has none"
                                                                 : "a stale handle of a destroyed entity");
    const Error error{system.empty() ? std::string{"entity handle"} : std::string{system},
                      format("{} was requested from {}, so all its fields are 0, and what is written to them "
                             "is lost",
                             name, entity),
                      format("{}, or use find<{}>(), which returns nullptr",
                             isEmpty ? "check that what was searched or spawned exists: if (entity)"
                             : world->alive(id) ? format("check hasComponent<{}>()", name)
                                                : "check alive()",
                             name)};
    PLUMB_ASSERT(false, error.text().c_str());
    logError("World", error);
}

void failWithoutWorld() {
    failAssertion("world() was called of the empty handle, which belongs to no world; check it: if (entity)",
                  __FILE__, __LINE__);
    std::abort();
}

// services

void World::provide(TypeKey key, void* service) {
    for (auto& [known, pointer] : services_) {
        if (known == key) {
            pointer = service;
            return;
        }
    }
    services_.emplace_back(key, service);
}

void* World::findService(TypeKey key) const {
    for (const auto& [known, pointer] : services_) {
        if (known == key) return pointer;
    }
    return nullptr;
}

// copies

Snapshot World::save() const {
    Snapshot snapshot;
    save(snapshot);
    return snapshot;
}

void World::save(Snapshot& snapshot) const {
    if (storage_.refusedInLoop("save()")) return;
    storage_.save(snapshot.storage_);
    snapshot.resources_.assign(resources_);
    snapshot.tiles_ = tiles_;
    // Texts are only added, so equal sizes mean equal content.
    if (snapshot.source_ != this || snapshot.texts_.size() != texts_.size()) snapshot.texts_ = texts_;
    snapshot.source_ = this;
    snapshot.tick_ = tick;
    events_.save(snapshot.inboxes_);
}

void World::restore(const Snapshot& snapshot) {
    if (storage_.refusedInLoop("restore()")) return;
    if (snapshot.byteCount() == 0) {
        const Error error{"World",
                          "restore() was called with a snapshot that holds no world; nothing was done",
                          "fill it by save() first, outside loops over queries"};
        PLUMB_ASSERT(false, error.text().c_str());
        return logError("World", error);
    }
    storage_.restore(snapshot.storage_);
    resources_.assign(snapshot.resources_);
    tiles_ = snapshot.tiles_;
    if (snapshot.source_ != this) texts_ = snapshot.texts_;  // adds the missing ones
    tick = snapshot.tick_;
    events_.retire();
    events_.restore(snapshot.inboxes_);
    commands_.clear();
}

namespace {

/// Hashes the components of a pool in the order of their entities.
void addTo(Hasher& hasher, const Storage& storage, const Pool& pool) {
    for (std::uint32_t index = 1; index <= storage.usedIndices(); ++index) {
        if (!pool.holds(index)) continue;
        hasher.add(std::uint64_t{index});
        hashComponent(hasher, pool.type->info, pool.at(pool.sparse[index].position));
    }
}

std::uint64_t hashOf(const Storage& storage, const Pool& pool) {
    Hasher hasher;
    addTo(hasher, storage, pool);
    return hasher.value();
}

}  // namespace

std::uint64_t World::hash() const {
    Hasher hasher;
    hasher.add(tick);
    hasher.add(std::uint64_t{storage_.entityCount()});
    for (std::uint32_t index = 1; index <= storage_.usedIndices(); ++index) {
        const EntityId id = storage_.idAt(index);
        if (storage_.livesAt(index)) hasher.add(std::uint64_t{id.generation} << 32 | index);
    }
    std::vector<const Pool*> pools;
    for (const auto& pool : storage_.pools()) {
        if (pool->size() > 0) pools.push_back(pool.get());
    }
    // Two types may have the same name, e.g. in two unnamed namespaces; then their components decide.
    std::sort(pools.begin(), pools.end(), [this](const Pool* a, const Pool* b) {
        return a->type->nameHash != b->type->nameHash ? a->type->nameHash < b->type->nameHash
                                                      : hashOf(storage_, *a) < hashOf(storage_, *b);
    });
    for (const Pool* pool : pools) {
        hasher.add(pool->type->nameHash);
        addTo(hasher, storage_, *pool);
    }
    tiles_.addTo(hasher);
    resources_.addTo(hasher);
    events_.addTo(hasher);
    return hasher.value();
}

}  // namespace plumb
