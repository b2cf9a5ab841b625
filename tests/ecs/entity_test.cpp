#include "ecs/entity.hpp"

#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#if defined(__unix__)
#include <sys/resource.h>
#endif

#include "core/assert.hpp"
#include "ecs/hierarchy.hpp"
#include "tests/ecs/parts.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

struct Remembers {
    std::uint64_t entities = 0;
    float scale = 0.0f;
    Remembers(World& world, float factor) : entities{world.entityCount()}, scale{factor} {}
};

std::string lastSentence;

/// Stores the message of a failed assertion instead of aborting.
class SentenceCatcher {
public:
    SentenceCatcher()
        : before_{setAssertHandler([](const char* text, const char*, int) { lastSentence = text; })} {
        lastSentence.clear();
    }
    ~SentenceCatcher() { setAssertHandler(before_); }

private:
    AssertHandler before_;
};

TEST(EntityTest, componentsAreAddedReadAndRemoved) {
    World world;
    Entity e = world.createEntity();

    e.addComponent<Position>(10, 20);
    EXPECT_TRUE(e.hasComponent<Position>());
    EXPECT_FLOAT_EQ(e.get<Position>().x, 10.0f);
    EXPECT_EQ(e.find<Velocity>(), nullptr);

    e.removeComponent<Position>();
    EXPECT_FALSE(e.hasComponent<Position>());
    EXPECT_EQ(e.find<Position>(), nullptr);
    e.removeComponent<Position>();  // no effect
    EXPECT_TRUE(e.alive());
}

TEST(EntityTest, addingAgainReplaces) {
    World world;
    Entity e = world.createEntity();
    e.addComponent<Position>(1.0f, 2.0f);

    Position& replaced = e.addComponent<Position>(e.get<Position>().y, e.get<Position>().x);

    EXPECT_EQ(replaced.x, 2.0f);
    EXPECT_EQ(replaced.y, 1.0f);
    EXPECT_EQ(world.count<Position>(), 1u);
}

TEST(EntityTest, componentConstructorsMayTakeTheWorld) {
    World world;
    world.createEntity();
    Entity e = world.createEntity();

    EXPECT_EQ(e.addComponent<Remembers>(2.0f).entities, 2u);
    EXPECT_EQ(e.get<Remembers>().scale, 2.0f);
    EXPECT_EQ(e.addComponent<Velocity>(3.0f, 4.0f).y, 4.0f);  // an aggregate
}

TEST(EntityTest, theEmptyHandleRefersToNoEntity) {
    World world;
    const Entity none;
    EXPECT_FALSE(none);
    EXPECT_FALSE(none.hasComponent<Position>());
    EXPECT_EQ(none.find<Position>(), nullptr);
    none.destroy();
    world.createEntity().addComponent<Position>();
    EXPECT_EQ(world.find<Position>(EntityId{}), nullptr);
    EXPECT_EQ(world.find<Position>(EntityId{1, 0}), nullptr);
    EXPECT_EQ(world.find<Position>(EntityId{4000000000u, 1}), nullptr);
    EXPECT_FALSE(world.alive(EntityId{}));
    EXPECT_FALSE(world.alive(EntityId{7, 0}));
}

TEST(EntityTest, aStaleHandleNeverRefersToAnotherEntity) {
    World world;
    Entity first = world.createEntity();
    first.addComponent<Position>(1.0f, 1.0f);
    first.destroy();
    EXPECT_FALSE(first.alive());

    Entity second = world.createEntity();
    second.addComponent<Position>(2.0f, 2.0f);

    ASSERT_EQ(second.id().index, first.id().index) << "the freed index is used again";
    EXPECT_NE(first, second);
    EXPECT_FALSE(first.alive());
    EXPECT_EQ(first.find<Position>(), nullptr);
    EXPECT_FALSE(first.hasComponent<Position>());
    first.destroy();
    first.removeComponent<Position>();
    EXPECT_EQ(second.get<Position>().x, 2.0f);
}

