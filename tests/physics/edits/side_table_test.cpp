#include "physics/model/side_table.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "physics/simulation.hpp"

// Rarely used properties of bodies and shapes are stored in rows of side tables. A row is created when a body
// or shape needs one, and freed with it.

namespace plumb::physics {
namespace {

constexpr float kTick = 1.0f / 60.0f;

TEST(SideTable, hasOneRowOfDefaultsForAllWithoutOne) {
    SideTable<BodyDrive> table;
    EXPECT_EQ(table[kNone], BodyDrive{});
    std::uint32_t a = kNone, b = kNone;
    table.own(a).linearDrag = 1.0f;
    table.own(b).linearDrag = 2.0f;
    table.own(a).angularDrag = 3.0f;  // a already has a row
    EXPECT_EQ(table[a].linearDrag, 1.0f);
    EXPECT_EQ(table[a].angularDrag, 3.0f);
    EXPECT_EQ(table[b].linearDrag, 2.0f);
    EXPECT_EQ(table[kNone], BodyDrive{});
}

TEST(SideTable, reusedRowsHaveDefaults) {
    SideTable<BodyDrive> table;
    std::uint32_t a = kNone, b = kNone;
    table.own(a).linearDrag = 1.0f;
    table.release(a);
    EXPECT_EQ(a, kNone);
    table.release(a);  // no effect: its row is already free
    EXPECT_EQ(table.own(b), BodyDrive{});
    EXPECT_EQ(table.rows.size(), 1u);
    EXPECT_TRUE(table.free.empty());
}

/// Expects that every used index has a row of its own, and that all other rows are in the list `free`.
void expectNoRowIsLostOrShared(std::vector<std::uint32_t> used, const std::vector<std::uint32_t>& free,
                               std::size_t rows) {
    used.erase(std::remove(used.begin(), used.end(), kNone), used.end());
    used.insert(used.end(), free.begin(), free.end());
    std::sort(used.begin(), used.end());
    ASSERT_EQ(used.size(), rows);
    for (std::uint32_t i = 0; i < rows; ++i) ASSERT_EQ(used[i], i);
}

void expectNoRowIsLostOrShared(const World& world) {
    std::vector<std::uint32_t> drives, extras;
    for (const BodyInfo& info : world.bodies.info) drives.push_back(info.drive);
    for (const ShapeInfo& info : world.shapes.info) extras.push_back(info.extras);
    expectNoRowIsLostOrShared(drives, world.bodies.drives.free, world.bodies.drives.rows.size());
    expectNoRowIsLostOrShared(extras, world.shapes.extras.free, world.shapes.extras.rows.size());
}

struct Known {
    BodyId body;
    ShapeId shape;
    BodyDrive drive;
    ShapeExtras extras;
};

class Crowd {
public:
    explicit Crowd(std::uint64_t seed) : random_{Random::seeded(seed)} {}

    void changeSomething() {
        if (known.empty() || random_.below(4) == 0) return add();
        Known& one = known[random_.below(static_cast<std::uint32_t>(known.size()))];
        switch (random_.below(7)) {
            case 0: return remove(one);
            case 1:
                return expectOk(setAcceleration(world, one.body, one.drive.acceleration = {value(), 0.0f}));
            case 2: return expectOk(setGravityScale(world, one.body, one.drive.gravityScale = value()));
            case 3:
                one.drive.linearDrag = value(), one.drive.angularDrag = value();
                return expectOk(setDrag(world, one.body, one.drive.linearDrag, one.drive.angularDrag));
            case 4:
                one.drive.force += {2.0f, 3.0f};
                return expectOk(applyForce(world, one.body, {2.0f, 3.0f}));
            case 5: one.drive.torque += 1.0f; return expectOk(applyTorque(world, one.body, 1.0f));
            default: return expectOk(setSurfaceSpeed(world, one.shape, one.extras.surfaceSpeed = value()));
        }
    }

    void advance() {
        step(world, kTick);
        for (Known& one : known) one.drive.force = {}, one.drive.torque = 0.0f;
    }

    World world;
    std::vector<Known> known;

private:
    static void expectOk(const Result<Done>& result) { EXPECT_TRUE(result.ok()); }

