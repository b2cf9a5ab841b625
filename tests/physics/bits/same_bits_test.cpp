#include "core/cpu.hpp"
#include "core/random.hpp"
#include "core/task_pool.hpp"
#include "physics/kernels.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// Drops crates and balls of many sizes into a heap; enough of them to give work to all threads.
void pourIn(Playground& scene, int count) {
    scene.floor();
    Random random = Random::seeded(7);
    for (int i = 0; i < count; ++i) {
        const WorldPosition place{-6.0 + 0.8 * (i % 16), 0.6 + 0.8 * (i / 16)};
        const float size = 0.2f + 0.15f * random.unit();
        if (i % 3 == 0) {
            scene.ball(place, size, {.bounciness = 0.3f});
        } else {
            scene.crate(place, {size, 0.8f * size});
        }
    }
}

std::vector<std::uint64_t> heapAfter(int ticks, const StepOptions& options = {}) {
    Playground scene;
    scene.world.settings.sleeping = true;
    pourIn(scene, 600);
    scene.run(ticks, options);
    EXPECT_GT(touching(scene.world), 500);
    return bitsOf(scene.world);
}

TEST(SameBits, forAnyNumberOfThreads) {
    const std::vector<std::uint64_t> expected = heapAfter(90);
    for (const int threads : {2, 4, 16}) {
        TaskPool pool{threads};
        EXPECT_EQ(heapAfter(90, {.pool = &pool, .minimumWork = 0}), expected) << threads;
    }
}

/// Rows of balls that collide without loss of energy: impacts propagate through whole rows within a step, in
/// the order of their contacts.
std::vector<std::uint64_t> cradlesAfter(int ticks, const StepOptions& options = {}) {
    Playground scene;
    scene.world.settings.gravity = {};
    for (int i = 0; i < 600; ++i) {
        const int row = i % 30, place = i / 30;
        const BodyId ball =
            scene.ball({1.001 * place, 1.5 * row}, 0.5f, {.friction = 0.0f, .bounciness = 1.0f});
        if (place == 0) {
            EXPECT_TRUE(setVelocity(scene.world, ball, {2.0f + 0.1f * static_cast<float>(row), 0.0f}).ok());
        }
    }
    scene.run(ticks, options);
    EXPECT_GT(scene.world.contacts.size(), 400u);
    return bitsOf(scene.world);
}

TEST(SameBits, forImpactsThatPropagateThroughRows) {
    const std::vector<std::uint64_t> expected = cradlesAfter(40);
    for (const int threads : {2, 5}) {
        TaskPool pool{threads};
        EXPECT_EQ(cradlesAfter(40, {.pool = &pool, .minimumWork = 0}), expected) << threads;
    }
}

TEST(SameBits, smallWorldsUseNoThreads) {
    struct Scheduler {
        int rounds = 0;
        static void run(void* owner, int count, TaskPool::Call task, void* context) {
            ++static_cast<Scheduler*>(owner)->rounds;
            for (int part = 0; part < count; ++part) task(context, part, 0);
        }
    } scheduler;
    TaskPool pool{2, Scheduler::run, &scheduler};
    heapAfter(90, {.pool = &pool, .minimumWork = 100000});
    EXPECT_EQ(scheduler.rounds, 0);
    heapAfter(90, {.pool = &pool, .minimumWork = 100});
    EXPECT_GT(scheduler.rounds, 0);
}

TEST(SameBits, forAnyInstructionSet) {
    const SimdWidth widest = simdWidth();
    const std::vector<std::uint64_t> expected = heapAfter(90);
    for (const SimdWidth width : {SimdWidth::Scalar, SimdWidth::Sse2, SimdWidth::Avx2, SimdWidth::Neon}) {
        if (!setSimdWidth(width)) continue;
        if (width == SimdWidth::Scalar) {
            EXPECT_STREQ(solverKernels().name, "scalar");
        }
        EXPECT_EQ(heapAfter(90), expected) << static_cast<int>(width);
    }
    setSimdWidth(widest);
}

