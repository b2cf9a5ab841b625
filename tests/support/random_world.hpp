#pragma once

#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/world.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb {

/// Sets fields of components to random values that a file can store. Uses reflection only.
class RandomValues {
public:
    RandomValues(World& world, Random& random, const std::vector<EntityId>& entities)
        : world_{world}, random_{random}, entities_{entities} {}

    void fill(const FieldInfo& field, void* object) {
        fillValue(field, field.kind, field.in(object), field.size);
    }

private:
    template <class Value>
    static void put(void* to, Value value) {
        std::memcpy(to, &value, sizeof value);
    }

    float number(const FieldInfo& field) {
        const float low = std::max(field.min, -1e6f);
        const float high = std::min(field.max, 1e6f);
        return std::min(std::max(random_.between(low, high), low), high);
    }

    void fillWhole(const FieldInfo& field, void* value, std::size_t size) {
        const auto number = static_cast<std::int64_t>(std::floor(this->number(field)));
        const std::int64_t kept = field.isSigned ? number : std::abs(number);
        const std::int64_t limited = size == 1 ? kept & 0x7f : size == 2 ? kept & 0x7fff : kept;
        std::memcpy(value, &limited, size);
    }

    TextId text() {
        static constexpr const char* kTexts[] = {
            "", "a", "two words", "line\nbreak \"quoted\" \\ \t", "ünïcödé 漢字", "{coins}"};
        return world_.texts().add(kTexts[random_.below(6)]);
    }

    TextId path() {
        static constexpr const char* kPaths[] = {"", "assets/player.png", "engine:fonts/small.ttf",
                                                 "a b/c.json"};
        return world_.texts().add(kPaths[random_.below(4)]);
    }

    Curve curve(const FieldInfo& field) {
        Curve curve = Curve::constant(number(field));
        curve.shape = random_.below(2) == 0 ? CurveShape::Smooth : CurveShape::Linear;
        curve.keys[0].at = random_.between(0.0f, 0.1f);
        for (std::uint32_t more = random_.below(8); more > 0; --more)
            curve.insert({curve.keys[curve.size() - 1].at + random_.between(0.001f, 0.12f), number(field)});
        return curve;
    }

    TilesId tiles() {
        TileGrid grid{static_cast<int>(random_.below(9)), static_cast<int>(random_.below(5))};
        for (int i = 0; i < 12; ++i) {
            const TileCell flips = random_.below(3) == 0 ? random_.next() & kTileFlips : 0;
            const int x = static_cast<int>(random_.below(9));
            grid.set(x, static_cast<int>(random_.below(5)),
                     cellOf(static_cast<int>(random_.below(400)), flips));
        }
        return world_.tiles().add(std::move(grid));
    }

    void fillValue(const FieldInfo& field, FieldKind kind, void* value, std::size_t size) {
        switch (kind) {
            case FieldKind::Bool: put(value, random_.below(2) == 1); break;
            case FieldKind::Int: fillWhole(field, value, size); break;
            case FieldKind::Float: put(value, number(field)); break;
            case FieldKind::Vec2:
            case FieldKind::Rect:
                for (std::size_t at = 0; at < size; at += sizeof(float)) {
                    put(static_cast<char*>(value) + at,
                        random_.below(5) == 0 ? -0.0f : random_.between(-1e5f, 1e5f));
                }
                break;
            case FieldKind::Color: put(value, random_.next()); break;
            case FieldKind::Text: put(value, text()); break;
            case FieldKind::Asset: put(value, path()); break;
            case FieldKind::Enum: {
                const int chosen =
                    field.names[random_.below(static_cast<std::uint32_t>(field.names.size()))].value;
                std::memcpy(value, &chosen, size);
                break;
            }
            case FieldKind::Entity:
                put(value, random_.below(3) == 0
                               ? EntityId{}
                               : entities_[random_.below(static_cast<std::uint32_t>(entities_.size()))]);
                break;
            case FieldKind::Tiles: put(value, random_.below(4) == 0 ? TilesId{} : tiles()); break;
            case FieldKind::List: {
                if (isCurve(field)) return put(value, curve(field));
                const auto count = random_.below(static_cast<std::uint32_t>(field.capacity) + 1);
                field.countOf(value) = count;
                for (std::uint32_t i = 0; i < count; ++i) {
                    fillValue(field, field.element, static_cast<char*>(value) + i * field.elementSize,
                              field.elementSize);
                }
                break;
            }
        }
    }

    World& world_;
    Random& random_;
    const std::vector<EntityId>& entities_;
};

/// Adds a scene whose entities have random components with random values.
/// @param all  true: the first entity has all component types
inline SceneId addRandomScene(World& world, const TypeRegistry& types, std::uint64_t seed,
                              std::uint32_t count, bool all) {
    Random random = Random::seeded(seed);
    const SceneId scene = addScene(world, "scenes/random.scene.json");
    std::vector<EntityId> entities;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Entity entity = world.createEntity();
        entity.addComponent<SceneEntity>(SceneEntity{newStableId(random), static_cast<int>(i), scene});
        if (i > 0 && random.below(3) == 0) setParent(world, entity, entities[random.below(i)]);
        entities.push_back(entity);
    }
    RandomValues values{world, random, entities};
    for (const EntityId entity : entities) {
        if (random.below(2) == 0)
            world.add<Name>(entity).text = world.texts().add("name " + hexText(random.next()));
        for (const TypeInfo& type : types.all()) {
            const bool ofTheFile =
                type.name == "SceneEntity" || type.name == "Name" || startsWith(type.name, "Prefab");
            if (ofTheFile || (!(all && entity == entities.front()) && random.below(6) != 0)) continue;
            void* object = world.add(type, entity);
            for (const FieldInfo& field : type.fields) {
                if (!field.transient && random.below(4) != 0) values.fill(field, object);
            }
        }
    }
    return scene;
}

}  // namespace plumb
