#include "tests/app/recipes/code_recipes.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "core/file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

// The recipes of docs/code.md do what it says.

namespace plumb {
namespace {

/// A game with the components and systems of one recipe.
class CodeRecipes : public testing::Test {
protected:
    Game& begin(void (*fill)(Module& module)) {
        Module module;
        fill(module);
        content.emplace(std::move(module), problems);
        game.emplace(*content);
        game->assets = AssetStore{folder.path, {}};
        game->assets.logging = false;
        game->setGravity({});
        content->addSystems(game->world);
        EXPECT_TRUE(problems.empty());
        return *game;
    }
    Entity add(Vec2 place, float radius, bool isTrigger = false) {
        Entity made = game->world.createEntity();
        made.addComponent<Transform>(place);
        made.addComponent<CircleCollider>(radius).isTrigger = isTrigger;
        return made;
    }
    void run(int ticks, const InputFrame& frame = {}) {
        for (int i = 0; i < ticks; ++i) tickGame(*game, frame);
    }
    void press(Key key) {
        InputFrame frame;
        frame.set(key, true);
        run(1, frame);
    }
    std::string shown(std::string_view word) { return *game->world.resource<LabelValues>().find(word); }
    SceneRequests& requests() { return game->world.resource<SceneRequests>(); }
    std::string requested() { return std::string{game->world.texts().find(requests().next)}; }

    test::TemporaryFolder folder;
    std::vector<Error> problems;
    std::optional<GameContent> content;
    std::optional<Game> game;
};

TEST_F(CodeRecipes, countPickUps) {
    begin(pickups::addCoins);
    const Entity coin = add({0.0f, 0.0f}, 8.0f, true), hero = add({50.0f, 0.0f}, 8.0f);
    coin.addComponent<pickups::Coin>().value = 5;
    hero.addComponent<pickups::Collector>();
    hero.addComponent<RigidBody>().velocity = {-100.0f, 0.0f};
    run(2);
    EXPECT_EQ(shown("points"), "0");
    run(60);
    EXPECT_EQ(shown("points"), "5");
    EXPECT_FALSE(coin.alive());
}

TEST_F(CodeRecipes, sendWaves) {
    begin(waves::addWaves);
    const std::string enemy = R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "enemy",
        "components": {"Transform": {}, "StaticBody": {}}}]})";
    ASSERT_TRUE(writeFile(folder.path / "prefabs/enemy.prefab.json", enemy).ok());
    const Entity sender = add({}, 1.0f);
    waves::Waves& sent = sender.addComponent<waves::Waves>();
    sent.enemy = {game->world.texts().add("prefabs/enemy.prefab.json")};
    sent.interval = 0.5f;
    run(1);
    EXPECT_EQ(game->world.count<StaticBody>(), 3u);
    run(30);
    EXPECT_EQ(game->world.count<StaticBody>(), 7u);
    game->world.destroy(sender);
    run(60);
    EXPECT_EQ(game->world.count<StaticBody>(), 7u);
}

TEST_F(CodeRecipes, endTheGameWithTheLastLife) {
    begin(health::addHealth);
    add({}, 8.0f).addComponent<health::Thorn>();
    const Entity hero = add({60.0f, 0.0f}, 8.0f);
    hero.addComponent<health::Hero>().lives = 2;
    hero.addComponent<RigidBody>().velocity = {-200.0f, 0.0f};
    run(90);  // until a hit counts again
    EXPECT_EQ(shown("lives"), "1");
    EXPECT_EQ(requested(), "");
    teleport(hero.get<Transform>(), {60.0f, 0.0f});
    hero.get<RigidBody>().velocity = {-200.0f, 0.0f};
    run(60);
    EXPECT_EQ(hero.get<health::Hero>().lives, 0);
    EXPECT_EQ(requested(), "scenes/game_over.scene.json");
    EXPECT_TRUE(requests().overlay);
}

TEST_F(CodeRecipes, shootTowardsTheMouse) {
    begin(shooting::addGuns);
    const std::string bullet = R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "bullet",
        "components": {"Transform": {}, "RigidBody": {}}}]})";
    ASSERT_TRUE(writeFile(folder.path / "prefabs/bullet.prefab.json", bullet).ok());
    game->world.resource<PictureSize>().size = {320.0f, 180.0f};
    add({100.0f, 90.0f}, 1.0f).addComponent<shooting::Gun>().bullet = {
        game->world.texts().add("prefabs/bullet.prefab.json")};
    InputFrame frame;
    frame.setMouse({100.0f, 10.0f});
    frame.set(Key::X, true);
    run(1, frame);
    const Entity shot = game->world.first<RigidBody>();
    ASSERT_TRUE(shot);
    EXPECT_EQ(shot.get<RigidBody>().velocity, (Vec2{0.0f, -600.0f}));
    run(30, frame);
    EXPECT_EQ(game->world.count<RigidBody>(), 3u) << "one in 12 ticks";
}