/// A heap that uses all functions of the broad phase: with bullets, a rope, a lift, and bodies that are added
/// and removed.
World busyWorldAfter(int ticks, BroadPhaseKind kind, const StepOptions& options = {}) {
    Playground scene;
    World& world = scene.world;
    world.settings.sleeping = true;
    world.settings.broadPhase = kind;
    pourIn(scene, 400);
    const BodyId lift = scene.body(BodyKind::Kinematic, {-9.0, 1.0});
    scene.shape(lift, box({1.0f, 0.2f}));
    EXPECT_TRUE(setVelocity(world, lift, {1.0f, 0.0f}).ok());
    EXPECT_TRUE(createRope(world, {-8.0, 6.0}, {8.0, 6.0}, 40).ok());
    Random random = Random::seeded(9);
    std::vector<BodyId> guests;
    for (int tick = 0; tick < ticks; ++tick) {
        if (tick % 10 == 0) {
            const BodyId bullet = scene.ball({-30.0, random.between(0.5f, 8.0f)}, 0.1f);
            EXPECT_TRUE(setVelocity(world, bullet, {200.0f, 0.0f}).ok());
            guests.push_back(bullet);
        }
        if (tick % 25 == 24) {
            destroyBody(world, guests[random.below(static_cast<std::uint32_t>(guests.size()))]);
        }
        scene.run(1, options);
    }
    return world;
}

TEST(SameBits, forAnyBroadPhase) {
    const World expected = busyWorldAfter(300, BroadPhaseKind::Tree);
    EXPECT_GT(touching(expected), 300);
    TaskPool pool{2};
    for (const BroadPhaseKind kind :
         {BroadPhaseKind::Grid, BroadPhaseKind::SweepAndPrune, BroadPhaseKind::Quadtree}) {
        SCOPED_TRACE(nameOf(kind));
        World world = busyWorldAfter(300, kind, {.pool = &pool, .minimumWork = 0});
        EXPECT_NE(hashOf(world), hashOf(expected));  // the hash includes the kind of broad phase
        world.settings.broadPhase = expected.settings.broadPhase;
        EXPECT_EQ(hashOf(world), hashOf(expected));
    }
}

TEST(SameBits, ifTheBroadPhaseIsSwitchedDuringTheRun) {
    Playground plain, switching;
    pourIn(plain, 200);
    pourIn(switching, 200);
    for (std::uint8_t tick = 0; tick < 120; ++tick) {
        // The kinds 4 to 6 are invalid, which selects the tree.
        if (tick % 5 == 0) switching.world.settings.broadPhase = static_cast<BroadPhaseKind>(tick / 5 % 7);
        plain.run(1);
        switching.run(1);
        ASSERT_EQ(bitsOf(plain.world), bitsOf(switching.world)) << tick;
    }
    EXPECT_GT(touching(plain.world), 100);
}

TEST(SameBits, ifASnapshotIsRestoredEverySeventhTick) {
    Playground plain, rewound;
    plain.world.settings.sleeping = rewound.world.settings.sleeping = true;
    pourIn(plain, 300);
    pourIn(rewound, 300);
    int met = 0;
    for (int tick = 0; tick < 240; ++tick) {
        plain.run(1);
        if (tick % 7 == 0) {
            const World saved = rewound.world;
            rewound.run(5);
            rewound.world = saved;
        }
        rewound.run(1);
        met += touching(plain.world);
        ASSERT_EQ(bitsOf(plain.world), bitsOf(rewound.world)) << tick;
    }
    EXPECT_GT(met, 10000);
}

TEST(SameBits, forCachedAndRebuiltContactBlocks) {
    const auto stack = [](Playground& scene, double x) {
        std::vector<BodyId> crates;
        for (int i = 0; i < 6; ++i) crates.push_back(scene.crate({x, 0.5 + i}));
        return crates;
    };
    Playground continued, copied;
    std::vector<BodyId> crates;
    for (Playground* scene : {&continued, &copied}) {
        scene->floor();
        crates = stack(*scene, 0.0);
        stack(*scene, 5.0);
    }
    for (int tick = 0; tick < 200; ++tick) {
        for (World* world : {&continued.world, &copied.world}) {
            // Between ticks 50 and 80 one body has another quality, so that there are two groups of islands.
            if (tick == 50 || tick == 80) {
                ASSERT_TRUE(setQuality(*world, crates[0], tick == 50 ? Quality{4} : kQualityOfWorld).ok());
            }
            if (tick == 110) world->manifest.pinnedOff = Manifest::bit(Effect::Contacts);
            if (tick == 112) world->manifest.pinnedOff = 0;
            if (tick == 140) destroyBody(*world, crates[2]);
        }
        copied.world = World{copied.world};  // a copy has a new workspace
        continued.run(1);
        copied.run(1);
        ASSERT_EQ(bitsOf(continued.world), bitsOf(copied.world)) << tick;
    }
    EXPECT_EQ(touching(continued.world), 11);
}

