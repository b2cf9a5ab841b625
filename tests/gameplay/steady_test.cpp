#include "tests/gameplay/level.hpp"
#include "tests/support/allocations.hpp"

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
    play(6000);  // until all buffers have reached the size that this scene needs
    const std::size_t before = test::allocations().made;
    play(600);
    EXPECT_EQ(test::allocations().made, before);
}

}  // namespace
}  // namespace plumb
