#include <map>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

/// The expected components of an entity.
struct Expected {
    std::optional<float> position;
    std::optional<float> velocity;
    std::optional<int> health;
    bool frozen = false;
};

using Model = std::map<EntityId, Expected>;

void expectSame(World& world, const Model& model) {
    ASSERT_EQ(world.entityCount(), model.size());
    std::size_t positions = 0;
    std::size_t movers = 0;
    std::size_t thawed = 0;
    for (const auto& [id, expected] : model) {
        ASSERT_TRUE(world.alive(id));
        const Position* position = world.find<const Position>(id);
        const Velocity* velocity = world.find<const Velocity>(id);
        const Health* health = world.find<const Health>(id);
        ASSERT_EQ(position != nullptr, expected.position.has_value());
        ASSERT_EQ(velocity != nullptr, expected.velocity.has_value());
        ASSERT_EQ(health != nullptr, expected.health.has_value());
        ASSERT_EQ(world.has<Frozen>(id), expected.frozen);
        if (position != nullptr) {
            ASSERT_EQ(position->x, *expected.position);
        }
        if (velocity != nullptr) {
            ASSERT_EQ(velocity->x, *expected.velocity);
        }
        if (health != nullptr) {
            ASSERT_EQ(health->points, *expected.health);
        }
        positions += position != nullptr ? 1 : 0;
        movers += position != nullptr && velocity != nullptr ? 1 : 0;
        thawed += position != nullptr && velocity != nullptr && !expected.frozen ? 1 : 0;
    }
    ASSERT_EQ(world.count<Position>(), positions);
    std::size_t seen = 0;
    for (auto [entity, position, velocity] : world.query<Position, const Velocity>()) {
        ASSERT_EQ(world.find<Position>(entity), &position);
        ASSERT_EQ(world.find<const Velocity>(entity), &velocity);
        ++seen;
    }
    ASSERT_EQ(seen, movers);
    seen = 0;
    world.query<const Position, const Velocity>(without<Frozen>)
        .each([&](EntityId id, const Position& position, const Velocity&) {
            const Expected& expected = model.at(id);
            ASSERT_EQ(position.x, *expected.position);
            ASSERT_FALSE(expected.frozen);
            ++seen;
        });
    ASSERT_EQ(seen, thawed);
}

/// Performs the same random operations on a world and on a model of it.
class Experiment {
public:
    explicit Experiment(std::uint64_t seed) : random{Random::seeded(seed)} {}

    void act(World& world) {
        const std::uint32_t what = random.below(16);
        if (what < 3 || ids.empty()) {
            const Entity entity = world.createEntity();
            model[entity] = {};
            ids.push_back(entity);
            return;
        }
        const std::size_t at = random.below(static_cast<std::uint32_t>(ids.size()));
        const EntityId id = ids[at];
        Expected& expected = model[id];
        const int number = static_cast<int>(random.below(1000));
        if (what < 5) {
            world.destroy(id);
            EXPECT_FALSE(world.alive(id));
            model.erase(id);
            ids[at] = ids.back();
            ids.pop_back();
        } else if (what < 8) {
            world.add<Position>(id, static_cast<float>(number), 0.0f);
            expected.position = static_cast<float>(number);
        } else if (what < 10) {
            world.add<Velocity>(id).x = static_cast<float>(number);
            expected.velocity = static_cast<float>(number);
        } else if (what < 11) {
            world.add<Health>(id).points = number;
            expected.health = number;
        } else if (what < 12) {
            world.add<Frozen>(id);
            expected.frozen = true;
        } else if (what < 13) {
            world.remove<Position>(id);
            expected.position.reset();
        } else if (what < 14) {
            world.remove<Velocity>(id);
            expected.velocity.reset();
        } else if (what < 15) {
            world.remove<Frozen>(id);
            expected.frozen = false;
        } else if (number < 20) {
            world.cluster();
        }
    }

    Random random;
    Model model;
    std::vector<EntityId> ids;
};

TEST(ModelTest, propertyRandomOperationsMatchAModel) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        World world;
        Experiment experiment{seed};
        for (int step = 0; step < 1500; ++step) {
            experiment.act(world);
            if (step % 250 == 0) expectSame(world, experiment.model);
            if (HasFatalFailure()) return;
        }
        expectSame(world, experiment.model);
        if (HasFatalFailure()) return;
    }
}

TEST(ModelTest, propertyRandomOperationsInsideLoopsMatchAModel) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        World world;
        Experiment experiment{seed};
        for (int step = 0; step < 300; ++step) experiment.act(world);
        for (int round = 0; round < 10; ++round) {
            for (auto [entity, position] : world.query<const Position>()) {
                ASSERT_TRUE(entity.alive());
                ASSERT_EQ(position.x, *experiment.model.at(entity).position);
                // Clustering is not allowed inside loops, so random numbers that would select it are skipped.
                Experiment dice = experiment;
                if (dice.random.below(16) == 15) {
                    experiment.random.below(16);
                    continue;
                }
                experiment.act(world);
                int nested = 0;
                for (auto [other, velocity] : world.query<const Velocity>()) {
                    ASSERT_EQ(velocity.x, *experiment.model.at(other).velocity);
                    if (++nested > 5) break;
                }
            }
            expectSame(world, experiment.model);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(ModelTest, propertyASnapshotRestoresEverything) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        World world;
        Experiment experiment{seed};
        for (int step = 0; step < 500; ++step) experiment.act(world);
        const Snapshot saved = world.save();
        const std::uint64_t hash = world.hash();
        const Experiment then = experiment;

        for (int step = 0; step < 500; ++step) experiment.act(world);
        const std::uint64_t later = world.hash();
        EXPECT_NE(later, hash) << "the operations must change the world";
        world.restore(saved);
        EXPECT_EQ(world.hash(), hash);
        expectSame(world, then.model);

        Experiment again = then;
        for (int step = 0; step < 500; ++step) again.act(world);
        EXPECT_EQ(world.hash(), later) << "the same operations must give the same state";
        expectSame(world, again.model);
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace plumb
