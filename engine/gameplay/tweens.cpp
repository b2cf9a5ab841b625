#include "gameplay/tweens.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "ecs/saved_type.hpp"
#include "gameplay/delayed_events.hpp"

namespace plumb {
namespace {

/// Name of the field that begins there; empty if none does.
std::string fieldAt(const TypeInfo& type, std::uint32_t offset) {
    for (const FieldInfo& field : type.fields) {
        if (field.offset == offset) return std::string{field.name};
    }
    return {};
}

/// Finds the field of a tween that was read. @return false if there is no such field of its kind
bool placeTween(Tweens::Entry& entry, std::string_view name) {
    const ComponentType* type = entry.type < kMaxTypes ? findComponentType(entry.type) : nullptr;
    const FieldInfo* field = type == nullptr ? nullptr : type->info.find(name);
    if (field == nullptr || entry.ease > Ease::BounceOut || entry.ticks == 0) return false;
    constexpr std::array kKinds{FieldKind::Float, FieldKind::Vec2, FieldKind::Color};
    if (entry.kind > Tweens::Kind::Color || field->kind != kKinds[static_cast<std::size_t>(entry.kind)])
        return false;
    entry.offset = static_cast<std::uint32_t>(field->offset);
    return true;
}

}  // namespace
namespace {

std::array<float, 4> valueAt(const Tweens::Entry& tween, const std::byte* field) {
    std::array<float, 4> value{};
    if (tween.kind == Tweens::Kind::Color) {
        for (std::size_t i = 0; i < 4; ++i) value[i] = static_cast<float>(std::to_integer<int>(field[i]));
    } else {
        std::memcpy(value.data(), field, tween.kind == Tweens::Kind::Float ? sizeof(float) : sizeof(Vec2));
    }
    return value;
}

bool sameComponent(const Tweens::Entry& a, const Tweens::Entry& b) {
    return a.entity == b.entity && a.type == b.type;
}

/// The bytes of a component that a tween changes.
struct Range {
    std::size_t begin = 0, end = 0;
};
Range rangeOf(const Tweens::Entry& tween) {
    constexpr std::size_t kSizes[] = {sizeof(float), sizeof(Vec2), 4 * sizeof(std::uint8_t)};  // by Kind
    return {tween.offset, tween.offset + kSizes[static_cast<std::size_t>(tween.kind)]};
}

/// Takes the bytes of a new tween from an earlier one of the same component: of a vector whose one coordinate
/// it changes, the earlier one keeps the other. @return true if nothing is left of the earlier one
bool giveWay(Tweens::Entry& earlier, const Tweens::Entry& later) {
    const Range old = rangeOf(earlier), taken = rangeOf(later);
    if (taken.begin >= old.end || taken.end <= old.begin) return false;
    if (earlier.kind != Tweens::Kind::Vec2 || later.kind != Tweens::Kind::Float) return true;
    const std::size_t kept = later.offset == earlier.offset ? 1 : 0;
    earlier.kind = Tweens::Kind::Float;
    earlier.offset += static_cast<std::uint32_t>(kept * sizeof(float));
    earlier.from = {earlier.from[kept]};
    earlier.to = {earlier.to[kept]};
    return false;
}

}  // namespace

std::byte* fieldOf(World& world, const Tweens::Entry& tween) {
    const ComponentType* type = findComponentType(tween.type);
    void* component = type == nullptr ? nullptr : world.find(type->info, tween.entity);
    return component == nullptr ? nullptr : static_cast<std::byte*>(component) + tween.offset;
}

void Tweens::archive(StateArchive& archive) {
    const std::size_t count = archive.count(entries.size());
    if (archive.reading()) entries.assign(count, {});
    for (Entry& entry : entries) {
        const ComponentType* type = archive.reading() ? nullptr : findComponentType(entry.type);
        // By the name of the field, as its place may be another in the next version of the game.
        std::string field = type == nullptr ? std::string{} : fieldAt(type->info, entry.offset);
        archiveKey(archive, entry.type);
        archive.text(field);
        archive.value(entry.entity);
        archive.value(entry.offset);
        archive.value(entry.kind);
        archive.value(entry.ease);
        archive.value(entry.from);
        archive.value(entry.to);
        archive.value(entry.start);
        archive.value(entry.ticks);
        if (archive.reading() && !placeTween(entry, field)) entry.type = kMaxTypes;
    }
    std::erase_if(entries, [](const Entry& entry) { return entry.type >= kMaxTypes; });
}

void Tweens::addTo(Hasher& hasher) const {
    for (const Entry& entry : entries) {
        hasher.add(std::uint64_t{entry.entity.index} << 32 | entry.entity.generation);
        hasher.add(std::uint64_t{entry.offset} << 16 |
                   std::uint64_t{static_cast<std::uint8_t>(entry.kind)} << 8 |
                   static_cast<std::uint8_t>(entry.ease));
        for (std::size_t i = 0; i < 4; ++i) hasher.add(entry.from[i]), hasher.add(entry.to[i]);
        hasher.add(entry.start);
        hasher.add(entry.ticks);
    }
}

void addTween(World& world, Tweens::Entry entry, float seconds) {
    const std::byte* field = fieldOf(world, entry);
    if (field == nullptr) return;
    if (!isTime(world, seconds, "tween()", findComponentType(entry.type)->name)) return;
    entry.from = valueAt(entry, field);
    entry.start = world.tick;
    entry.ticks = ticksOf(seconds);
    Tweens& tweens = world.resource<Tweens>();
    std::size_t kept = 0;
    for (Tweens::Entry& other : tweens.entries) {
        if (!sameComponent(other, entry) || !giveWay(other, entry)) tweens.entries[kept++] = other;
    }
    tweens.entries.resize(kept);
    tweens.entries.push_back(entry);
}

void stopTweens(World& world, EntityId entity) {
    if (auto* tweens = world.findResource<Tweens>())
        std::erase_if(tweens->entries, [&](const Tweens::Entry& tween) { return tween.entity == entity; });
}

}  // namespace plumb
