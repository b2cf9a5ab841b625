#include <array>
#include <plumb.hpp>
#include <string>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "core/file.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/support/places.hpp"

// The guide shows the code of the template, which is built and tested, and the code of this file.

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

// references begin
/// Lets `winner` take the place of `loser`, which ends.
void takePlace(World& world, EntityId winner, EntityId loser) {
    const Vec2 place = world.get<const Transform>(loser).position;  // a copy, not a reference
    world.destroy(loser);  // references to Transforms from above this line may be those of others now
    if (Transform* transform = world.find<Transform>(winner)) teleport(*transform, place);
}
// references end

/// The code of this file between two lines.
std::string codeBetween(const std::string& begin, const std::string& end) {
    const std::string file = *readFile(test::sourceFolder() / "tests/app/code_guide_test.cpp");
    const std::size_t from = file.find(begin) + begin.size();
    return file.substr(from, file.find(end) - from);
}

TEST(CodeGuide, showsTheCodeOfTheTemplate) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::string code = *readFile(test::sourceFolder() / "assets/templates/cpp/code/game.cpp");
    EXPECT_GT(code.size(), 1000u);
    EXPECT_NE(guide.find("```cpp\n" + code + "```"), std::string::npos)
        << "copy assets/templates/cpp/code/game.cpp into docs/code.md";
}

TEST(CodeGuide, showsTheCodeOfThisFile) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    for (const std::string& code : {codeBetween("// layers begin\n", "// layers end\n"),
                                    codeBetween("// references begin\n", "// references end\n")}) {
        EXPECT_GT(code.size(), 400u);
        EXPECT_NE(guide.find("```cpp\n" + code + "```"), std::string::npos) << code;
    }
}

TEST(CodeGuide, referencesAreThoseOfOthersWhenAnEntityWasDestroyed) {
    World world;
    std::array<EntityId, 3> ids;
    for (EntityId& id : ids) {
        const Entity entity = world.createEntity();
        id = entity.id();
        entity.addComponent<Transform>(0.0f, 10.0f * static_cast<float>(id.index));
    }
    const Transform* first = world.find<const Transform>(ids[0]);
    const Transform* last = world.find<const Transform>(ids[2]);
    for (int i = 0; i < 10000; ++i) world.createEntity().addComponent<Transform>();
    EXPECT_EQ(first, world.find<const Transform>(ids[0])) << "new components move nothing";
    takePlace(world, ids[2], ids[0]);
    EXPECT_FALSE(world.alive(ids[0]));
    EXPECT_EQ(world.get<const Transform>(ids[2]).position.y, 10.0f);
    EXPECT_EQ(last, world.find<const Transform>(ids[2])) << "it was not the last of its type";
    EXPECT_EQ(first, world.find<const Transform>(EntityId{10003, 1})) << "the last one took the place";
}

TEST(CodeGuide, wordsOfLabelsHaveValues) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::size_t from = guide.find("| word | value |");
    ASSERT_NE(from, std::string::npos);
    const std::string table = guide.substr(from, guide.find("\n## ", from) - from);
    World world;
    static_cast<void>(world.resource<PhysicsState>());
    static_cast<void>(world.resource<Input>());
    int words = 0;
    for (std::size_t at = table.find("`{"); at != std::string::npos; at = table.find("`{", at + 1)) {
        const std::string word = table.substr(at + 1, table.find('`', at + 1) - at - 1);
        std::string text;
        fillPlaceholders(world, word, text);
        EXPECT_NE(text, word);
        showText(world, word.substr(1, word.size() - 2), "own");
        fillPlaceholders(world, word, text);
        EXPECT_EQ(text, "own") << word;
        ++words;
    }
    EXPECT_EQ(words, 21);
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
