#include "ecs/events.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ecs/parts.hpp"
#include "tests/support/allocations.hpp"

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
    const auto play = [&world] {
        world.beginTick();
        for (int i = 0; i < 100; ++i) world.emit(Counted{i});
        for (const Counted& counted : world.events<Counted>()) {
            if (counted.number % 2 == 0) world.emit(counted);
        }
    };
    play();
    play();
    const std::size_t before = test::allocations().made;
    for (int tick = 0; tick < 10; ++tick) play();
    EXPECT_EQ(test::allocations().made, before);
    EXPECT_EQ(world.events<Counted>().size(), 150u);
}

}  // namespace
}  // namespace plumb