TEST(EntityTest, usingAStaleHandleFailsWithAClearMessage) {
    World world;
    Entity e = world.createEntity();
    e.addComponent<Position>(5.0f, 5.0f);
    e.destroy();
    const SentenceCatcher catcher;

    EXPECT_EQ(e.get<Position>().x, 0.0f) << "an empty component, not the one of another entity";
#if !defined(NDEBUG) || defined(PLUMB_ASSERTS)
    EXPECT_NE(lastSentence.find("Position was requested from entity 1 (generation 1)"), std::string::npos)
        << lastSentence;
    EXPECT_NE(lastSentence.find("stale"), std::string::npos) << lastSentence;
#endif
    EXPECT_EQ(world.count<Position>(), 0u);
}

TEST(EntityTest, accessingAMissingComponentFailsWithAClearMessage) {
    World world;
    Entity e = world.createEntity();
    const SentenceCatcher catcher;
    e.get<Velocity>().x = 1.0f;
#if !defined(NDEBUG) || defined(PLUMB_ASSERTS)
    EXPECT_NE(lastSentence.find("Velocity"), std::string::npos) << lastSentence;
    EXPECT_NE(lastSentence.find("an entity that has none"), std::string::npos) << lastSentence;
#endif
    EXPECT_FALSE(e.hasComponent<Velocity>());
}

/// Calls all functions of a handle and of its world that take an id, for an entity that does not exist.
void useInVain(World& world, Entity entity) {
    const EntityId id = entity;
    const TypeInfo& type = componentType<Position>().info;
    EXPECT_FALSE(entity);
    EXPECT_FALSE(entity.hasComponent<Position>());
    EXPECT_FALSE(entity.hasComponent<Frozen>());
    EXPECT_EQ(entity.find<Position>(), nullptr);
    EXPECT_EQ(entity.find<const Position>(), nullptr);
    entity.get<Position>().x = 5.0f;
    entity.get<const Position>();
    entity.get<Frozen>();
    entity.addComponent<Position>(1.0f, 2.0f).y = 3.0f;
    entity.addComponent<Frozen>();
    entity.removeComponent<Position>();
    entity.destroy();
    EXPECT_FALSE(world.alive(id));
    EXPECT_EQ(world.find<Position>(id), nullptr);
    EXPECT_EQ(world.find(type, id), nullptr);
    EXPECT_EQ(std::as_const(world).find(type, id), nullptr);
    EXPECT_FALSE(world.has<Position>(id));
    EXPECT_FALSE(world.has(type, id));
    EXPECT_EQ(world.add(type, id), nullptr);
    world.add<Position>(id, 1.0f, 2.0f);
    world.get<Position>(id).x = 6.0f;
    std::as_const(world).get<Position>(id);
    world.remove<Position>(id);
    world.remove(type, id);
    world.destroy(id);
    EXPECT_FALSE(world.changedSince<Position>(id, 0));
    EXPECT_EQ(world.positionOf<Position>(id), 0u);
    EXPECT_EQ(world.positionOf<Numbered<7>>(id), 0u) << "of a type that the world has not met";
    EXPECT_FALSE(setParent(world, id, {}));
    EXPECT_FALSE(setParent(world, world.first<Position>(), id) && id.index != 0);
    EXPECT_FALSE(parentOf(world, id));
    EXPECT_TRUE(childrenOf(world, id).empty());
    for (Entity child : childrenOf(world, id)) ADD_FAILURE() << child.id().index;
    EXPECT_FALSE(isAncestor(world, id, id));
    world.commands().add(id, Position{1.0f, 2.0f});
    world.commands().remove<Position>(id);
    world.commands().destroy(id);
    world.commands().flush(world);
}

TEST(EntityProperty, noFunctionChangesAWorldThroughAHandleOfNoEntity) {
    const test::Faults faults;
    World world;
    World other;
    fillWithMovers(world, 5);
    fillWithMovers(other, 60);
    world.destroy(EntityId{3, 1});
    const auto stateOf = [&world] {
        std::vector<float> state;
        for (auto [entity, position] : std::as_const(world).query<const Position>())
            state.insert(state.end(), {static_cast<float>(entity.id().index), position.x, position.y});
        return std::pair{state, world.hash()};
    };
    const auto before = stateOf();

    useInVain(world, Entity{});
    for (std::uint32_t index = 0; index < 60; ++index) {
        for (const std::uint32_t generation : {0u, 1u, 2u, 3u, 4u, 0xfffffffeu}) {
            SCOPED_TRACE(testing::Message() << index << ", generation " << generation);
            const EntityId id{index, generation};
            if (!world.alive(id)) useInVain(world, world.entity(id));
        }
    }
    useInVain(world, world.entity({4000000000u, 1}));
    for (auto [entity, position] : other.query<Position>()) {
        if (!world.alive(entity)) useInVain(world, world.entity(entity));
    }

    EXPECT_EQ(stateOf(), before);
    EXPECT_EQ(world.entityCount(), 4u);
    EXPECT_EQ(world.count<Frozen>(), 0u);
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(world.createEntity().hasComponent<Position>());
}

