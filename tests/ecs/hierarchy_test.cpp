#include "ecs/hierarchy.hpp"

#include <algorithm>
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

std::vector<EntityId> listed(World& world, EntityId parent) {
    std::vector<EntityId> children;
    for (Entity child : childrenOf(world, parent)) children.push_back(child);
    return children;
}

TEST(HierarchyTest, childrenAreInOrder) {
    World world;
    Entity parent = world.createEntity();
    Entity a = world.createEntity();
    Entity b = world.createEntity();
    Entity c = world.createEntity();
    for (Entity child : {a, b, c}) EXPECT_TRUE(setParent(world, child, parent));
    EXPECT_EQ(listed(world, parent), (std::vector<EntityId>{a, b, c}));
    EXPECT_EQ(childrenOf(world, parent).size(), 3u);
    EXPECT_EQ(parentOf(world, b), parent);

    setParent(world, b, {});
    EXPECT_EQ(listed(world, parent), (std::vector<EntityId>{a, c}));
    EXPECT_FALSE(parentOf(world, b));
    setParent(world, a, b);
    EXPECT_EQ(listed(world, parent), (std::vector<EntityId>{c}));
    EXPECT_EQ(listed(world, b), (std::vector<EntityId>{a}));
    c.destroy();
    EXPECT_TRUE(childrenOf(world, parent).empty());
    EXPECT_FALSE(parent.hasComponent<Children>());
}

TEST(HierarchyTest, destroyingAParentDestroysItsChildren) {
    World world;
    std::vector<Entity> chain;
    for (int i = 0; i < 10; ++i) {
        chain.push_back(world.createEntity());
        if (i > 0) setParent(world, chain.back(), chain[static_cast<std::size_t>(i) - 1]);
    }
    Entity sibling = world.createEntity();
    setParent(world, sibling, chain[0]);

    chain[1].destroy();

    EXPECT_EQ(world.entityCount(), 2u);
    EXPECT_TRUE(chain[0].alive());
    EXPECT_TRUE(sibling.alive());
    EXPECT_EQ(listed(world, chain[0]), std::vector<EntityId>{sibling});
}

TEST(HierarchyTest, cyclesAndDestroyedParentsAreRejected) {
    World world;
    Entity a = world.createEntity();
    Entity b = world.createEntity();
    Entity c = world.createEntity();
    EXPECT_TRUE(setParent(world, b, a));
    EXPECT_TRUE(setParent(world, c, b));
    EXPECT_FALSE(setParent(world, a, c));
    EXPECT_FALSE(setParent(world, a, a));
    EXPECT_TRUE(isAncestor(world, a, c));
    EXPECT_FALSE(isAncestor(world, c, a));
    Entity gone = world.createEntity();
    gone.destroy();
    EXPECT_FALSE(setParent(world, a, gone));
    EXPECT_FALSE(setParent(world, gone, a));
    EXPECT_FALSE(parentOf(world, a));
}

TEST(HierarchyTest, childrenMayBeDestroyedDuringIteration) {
    World world;
    Entity parent = world.createEntity();
    for (int i = 0; i < 10; ++i) setParent(world, world.createEntity(), parent);
    int at = 0;
    for (Entity child : childrenOf(world, parent)) {
        if (at++ % 2 == 0) child.destroy();
    }
    EXPECT_EQ(at, 10);
    EXPECT_EQ(childrenOf(world, parent).size(), 5u);
}

/// A chain of entities, each the child of the one before; built from its top or from its end.
std::vector<Entity> chainOf(World& world, std::size_t count, bool fromTop) {
    std::vector<Entity> chain(count);
    for (Entity& entity : chain) {
        entity = world.createEntity();
        entity.addComponent<Position>();
    }
    for (std::size_t i = 1; i < count; ++i) {
        const std::size_t child = fromTop ? i : count - i;
        EXPECT_TRUE(setParent(world, chain[child], chain[child - 1]));
    }
    return chain;
}

// A function that recurses along the chain exhausts the stack; one that walks along
// it for each entity takes 5 * 10^9 steps, more than 10 s.
TEST(HierarchyTest, aChainOf100000EntitiesIsBuiltMovedAndDestroyedInTimeAndWithoutRecursion) {
    constexpr std::size_t kCount = 100'000;
    constexpr double kMostSeconds = 5.0;
    const std::clock_t start = std::clock();
    for (const bool fromTop : {true, false}) {
        World world;
        const std::vector<Entity> chain = chainOf(world, kCount, fromTop);
        EXPECT_TRUE(isAncestor(world, chain.front(), chain.back()));
        EXPECT_FALSE(setParent(world, chain.front(), chain.back())) << "a cycle";

        Entity other = world.createEntity();
        EXPECT_TRUE(setParent(world, chain[kCount / 2], other));
        std::size_t below = 0;
        forEachBelow(world, other, [&](EntityId) { return ++below, true; });
        EXPECT_EQ(below, kCount / 2);

        other.destroy();
        EXPECT_EQ(world.entityCount(), kCount / 2);
        int visited = 0;
        for (auto [entity, position] : world.query<Position>()) {
            ++visited;
            chain[1].destroy();  // all others, inside a loop
        }
        EXPECT_EQ(visited, 1);
        EXPECT_EQ(world.entityCount(), 1u);
        EXPECT_EQ(world.count<Parent>() + world.count<Children>(), 0u);
    }
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kMostSeconds);
}

