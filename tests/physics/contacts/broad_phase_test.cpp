#include "physics/broadphase/broad_phase.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "core/cpu.hpp"
#include "tests/physics/support/proxy_world.hpp"
#include "tests/support/allocations.hpp"

namespace plumb::physics::test {

namespace {

constexpr std::uint64_t kSeeds = 64;
constexpr auto kKinds = static_cast<std::uint32_t>(BroadPhaseKind::Count);

/// Updates the broad phase and returns the sorted keys of all pairs with a changed proxy.
std::vector<PairKey> pairsOf(BroadPhase& phase, const ProxyWorld& world, bool arranged = true) {
    phase.update(world.proxies(), world.changed);
    std::vector<std::uint32_t> moved = world.changed;
    if (arranged) phase.arrange(moved);
    std::vector<PairKey> pairs;
    phase.findPairs(moved, world.isChanged, pairs);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// Applies random changes to random proxies.
void changeSome(ProxyWorld& world, Random& random, BoxStatistics spread, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t id = random.below(world.size());
        const bool gone = world.motions[id] == ProxyMotion::Gone;
        switch (random.below(gone ? 2 : 8)) {
            case 0:
                world.bounds[id] = randomBox(random, spread);
                world.filters[id] = randomFilter(random);
                world.become(id, randomMotion(random));
                break;
            case 1: world.add(randomBox(random, spread), randomMotion(random), randomFilter(random)); break;
            case 2: world.become(id, ProxyMotion::Gone); break;
            case 3: world.become(id, ProxyMotion::Asleep); break;
            case 4: world.become(id, ProxyMotion::Awake); break;
            case 5: world.move(id, randomBox(random, spread)); break;
            default: {
                const Vec2 way{random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f)};
                world.move(id, {world.bounds[id].min + way, world.bounds[id].max + way});
            }
        }
    }
}

ProxyWorld randomWorld(Random& random, BoxStatistics spread, std::uint32_t count) {
    ProxyWorld world;
    for (std::uint32_t i = 0; i < count; ++i)
        world.add(randomBox(random, spread), randomMotion(random), randomFilter(random));
    return world;
}

BoxStatistics statisticsOf(std::uint64_t seed) {
    return static_cast<BoxStatistics>(seed % static_cast<std::uint64_t>(BoxStatistics::Count));
}

class BroadPhases : public testing::TestWithParam<std::uint32_t> {
protected:
    static std::unique_ptr<BroadPhase> make() {
        return makeBroadPhase(static_cast<BroadPhaseKind>(GetParam()));
    }
};

std::string nameOfParam(const testing::TestParamInfo<std::uint32_t>& info) {
    std::string name{nameOf(static_cast<BroadPhaseKind>(info.param))};
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
}

TEST_P(BroadPhases, findTheSamePairsAsBruteForce) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const BoxStatistics spread = statisticsOf(seed);
        ProxyWorld world = randomWorld(random, spread, 10 + random.below(300));
        const auto phase = make();
        phase->rebuild({});
        for (int round = 0; round < 25; ++round) {
            SCOPED_TRACE(round);
            ASSERT_EQ(pairsOf(*phase, world, random.below(4) != 0), world.pairsOfChanged());
            world.clearChanged();
            changeSome(world, random, spread, random.below(4) == 0 ? world.size() : random.below(20));
        }
    }
}

TEST_P(BroadPhases, findTheSameAfterARebuild) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        ProxyWorld world = randomWorld(random, statisticsOf(seed), 200);
        const auto phase = make();
        phase->rebuild(world.proxies());
        ASSERT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
        world.clearChanged();
        changeSome(world, random, statisticsOf(seed), 40);
        phase->rebuild(world.proxies());
        world.clearChanged();
        changeSome(world, random, statisticsOf(seed), 10);
        ASSERT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
    }
}

TEST_P(BroadPhases, keepUpWithManySmallMoves) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        ProxyWorld world = randomWorld(random, BoxStatistics::Even, 120);
        std::vector<Vec2> speeds;
        for (std::uint32_t id = 0; id < world.size(); ++id)
            speeds.push_back({random.between(-0.2f, 0.2f), random.between(-0.2f, 0.2f)});
        const auto phase = make();
        phase->rebuild(world.proxies());
        for (int round = 0; round < 60; ++round) {
            SCOPED_TRACE(round);
            world.clearChanged();
            const std::uint32_t stride = 1 + random.below(3);
            for (std::uint32_t id = 0; id < world.size(); id += stride)
                world.move(id, {world.bounds[id].min + speeds[id], world.bounds[id].max + speeds[id]});
            ASSERT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
        }
    }
}