TEST(SameBits, forAnIslandThatChangesItsQualityGroup) {
    Playground continued, copied;
    std::vector<BodyId> crates;
    for (Playground* scene : {&continued, &copied}) {
        scene->floor();
        crates = {scene->crate({0.0, 0.5}), scene->crate({5.0, 0.5}), scene->crate({10.0, 0.5})};
        ASSERT_TRUE(setQuality(scene->world, crates[2], 4).ok());
    }
    for (int tick = 0; tick < 100; ++tick) {
        for (World* world : {&continued.world, &copied.world}) {
            // The order of all bodies stays the same: only the boundary between the two groups moves.
            if (tick == 50) {
                ASSERT_TRUE(setQuality(*world, crates[1], 4).ok());
            }
        }
        copied.world = World{copied.world};  // a copy has a new workspace
        continued.run(1);
        copied.run(1);
        ASSERT_EQ(bitsOf(continued.world), bitsOf(copied.world)) << tick;
    }
    EXPECT_EQ(touching(continued.world), 3);
}

TEST(SameBits, forIslandsNextToIslandsOfAnotherQuality) {
    const auto leftHeap = [](Quality right) {
        Playground scene;
        scene.floor();
        std::vector<BodyId> left;
        for (int i = 0; i < 8; ++i) left.push_back(scene.crate({0.01 * (i % 2), 0.5 + i}));
        for (int i = 0; i < 8; ++i) {
            const BodyId other = scene.crate({20.0 + 0.01 * (i % 2), 0.5 + i});
            EXPECT_TRUE(setQuality(scene.world, other, right).ok());
        }
        scene.run(120);
        std::vector<WorldPosition> places;
        for (const BodyId body : left) places.push_back(centreOf(scene.world, body));
        return places;
    };
    const std::vector<WorldPosition> expected = leftHeap(kQualityOfWorld);
    EXPECT_EQ(leftHeap(4), expected);
    EXPECT_EQ(leftHeap(5), expected);
}

/// Fast boxes among many thin walls; several walls are in the path of each box at once.
World hailAmongWalls(std::uint64_t seed, BroadPhaseKind kind) {
    World world;
    world.settings.broadPhase = kind;
    world.settings.sleeping = false;
    Random random = Random::seeded(seed);
    const auto place = [&] {
        return WorldPosition{random.between(-10.0f, 10.0f), random.between(-10.0f, 10.0f)};
    };
    for (int i = 0; i < 60; ++i) {
        const BodyId wall = addBody(world, BodyKind::Static, place(), random.between(-3.0f, 3.0f));
        static_cast<void>(createShape(world, wall, box({random.between(0.2f, 2.0f), 0.1f})));
    }
    for (int i = 0; i < 60; ++i) {
        const BodyId body = addBody(world, BodyKind::Dynamic, place(), random.between(-3.0f, 3.0f));
        static_cast<void>(
            createShape(world, body, box({random.between(0.05f, 0.3f), random.between(0.05f, 0.3f)})));
        static_cast<void>(
            setVelocity(world, body, {random.between(-100.0f, 100.0f), random.between(-100.0f, 100.0f)}));
        static_cast<void>(setAngularVelocity(world, body, random.between(-20.0f, 20.0f)));
        setBullet(world, body, i % 4 == 0);
    }
    return world;
}

TEST(SameBits, forFastBodiesInAnyOrderOfFoundWalls) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        World tree = hailAmongWalls(seed, BroadPhaseKind::Tree);
        World quadtree = hailAmongWalls(seed, BroadPhaseKind::Quadtree);
        World grid = hailAmongWalls(seed, BroadPhaseKind::Grid);
        World restored = tree;
        for (int i = 0; i < 20; ++i) {
            step(tree, kTick);
            step(quadtree, kTick);
            step(grid, kTick);
            const World snapshot = restored;
            restored = snapshot;
            step(restored, kTick);
            ASSERT_EQ(bitsOf(quadtree), bitsOf(tree)) << i;
            ASSERT_EQ(bitsOf(grid), bitsOf(tree)) << i;
            ASSERT_EQ(bitsOf(restored), bitsOf(tree)) << i;
        }
    }
}

}  // namespace
}  // namespace plumb::physics
