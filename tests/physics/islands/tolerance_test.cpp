#include "core/task_pool.hpp"
#include "physics/islands/island_report.hpp"
#include "physics/islands/substep_controller.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/world_of_bodies.hpp"
#include "tests/support/allocations.hpp"

// Tests Settings::tolerance in whole worlds. The rule itself is tested in substep_controller_test.cpp.

namespace plumb::physics {
namespace {

constexpr float kTolerance = 0.002f;  // m

struct Held : Playground {
    Held() {
        world.settings.tolerance = kTolerance;
        floor();
    }
    BodyId heavy(WorldPosition at, Vec2 half, float mass) {
        const BodyId made = crate(at, half);
        EXPECT_TRUE(setMass(world, made, mass).ok());
        return made;
    }
    BodyId tower(double x, int crates) {
        BodyId top;
        for (int i = 0; i < crates; ++i) top = crate({x, 0.5 + i});
        return top;
    }
    [[nodiscard]] IslandReport islandOf(BodyId body) const {
        const std::vector<IslandReport> islands = reportIslands(world);
        const std::uint32_t index = islandIndices(world)[body.index];
        EXPECT_LT(index, islands.size());
        return index < islands.size() ? islands[index] : IslandReport{};
    }
    [[nodiscard]] Quality qualityOf(BodyId body) const { return islandOf(body).quality; }
    /// Maximum error within `steps` steps, m.
    float worstIn(int steps) {
        float worst = 0.0f;
        for (int i = 0; i < steps; ++i) {
            run(1);
            for (const IslandReport& island : reportIslands(world))
                worst = std::max({worst, island.overlap, island.jointError});
        }
        return worst;
    }
};

/// Hangs a net of hinges with a heavy load; its loops exclude the direct solver for trees.
void hangNet(Held& scene) {
    constexpr int kSide = 6;
    std::vector<BodyId> knots;
    const BodyId ceiling = scene.body(BodyKind::Static, {0.0, 20.0});
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const BodyId knot = scene.body(BodyKind::Dynamic, {1.0 * x, 20.0 - y});
            scene.shape(knot, circle(0.2f), {.mask = 0});
            const auto tie = [&](BodyId to, Vec2 anchor) {
                EXPECT_TRUE(createJoint(scene.world, {.a = to, .b = knot, .anchorA = anchor}).ok());
            };
            if (x > 0) tie(knots.back(), {1.0f, 0.0f});
            if (y > 0) tie(knots[knots.size() - kSide], {0.0f, -1.0f});
            if (y == 0 && (x == 0 || x == kSide - 1)) tie(ceiling, {static_cast<float>(x), 0.0f});
            knots.push_back(knot);
        }
    }
}

void heap(Held& scene) {
    Random random = Random::seeded(4);
    for (const double x : {-5.0, 5.0})
        scene.shape(scene.body(BodyKind::Static, {x, 5.0}), box({0.5f, 10.0f}));
    for (int i = 0; i < 80; ++i) {
        const WorldPosition place{-3.6 + 0.9 * (i % 9), 0.6 + 0.9 * (i / 9)};
        if (i % 3 == 0) {
            scene.ball(place, random.between(0.25f, 0.4f));
        } else {
            scene.crate(place, {random.between(0.25f, 0.4f), random.between(0.2f, 0.4f)});
        }
    }
}

struct HardCase {
    const char* name;
    void (*build)(Held& scene);
};
const HardCase kHardCases[] = {
    {"a tower of 25", [](Held& scene) { scene.tower(0.0, 25); }},
    {"400 kg on two crates of 1",
     [](Held& scene) {
         scene.crate({-0.7, 0.5});
         scene.crate({0.7, 0.5});
         scene.heavy({0.0, 2.0}, {1.0f, 1.0f}, 400.0f);
     }},
    {"100 kg on ten crates of 1",
     [](Held& scene) {
         scene.tower(0.0, 10);
         scene.heavy({0.0, 10.5}, {0.5f, 0.5f}, 100.0f);
     }},
    {"a net", hangNet},
    {"a heap", heap},
};

TEST(Tolerance, separatedIslandsAreControlledSeparately) {
    Held scene;
    scene.world.settings.sleeping = false;
    scene.tower(0.0, 10);
    const BodyId load = scene.heavy({0.0, 10.5}, {0.5f, 0.5f}, 100.0f);
    const BodyId alone = scene.crate({5.0, 0.5});
    const JointId rod = *createJoint(
        scene.world, {.kind = JointKind::Distance, .a = load, .b = alone, .length = std::sqrt(125.0f)});
    scene.run(60);
    ASSERT_EQ(scene.qualityOf(alone), scene.qualityOf(load));
    destroyJoint(scene.world, rod);
    scene.run(30);
    EXPECT_LT(scene.qualityOf(alone), scene.qualityOf(load));
}

