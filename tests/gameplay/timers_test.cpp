#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "gameplay/delayed_events.hpp"
#include "gameplay/systems/timer_system.hpp"
#include "gameplay/systems/tween_system.hpp"
#include "gameplay/tweens.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"
#include "tests/support/faults.hpp"

// Delayed events and tweens: state of the world that is rewound with it.

namespace plumb {
namespace {

struct Ring {
    int number = 0;
};

struct Listener {
    std::vector<std::pair<std::uint64_t, int>>* heard = nullptr;

    void update(World& world, float) const {
        for (const Ring& ring : world.events<Ring>()) heard->emplace_back(world.tick, ring.number);
    }
};

class Timers : public ::testing::Test {
protected:
    Timers() {
        world.addSystem<TimerSystem>();
        world.addSystem<Listener>().heard = &heard;
        world.addSystem<TweenSystem>();
    }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            world.update(1.0f / 60.0f);
        }
    }

    World world;
    std::vector<std::pair<std::uint64_t, int>> heard;
};

using Heard = std::vector<std::pair<std::uint64_t, int>>;

TEST_F(Timers, emitInTheTickThatIsDueInTheOrderInWhichTheyWereSet) {
    run(10);
    emitAfter(world, 0.5f, Ring{1});
    emitAfter(world, 0.1f, Ring{2});
    emitAfter(world, 0.5f, Ring{3});
    emitAfter(world, 0.0f, Ring{4});
    emitAfter(world, -5.0f, Ring{5});
    run(60);
    EXPECT_EQ(heard, (Heard{{11, 4}, {11, 5}, {16, 2}, {40, 1}, {40, 3}}));
    EXPECT_TRUE(world.resource<DelayedEvents>().entries.empty());
}

TEST_F(Timers, canBeCancelled) {
    const DelayedEvent first = emitAfter(world, 0.1f, Ring{1});
    emitAfter(world, 0.1f, Ring{2});
    cancel(world, first);
    run(10);
    cancel(world, first);
    EXPECT_EQ(heard, (Heard{{6, 2}}));
}