TEST_P(BroadPhases, findTheSamePairsWhileHalfTheWorldFallsAsleepAndWakesUp) {
    Random random = Random::seeded(3);
    ProxyWorld world;
    for (int i = 0; i < 3000; ++i)
        world.add(boxAt({random.between(0.0f, 40.0f), random.between(0.0f, 40.0f)}, {0.3f, 0.3f}));
    const auto phase = make();
    EXPECT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
    for (const ProxyMotion motion :
         {ProxyMotion::Asleep, ProxyMotion::Awake, ProxyMotion::Asleep, ProxyMotion::Gone}) {
        world.clearChanged();
        for (std::uint32_t id = 0; id < world.size(); ++id) {
            if (world.bounds[id].min.x < 20.0f) world.become(id, motion);
        }
        EXPECT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
    }
}

TEST_P(BroadPhases, arrangeKeepsEachProxyOnce) {
    Random random = Random::seeded(1);
    ProxyWorld world = randomWorld(random, BoxStatistics::Sizes, 500);
    for (std::uint32_t id = 0; id < world.size(); id += 7) world.become(id, ProxyMotion::Gone);
    const auto phase = make();
    phase->update(world.proxies(), world.changed);
    std::vector<std::uint32_t> moved;
    for (std::uint32_t id = 0; id < world.size(); id += 3) moved.push_back(id);
    std::vector<std::uint32_t> arranged = moved;

    phase->arrange(arranged);

    std::sort(arranged.begin(), arranged.end());
    EXPECT_EQ(arranged, moved);
}

TEST_P(BroadPhases, answerQueriesLikeBruteForce) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const BoxStatistics spread = statisticsOf(seed);
        ProxyWorld world = randomWorld(random, spread, 10 + random.below(400));
        const auto phase = make();
        for (int round = 0; round < 20; ++round) {
            phase->update(world.proxies(), world.changed);
            world.clearChanged();
            AABB box = randomBox(random, spread);
            if (round % 3 == 0) box = {box.min - Vec2{3.0f, 3.0f}, box.max + Vec2{3.0f, 3.0f}};
            const std::uint32_t mask = random.below(2) == 0 ? 0xffffffffu : 1u << random.below(4);
            std::vector<std::uint32_t> found;
            phase->query(box, mask, found);
            std::sort(found.begin(), found.end());
            ASSERT_EQ(found, world.inBox(box, mask));
            changeSome(world, random, spread, 10);
        }
    }
}