TEST(Tolerance, isKept) {
    for (const HardCase& hard : kHardCases) {
        SCOPED_TRACE(hard.name);
        Held scene;
        hard.build(scene);
        scene.run(480);
        EXPECT_LE(scene.worstIn(120), kTolerance);
    }
}

TEST(Tolerance, eachIslandGetsTheQualityItNeeds) {
    Held scene;
    const BodyId alone = scene.crate({-20.0, 0.5});
    const BodyId small = scene.tower(-10.0, 2);
    const BodyId high = scene.tower(0.0, 25);
    const BodyId flying = scene.crate({20.0, 4000.0});
    scene.run(480);
    EXPECT_EQ(scene.qualityOf(alone), 0);
    EXPECT_EQ(scene.qualityOf(flying), 0);
    EXPECT_LE(scene.qualityOf(small), 1);
    EXPECT_GT(scene.qualityOf(high), 2);
}

TEST(Tolerance, newBodiesStartWithTheEstimatedQuality) {
    Held scene;
    const BodyId high = scene.tower(0.0, 25);
    const BodyId alone = scene.crate({20.0, 0.5});
    scene.run(1);
    EXPECT_EQ(scene.qualityOf(high), 4);
    EXPECT_EQ(scene.qualityOf(alone), 2);
    const float sunk = scene.islandOf(high).overlap;
    EXPECT_LT(sunk, 2.0f * kTolerance);
}

TEST(Tolerance, theQualityOfABodyIsTheMinimumForItsIsland) {
    Held scene;
    const BodyId made = *createBody(scene.world, {.position = {0.0, 0.5}, .quality = 3});
    scene.shape(made, box({0.5f, 0.5f}));
    scene.run(480);
    EXPECT_EQ(scene.qualityOf(made), 3);
}

TEST(Tolerance, doesNotOscillateAtRest) {
    for (const HardCase& hard : kHardCases) {
        SCOPED_TRACE(hard.name);
        Held scene;
        hard.build(scene);
        scene.run(480);
        int changes = 0;
        std::vector<SubstepController> before = scene.world.bodies.substepControllers;
        for (int i = 0; i < 1800; ++i) {
            scene.run(1);
            int now = 0;
            for (std::size_t body = 0; body < before.size(); ++body)
                now |= before[body].quality != scene.world.bodies.substepControllers[body].quality ? 1 : 0;
            changes += now;
            before = scene.world.bodies.substepControllers;
        }
        EXPECT_LE(changes, 12) << "in half a minute";
    }
}

TEST(Tolerance, comesDownWhenTheLoadIsGone) {
    Held scene;
    const BodyId below = scene.crate({0.0, 0.5});
    const BodyId load = scene.heavy({0.0, 1.5}, {0.5f, 0.5f}, 400.0f);
    scene.run(480);
    EXPECT_GE(scene.qualityOf(below), 3);
    destroyBody(scene.world, load);
    scene.run(480);
    EXPECT_EQ(scene.qualityOf(below), 0);
}

TEST(Tolerance, qualityRisesWhenAHeavyBodyArrives) {
    Held scene;
    const BodyId below = scene.crate({0.0, 0.5});
    scene.run(300);
    ASSERT_EQ(scene.qualityOf(below), 0);
    scene.heavy({0.0, 1.8}, {0.5f, 0.5f}, 400.0f);
    scene.run(300);
    EXPECT_GE(scene.qualityOf(below), 3);
    EXPECT_LE(scene.islandOf(below).overlap, kTolerance);
    EXPECT_NEAR(scene.y(below), 0.5, static_cast<double>(kTolerance));
}

/// Stored impulses are per substep, so they must be rescaled when the number of substeps changes. A deep
/// overlap acts like a compressed spring and must not be released at once.
TEST(Tolerance, changesOfQualityDoNotMakeBodiesJump) {
    Held scene;
    const BodyId top = scene.tower(0.0, 8);
    scene.run(300);
    double highest = 0.0;
    int changes = 0;
    for (int i = 0; i < 900; ++i) {
        const Quality before = scene.world.bodies.substepControllers.back().quality;
        if (i % 90 == 0) {  // first the lowest possible quality, then up again
            for (SubstepController& effort : scene.world.bodies.substepControllers) effort.wait = 0;
            scene.world.settings.tolerance = i % 180 == 0 ? 0.02f : 0.0005f;
        }
        scene.run(1);
        changes += scene.world.bodies.substepControllers.back().quality != before ? 1 : 0;
        highest = std::max(highest, scene.y(top));
    }
    EXPECT_GT(changes, 6);
    EXPECT_LT(highest, 7.501);
}