TEST(HierarchyProperty, destroyingFreesIndicesChildrenBeforeTheirParentsInOrder) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        std::vector<Entity> all;
        for (std::uint32_t i = 0; i < 40; ++i) {
            all.push_back(world.createEntity());
            if (i > 0) setParent(world, all.back(), all[random.below(i)]);
        }
        std::vector<EntityId> expected;  // by a recursive walk
        const std::function<void(EntityId)> walk = [&](EntityId parent) {
            for (Entity child : childrenOf(world, parent)) walk(child);
            expected.push_back(parent);
        };
        walk(all[0]);
        std::vector<EntityId> visited{all[0]};
        forEachBelow(world, all[0], [&](EntityId id) {
            EXPECT_EQ(std::count(visited.begin(), visited.end(), parentOf(std::as_const(world), id)), 1)
                << "parents before their children";
            visited.push_back(id);
            return true;
        });
        EXPECT_EQ(visited.size(), 40u);

        all[0].destroy();

        ASSERT_EQ(expected.size(), 40u);
        for (auto freed = expected.rbegin(); freed != expected.rend(); ++freed)
            ASSERT_EQ(world.createEntity().id().index, freed->index) << "the index freed last is used first";
    }
}

TEST(HierarchyTest, aListOfChildrenThatSetParentDidNotWriteEndsTheDestruction) {
    World world;
    Entity parent = world.createEntity();
    Entity stranger = world.createEntity();
    parent.addComponent<Children>(Children{stranger, stranger, 1});
    parent.destroy();
    EXPECT_FALSE(parent.alive());
    EXPECT_TRUE(stranger.alive());
}

TEST(HierarchyTest, hierarchiesMayBeDestroyedInALoop) {
    World world;
    Entity parent = world.createEntity();
    for (int i = 0; i < 10; ++i) {
        Entity child = world.createEntity();
        child.addComponent<Position>();
        setParent(world, child, parent);
    }
    int visited = 0;
    for (auto [entity, position] : world.query<Position>()) {
        ++visited;
        parent.destroy();
    }
    EXPECT_EQ(visited, 1);
    EXPECT_EQ(world.entityCount(), 0u);
    EXPECT_EQ(world.count<Parent>(), 0u);
}

TEST(HierarchyTest, propertyListsAndParentsAgree) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        std::vector<Entity> all;
        for (int i = 0; i < 30; ++i) all.push_back(world.createEntity());
        for (int step = 0; step < 200; ++step) {
            const Entity child = all[random.below(30)];
            const Entity parent = all[random.below(30)];
            const std::uint32_t what = random.below(200);
            if (what == 0)
                child.destroy();
            else
                setParent(world, child, what < 5 ? EntityId{} : parent.id());
        }
        std::size_t linked = 0;
        for (const Entity parent : all) {
            for (Entity child : childrenOf(world, parent)) {
                ASSERT_EQ(parentOf(world, child), parent);
                ASSERT_FALSE(isAncestor(world, child, parent));
                ++linked;
            }
        }
        EXPECT_EQ(linked, world.count<Parent>());
        EXPECT_GT(linked, 0u);
    }
}

TEST(HierarchyProperty, theOrderOfChildrenIsThatInWhichTheyWereAttached) {
    constexpr std::uint32_t kCount = 12;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        std::vector<Entity> all;
        for (std::uint32_t i = 0; i < kCount; ++i) all.push_back(world.createEntity());
        std::vector<std::vector<std::uint32_t>> children(kCount);
        std::vector<std::uint32_t> parent(kCount, kCount);  // kCount: a root
        for (int step = 0; step < 150; ++step) {
            const std::uint32_t child = random.below(kCount), to = random.below(kCount + 1);
            bool isAllowed = child != to;
            for (std::uint32_t at = to; at != kCount; at = parent[at]) isAllowed = isAllowed && at != child;
            ASSERT_EQ(setParent(world, all[child], to < kCount ? all[to].id() : EntityId{}), isAllowed);
            if (isAllowed && parent[child] != to) {  // a child of the same parent keeps its place
                if (parent[child] != kCount) std::erase(children[parent[child]], child);
                if (to != kCount) children[to].push_back(child);
                parent[child] = to;
            }
            for (std::uint32_t i = 0; i < kCount; ++i) {
                std::vector<EntityId> expected;
                for (const std::uint32_t each : children[i]) expected.push_back(all[each]);
                ASSERT_EQ(listed(world, all[i]), expected);
                ASSERT_EQ(childrenOf(world, all[i]).size(), expected.size());
                ASSERT_EQ(firstChildOf(world, all[i]), expected.empty() ? EntityId{} : expected.front());
                ASSERT_EQ(parentOf(world, all[i]).id(),
                          parent[i] == kCount ? EntityId{} : all[parent[i]].id());
            }
        }
    }
}

TEST(HierarchyProperty, aWalkSkipsWhatIsBelowAnEntityIfTheVisitorSaysSo) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        std::vector<Entity> all;
        for (std::uint32_t i = 0; i < 30; ++i) {
            all.push_back(world.createEntity());
            if (i > 0) setParent(world, all.back(), all[random.below(i)]);
        }
        const auto goesDown = [&](EntityId id) { return (id.index * 7 + seed) % 3 != 0; };
        for (const Entity root : all) {
            std::vector<EntityId> expected;
            const std::function<void(EntityId)> walk = [&](EntityId parent) {
                for (Entity child : childrenOf(world, parent)) {
                    expected.push_back(child);
                    if (goesDown(child)) walk(child);
                }
            };
            walk(root);
            std::vector<EntityId> visited;
            forEachBelow(world, root, [&](EntityId id) { return visited.push_back(id), goesDown(id); });
            ASSERT_EQ(visited, expected);
            ASSERT_FALSE(nextBelow(world, root, root, false)) << "nothing follows the root";
        }
    }
}

}  // namespace
}  // namespace plumb