TEST(EntityTest, whatIsWrittenToAMissingComponentIsLost) {
    test::Faults faults;
    World world;
    const Entity e = world.createEntity();
    for (const Entity handle : {e, Entity{}}) {
        handle.get<Position>().x = 5.0f;
        EXPECT_EQ(handle.get<Position>().x, 0.0f);
    }
}

TEST(EntityTest, theWorldOfTheEmptyHandleStopsTheProgramWithAMessage) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(static_cast<void>(Entity{}.world()), "belongs to no world; check it: if \\(entity\\)");
}

TEST(EntityTest, handlesCompareByIndexAndGeneration) {
    World world;
    Entity a = world.createEntity();
    Entity b = world.createEntity();
    EXPECT_LT(a, b);
    EXPECT_TRUE(b >= a);
    EXPECT_EQ(a, world.entity(a.id()));
    EXPECT_EQ(std::set<Entity>({b, a, b}).size(), 2u);
    EXPECT_EQ(a, EntityId(a));
}

TEST(EntityTest, columnsNeverMove) {
    World world;
    Entity first = world.createEntity();
    const Position* place = &first.addComponent<Position>(7.0f, 0.0f);
    fillWithMovers(world, 100000);
    EXPECT_EQ(first.find<Position>(), place);
    EXPECT_EQ(place->x, 7.0f);
}

TEST(EntityTest, tagsTakeNoMemory) {
    World world;
    Entity e = world.createEntity();
    e.addComponent<Frozen>();
    EXPECT_TRUE(e.hasComponent<Frozen>());
    EXPECT_NE(e.find<Frozen>(), nullptr);
    EXPECT_EQ(componentType<Frozen>().info.size, 0u);
    EXPECT_EQ(&e.get<Frozen>(), &world.createEntity().addComponent<Frozen>()) << "tags share one object";
    e.removeComponent<Frozen>();
    EXPECT_FALSE(e.hasComponent<Frozen>());
}

template <int... N>
void addAll(Entity entity, std::integer_sequence<int, N...>) {
    (entity.addComponent<Numbered<N>>(), ...);
}

template <int... N>
int countAll(Entity entity, std::integer_sequence<int, N...>) {
    return ((entity.hasComponent<Numbered<N>>() && entity.get<Numbered<N>>().value == N ? 1 : 0) + ...);
}

TEST(EntityTest, moreThanSixtyFourComponentTypesWork) {
    using All = std::make_integer_sequence<int, 100>;
    World world;
    Entity e = world.createEntity();
    Entity other = world.createEntity();
    addAll(e, All{});
    addAll(other, All{});
    EXPECT_EQ(countAll(e, All{}), 100);

    e.removeComponent<Numbered<80>>();
    e.removeComponent<Numbered<3>>();
    EXPECT_EQ(countAll(e, All{}), 98);
    EXPECT_EQ((world.query<Numbered<2>, Numbered<80>>().count()), 1u);
    EXPECT_EQ(world.query<Numbered<2>>(without<Numbered<80>>).first(), e);
    EXPECT_EQ(world.query<Numbered<90>>(without<Numbered<3>>).first(), e);
    world.cluster();
    EXPECT_EQ(countAll(other, All{}), 100);

    e.destroy();
    EXPECT_EQ(world.count<Numbered<99>>(), 1u);
    EXPECT_EQ(world.count<Numbered<10>>(), 1u);
    EXPECT_EQ(countAll(other, All{}), 100);
    EXPECT_EQ(countAll(world.createEntity(), All{}), 0) << "a new entity with the freed index is empty";
}

TEST(EntityTest, aWorldOfTagsOnlyIsClustered) {
    World world;
    for (int i = 0; i < 10; ++i) world.createEntity().addComponent<Frozen>();
    world.cluster();
    EXPECT_EQ(world.count<Frozen>(), 10u);
}

