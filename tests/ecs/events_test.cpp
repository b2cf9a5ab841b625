#include "ecs/events.hpp"

#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ecs/parts.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

struct Said {
    std::string word;
};
struct Counted {
    int number = 0;
};
/// An event with a constant member cannot be assigned.
struct Fixed {
    const int number = 0;
};

/// A handler, of which a world knows only the key.
struct Receiver {};

TEST(EventsTest, aLoopSeesTheEventsEmittedBeforeIt) {
    World world;
    for (int i = 0; i < 3; ++i)
        world.emit(Said{"a word too long for the text object itself " + std::to_string(i)});
    std::vector<std::string> heard;
    for (const Said& said : world.events<Said>()) {
        for (int i = 0; i < 100; ++i) world.emit(Said{"echo"});
        heard.push_back(said.word);
    }
    ASSERT_EQ(heard.size(), 3u);
    EXPECT_EQ(heard[2], "a word too long for the text object itself 2");
    ASSERT_EQ(world.events<Said>().size(), 303u) << "the next loop sees the others";
    EXPECT_EQ(world.events<Said>()[2].word, heard[2]);
    EXPECT_EQ(world.events<Said>()[302].word, "echo");
}

TEST(EventsTest, aLoopGoesOnThoughTheWorldIsRestored) {
    World world;
    const Snapshot before = world.save();
    for (int i = 0; i < 20; ++i)
        world.emit(Said{"a word too long for the text object itself " + std::to_string(i)});
    std::vector<std::string> heard;
    for (const Said& said : world.events<Said>()) {
        world.restore(before);
        world.emit(Said{"of the time after"});
        heard.push_back(said.word);
    }
    ASSERT_EQ(heard.size(), 20u);
    EXPECT_EQ(heard[19], "a word too long for the text object itself 19");
    EXPECT_EQ(world.events<Said>().size(), 1u) << "those of the abandoned time are gone";
}

TEST(EventsProperty, spansAndReferencesStayValidForTheTick) {
    World world;
    for (int tick = 0; tick < 3; ++tick) {
        world.beginTick();
        std::vector<std::span<const Counted>> spans;
        std::vector<const Counted*> last;
        for (int i = 0; i < 1000; ++i) {
            world.emit(Counted{i});
            spans.push_back(world.events<Counted>());
            last.push_back(&spans.back().back());
        }
        for (std::size_t i = 0; i < spans.size(); ++i) {
            ASSERT_EQ(spans[i].size(), i + 1);
            for (std::size_t k = 0; k <= i; ++k) ASSERT_EQ(spans[i][k].number, static_cast<int>(k));
            ASSERT_EQ(last[i]->number, static_cast<int>(i));
        }
    }
}

TEST(EventsTest, anEventMayBeEmittedAgain) {
    World world;
    world.emit(Said{"again"});
    for (int i = 0; i < 100; ++i) world.emit(world.events<Said>().front());
    for (const Said& said : world.events<Said>()) ASSERT_EQ(said.word, "again");
    for (int i = 0; i < 100; ++i) world.emit(Fixed{i});
    EXPECT_EQ(world.events<Fixed>()[99].number, 99);
}

TEST(EventsTest, aTickWithNoMoreEventsThanTheOneBeforeAllocatesNothing) {
    World world;
    world.openInbox<Counted>(typeKey<Receiver>());
    int received = 0;
    const auto play = [&] {
        world.beginTick();
        for (int i = 0; i < 100; ++i) world.emit(Counted{i});
        world.deliver<Counted>(typeKey<Receiver>(), [&](const Counted&) { ++received; });
        for (const Counted& counted : world.events<Counted>()) {
            if (counted.number % 2 == 0) world.emit(counted);
        }
    };
    for (int tick = 0; tick < 3; ++tick) play();
    const std::size_t before = test::allocations().made;
    for (int tick = 0; tick < 10; ++tick) play();
    EXPECT_EQ(test::allocations().made, before);
    EXPECT_EQ(world.events<Counted>().size(), 150u);
    EXPECT_EQ(received, 100 + 12 * 150);
}

/// Receives all numbers in the inbox of Receiver.
std::vector<int> receive(World& world) {
    std::vector<int> numbers;
    world.deliver<Fixed>(typeKey<Receiver>(), [&](const Fixed& event) { numbers.push_back(event.number); });
    return numbers;
}
using Numbers = std::vector<int>;

TEST(EventsTest, anInboxHasWhatWasEmittedSinceItsHandlersTurn) {
    World world;
    world.openInbox<Fixed>(typeKey<Receiver>());
    world.emit(Fixed{1});
    world.beginTick();
    world.emit(Fixed{2});
    world.openInbox<Fixed>(typeKey<Receiver>());  // it has one: nothing changes
    EXPECT_EQ(receive(world), (Numbers{1, 2}));
    EXPECT_EQ(receive(world), Numbers{});
    world.emit(Fixed{3});
    world.deliver<Fixed>(typeKey<Receiver>(),
                         [&](const Fixed& event) { world.emit(Fixed{event.number + 1}); });
    world.beginTick();
    EXPECT_EQ(receive(world), Numbers{4}) << "emitted by the handler itself";
}

TEST(EventsTest, inboxesArePartOfSnapshotsAndOfTheHash) {
    World world;
    world.openInbox<Fixed>(typeKey<Receiver>());
    const std::uint64_t none = world.hash();
    EXPECT_EQ(none, World{}.hash()) << "without events in it, an inbox is not seen";
    world.emit(Fixed{1});
    const std::uint64_t one = world.hash();
    EXPECT_NE(one, none);
    const Snapshot before = world.save();
    EXPECT_EQ(receive(world), Numbers{1});
    EXPECT_EQ(world.hash(), none);
    world.emit(Fixed{2});
    world.emit(Fixed{3});
    world.restore(before);
    EXPECT_EQ(world.hash(), one);
    EXPECT_EQ(receive(world), Numbers{1});

    World other;
    other.restore(before);
    EXPECT_EQ(other.hash(), none) << "it has no such handler";
    other.openInbox<Fixed>(typeKey<Receiver>());
    other.restore(before);
    EXPECT_EQ(receive(other), Numbers{1});
}