TEST(Tolerance, sleepingBodiesWakeWithTheirFormerQuality) {
    Held scene;
    scene.world.settings.sleeping = true;
    const BodyId top = scene.tower(0.0, 25);
    for (int i = 0; i < 1200 && isAwake(scene.world, top); ++i) scene.run(1);
    ASSERT_FALSE(isAwake(scene.world, top));
    const Quality asleep = scene.world.bodies.substepControllers[top.index].quality;
    ASSERT_GT(asleep, 2);
    EXPECT_FALSE(isAtWork(scene.world.bodies.substepControllers[top.index]));
    setAwake(scene.world, top, true);
    scene.run(1);
    EXPECT_EQ(scene.qualityOf(top), asleep);
    scene.world.settings.sleeping = false;
    EXPECT_LE(scene.worstIn(300), kTolerance);
}

TEST(Tolerance, noBodyFallsAsleepWithADeepOverlap) {
    Held scene;
    scene.world.settings.sleeping = true;
    scene.world.settings.quality = 0;
    const BodyId below = scene.crate({0.0, 0.5});
    scene.run(200);
    ASSERT_FALSE(isAwake(scene.world, below));
    scene.heavy({0.0, 1.51}, {0.5f, 0.5f}, 100.0f);
    for (int i = 0; i < 1200 && !scene.world.awake.empty(); ++i) scene.run(1);
    ASSERT_TRUE(scene.world.awake.empty());
    EXPECT_NEAR(scene.y(below), 0.5, static_cast<double>(kTolerance));
}

/// Builds and runs a world with bodies that fall on each other, a net, a lift, and bodies that are created
/// and destroyed.
World busyWorldAfter(int ticks, const StepOptions& options, bool rewinds) {
    Held scene;
    scene.world.settings.sleeping = true;
    heap(scene);
    hangNet(scene);
    scene.tower(20.0, 15);
    const BodyId lift = scene.body(BodyKind::Kinematic, {30.0, 1.0});
    scene.shape(lift, box({2.0f, 0.2f}));
    EXPECT_TRUE(setVelocity(scene.world, lift, {0.0f, 0.5f}).ok());
    scene.crate({30.0, 1.8});
    std::vector<BodyId> guests;
    const auto advance = [&](int tick) {
        if (tick % 40 == 20) {
            guests.push_back(scene.heavy({20.0, 18.0}, {0.5f, 0.5f}, 50.0f));
            EXPECT_TRUE(setVelocity(scene.world, guests.back(), {0.5f, -3.0f}).ok());
        }
        if (tick % 100 == 99) destroyBody(scene.world, guests.back()), guests.pop_back();
        scene.run(1, options);
    };
    World saved;
    for (int tick = 0; tick < ticks; ++tick) {
        if (rewinds && tick % 7 == 0) {
            saved = scene.world;
            const std::vector<BodyId> here = guests;
            for (int ahead = 0; ahead < 5; ++ahead) advance(tick + ahead);
            scene.world = saved;
            guests = here;
        }
        advance(tick);
    }
    return scene.world;
}

TEST(Tolerance, isTheSameForAnyThreadsAndAfterRollbacks) {
    const World expected = busyWorldAfter(400, {}, false);
    Quality most = 0;
    for (const SubstepController& effort : expected.bodies.substepControllers)
        most = std::max(most, effort.quality);
    EXPECT_GT(most, 2);
    for (const int threads : {2, 5}) {
        TaskPool pool{threads};
        EXPECT_EQ(hashOf(busyWorldAfter(400, {.pool = &pool, .minimumWork = 0}, false)), hashOf(expected))
            << threads;
    }
    EXPECT_EQ(hashOf(busyWorldAfter(400, {}, true)), hashOf(expected));
}

TEST(Tolerance, aSteadyStepAllocatesNothing) {
    Held scene;
    heap(scene);
    hangNet(scene);
    scene.tower(20.0, 15);
    scene.run(600);
    const std::size_t before = test::allocations().made;
    scene.run(60);
    EXPECT_EQ(test::allocations().made - before, 0u);
}

TEST(Tolerance, withoutAToleranceNoControllersAreStored) {
    Held scene;
    scene.tower(0.0, 25);
    scene.run(10);
    EXPECT_FALSE(scene.world.bodies.substepControllers.empty());
    scene.world.settings.tolerance = 0.0f;
    scene.run(1);
    EXPECT_TRUE(scene.world.bodies.substepControllers.empty());
    EXPECT_EQ(scene.world.work.get().groups.size(), 1u);
    scene.world.settings.tolerance = std::numeric_limits<float>::quiet_NaN();
    scene.run(1);
    EXPECT_EQ(scene.world.settings.tolerance, 0.0f);
}

TEST(Tolerance, aBodyWithAReusedIndexStartsWithANewController) {
    Held scene;
    const BodyId old = scene.heavy({0.0, 0.5}, {0.5f, 0.5f}, 1.0f);
    scene.run(300);
    ASSERT_EQ(scene.qualityOf(old), 0);
    destroyBody(scene.world, old);
    scene.run(2);
    const BodyId made = scene.crate({0.0, 0.5});
    ASSERT_EQ(made.index, old.index);
    scene.run(1);
    EXPECT_EQ(scene.qualityOf(made), 2);
}

}  // namespace
}  // namespace plumb::physics
