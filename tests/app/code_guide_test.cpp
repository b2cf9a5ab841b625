#include <plumb.hpp>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "core/file.hpp"
#include "tests/support/places.hpp"

// The guide shows the code of the template, which is built and tested, and the code for collision layers
// below.

namespace plumb {
namespace {

// layers begin
constexpr std::uint32_t kGround = 1u << 0;  // in the order of "layers" in project.json
constexpr std::uint32_t kPlayer = 1u << 1;
constexpr std::uint32_t kShots = 1u << 2;

/// Creates a shot, which passes through the player and other shots.
EntityId shoot(World& world, Vec2 from, Vec2 velocity) {
    Entity shot = world.createEntity();
    shot.addComponent<Transform>(from.x, from.y);
    shot.addComponent<RigidBody>().velocity = velocity;
    CircleCollider& collider = shot.addComponent<CircleCollider>(4.0f);
    collider.layers = kShots;
    collider.mask = ~(kPlayer | kShots);
    return shot.id();
}

/// Destroys shots that hit the ground.
struct ShotSystem {
    void update(World& world, float) {
        for (const ContactBegan& contact : world.events<ContactBegan>()) {
            if ((collisionLayersOf(world, contact.a) & kGround) != 0) hitGround(world, contact.b);
            if ((collisionLayersOf(world, contact.b) & kGround) != 0) hitGround(world, contact.a);
        }
    }
    void hitGround(World& world, EntityId entity) {
        if ((collisionLayersOf(world, entity) & kShots) != 0) world.destroy(entity);
    }
};
// layers end

TEST(CodeGuide, showsTheCodeOfTheTemplate) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::string code = *readFile(test::sourceFolder() / "assets/templates/cpp/code/game.cpp");
    EXPECT_GT(code.size(), 1000u);
    EXPECT_NE(guide.find("```cpp\n" + code + "```"), std::string::npos)
        << "copy assets/templates/cpp/code/game.cpp into docs/code.md";
}

TEST(CodeGuide, showsTheCodeForCollisionLayersOfThisFile) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::string file = *readFile(test::sourceFolder() / "tests/app/code_guide_test.cpp");
    const std::size_t from = file.find("// layers begin\n") + 16;
    const std::string code = file.substr(from, file.find("// layers end\n") - from);
    EXPECT_GT(code.size(), 500u);
    EXPECT_NE(guide.find("```cpp\n" + code + "```"), std::string::npos);
}

TEST(CodeGuide, shotsPassThroughThePlayerAndEndAtTheGround) {
    Module module;
    module.system<ShotSystem>();
    std::vector<Error> problems;
    const GameContent content{module, problems};
    Game game{content};
    content.addSystems(game.world);
    const auto box = [&](float y, std::uint32_t layers) {
        Entity entity = game.world.createEntity();
        entity.addComponent<Transform>(0.0f, y);
        entity.addComponent<StaticBody>();
        entity.addComponent<BoxCollider>(100, 20).layers = layers;
        return entity.id();
    };
    const EntityId player = box(100.0f, kPlayer), ground = box(200.0f, kGround);
    const EntityId shot = shoot(game.world, {50.0f, 50.0f}, {0.0f, 300.0f});
    EXPECT_EQ(collisionLayersOf(game.world, shot), kShots);
    EXPECT_EQ(collisionLayersOf(game.world, EntityId{}), 0u);

    float lowest = 0.0f;
    for (int i = 0; i < 60 && game.world.alive(shot); ++i) {
        lowest = game.world.get<Transform>(shot).position.y;
        tickGame(game, {});
    }
    EXPECT_FALSE(game.world.alive(shot));
    EXPECT_GT(lowest, 180.0f) << "it is below the player";
    EXPECT_TRUE(game.world.alive(player) && game.world.alive(ground));
}

TEST(CodeGuide, tilesHaveCollisionLayersToo) {
    World world;
    Entity tiles = world.createEntity();
    tiles.addComponent<TileCollider>().layers = kGround | kPlayer;
    EXPECT_EQ(collisionLayersOf(world, tiles.id()), kGround | kPlayer);
}

}  // namespace
}  // namespace plumb
