#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game.hpp"
#include "app/game_content.hpp"

// Handlers of a project's code receive every event once, in whatever order they, and the systems that emit
// the events, are registered.

namespace plumb {
namespace {

constexpr int kTypes = 3;           // of events
constexpr int kHandlersOfType = 3;  // handlers of each type
constexpr int kHandlers = kTypes * kHandlersOfType;
constexpr int kEmitters = 3;  // systems that emit events
constexpr int kNodes = kHandlers + kEmitters;
constexpr int kOutside = kNodes;       // emits between two ticks
constexpr int kDepth = 4;              // of chains of handlers that emit events
constexpr std::uint64_t kActive = 12;  // ticks in which systems emit; then the chains end

template <int Type>
struct Event {
    int number = 0;  ///< of its type, in the order of emission
    int depth = 0;
    int from = 0;  ///< the node that emitted it
    std::uint64_t tick = 0;
};

/// Number of events of each type that were emitted: a resource, so that a restore resets it.
struct Emitted {
    std::array<int, kTypes> count{};
};

/// Which node emits what, and what handlers have received: a service.
struct Graph {
    struct Received {
        int number = 0;
        bool inTime = false;  ///< in the tick of emission if the handler's turn came later, else in the next
        bool operator==(const Received&) const = default;
    };

    std::array<std::array<bool, kTypes>, kNodes + 1> emits{};
    std::array<int, kNodes + 1> place{};  ///< of each node in the order of the tick
    std::array<std::vector<Received>, kHandlers> received;
};

template <int Type>
void emitOne(World& world, int from, int depth) {
    world.emit(Event<Type>{world.resource<Emitted>().count[Type]++, depth, from, world.tick});
}

void emitFrom(World& world, int from, int depth) {
    const auto& emits = world.service<Graph>()->emits[static_cast<std::size_t>(from)];
    if (depth == kDepth) return;
    if (emits[0]) emitOne<0>(world, from, depth);
    if (emits[1]) emitOne<1>(world, from, depth);
    if (emits[2]) emitOne<2>(world, from, depth);
}

template <int Type, int Number>
void handle(World& world, const Event<Type>& event) {
    constexpr int kNode = Type * kHandlersOfType + Number;
    Graph& graph = *world.service<Graph>();
    const bool isLate =
        graph.place[static_cast<std::size_t>(event.from)] >= graph.place[static_cast<std::size_t>(kNode)];
    graph.received[kNode].push_back({event.number, world.tick == event.tick + (isLate ? 1 : 0)});
    emitFrom(world, kNode, event.depth + 1);
}

template <int Number>
struct Emitter {
    void update(World& world, float) const {
        if (world.tick <= kActive) emitFrom(world, kHandlers + Number, 0);
    }
};

using Add = void (*)(Module& module);
template <int Type, int Number>
void addHandler(Module& module) {
    module.on<Event<Type>, handle<Type, Number>>();
}
template <int Number>
void addEmitter(Module& module) {
    module.system<Emitter<Number>>();
}
constexpr std::array<Add, kNodes> kAdd{addHandler<0, 0>, addHandler<0, 1>, addHandler<0, 2>, addHandler<1, 0>,
                                       addHandler<1, 1>, addHandler<1, 2>, addHandler<2, 0>, addHandler<2, 1>,
                                       addHandler<2, 2>, addEmitter<0>,    addEmitter<1>,    addEmitter<2>};

/// A random order of registration. @return the module
Module shuffled(Graph& graph, std::mt19937& random) {
    std::array<int, kNodes> order{};
    for (int i = 0; i < kNodes; ++i) order[static_cast<std::size_t>(i)] = i;
    std::shuffle(order.begin(), order.end(), random);
    Module module;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto node = static_cast<std::size_t>(order[i]);
        graph.place[node] = static_cast<int>(i);
        kAdd[node](module);
    }
    graph.place[kOutside] = kNodes;
    for (auto& emits : graph.emits)
        for (bool& isEmitted : emits) isEmitted = random() % 3 == 0;
    return module;
}

void play(Game& game, std::uint64_t end) {
    while (game.world.tick < end) {
        tickGame(game, {});
        if (game.world.tick <= kActive && game.world.tick % 3 == 0) emitFrom(game.world, kOutside, 0);
    }
}

void expectAllReceivedOnce(const Graph& graph, const Emitted& emitted) {
    for (int handler = 0; handler < kHandlers; ++handler) {
        const auto& received = graph.received[static_cast<std::size_t>(handler)];
        const int count = emitted.count[static_cast<std::size_t>(handler / kHandlersOfType)];
        ASSERT_EQ(received.size(), static_cast<std::size_t>(count)) << "handler " << handler;
        for (int i = 0; i < count; ++i) {
            ASSERT_EQ(received[static_cast<std::size_t>(i)].number, i) << "handler " << handler;
            ASSERT_TRUE(received[static_cast<std::size_t>(i)].inTime) << "handler " << handler << ", " << i;
        }
    }
}

TEST(EventDelivery, everyHandlerReceivesEveryEventOnceInOrderAlsoAfterARewind) {
    std::mt19937 random{11};
    int busy = 0;  // graphs with many events
    for (int round = 0; round < 30; ++round) {
        SCOPED_TRACE(round);
        Graph graph;
        std::vector<Error> problems;
        const GameContent content{shuffled(graph, random), problems};
        ASSERT_TRUE(problems.empty()) << problems[0].text();
        Game game{content};
        content.addSystems(game.world);
        game.world.provide(graph);

        emitFrom(game.world, kOutside, 0);  // before the first tick
        play(game, kActive / 2);
        const Snapshot middle = game.world.save();
        const std::uint64_t hash = game.world.hash();
        const auto before = graph.received;
        play(game, kActive + kDepth + 1);
        expectAllReceivedOnce(graph, game.world.resource<Emitted>());
        const auto all = std::exchange(graph.received, before);

        game.world.restore(middle);
        EXPECT_EQ(game.world.hash(), hash);
        play(game, kActive + kDepth + 1);
        EXPECT_TRUE(graph.received == all) << "the same again, none twice";

        Game other{content};  // a game that has not emitted these events itself
        content.addSystems(other.world);
        other.world.provide(graph);
        graph.received = before;
        other.world.restore(middle);
        EXPECT_EQ(other.world.hash(), hash);
        play(other, kActive + kDepth + 1);
        EXPECT_TRUE(graph.received == all) << "the same in another game";
        const Emitted& emitted = other.world.resource<Emitted>();
        busy += std::any_of(emitted.count.begin(), emitted.count.end(), [](int n) { return n > 20; }) ? 1 : 0;
    }
    EXPECT_GT(busy, 10) << "the graphs are too sparse for this test";
}

}  // namespace
}  // namespace plumb