/// True if the segment from `from` to `from` + `way` crosses the box enlarged by `half` on all sides. Slab
/// test in double precision.
bool meetsLine(const AABB& box, Vec2 from, Vec2 way, Vec2 half) {
    double first = 0.0;
    double last = 1.0;
    const double start[] = {from.x, from.y};
    const double speed[] = {way.x, way.y};
    const double low[] = {double{box.min.x} - double{half.x}, double{box.min.y} - double{half.y}};
    const double high[] = {double{box.max.x} + double{half.x}, double{box.max.y} + double{half.y}};
    for (int axis = 0; axis < 2; ++axis) {
        if (speed[axis] == 0.0) {
            if (start[axis] < low[axis] || start[axis] > high[axis]) return false;
            continue;
        }
        const double a = (low[axis] - start[axis]) / speed[axis];
        const double b = (high[axis] - start[axis]) / speed[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

TEST_P(BroadPhases, castsMissNothing) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const BoxStatistics spread = statisticsOf(seed);
        ProxyWorld world = randomWorld(random, spread, 300);
        const auto phase = make();
        phase->update(world.proxies(), world.changed);
        for (int round = 0; round < 20; ++round) {
            const Vec2 from = randomBox(random, spread).min;
            Vec2 way = randomBox(random, spread).max - from;
            if (round % 4 == 0) way.x = 0.0f;
            if (round % 5 == 0) way = way * 1000.0f;
            const Vec2 half = round % 2 == 0 ? Vec2{} : Vec2{0.3f, 0.2f};
            std::vector<std::uint32_t> found;
            const Among among = round % 3 == 0 ? Among::Static : Among::All;
            phase->cast(from, way, half, 5u, found, among);
            std::sort(found.begin(), found.end());
            ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
            for (std::uint32_t id = 0; id < world.size(); ++id) {
                const bool wanted = (world.filters[id].layers & 5u) != 0 &&
                                    (among == Among::All || world.motions[id] == ProxyMotion::Static);
                const bool has = std::binary_search(found.begin(), found.end(), id);
                ASSERT_TRUE(has || !wanted || !meetsLine(world.bounds[id], from, way, half)) << id;
                ASSERT_TRUE(!has || wanted) << id;
            }
        }
    }
}

TEST_P(BroadPhases, castsAcrossAWorldVisitFewProxies) {
    ProxyWorld world;
    for (int i = 0; i < 10000; ++i)
        world.add(boxAt({static_cast<float>(i % 100), static_cast<float>(i / 100)}, {0.3f, 0.3f}));
    const auto phase = make();
    phase->update(world.proxies(), world.changed);
    std::vector<std::uint32_t> found;
    phase->cast({-1.0f, -1.0f}, {102.0f, 102.0f}, {}, 1, found, Among::All);
    EXPECT_GE(found.size(), 100u);
    EXPECT_LE(found.size(), 1000u);
}

TEST_P(BroadPhases, emptyBoundsOverlapNothing) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    ProxyWorld world;
    const std::uint32_t box = world.add({{0.0f, 0.0f}, {1.0f, 1.0f}});
    const std::uint32_t point = world.add({{1.0f, 1.0f}, {1.0f, 1.0f}});
    const std::uint32_t everything = world.add({{-kInfinity, -kInfinity}, {kInfinity, kInfinity}});
    const std::uint32_t line = world.add({{-1e6f, 0.5f}, {1e6f, 0.5f}});
    world.add({{1.0f, 1.0f}, {0.0f, 0.0f}});
    world.add({{0.0f, kNan}, {1.0f, 1.0f}});
    world.add({{kNan, kNan}, {kNan, kNan}});
    world.add({{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
    const std::vector<PairKey> expected{pairKey(box, point), pairKey(box, everything), pairKey(box, line),
                                        pairKey(point, everything), pairKey(everything, line)};
    const auto phase = make();

    EXPECT_EQ(pairsOf(*phase, world), expected);
    std::vector<std::uint32_t> found;
    phase->query(world.bounds[everything], 1, found);
    EXPECT_EQ(found.size(), 4u);
    found.clear();
    phase->query({{1.0f, 1.0f}, {0.0f, 0.0f}}, 1, found);
    phase->query({{kNan, 0.0f}, {1.0f, 1.0f}}, 1, found);
    phase->cast({kNan, 0.0f}, {1.0f, 1.0f}, {}, 1, found, Among::All);
    phase->cast({0.0f, 0.0f}, {kInfinity, 1.0f}, {}, 1, found, Among::All);
    EXPECT_TRUE(found.empty());
    phase->cast({-3e38f, 0.5f}, {3e38f, 0.0f}, {-1.0f, -1.0f}, 1, found, Among::All);
    EXPECT_EQ(std::set<std::uint32_t>(found.begin(), found.end()).count(line), 1u);
    // The same update again: the proxies are now known to the broad phase.
    EXPECT_EQ(pairsOf(*phase, world), expected);
}

TEST_P(BroadPhases, filteredCrowdsAtOneSpotAreCheap) {
    ProxyWorld world;
    Filter alone;
    alone.mask = 0;
    for (int i = 0; i < 100000; ++i) world.add({{-1.0f, 2.0f}, {1.0f, 3.0f}}, ProxyMotion::Awake, alone);
    const std::uint32_t a = world.add({{0.0f, 2.0f}, {1.0f, 3.0f}});
    const std::uint32_t b = world.add({{0.5f, 2.0f}, {1.0f, 3.0f}});
    const auto phase = make();
    for (int step = 0; step < 4; ++step)
        ASSERT_EQ(pairsOf(*phase, world), std::vector<PairKey>{pairKey(a, b)});
    std::vector<std::uint32_t> found;
    phase->query({{5.0f, 5.0f}, {6.0f, 6.0f}}, 1, found);
    EXPECT_TRUE(found.empty());
}

TEST_P(BroadPhases, findTheSamePairsWithAnyNumberOfThreads) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        ProxyWorld world = randomWorld(random, statisticsOf(seed), 2000);
        const auto phase = make();
        phase->update(world.proxies(), world.changed);
        std::vector<std::uint32_t> moved = world.changed;
        if (seed % 2 == 0) phase->arrange(moved);
        constexpr std::size_t kThreads = 4;
        std::vector<PairKey> parts[kThreads];
        std::vector<std::thread> threads;
        for (std::size_t t = 0; t < kThreads; ++t) {
            const std::size_t first = moved.size() * t / kThreads;
            const std::size_t last = moved.size() * (t + 1) / kThreads;
            threads.emplace_back([&, t, first, last] {
                phase->findPairs(std::span{moved}.subspan(first, last - first), world.isChanged, parts[t]);
            });
        }
        std::vector<PairKey> pairs;
        for (std::size_t t = 0; t < kThreads; ++t) {
            threads[t].join();
            pairs.insert(pairs.end(), parts[t].begin(), parts[t].end());
        }
        std::sort(pairs.begin(), pairs.end());
        ASSERT_EQ(pairs, world.pairsOfChanged());
    }
}

TEST_P(BroadPhases, findTheSamePairsWithAnySimdWidth) {
    const SimdWidth usual = simdWidth();
    for (const SimdWidth width : {SimdWidth::Scalar, SimdWidth::Sse2, SimdWidth::Avx2, SimdWidth::Neon}) {
        if (!setSimdWidth(width)) continue;
        SCOPED_TRACE(static_cast<int>(width));
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
            SCOPED_TRACE(seed);
            Random random = Random::seeded(seed);
            const BoxStatistics spread = statisticsOf(seed);
            ProxyWorld world = randomWorld(random, spread, 250);
            const auto phase = make();
            EXPECT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
            const AABB box = randomBox(random, spread);
            std::vector<std::uint32_t> found;
            phase->query(box, 3, found);
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, world.inBox(box, 3));
        }
    }
    setSimdWidth(usual);
}