TEST_F(Timers, emitLikeASortedListWhateverIsSetAndCancelled) {
    std::mt19937 random{7};
    std::vector<std::pair<std::uint64_t, int>> pending;  // due tick, number of the ring
    Heard expected;
    const auto passesTick = [&](std::uint64_t tick) {
        std::stable_sort(pending.begin(), pending.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        while (!pending.empty() && pending.front().first <= tick) {
            expected.push_back(pending.front());
            pending.erase(pending.begin());
        }
    };
    std::vector<DelayedEvent> timers;
    for (int step = 0; step < 400; ++step) {
        for (auto i = random() % 6; i > 0; --i) {
            const auto ticks = static_cast<float>(1 + random() % 40);
            const int number = static_cast<int>(timers.size());
            timers.push_back(emitAfter(world, ticks / 60.0f, Ring{number}));
            pending.emplace_back(world.tick + static_cast<std::uint64_t>(ticks), number);
        }
        if (random() % 3 == 0 && !timers.empty()) {
            const std::size_t cancelled = random() % timers.size();
            cancel(world, timers[cancelled]);
            std::erase_if(pending,
                          [&](const auto& ring) { return ring.second == static_cast<int>(cancelled); });
        }
        run(1);
        passesTick(world.tick);
    }
    EXPECT_EQ(heard, expected);
}

// Linear insertion or removal would move 8 MB for each of them, which takes minutes.
TEST_F(Timers, areCheapIfThereAreVeryMany) {
    constexpr int kCount = 100'000, kTicks = 600;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kCount; ++i) emitAfter(world, 10.0f - 5.0f * static_cast<float>(i) / kCount, Ring{i});
    run(kTicks);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(heard.size(), std::size_t{kCount});
    EXPECT_LT(taken.count(), 5.0);
}

TEST_F(Timers, hashesOfEqualTimersAreEqualHoweverTheyAreArranged) {
    World other;
    const DelayedEvent first = emitAfter(world, 1.0f, Ring{});
    emitAfter(world, 3.0f, Ring{});
    emitAfter(world, 2.0f, Ring{});
    cancel(world, first);
    cancel(other, emitAfter(other, 5.0f, Ring{}));
    emitAfter(other, 3.0f, Ring{});
    emitAfter(other, 2.0f, Ring{});
    std::vector<DelayedEvents::Entry>& arranged = other.resource<DelayedEvents>().entries;
    std::reverse(arranged.begin(), arranged.end());
    EXPECT_EQ(world.hash(), other.hash());
}

// As the editor loads the code of a project again: each version lists the event types that it delays.
TEST_F(Timers, ofReloadedCodeAreEmittedByItsNewVersionIfTheEventHasTheSameSize) {
    static const TypeKey kKept = reloadableTypeKey("timers_test::Kept");
    static const TypeKey kGrown = reloadableTypeKey("timers_test::Grown");
    static const TypeKey kUnused = reloadableTypeKey("timers_test::Unused");
    static std::vector<std::pair<int, std::uint32_t>> emitted;  // version of the code, value
    emitted.clear();
    const auto list = [](const TypeKey& key, const char* name, std::uint32_t size, DelayedEvents::Emit emit) {
        return listDelayedType({&key, name, size, emit, reloadableVersion()});
    };
    const auto first = [](World&, const std::byte* bytes) {
        emitted.emplace_back(1, static_cast<std::uint32_t>(*bytes));
    };
    const auto second = [](World&, const std::byte* bytes) {
        emitted.emplace_back(2, static_cast<std::uint32_t>(*bytes));
    };
    beginReloadableTypes();
    const std::uint64_t value = 7;
    emitAfter(world, 0.1f, Ring{3});
    for (int i = 0; i < 2; ++i) {
        addDelayed(world, {}, 0.1f, list(kKept, "Kept", 4, first), &value);
        addDelayed(world, {}, 0.1f, list(kGrown, "Grown", 4, first), &value);
        addDelayed(world, {}, 0.1f, list(kUnused, "Unused", 4, first), &value);
    }
    DelayedEvents& delayed = world.resource<DelayedEvents>();
    EXPECT_TRUE(delayed.followCode().empty()) << "of this version";

    beginReloadableTypes();
    list(kKept, "Kept", 4, second);
    list(kGrown, "Grown", 8, second);
    EXPECT_EQ(delayed.followCode(), (std::vector<std::string>{"Grown", "Unused"}));
    EXPECT_TRUE(delayed.followCode().empty());
    run(6);
    EXPECT_EQ(emitted, (std::vector<std::pair<int, std::uint32_t>>{{2, 7}, {2, 7}}));
    EXPECT_EQ(heard, (Heard{{6, 3}})) << "those of the engine's types are kept";
}

TEST_F(Timers, areRewoundWithTheWorld) {
    emitAfter(world, 1.0f, Ring{1});
    run(30);
    const Snapshot middle = world.save();
    const std::uint64_t hash = world.hash();
    run(60);
    EXPECT_EQ(heard, (Heard{{60, 1}}));
    world.restore(middle);
    EXPECT_EQ(world.hash(), hash);
    run(60);
    EXPECT_EQ(heard, (Heard{{60, 1}, {60, 1}}));
}

TEST_F(Timers, areOfTheState) {
    const std::uint64_t before = world.hash();
    emitAfter(world, 1.0f, Ring{1});
    const std::uint64_t one = world.hash();
    EXPECT_NE(one, before);
    world.resource<DelayedEvents>().entries[0].tick += 1;
    EXPECT_NE(world.hash(), one);
}

TEST_F(Timers, bytesBetweenMembersAreNotOfTheState) {
    struct Padded {
        bool flag;
        double value;
    };
    World other;
    Padded first, second;
    std::memset(static_cast<void*>(&first), 0, sizeof first);
    std::memset(static_cast<void*>(&second), 255, sizeof second);
    first.flag = second.flag = true;
    first.value = second.value = 1.0;
    emitAfter(world, 1.0f, first);
    emitAfter(other, 1.0f, second);
    EXPECT_EQ(world.hash(), other.hash());
}

TEST_F(Timers, ticksAreTheNearestToATime) {
    EXPECT_EQ(ticksOf(0.0f), 1u);
    EXPECT_EQ(ticksOf(0.024f), 1u);
    EXPECT_EQ(ticksOf(0.026f), 2u);
    EXPECT_EQ(ticksOf(1.0f), 60u);
    EXPECT_EQ(ticksOf(1e30f), 1'000'000'000u);
}

/// Sets a timer and a tween of a time that is none, in every tick.
struct Miscalculation {
    float seconds = 0.0f;

    void update(World& world, float) const {
        EXPECT_EQ(emitAfter(world, seconds, Ring{1}).number, 0u);
        for (auto [entity, transform] : world.query<const Transform>())
            tween(world, entity, &Transform::rotation, 1.0f, seconds);
    }
};

TEST_F(Timers, timesThatAreNoNumbersAreReportedOnceAndSetNothing) {
    const Entity entity = world.createEntity();
    entity.addComponent<Transform>();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float seconds : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity}) {
        world.reports().forget();
        test::Faults faults;
        world.addSystem<Miscalculation>().seconds = seconds;
        run(5);
        ASSERT_EQ(faults.lines().size(), 2u) << testing::PrintToString(faults.lines());
        EXPECT_TRUE(faults.mention("Miscalculation: emitAfter() of "));
        EXPECT_TRUE(faults.mention("Ring: expected a time in s, found "));
        EXPECT_TRUE(faults.mention("Miscalculation: tween() of Transform: expected a time in s, found "));
        EXPECT_TRUE(faults.mention("check the computation"));
    }
    EXPECT_TRUE(heard.empty());
    EXPECT_EQ(entity.get<Transform>().rotation, 0.0f);
}

