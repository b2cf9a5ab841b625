#include <algorithm>
#include <filesystem>
#include <optional>
#include <plumb.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "core/file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

// The recipes of docs/code.md, which are the files of tests/code/recipes/code: each does what the document
// says. They are compiled like the code of a project, so the tests know their components by name only, as a
// scene does.

void addPoints(plumb::World& world, int points);                              // score.cpp
void follow(plumb::World& world, plumb::EntityId target, plumb::Vec2 level);  // camera.cpp

namespace plumb {
namespace {

/// A game with the code of all recipes and without gravity.
class CodeRecipes : public testing::Test {
protected:
    CodeRecipes() {
        Module module;
        plumbDescribeModule(module);
        content.emplace(std::move(module), problems);
        for (const Error& problem : problems) ADD_FAILURE() << problem.text();
        game.emplace(*content);
        game->assets = AssetStore{folder.path, {}};
        game->assets.logging = false;
        game->setGravity({});
        content->addSystems(game->world);
        game->world.resource<PictureSize>().size = {320.0f, 180.0f};
        previous_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) logged += line.text + "\n";
        });
    }
    ~CodeRecipes() override { setLogSink(previous_); }

    void writePrefab(const std::string& name, const std::string& components) {
        const std::string text = R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "it",
            "components": {"Transform": {}, )" +
                                 components + "}}]}";
        ASSERT_TRUE(writeFile(folder.path / "prefabs" / (name + ".prefab.json"), text).ok());
    }
    /// Adds an entity with these components, written as in a scene file.
    Entity add(Vec2 place, const std::string& components) {
        const std::string name = format("part{}", parts_++);
        writePrefab(name, components);
        return game->spawn(name, place);
    }
    void run(int ticks, const InputFrame& frame = {}) {
        for (int i = 0; i < ticks; ++i) tickGame(*game, frame);
    }
    void press(Key key, int ticks = 1) {
        InputFrame frame;
        frame.set(key, true);
        run(ticks, frame);
    }
    std::string shown(std::string_view word) {
        const std::string* text = game->world.resource<LabelValues>().find(word);
        return text == nullptr ? "nothing" : *text;
    }
    SceneRequests& requests() { return game->world.resource<SceneRequests>(); }
    std::string requested() { return std::string{game->world.texts().find(requests().next)}; }

    test::TemporaryFolder folder;
    std::vector<Error> problems;
    std::optional<GameContent> content;
    std::optional<Game> game;
    std::string logged;  ///< warnings and errors

private:
    LogSink previous_;
    int parts_ = 0;
};

const std::string kDisc = R"("CircleCollider": {"radius": 8})";

TEST_F(CodeRecipes, countPickUpsAndKeepTheBestScore) {
    run(1);
    EXPECT_EQ(shown("best"), "0") << "also in a scene without a score";
    Entity score = add({}, R"("Score": {})");
    const Entity coin =
        add({}, R"("CircleCollider": {"radius": 8, "isTrigger": true}, "Coin": {"value": 5})");
    add({50.0f, 0.0f}, kDisc + R"(, "Collector": {}, "RigidBody": {"velocity": [-100, 0]})");
    run(2);
    EXPECT_EQ(shown("score"), "0");
    run(60);
    EXPECT_EQ(shown("score"), "5");
    EXPECT_FALSE(coin.alive());
    addPoints(game->world, 2);
    run(1);
    EXPECT_EQ(shown("score") + " " + shown("best"), "7 7");
    score.destroy();  // as a restart does, which loads the level again
    add({}, R"("Score": {})");
    addPoints(game->world, 3);
    run(1);
    EXPECT_EQ(shown("score") + " " + shown("best"), "3 7");
}

TEST_F(CodeRecipes, sendWaves) {
    writePrefab("enemy", R"("StaticBody": {})");
    Entity sender = add({}, R"("Waves": {"enemy": "prefabs/enemy.prefab.json", "interval": 0.5})");
    run(1);
    EXPECT_EQ(game->world.count<StaticBody>(), 3u);
    run(30);
    EXPECT_EQ(game->world.count<StaticBody>(), 7u);
    sender.destroy();
    run(60);
    EXPECT_EQ(game->world.count<StaticBody>(), 7u);
    EXPECT_EQ(logged, "");
}

TEST_F(CodeRecipes, wavesWithoutAPrefabAreReportedOnce) {
    add({}, R"("Waves": {"interval": 0.5})");
    run(120);
    EXPECT_EQ(logged, "Waves.enemy: no prefab is chosen; choose the enemy in the inspector\n");
}

TEST_F(CodeRecipes, endTheGameWithTheLastLife) {
    add({}, kDisc + R"(, "StaticBody": {}, "Thorn": {})");
    add({60.0f, 0.0f}, kDisc + R"(, "Hero": {"lives": 2}, "RigidBody": {"velocity": [-200, 0]})");
    run(40);
    EXPECT_EQ(shown("lives"), "1");
    EXPECT_EQ(requested(), "");
    run(60);  // until it may be hurt again
    EXPECT_EQ(shown("lives"), "0");
    EXPECT_EQ(requested(), "scenes/game_over.scene.json");
    EXPECT_TRUE(requests().overlay);
}

TEST_F(CodeRecipes, aHeroThatRestsOnAThornLosesALifeOncePerMercy) {
    game->setGravity({0.0f, 980.0f});
    add({0.0f, 40.0f}, R"("BoxCollider": {"width": 100, "height": 20}, "StaticBody": {}, "Thorn": {})");
    add({50.0f, 20.0f},
        R"("BoxCollider": {"width": 16, "height": 16}, "RigidBody": {}, "Hero": {"lives": 9})");
    run(20);
    EXPECT_EQ(shown("lives"), "8");
    run(300);  // it sleeps long before
    EXPECT_EQ(shown("lives"), "3");
}