TEST_F(CodeRecipes, followAnEntity) {
    begin(scores::addScore);
    game->world.resource<PictureSize>().size = {320.0f, 180.0f};
    const Entity hero = add({400.0f, 90.0f}, 8.0f);
    game->camera();
    following::follow(game->world, hero, {1000.0f, 180.0f});
    run(120);
    EXPECT_NEAR(game->camera().get<Transform>().position.x, 400.0f, 20.5f) << "within the dead zone";
}

TEST_F(CodeRecipes, playTheClipOfTheState) {
    begin(animation::addWalking);
    AnimationSet set;
    for (const char* name : {"idle", "run", "jump"}) set.clips.emplace_back().name = name;
    const Entity hero = add({}, 8.0f);
    hero.addComponent<animation::Walking>();
    hero.addComponent<Sprite>();
    hero.addComponent<Animator>(game->assets.addAnimation("hero", set));
    hero.addComponent<RigidBody>().velocity = {-50.0f, 0.0f};
    run(2);
    EXPECT_EQ(hero.get<Animator>().clip, 2) << "in the air";
    EXPECT_TRUE(hero.get<Sprite>().flipX);
}

TEST_F(CodeRecipes, keepTheBestScore) {
    begin(scores::addScore);
    scores::addPoints(game->world, 7);
    game->world.resource<scores::Score>().points = 0;
    scores::addPoints(game->world, 3);
    EXPECT_EQ(shown("score"), "3");
    EXPECT_EQ(shown("best"), "7");
}

TEST_F(CodeRecipes, restartAndReturnToTheMenu) {
    begin(menus::addGameKeys);
    add({}, 1.0f).addComponent<menus::GameKeys>().menu = {game->world.texts().add("scenes/menu.scene.json")};
    press(Key::R);
    EXPECT_TRUE(requests().reload);
    press(Key::Escape);
    EXPECT_EQ(requested(), "scenes/menu.scene.json");
}

TEST_F(CodeRecipes, moveBackAndForth) {
    begin(patrols::addShuttles);
    const Entity lift = add({10.0f, 20.0f}, 8.0f);
    lift.addComponent<KinematicBody>();
    lift.addComponent<patrols::Shuttle>().way = {30.0f, 0.0f};
    float most = 0.0f;
    for (int i = 0; i < 240; ++i) {
        run(1);
        const Vec2 at = lift.get<Transform>().position;
        most = std::max(most, at.x);
        EXPECT_GE(at.x, 8.0f);
        EXPECT_EQ(at.y, 20.0f);
    }
    EXPECT_NEAR(most, 40.0f, 2.0f);
}

TEST_F(CodeRecipes, emitSparksWhereItIsHitHard) {
    begin(sparks::addSparks);
    add({}, 8.0f).addComponent<sparks::Sparks>();
    const Entity ball = add({60.0f, 0.0f}, 8.0f);
    ball.addComponent<RigidBody>().velocity = {-300.0f, 0.0f};
    run(10);
    EXPECT_EQ(game->world.count<ParticleEmitter>(), 1u);
}

TEST_F(CodeRecipes, pauseAndGoOn) {
    begin(pausing::addPause);
    press(Key::Escape);
    EXPECT_EQ(requested(), "scenes/pause.scene.json");
    requests() = {};
    run(1);
    game->world.resource<LoadedScenes>().scenes.resize(2);
    press(Key::Escape);
    EXPECT_TRUE(requests().close);
    game->world.resource<LoadedScenes>().scenes.clear();
}

TEST(CodeGuide, everyRecipeIsCompiledAndRun) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::string file = *readFile(test::sourceFolder() / "tests/app/recipes/code_recipes.hpp");
    const std::size_t begin = guide.find("\n## Recipes\n");
    ASSERT_NE(begin, std::string::npos);
    const std::string recipes = guide.substr(begin, guide.find("\n## ", begin + 1) - begin);
    std::size_t count = 0;
    for (std::size_t at = recipes.find("```cpp\n"); at != std::string::npos; ++count) {
        const std::size_t start = at + 7;
        const std::string code = recipes.substr(start, recipes.find("```", start) - start);
        EXPECT_NE(file.find("\n// doc\n" + code + "// end\n"), std::string::npos) << code;
        at = recipes.find("```cpp\n", start);
    }
    EXPECT_EQ(count, 11u);
}

}  // namespace
}  // namespace plumb