class TweenTest : public Timers {
protected:
    TweenTest() : entity{world.createEntity()} {
        entity.addComponent<Transform>(10.0f, 20.0f);
        entity.addComponent<Sprite>();
    }
    int ended() const { return static_cast<int>(world.events<TweenEnded>().size()); }

    Entity entity;
};

TEST_F(TweenTest, changesAFieldToItsEndExactly) {
    tween(world, entity.id(), &Transform::position, Vec2{110.0f, -20.0f}, 1.0f, Ease::Linear);
    run(30);
    EXPECT_EQ(entity.get<Transform>().position, (Vec2{60.0f, 0.0f}));
    EXPECT_EQ(ended(), 0);
    run(30);
    EXPECT_EQ(entity.get<Transform>().position, (Vec2{110.0f, -20.0f}));
    EXPECT_EQ(ended(), 1);
    run(1);
    EXPECT_EQ(ended(), 0);
    EXPECT_TRUE(world.resource<Tweens>().entries.empty());
}

TEST_F(TweenTest, changesNumbersAndColors) {
    tween(world, entity.id(), &Transform::rotation, 2.0f, 0.5f, Ease::QuadIn);
    tween(world, entity.id(), &Sprite::tint, Color{55, 255, 255, 0}, 0.5f, Ease::Linear);
    run(15);
    EXPECT_EQ(entity.get<Transform>().rotation, 0.5f);
    EXPECT_EQ(entity.get<Sprite>().tint, (Color{155, 255, 255, 128}));
    run(15);
    EXPECT_EQ(entity.get<Transform>().rotation, 2.0f);
    EXPECT_EQ(entity.get<Sprite>().tint, (Color{55, 255, 255, 0}));
}

TEST_F(TweenTest, aSecondTweenOfTheFieldContinuesFromThePresentValue) {
    tween(world, entity.id(), &Transform::rotation, 2.0f, 1.0f, Ease::Linear);
    run(30);
    tween(world, entity.id(), &Transform::rotation, 0.0f, 1.0f, Ease::Linear);
    run(30);
    EXPECT_EQ(entity.get<Transform>().rotation, 0.5f);
    run(30);
    EXPECT_EQ(entity.get<Transform>().rotation, 0.0f);
    EXPECT_EQ(ended(), 1);
}

TEST_F(TweenTest, takesOnlyItsCoordinateFromTheTweenOfAVector) {
    tween(world, entity.id(), &Transform::position, Vec2{70.0f, 80.0f}, 1.0f, Ease::Linear);
    run(30);
    Tweens::Entry x = tweenOf(entity.id(), &Transform::position, Ease::Linear);  // as scripts tween `x`
    x.to = {100.0f};
    addTween(world, x, 0.5f);
    EXPECT_EQ(world.resource<Tweens>().entries.size(), 2u);
    run(15);
    EXPECT_EQ(entity.get<Transform>().position, (Vec2{70.0f, 65.0f}));
    run(15);
    EXPECT_EQ(entity.get<Transform>().position, (Vec2{100.0f, 80.0f}));
    tween(world, entity.id(), &Transform::position, Vec2{0.0f, 0.0f}, 1.0f, Ease::Linear);
    addTween(world, x, 0.5f);
    tween(world, entity.id(), &Transform::position, Vec2{0.0f, 0.0f}, 1.0f, Ease::Linear);
    EXPECT_EQ(world.resource<Tweens>().entries.size(), 1u) << "the vector takes both";
}

TEST_F(TweenTest, endsWithItsComponent) {
    tween(world, entity.id(), &Sprite::tint, Color{}, 1.0f);
    tween(world, entity.id(), &Transform::rotation, 1.0f, 1.0f);
    run(5);
    world.remove<Sprite>(entity.id());
    run(1);
    EXPECT_EQ(world.resource<Tweens>().entries.size(), 1u);
    world.destroy(entity.id());
    run(1);
    EXPECT_TRUE(world.resource<Tweens>().entries.empty());
    EXPECT_EQ(ended(), 0);
    tween(world, entity.id(), &Transform::rotation, 1.0f, 1.0f);
    EXPECT_TRUE(world.resource<Tweens>().entries.empty()) << "a tween must end with its component";
}

TEST_F(TweenTest, canBeStopped) {
    tween(world, entity.id(), &Transform::rotation, 2.0f, 1.0f, Ease::Linear);
    run(30);
    stopTweens(world, entity.id());
    run(60);
    EXPECT_EQ(entity.get<Transform>().rotation, 1.0f);
}

TEST_F(TweenTest, isRewoundWithTheWorld) {
    tween(world, entity.id(), &Transform::position, Vec2{110.0f, 20.0f}, 1.0f, Ease::ElasticOut);
    run(20);
    const Snapshot early = world.save();
    run(20);
    const std::uint64_t late = world.hash();
    world.restore(early);
    run(20);
    EXPECT_EQ(world.hash(), late);
}

}  // namespace
}  // namespace plumb