TEST_F(CodeRecipes, moveInEightDirectionsAtOneSpeed) {
    const Entity mover =
        add({}, kDisc + R"(, "RigidBody": {"gravityScale": 0}, "TopDownMover": {"speed": 120})");
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
        for (const float y : {-1.0f, 0.0f, 1.0f}) {
            InputFrame frame;
            if (x != 0.0f) frame.set(x < 0.0f ? Key::Left : Key::Right, true);
            if (y != 0.0f) frame.set(y < 0.0f ? Key::Up : Key::Down, true);
            const Vec2 before = mover.get<const Transform>().position;
            run(30, frame);
            const Vec2 moved = mover.get<const Transform>().position - before;
            const Vec2 expected = x == 0.0f && y == 0.0f ? Vec2{} : normalized(Vec2{x, y}) * 60.0f;
            EXPECT_NEAR(moved.x, expected.x, 0.1f);
            EXPECT_NEAR(moved.y, expected.y, 0.1f);
        }
    }
}

TEST_F(CodeRecipes, movementStopsAtAWallAndSlidesAlongIt) {
    add({20.0f, -200.0f}, R"("BoxCollider": {"width": 20, "height": 400}, "StaticBody": {})");
    const Entity mover =
        add({}, kDisc + R"(, "RigidBody": {"gravityScale": 0}, "TopDownMover": {"speed": 120})");
    InputFrame frame;
    frame.set(Key::D, true);
    frame.set(Key::S, true);
    run(60, frame);
    const Vec2 at = mover.get<const Transform>().position;
    EXPECT_NEAR(at.x, 12.0f, 1.0f);
    EXPECT_GT(at.y, 40.0f);
}

TEST_F(CodeRecipes, shootTowardsTheMouse) {
    writePrefab("bullet", R"("RigidBody": {})");
    add({100.0f, 90.0f}, R"("Gun": {"bullet": "prefabs/bullet.prefab.json"})");
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

TEST_F(CodeRecipes, shotsMoveAlsoWithTheMouseOnTheGun) {
    writePrefab("bullet", R"("RigidBody": {})");
    const Entity gun = add({100.0f, 90.0f}, R"("Gun": {"bullet": "prefabs/bullet.prefab.json"})");
    InputFrame frame;
    frame.setMouse({100.0f, 90.0f});
    frame.set(Key::X, true);
    run(1, frame);
    ASSERT_EQ(game->mouseInWorld(), gun.get<const Transform>().position);
    EXPECT_EQ(length(game->world.first<RigidBody>().get<RigidBody>().velocity), 600.0f);
}

TEST_F(CodeRecipes, followAnEntity) {
    const Entity hero = add({400.0f, 90.0f}, kDisc);
    game->camera();
    follow(game->world, hero, {1000.0f, 180.0f});
    run(120);
    EXPECT_NEAR(game->camera().get<Transform>().position.x, 400.0f, 20.5f) << "within the dead zone";
}

TEST_F(CodeRecipes, playTheClipOfTheState) {
    AnimationSet set;
    for (const char* name : {"idle", "run", "jump"}) set.clips.emplace_back().name = name;
    Entity hero = add({}, kDisc + R"(, "Walking": {}, "Sprite": {}, "RigidBody": {"velocity": [-50, 0]})");
    hero.addComponent<Animator>(game->assets.addAnimation("hero", set));
    run(2);
    EXPECT_EQ(hero.get<Animator>().clip, 2) << "in the air";
    EXPECT_TRUE(hero.get<Sprite>().flipX);
}

TEST_F(CodeRecipes, restartAndOpenThePauseMenu) {
    add({}, R"("LevelKeys": {"pause": "scenes/pause.scene.json"})");
    press(Key::R);
    EXPECT_TRUE(requests().reload);
    requests() = {};
    run(1);
    press(Key::Escape);
    EXPECT_EQ(requested(), "scenes/pause.scene.json");
    EXPECT_TRUE(requests().overlay);
}

TEST_F(CodeRecipes, moveBackAndForth) {
    const Entity lift = add({10.0f, 20.0f}, kDisc + R"(, "KinematicBody": {}, "Shuttle": {"way": [30, 0]})");
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
    add({}, kDisc + R"(, "StaticBody": {}, "Sparks": {})");
    add({60.0f, 0.0f}, kDisc + R"(, "RigidBody": {"velocity": [-300, 0]})");
    run(10);
    EXPECT_EQ(game->world.count<ParticleEmitter>(), 1u);
}

TEST(CodeGuide, theRecipesAreTheFilesThatAreCompiled) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::size_t begin = guide.find("\n## Recipes\n");
    ASSERT_NE(begin, std::string::npos);
    const std::string recipes = guide.substr(begin, guide.find("\n## ", begin + 1) - begin);
    std::size_t files = 0;
    for (const auto& file :
         std::filesystem::directory_iterator{test::sourceFolder() / "tests/code/recipes/code"}) {
        EXPECT_NE(recipes.find("```cpp\n" + *readFile(file.path()) + "```"), std::string::npos)
            << "copy " << file.path() << " into docs/code.md";
        ++files;
    }
    std::size_t blocks = 0;
    for (std::size_t at = recipes.find("```cpp\n"); at != std::string::npos;
         at = recipes.find("```cpp\n", at + 1))
        ++blocks;
    EXPECT_EQ(files, blocks);
    EXPECT_GE(files, 11u);
}

}  // namespace
}  // namespace plumb
