#include <cstring>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "ecs/world.hpp"
#include "reflect/convert_component.hpp"
#include "reflect/type_key.hpp"
#include "reflect/type_registry.hpp"
#include "tests/support/random_type.hpp"

// Component types whose description (name, fields) changes while worlds contain components of them, as when
// the editor reloads the code of a game.

namespace plumb {
namespace {

struct Marker {
    int value = 0;
};

class ChangedTypes : public ::testing::Test {
protected:
    TypeRegistry types;
    World world;
    Random random = Random::seeded(7);

    const TypeInfo& add(TypeInfo type) {
        const TypeInfo& known = types.update(std::move(type));
        updateComponentType(known);
        return known;
    }
    void fill(const TypeInfo& type, EntityId entity) {
        auto* bytes = static_cast<std::byte*>(world.find(type, entity));
        for (std::size_t i = 0; i < type.size; ++i) bytes[i] = static_cast<std::byte>(random.below(2));
    }
};

TEST_F(ChangedTypes, aThousandRandomEditsKeepEveryFieldThatStays) {
    const TypeKey key = nextTypeKey();
    const TypeInfo* type = &add(made_types::random(random, key, "Made"));
    std::vector<EntityId> owners;
    for (int i = 0; i < 60; ++i) {
        const Entity entity = world.createEntity();
        if (i % 2 == 0) world.add<Marker>(entity.id()).value = i;
        if (i % 3 == 0) continue;
        world.add(*type, entity.id());
        owners.push_back(entity.id());
    }
    int compared = 0;
    for (int edit = 0; edit < 1000; ++edit) {
        for (const EntityId owner : owners) fill(*type, owner);
        const TypeInfo before = *type;
        std::map<EntityId, std::vector<std::byte>> components;
        std::vector<EntityId> order;
        world.eachOf(before, [&](EntityId owner, const void* at) {
            const auto* bytes = static_cast<const std::byte*>(at);
            components[owner].assign(bytes, bytes + before.size);
            order.push_back(owner);
        });
        ASSERT_EQ(order.size(), owners.size());

        type = &add(made_types::random(random, key, "Made"));
        world.convert(before, type);

        std::vector<EntityId> now;
        world.eachOf(*type, [&](EntityId owner, const void* at) {
            now.push_back(owner);
            std::vector<std::byte> expected = type->defaults;
            convertComponent(before, components[owner].data(), *type, expected.data());
            ASSERT_EQ(std::memcmp(at, expected.data(), expected.size()), 0) << "edit " << edit;
            ++compared;
        });
        ASSERT_EQ(now, order) << "the order of a query is part of the simulation";
    }
    EXPECT_EQ(compared, 40'000);
    int markers = 0;
    for (auto [entity, marker] : world.query<const Marker>()) markers += marker.value;
    EXPECT_EQ(markers, 29 * 30) << "components of other types are unchanged";
}

TEST_F(ChangedTypes, loseTheirComponentsWhenTheyAreRemoved) {
    const TypeInfo& type = add(made_types::random(random, nextTypeKey(), "Made"));
    const Entity entity = world.createEntity();
    world.add(type, entity.id());
    world.convert(type, nullptr);
    EXPECT_FALSE(world.has(type, entity.id()));
    EXPECT_TRUE(entity.alive());
    types.remove("Made");
    EXPECT_EQ(types.find("Made"), nullptr);
    EXPECT_EQ(type.name, "Made") << "references to the description stay valid";
}

TEST_F(ChangedTypes, comeBackWithAnotherLayout) {
    const TypeKey key = nextTypeKey();
    TypeInfo small, large;
    small.name = large.name = "Made";
    small.key = large.key = key;
    small.fields = {made_types::field("speed", FieldKind::Float)};
    for (const std::string_view name : made_types::kNames)
        large.fields.push_back(made_types::field(name, FieldKind::Vec2));
    made_types::layOut(small);
    made_types::layOut(large, std::byte{7});
    const TypeInfo before = add(small);
    const Entity entities[] = {world.createEntity(), world.createEntity()};
    for (const Entity& entity : entities) world.add(before, entity.id());
    world.convert(before, nullptr);
    types.remove("Made");

    const TypeInfo& now = add(large);
    for (const Entity& entity : entities) world.add(now, entity.id());
    for (const Entity& entity : entities)
        EXPECT_EQ(std::memcmp(world.find(now, entity.id()), now.defaults.data(), now.size), 0);
    EXPECT_EQ(world.count(now), 2u);
}

TEST_F(ChangedTypes, areRestoredInAWorldThatHadTheOldLayout) {
    const TypeKey key = nextTypeKey();
    TypeInfo small, large;
    small.name = large.name = "Made";
    small.key = large.key = key;
    small.fields = {made_types::field("speed", FieldKind::Float)};
    for (const std::string_view name : made_types::kNames)
        large.fields.push_back(made_types::field(name, FieldKind::Vec2));
    made_types::layOut(small);
    made_types::layOut(large);
    const TypeInfo before = add(small);
    const Entity entities[] = {world.createEntity(), world.createEntity()};
    for (const Entity& entity : entities) world.add(before, entity.id());
    World copy{types};
    copy.restore(world.save());

    const TypeInfo& now = add(large);
    world.convert(before, &now);
    for (const Entity& entity : entities) fill(now, entity.id());
    copy.restore(world.save());
    for (const Entity& entity : entities)
        EXPECT_EQ(std::memcmp(world.find(now, entity.id()), copy.find(now, entity.id()), now.size), 0);
    EXPECT_EQ(copy.hash(), world.hash());
}

TEST_F(ChangedTypes, thatCodeUsesWithoutAListAreRemovedWhenItIsLoadedAgain) {
    TypeInfo unlisted;
    unlisted.name = "Unlisted";
    unlisted.key = reloadableTypeKey("convert_test::Unlisted");
    unlisted.size = 4;
    unlisted.defaults.assign(4, std::byte{1});
    TypeInfo listed = made_types::random(random, reloadableTypeKey("convert_test::Listed"), "Listed");
    World game{types};
    add(listed);
    const EntityId entity = game.createEntity().id();
    game.add(unlisted, entity);
    game.add(listed, entity);
    game.add<Marker>(entity).value = 3;
    game.dropReloadable();
    EXPECT_FALSE(game.has(unlisted, entity));
    EXPECT_TRUE(game.has(listed, entity));
    EXPECT_EQ(game.get<Marker>(entity).value, 3);

    unlisted.size = 400;
    unlisted.defaults.assign(400, std::byte{2});
    const EntityId other = game.createEntity().id();
    for (const EntityId id : {entity, other}) game.add(unlisted, id);
    for (const EntityId id : {entity, other})
        EXPECT_EQ(std::memcmp(game.find(unlisted, id), unlisted.defaults.data(), 400), 0);
}

TEST_F(ChangedTypes, canGetAnotherKey) {
    TypeInfo first = made_types::random(random, nextTypeKey(), "Made");
    TypeInfo second = first;
    second.key = nextTypeKey();
    const TypeInfo before = add(std::move(first));
    const Entity entity = world.createEntity();
    world.add(before, entity.id());
    fill(before, entity.id());
    std::vector<std::byte> bytes(before.size);
    std::memcpy(bytes.data(), world.find(before, entity.id()), before.size);
    const TypeInfo& now = add(std::move(second));
    world.convert(before, &now);
    EXPECT_FALSE(world.has(before, entity.id()));
    ASSERT_TRUE(world.has(now, entity.id()));
    std::vector<std::byte> expected = now.defaults;
    convertComponent(before, bytes.data(), now, expected.data());
    EXPECT_EQ(std::memcmp(world.find(now, entity.id()), expected.data(), now.size), 0);
}

TEST_F(ChangedTypes, canBecomeATagAndBack) {
    const TypeKey key = nextTypeKey();
    TypeInfo tag;
    tag.name = "Made";
    tag.key = key;
    const TypeInfo before = add(made_types::random(random, key, "Made"));
    const Entity entity = world.createEntity();
    world.add(before, entity.id());
    world.convert(before, &add(tag));
    EXPECT_TRUE(world.has(*types.find("Made"), entity.id()));
    const TypeInfo& again = add(made_types::random(random, key, "Made"));
    world.convert(tag, &again);
    ASSERT_TRUE(world.has(again, entity.id()));
    EXPECT_EQ(std::memcmp(world.find(again, entity.id()), again.defaults.data(), again.size), 0);
}

}  // namespace
}  // namespace plumb