TEST(EntityTest, manyEntitiesAreCreatedInOneCall) {
    World world;
    world.createEntity().destroy();
    std::vector<EntityId> ids(1000);
    world.createEntities(ids, Position{1.0f, 2.0f}, Velocity{3.0f, 4.0f}, Frozen{});
    EXPECT_EQ(world.entityCount(), 1000u);
    EXPECT_EQ((world.query<Position, Velocity, Frozen>().count()), 1000u);
    EXPECT_EQ(world.get<Velocity>(ids[999]).y, 4.0f);
    world.destroy(ids[500]);
    EXPECT_FALSE(world.alive(ids[500]));
    EXPECT_EQ(world.count<Velocity>(), 999u);
}

TEST(EntityTest, clearDestroysAllAndMakesHandlesStale) {
    World world;
    fillWithMovers(world, 300);
    Entity e = world.query<Position>().first();
    world.clear();
    EXPECT_EQ(world.entityCount(), 0u);
    EXPECT_FALSE(e.alive());
    EXPECT_EQ(world.count<Position>(), 0u);
    fillWithMovers(world, 10);
    EXPECT_FALSE(e.alive());
    EXPECT_EQ((world.query<Position, Velocity>().count()), 10u);
}

TEST(EntityTest, accessByReflectionReturnsTheSameComponents) {
    World world;
    Entity e = world.createEntity();
    const TypeInfo& type = componentType<Position>().info;
    const TypeInfo& tag = componentType<Frozen>().info;

    static_cast<Position*>(world.add(type, e))->x = 4.0f;
    world.add(tag, e);

    EXPECT_EQ(e.get<Position>().x, 4.0f);
    EXPECT_TRUE(e.hasComponent<Frozen>());
    EXPECT_NE(world.find(tag, e), nullptr);
    EXPECT_EQ(world.find(type, e), e.find<Position>());
    world.add(type, e);
    EXPECT_EQ(e.get<Position>().x, 0.0f) << "a component added again has default values";
    world.remove(type, e);
    world.remove(tag, e);
    EXPECT_FALSE(world.has(type, e));
    EXPECT_FALSE(e.hasComponent<Frozen>());
}

template <std::size_t N>
struct Block {
    std::array<std::uint8_t, N> bytes{};
};

template <std::size_t N>
void expectBytesToSurviveTheRemovalOfOthers() {
    SCOPED_TRACE(N);
    World world;
    std::vector<Entity> entities;
    for (std::uint8_t i = 0; i < 20; ++i) {
        entities.push_back(world.createEntity());
        auto& bytes = entities.back().addComponent<Block<N>>().bytes;
        for (std::size_t k = 0; k < N; ++k) bytes[k] = static_cast<std::uint8_t>(i * 7 + k);
    }
    for (std::size_t i = 0; i < 20; i += 3) entities[i].removeComponent<Block<N>>();
    for (std::size_t i = 0; i < 20; ++i) {
        ASSERT_EQ(entities[i].hasComponent<Block<N>>(), i % 3 != 0);
        if (i % 3 == 0) continue;
        const auto& bytes = entities[i].get<Block<N>>().bytes;
        for (std::size_t k = 0; k < N; ++k) ASSERT_EQ(bytes[k], static_cast<std::uint8_t>(i * 7 + k));
    }
}

TEST(EntityTest, componentsOfEverySizeKeepTheirBytesWhenOthersAreRemoved) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (expectBytesToSurviveTheRemovalOfOthers<I + 1>(), ...);
    }
    (std::make_index_sequence<40>{});
}

#if defined(__unix__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
template <int kNumber>
struct Numbered {
    float values[16] = {};
};

/// Creates an entity with 64 component types in a process limited to 4 GiB of address space, and exits.
template <int... kNumbers>
[[noreturn]] void liveIn4GiB(std::integer_sequence<int, kNumbers...>) {
    const rlimit limit{std::size_t{4} << 30, std::size_t{4} << 30};
    setrlimit(RLIMIT_AS, &limit);
    World world;
    Entity entity = world.createEntity();
    (entity.addComponent<Numbered<kNumbers>>(), ...);
    std::exit(entity.hasComponent<Numbered<63>>() ? 0 : 1);
}

TEST(EntityTest, aWorldWorksWithALimitedAddressSpace) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(liveIn4GiB(std::make_integer_sequence<int, 64>{}), testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace plumb
