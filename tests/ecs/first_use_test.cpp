#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ecs/parts.hpp"

// The state of a world must not depend on the component types that were used in queries, or on their order: a
// program with a window uses other types than one without.

namespace plumb {
namespace {

constexpr int kTypes = 80;  ///< more than the 64 bits of a component mask
constexpr int kEntities = 200;

/// One of many component types that no entity has and only queries use.
template <int N>
struct Unused {
    int value = N;
};

template <template <int> class Type, int... N>
void askFor(World& world, std::integer_sequence<int, N...>) {
    (static_cast<void>(world.query<const Type<N>>().count()), ...);
}
template <template <int> class Type, int... N>
void askBackwards(World& world, std::integer_sequence<int, N...>) {
    (static_cast<void>(world.query<const Type<kTypes - 1 - N>>().count()), ...);
}

template <int... N>
void addSome(Entity entity, int seed, std::integer_sequence<int, N...>) {
    const auto maybe = [&]<int M>(std::integral_constant<int, M>) {
        if ((seed * 7 + M * M) % 11 == 0) entity.addComponent<Numbered<M>>();
    };
    (maybe(std::integral_constant<int, N>{}), ...);
}

using All = std::make_integer_sequence<int, kTypes>;

void fill(World& world) {
    for (int i = 0; i < kEntities; ++i) {
        Entity entity = world.createEntity();
        entity.addComponent<Position>(static_cast<float>(i), 0.0f);
        addSome(entity, i % 13, All{});
    }
}

std::vector<std::uint32_t> orderOf(World& world) {
    std::vector<std::uint32_t> order;
    for (auto [entity, position] : world.query<const Position>()) order.push_back(entity.id().index);
    return order;
}

TEST(FirstUse, theClusteredOrderDoesNotDependOnTheTypesUsed) {
    World plain;
    fill(plain);
    plain.cluster();
    const std::vector<std::uint32_t> expected = orderOf(plain);
    ASSERT_EQ(expected.size(), static_cast<std::size_t>(kEntities));
    ASSERT_FALSE(std::is_sorted(expected.begin(), expected.end())) << "nothing was reordered";

    const auto expectSame = [&](World& world) {
        world.cluster();
        EXPECT_EQ(orderOf(world), expected);
        EXPECT_EQ(world.hash(), plain.hash());
    };
    {
        SCOPED_TRACE("types that no entity has, before");
        World world;
        askFor<Unused>(world, All{});
        fill(world);
        expectSame(world);
    }
    {
        SCOPED_TRACE("types that no entity has, after");
        World world;
        fill(world);
        askFor<Unused>(world, All{});
        expectSame(world);
    }
    {
        SCOPED_TRACE("the same types in another order");
        World world;
        askBackwards<Numbered>(world, All{});
        fill(world);
        expectSame(world);
    }
    {
        SCOPED_TRACE("copied into a world that was asked for others");
        World world;
        askFor<Unused>(world, All{});
        world.restore(plain.save());
        expectSame(world);
    }
}

TEST(FirstUse, aRemovedComponentDoesNotAffectTheState) {
    World plain;
    World other;
    askFor<Unused>(other, All{});
    fill(plain);
    fill(other);
    for (EntityId id : other.entities()) {
        if (id.index % 3 != 0) continue;
        other.add<Health>(id);  // its pool has an index above 63
        other.remove<Health>(id);
    }
    plain.cluster();
    other.cluster();
    EXPECT_EQ(orderOf(other), orderOf(plain));
    EXPECT_EQ(other.hash(), plain.hash());
}

struct OneName {
    int value = 1;

    static void describe(TypeBuilder<OneName>& type) {
        type.name("One");
        type.field<&OneName::value>("value");
    }
};
struct SameName {
    int value = 2;

    static void describe(TypeBuilder<SameName>& type) {
        type.name("One");
        type.field<&SameName::value>("value");
    }
};

TEST(FirstUse, typesOfTheSameNameAreOrderedByTheirFields) {
    const auto make = [](World& world) {
        for (int i = 0; i < 12; ++i) {
            Entity entity = world.createEntity();
            entity.addComponent<Position>(static_cast<float>(i), 0.0f);
            if (i % 3 == 0) entity.addComponent<OneName>();
            if (i % 3 == 1) entity.addComponent<SameName>();
        }
        world.cluster();
    };
    World first;
    World second;
    EXPECT_EQ(first.count<OneName>(), 0u);
    EXPECT_TRUE(second.query<const SameName>().empty());
    make(first);
    make(second);
    EXPECT_EQ(orderOf(first), orderOf(second));
    EXPECT_EQ(first.hash(), second.hash());
}

}  // namespace
}  // namespace plumb
