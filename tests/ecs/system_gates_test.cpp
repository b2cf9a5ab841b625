#include "ecs/system_gates.hpp"

#include <string>

#include <gtest/gtest.h>

#include "ecs/paused.hpp"
#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

struct Diary {
    std::string text;
};
/// Creates, in its third tick, the component that the following system requires.
struct MakerSystem {
    int ticks = 0;
    void update(World& world, float) {
        world.resource<Diary>().text += 'm';
        if (++ticks == 3) world.createEntity().addComponent<Position>();
    }
};
struct MoverSystem {
    void update(World& world, float) { world.resource<Diary>().text += 'p'; }
};
struct EndSystem {
    void update(World& world, float) {
        world.resource<Diary>().text += 'e';
        for (auto [entity, position] : world.query<const Position>()) entity.destroy();
    }
};
struct LateSystem {
    void update(World& world, float) { world.resource<Diary>().text += 'l'; }
};

bool hasPosition(const World& world) { return world.count<Position>() > 0; }

class SystemGatesTest : public testing::Test {
protected:
    SystemGatesTest() {
        world.addSystem<MakerSystem>();
        world.addSystem<MoverSystem>();
        gate = gates.add(typeKey<MoverSystem>(), hasPosition);
        world.provide(gates);
        EXPECT_EQ(played(1), "mp") << "p runs once without need, to create its queries";
        EXPECT_EQ(gates.gate(gate).runs, 0u);
    }
    std::string played(int ticks) {
        world.resource<Diary>().text.clear();
        for (int i = 0; i < ticks; ++i) world.update(0.0f);
        return world.resource<Diary>().text;
    }

    SystemGates gates;
    World world;
    std::size_t gate = 0;
};

TEST_F(SystemGatesTest, aSystemRunsFromTheTickInWhichAComponentRequiresIt) {
    EXPECT_EQ(played(3), "mmpmp") << "in tick 3, m creates the component before p";
    EXPECT_EQ(gates.gate(gate).runs, 2u);
    world.clear();
    EXPECT_EQ(played(2), "mm");
    EXPECT_EQ(gates.gate(gate).runs, 2u);
}

TEST_F(SystemGatesTest, pausedEntitiesStillRequireTheirSystems) {
    Entity waiting = world.createEntity();
    waiting.addComponent<Position>();
    waiting.addComponent<Paused>();
    EXPECT_EQ(played(1), "mp");
}

TEST_F(SystemGatesTest, pinsOverrideWhatComponentsRequire) {
    gates.setPin(gate, Pin::On);
    EXPECT_EQ(played(1), "mp");
    gates.setPin(gate, Pin::Off);
    EXPECT_EQ(played(3), "mmm");
    EXPECT_EQ(gates.gate(gate).runs, 1u);
    gates.setPin(gate, Pin::Auto);
    EXPECT_EQ(played(1), "mp");
}

TEST_F(SystemGatesTest, systemsAddedLaterHaveTheirOwnGates) {
    EXPECT_EQ(played(1), "m");
    world.addSystem<LateSystem>();
    world.addSystem<EndSystem>();
    const std::string_view order[] = {"MoverSystem", "EndSystem", "MakerSystem", "LateSystem"};
    world.setSystemOrder(order);
    EXPECT_EQ(played(3), "emlpemleml") << "e destroys what m made in the previous tick";
}

TEST_F(SystemGatesTest, gatesAreEvaluatedAgainAfterARestore) {
    const Snapshot empty = world.save();
    EXPECT_EQ(played(2), "mmp");
    world.restore(empty);
    EXPECT_EQ(played(1), "m");
}

}  // namespace
}  // namespace plumb
