#include <cstdlib>
#include <new>

#include "tests/gameplay/level.hpp"

namespace {
std::size_t allocations = 0;
}

// Counts what the program allocates, so that a test can ask a tick for none.
void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
    throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace plumb {
namespace {

TEST(Steady, aTickOfAPlayedLevelAllocatesNothing) {
    Level level{{"##############################", "#                            #",
                 "#        ----      /##\\      #", "#                 /####\\     #",
                 "#   ###     --   ########    #", "#                            #",
                 "#  /##\\   lh##HL      ---    #", "# /####\\lh######HL           #",
                 "##############################"}};
    level.addPlayer({40, 60});
    Entity platform = level.addBox({200, 40}, {48, 10});
    platform.addComponent<KinematicBody>();
    platform.addComponent<MovingPlatform>();
    for (int i = 0; i < 6; ++i) {
        Entity crate = level.addBox({300.0f + 12.0f * static_cast<float>(i), 100}, {10, 10});
        crate.addComponent<RigidBody>();
        Entity enemy = level.addBox({330.0f, 114}, {14, 14}, true);
        enemy.addComponent<KinematicBody>();
        enemy.addComponent<Patrol>();
        level.addBox({60.0f, 20}, {8, 8}, true).addComponent<Spring>();
    }
    const auto play = [&level](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            level.hold(Key::Right, i / 60 % 2 == 0);
            level.hold(Key::Left, i / 60 % 2 == 1);
            level.hold(Key::Space, i % 40 < 15);
            level.tick();
        }
    };
    play(600);
    const std::size_t before = allocations;
    play(600);
    EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace plumb