/// Regression: cell indices whose difference does not fit an int were subtracted as ints. Detected by
/// sanitizer builds.
TEST_P(BroadPhases, supportBoxesOfAnyFiniteSize) {
    ProxyWorld world;
    for (const float half : {1.0e6f, 1.0e9f, 1.0e15f, 1.0e30f})
        world.add(boxAt({}, {half, half}), ProxyMotion::Awake);
    for (int i = 0; i < 40; ++i) {
        const float x = 0.01f * static_cast<float>(i - 20);
        world.add(boxAt({x, -x}, {0.002f, 0.002f}), ProxyMotion::Awake);
    }
    const auto phase = make();
    EXPECT_EQ(pairsOf(*phase, world), world.pairsOfChanged());
    std::vector<std::uint32_t> found;
    phase->query(boxAt({2.0e5f, 0.0f}, {1.0f, 1.0f}), 3, found);
    EXPECT_EQ(found.size(), 4u);
}

TEST_P(BroadPhases, aSteadyStepAllocatesNothing) {
    Random random = Random::seeded(5);
    ProxyWorld world;
    for (int i = 0; i < 2000; ++i)
        world.add(boxAt({random.between(0.0f, 40.0f), random.between(0.0f, 40.0f)}, {0.3f, 0.3f}),
                  i % 3 == 0 ? ProxyMotion::Static : ProxyMotion::Awake);
    const auto phase = make();
    std::vector<PairKey> pairs;
    pairs.reserve(100000);
    std::vector<std::uint32_t> moved;
    std::size_t before = 0;
    for (int step = 0; step < 240; ++step) {
        // The motion is repeated after step 120, so that the second half needs no more memory than the first.
        if (step == 120) before = plumb::test::allocations().made;
        const float way = step / 30 % 2 == 0 ? 0.05f : -0.05f;
        for (std::uint32_t id = 0; id < world.size(); ++id) {
            const Vec2 shift{id % 2 == 0 ? way : 0.0f, id % 5 == 0 ? way : 0.0f};
            if (world.motions[id] == ProxyMotion::Awake && shift != Vec2{})
                world.move(id, {world.bounds[id].min + shift, world.bounds[id].max + shift});
        }
        phase->update(world.proxies(), world.changed);
        moved = world.changed;
        phase->arrange(moved);
        pairs.clear();
        phase->findPairs(moved, world.isChanged, pairs);
        world.clearChanged();
    }
    EXPECT_EQ(plumb::test::allocations().made, before);
}

INSTANTIATE_TEST_SUITE_P(All, BroadPhases, testing::Range(0u, kKinds), nameOfParam);

TEST(BroadPhaseKinds, haveUniqueNames) {
    std::set<std::string_view> names;
    for (std::uint32_t kind = 0; kind < kKinds; ++kind)
        names.insert(nameOf(static_cast<BroadPhaseKind>(kind)));
    EXPECT_EQ(names.size(), kKinds);
    EXPECT_EQ(names.count(""), 0u);
    EXPECT_EQ(nameOf(BroadPhaseKind::Count), nameOf(BroadPhaseKind{})) << "invalid kinds mean the default";
}

}  // namespace

}  // namespace plumb::physics::test