    /// Returns the default value 0 in half of the cases, otherwise a random one.
    float value() { return random_.below(2) == 0 ? 0.0f : random_.between(0.1f, 2.0f); }

    void add() {
        Known one;
        one.drive.linearDrag = value();
        one.drive.gravityScale = random_.below(2) == 0 ? 1.0f : value();
        one.extras.rollingResistance = value();
        one.extras.frontLayers = random_.below(2);
        const bool oneWay = random_.below(3) == 0;
        if (oneWay) one.extras.oneWayDirection = {0.0f, -1.0f};
        one.body =
            *createBody(world, {.position = {random_.between(-9.0f, 9.0f), random_.between(-9.0f, 9.0f)},
                                .gravityScale = one.drive.gravityScale,
                                .linearDrag = one.drive.linearDrag});
        one.shape = *createShape(world, one.body, box({0.5f, 0.5f}),
                                 {.rollingResistance = one.extras.rollingResistance,
                                  .oneWay = oneWay,
                                  .frontLayers = one.extras.frontLayers});
        known.push_back(one);
    }

    void remove(Known& one) {
        destroyBody(world, one.body);
        one = known.back();
        known.pop_back();
    }

    Random random_;
};

TEST(SideTable, keepsPropertiesWhileBodiesAndShapesAreAddedAndRemoved) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Crowd crowd{seed};
        for (int i = 0; i < 120; ++i) {
            crowd.changeSomething();
            if (i % 10 == 9) crowd.advance();
            for (const Known& one : crowd.known) {
                ASSERT_EQ(crowd.world.bodies.driveOf(one.body.index), one.drive) << i;
                ASSERT_EQ(crowd.world.shapes.extrasOf(one.shape.index), one.extras) << i;
            }
            ASSERT_NO_FATAL_FAILURE(expectNoRowIsLostOrShared(crowd.world)) << i;
        }
        ASSERT_FALSE(crowd.world.bodies.drives.rows.empty());
        while (!crowd.known.empty()) {
            destroyBody(crowd.world, crowd.known.back().body);
            crowd.known.pop_back();
        }
        EXPECT_EQ(crowd.world.bodies.drives.free.size(), crowd.world.bodies.drives.rows.size());
        EXPECT_EQ(crowd.world.shapes.extras.free.size(), crowd.world.shapes.extras.rows.size());
    }
}

TEST(SideTable, needsNoRowForDefaults) {
    World world;
    const BodyId body = *createBody(world, {});
    const ShapeId shape =
        *createShape(world, body, box({0.5f, 0.5f}), {.friction = 0.2f, .bounciness = 0.5f});
    EXPECT_TRUE(setAcceleration(world, body, {}).ok());
    EXPECT_TRUE(setGravityScale(world, body, 1.0f).ok());
    EXPECT_TRUE(setDrag(world, body, 0.0f, 0.0f).ok());
    EXPECT_TRUE(setMass(world, body, 3.0f).ok());
    EXPECT_TRUE(setSurfaceSpeed(world, shape, 0.0f).ok());
    EXPECT_TRUE(world.bodies.drives.rows.empty());
    EXPECT_TRUE(world.shapes.extras.rows.empty());
}

TEST(Mass, staysAsSetWhenShapesChange) {
    World world;
    const BodyId body = *createBody(world, {});
    ASSERT_TRUE(createShape(world, body, box({0.5f, 0.5f})).ok());
    ASSERT_TRUE(setMass(world, body, 7.0f).ok());
    ASSERT_TRUE(createShape(world, body, box({0.5f, 0.5f}, {1.0f, 0.0f})).ok());
    setFixedRotation(world, body, true);
    EXPECT_EQ(massOf(world, body), 7.0f);
    ASSERT_TRUE(setMass(world, body, 0.0f).ok());
    EXPECT_EQ(massOf(world, body), 2.0f);  // mass of two boxes of 1 m2, kg
    destroyBody(world, body);
    step(world, kTick);
    const BodyId next = *createBody(world, {});
    ASSERT_EQ(next.index, body.index);
    EXPECT_EQ(massOf(world, next), 1.0f);
}

}  // namespace
}  // namespace plumb::physics