TEST(EventsTest, savingIntoTheSameSnapshotAgainReusesItsMemory) {
    World world;
    world.openInbox<Counted>(typeKey<Receiver>());
    world.openInbox<Fixed>(typeKey<Receiver>());
    Snapshot saved;
    const auto play = [&](int round) {
        world.beginTick();
        for (int i = 0; i < 20; ++i) world.emit(Counted{i});
        if (round % 2 == 0) world.emit(Fixed{round});  // its inbox is empty in every second snapshot
        world.save(saved);
        world.deliver<Counted>(typeKey<Receiver>(), [](const Counted&) {});
        receive(world);
    };
    for (int round = 0; round < 4; ++round) play(round);
    const std::size_t before = test::allocations().made;
    play(5);
    EXPECT_EQ(test::allocations().made, before);
    world.restore(saved);
    EXPECT_EQ(receive(world), Numbers{}) << "those of the round before are not in the snapshot";
}

TEST(EventsTest, aRestoreInAHandlerEndsItsTurn) {
    World world;
    world.openInbox<Fixed>(typeKey<Receiver>());
    const auto emit = [&](int from) {
        for (int i = from; i < from + 3; ++i) world.emit(Fixed{i});
    };
    const Snapshot none = world.save();
    emit(1);
    Numbers received;
    world.deliver<Fixed>(typeKey<Receiver>(), [&](const Fixed& event) {
        world.restore(none);
        received.push_back(event.number);
    });
    EXPECT_EQ(received, Numbers{1}) << "2 and 3 are of the abandoned time";
    EXPECT_EQ(receive(world), Numbers{});

    emit(4);
    Snapshot middle;
    std::uint64_t hash = 0;
    world.deliver<Fixed>(typeKey<Receiver>(), [&](const Fixed& event) {
        if (event.number != 4) return;
        world.save(middle);
        hash = world.hash();
    });
    EXPECT_NE(hash, world.hash()) << "5 and 6 had yet to be received";
    world.restore(middle);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_EQ(receive(world), (Numbers{5, 6}));
}

/// Numbers that a handler has received, part of the world.
struct Journal {
    Numbers numbers;
};

TEST(EventsProperty, savingAndRestoringWithinHandlersChangesNoDelivery) {
    std::mt19937 random{3};
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(round);
        const auto count = static_cast<int>(1 + random() % 8);
        const auto savedAt = static_cast<int>(random() % 8) % count;
        const auto restoredAt = savedAt + static_cast<int>(random() % 8) % (count - savedAt);
        const bool echoes = random() % 2 == 0;
        const auto play = [&](bool rewinds) {
            World world;
            world.openInbox<Fixed>(typeKey<Receiver>());
            for (int i = 0; i < count; ++i) world.emit(Fixed{i});
            Snapshot saved;
            std::uint64_t hash = 0;
            for (int tick = 0; tick < 4; ++tick) {
                world.deliver<Fixed>(typeKey<Receiver>(), [&](const Fixed& event) {
                    world.resource<Journal>().numbers.push_back(event.number);
                    if (echoes && event.number < count) world.emit(Fixed{count + event.number});
                    if (!std::exchange(rewinds, rewinds && event.number != restoredAt)) return;
                    if (event.number == savedAt) world.save(saved), hash = world.hash();
                    if (event.number != restoredAt) return;
                    world.restore(saved);
                    EXPECT_EQ(world.hash(), hash);
                });
            }
            EXPECT_EQ(world.hash(), World{}.hash()) << "none waits";
            return world.resource<Journal>().numbers;
        };
        Numbers expected = play(false), received = play(true);
        EXPECT_EQ(received.size(), expected.size());
        // What waits at the restore comes in the next turn, after what was emitted before.
        EXPECT_EQ(received, expected);
    }
}

TEST(EventsTest, aNestedDeliveryIsRefused) {
    test::Faults faults;
    World world;
    world.openInbox<Fixed>(typeKey<Receiver>());
    for (int i = 0; i < 3; ++i) world.emit(Fixed{i});
    Numbers received;
    world.deliver<Fixed>(typeKey<Receiver>(), [&](const Fixed& event) {
        received.push_back(event.number);
        EXPECT_EQ(receive(world), Numbers{});
    });
    EXPECT_EQ(received, (Numbers{0, 1, 2}));
}

TEST(EventsTest, waitingEventsCanBeDropped) {
    World world;
    world.openInbox<Fixed>(typeKey<Receiver>());
    const std::uint64_t none = world.hash();
    world.emit(Fixed{1});
    world.dropWaitingEvents();
    EXPECT_EQ(world.hash(), none);
    world.emit(Fixed{2});
    EXPECT_EQ(receive(world), Numbers{2});
}

TEST(EventsTest, theInboxOfARemovedSystemIsGone) {
    World world;
    world.openInbox<Fixed>(typeKey<Receiver>());
    const std::uint64_t none = world.hash();
    world.emit(Fixed{1});
    world.removeSystem(typeKey<Receiver>());
    world.emit(Fixed{2});
    EXPECT_EQ(world.hash(), none);
    EXPECT_EQ(receive(world), Numbers{});
}

}  // namespace
}  // namespace plumb
