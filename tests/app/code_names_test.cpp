#include <plumb.hpp>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "core/file.hpp"
#include "tests/support/places.hpp"

// The guide's code for a component with the name of one of the engine.

// names begin
using namespace plumb;

namespace game {

struct Health {
    int hearts = 3;

    static void describe(TypeBuilder<Health>& type) {
        type.name("Hearts").doc("How many hits an enemy survives.");
        type.field<&Health::hearts>("hearts").range(1.0f, 100.0f);
    }
};

struct HealthSystem {
    void update(World& world, float) {
        for (auto [entity, health] : world.query<Health>())  // game::Health
            if (health.hearts == 0 && !world.has<plumb::Health>(entity)) world.destroy(entity);
    }
};

}  // namespace game
// names end

namespace {

TEST(CodeNames, theGuideShowsTheCodeOfThisFile) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::string file = *readFile(test::sourceFolder() / "tests/app/code_names_test.cpp");
    const std::size_t from = file.find("// names begin\n") + 15;
    const std::string code = file.substr(from, file.find("// names end\n") - from);
    EXPECT_GT(code.size(), 500u);
    EXPECT_NE(guide.find("```cpp\n" + code + "```"), std::string::npos);
}

TEST(CodeNames, aTypeInANamespaceMayHaveTheNameOfOneOfTheEngine) {
    Module module;
    module.components<game::Health>();
    module.system<game::HealthSystem, game::Health>();
    std::vector<Error> problems;
    const GameContent content{module, problems};
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    Game game{content};
    content.addSystems(game.world);
    const Entity enemy = game.world.createEntity(), player = game.world.createEntity();
    enemy.addComponent<game::Health>().hearts = 0;
    player.addComponent<game::Health>().hearts = 0;
    player.addComponent<plumb::Health>();
    tickGame(game, {});
    EXPECT_FALSE(enemy.alive());
    EXPECT_TRUE(player.alive());
}

}  // namespace
