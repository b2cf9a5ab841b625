#include <algorithm>
#include <cmath>

#include "ecs/hierarchy.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/pause_scene.hpp"
#include "gameplay/register_components.hpp"
#include "input/input.hpp"
#include "math/portable.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/play_sound.hpp"
#include "scene/scene_requests.hpp"
#include "scene/systems/animation_system.hpp"
#include "tests/gameplay/level.hpp"

namespace plumb {
namespace {

const std::vector<std::string_view> kFlat = {
    "                              ", "                              ", "                              ",
    "                              ", "                              ", "##############################",
};
constexpr float kFloor = 80.0f;

Entity addEnemy(Level& level, Vec2 feet) {
    Entity enemy = level.addBox({feet.x - 8, feet.y - 14}, {16, 14}, true);
    enemy.addComponent<KinematicBody>();
    enemy.addComponent<Patrol>();
    enemy.addComponent<Hazard>();
    enemy.addComponent<Stompable>();
    return enemy;
}

TEST(Patrol, turnsAtWallsAndEdgesAndNeverFalls) {
    Level level{{"                    ", "#     #             ", "#     #             ",
                 "#     ############# ", "#     #             ", "#######             "}};
    const Entity inRoom = addEnemy(level, {60, 80});
    const Entity onLedge = addEnemy(level, {200, 48});
    int turns = 0;
    int before = 0;
    for (int i = 0; i < 1200; ++i) {
        level.tick();
        ASSERT_GE(inRoom.get<Transform>().position.x, 16.0f);
        ASSERT_LE(inRoom.get<Transform>().position.x + 16.0f, 96.0f);
        ASSERT_GE(onLedge.get<Transform>().position.x, 112.0f - 8.0f);
        ASSERT_LE(onLedge.get<Transform>().position.x + 16.0f, 304.0f + 1.0f);
        const int direction = onLedge.get<Patrol>().direction;
        turns += direction != before ? 1 : 0;
        before = direction;
    }
    EXPECT_GT(turns, 3);
}

TEST(Patrol, keepsToItsLimits) {
    Level level{kFlat};
    const Entity enemy = addEnemy(level, {240, kFloor});
    enemy.get<Patrol>().leftLimit = 30;
    enemy.get<Patrol>().rightLimit = 50;
    for (int i = 0; i < 900; ++i) {
        level.tick();
        ASSERT_NEAR(enemy.get<Transform>().position.x, 242.0f, 41.0f);
    }
}

TEST(Hazard, killsThePlayerWhichRespawnsAtTheCheckpoint) {
    Level level{kFlat};
    level.addPlayer({40, kFloor});
    Entity checkpoint = level.addBox({90, kFloor - 30}, {10, 30}, true);
    checkpoint.addComponent<Checkpoint>();
    Entity spikes = level.addBox({200, kFloor - 8}, {16, 8}, true);
    spikes.addComponent<Hazard>();
    level.settle();
    level.hold(Key::Right);
    int ticks = 0;
    while (level.world.resource<GameProgress>().deaths == 0 && ++ticks < 300) level.tick();
    EXPECT_EQ(level.world.resource<GameProgress>().deaths, 1);
    EXPECT_TRUE(checkpoint.get<Checkpoint>().active);
    level.hold(Key::Right, false);
    level.tick();
    EXPECT_TRUE(level.player.hasComponent<Hidden>());
    level.run(60);
    EXPECT_FALSE(level.player.hasComponent<Hidden>());
    EXPECT_NEAR(level.at().x, 90.0f, 2.0f);
    EXPECT_EQ(level.player.get<Health>().points, 1);
    EXPECT_EQ(level.world.resource<GameProgress>().deaths, 1) << "one touch must count as one death";
}

TEST(Hazard, withMoreHealthItHurtsOnceAndKnocksBack) {
    Level level{kFlat};
    level.addPlayer({100, kFloor});
    level.player.get<Health>().points = level.player.get<Health>().most = 3;
    level.addBox({112, kFloor - 8}, {40, 8}, true).addComponent<Hazard>();
    level.settle();
    level.hold(Key::Right);
    level.run(10);
    EXPECT_EQ(level.player.get<Health>().points, 2);
    EXPECT_GT(level.player.get<Health>().safe, 0);
    EXPECT_EQ(level.world.resource<GameProgress>().deaths, 0);
}

TEST(Hazard, fallingBelowTheKillPlaneKills) {
    Level level{{"                  ", "####              ", "                  "}};
    level.addPlayer({30, 16});
    Entity plane = level.world.createEntity();
    plane.addComponent<Transform>(0.0f, 300.0f);
    plane.addComponent<KillPlane>();
    level.settle();
    level.hold(Key::Right);
    level.run(120);
    level.hold(Key::Right, false);
    EXPECT_EQ(level.world.resource<GameProgress>().deaths, 1);
    level.run(90);
    EXPECT_NEAR(level.at().x, 24.0f, 1.0f) << "respawns at the start, without a checkpoint";
}

TEST(Hazard, theKillPlaneIsWhereItIsDrawn) {
    Level level{kFlat};
    level.addPlayer({30, 16});
    Entity group = level.world.createEntity();
    group.addComponent<Transform>(0.0f, 300.0f);
    Entity plane = level.world.createEntity();
    plane.addComponent<Transform>(0.0f, 50.0f);
    plane.addComponent<KillPlane>();
    setParent(level.world, plane, group);
    const Entity above = level.addBox({200, 10}, {10, 10}, false),
                 below = level.addBox({200, 400}, {10, 10}, false);
    for (Entity crate : {above, below}) crate.addComponent<RigidBody>().gravityScale = 0.0f;
    level.run(2);
    EXPECT_TRUE(above.alive());
    EXPECT_FALSE(below.alive());
    EXPECT_EQ(level.world.resource<GameProgress>().deaths, 0);
}

TEST(Stompable, diesWhenJumpedOnAndHurtsFromTheSide) {
    Level level{kFlat};
    const Entity enemy = addEnemy(level, {100, kFloor});
    enemy.get<Patrol>().speed = 0;
    level.addPlayer({100, 20});
    int ticks = 0;
    while (enemy.hasComponent<Stompable>() && ++ticks < 120) level.tick();
    EXPECT_LT(level.velocity().y, -200.0f);
    EXPECT_EQ(level.world.resource<GameProgress>().deaths, 0);
    level.run(60);
    EXPECT_FALSE(enemy.alive());

    Level side{kFlat};
    addEnemy(side, {100, kFloor}).get<Patrol>().speed = 0;
    side.addPlayer({60, kFloor});
    side.settle();
    side.hold(Key::Right);
    side.run(30);
    EXPECT_EQ(side.world.resource<GameProgress>().deaths, 1);
}

TEST(Spring, launchesToTheHeightOfItsSpeed) {
    Level level{kFlat};
    Entity spring = level.addBox({92, kFloor - 8}, {16, 8}, true);
    spring.addComponent<Spring>().speed = {0, -420};
    level.addPlayer({100, 30});
    float highest = kFloor;
    float fastest = 0.0f;
    for (int i = 0; i < 60; ++i) {
        level.tick();
        highest = std::min(highest, level.feet());
        fastest = std::min(fastest, level.velocity().y);
    }
    EXPECT_EQ(fastest, -420.0f);
    EXPECT_NEAR(kFloor - 8 - highest, 420.0f * 420.0f / 2.0f / 1800.0f, 6.0f);
}

TEST(Collectible, spawnsItsSparksAtItsPosition) {
    Level level{kFlat};
    level.player = level.addPlayer({40, kFloor});
    Entity coin = level.addBox({80, kFloor - 16}, {8, 8}, true);
    coin.addComponent<Collectible>();
    Entity sparks = level.world.createEntity();
    sparks.addComponent<Transform>(4.0f, -2.0f);
    auto& emitter = sparks.addComponent<ParticleEmitter>();
    emitter.playing = false;
    emitter.duration = 0.1f;
    emitter.lifetime = 0.5f;
    emitter.lifetimeSpread = 0.0f;
    setParent(level.world, sparks, coin);
    const Vec2 place = worldPose(level.world, sparks).position;
    level.settle();
    level.hold(Key::Right);
    for (int i = 0; i < 120 && level.world.count<Collectible>() > 0; ++i) level.tick();
    ASSERT_TRUE(level.world.alive(sparks));
    EXPECT_TRUE(sparks.get<ParticleEmitter>().playing);
    EXPECT_EQ(sparks.get<Transform>().position, place);
    EXPECT_NEAR(sparks.get<Lifetime>().seconds, 0.6f, 0.02f);  // one tick has passed
}

TEST(Collectible, isCountedOnceAndRemoved) {
    Level level{kFlat};
    level.player = level.addPlayer({40, kFloor});
    for (int i = 0; i < 5; ++i) {
        Entity coin = level.addBox({80.0f + 20.0f * static_cast<float>(i), kFloor - 16}, {8, 8}, true);
        coin.addComponent<Collectible>();
        coin.addComponent<SoundCues>().collect = {textId("assets/coin.wav")};
    }
    level.settle();
    level.hold(Key::Right);
    int sounds = 0;
    for (int i = 0; i < 120; ++i) level.tick(), sounds += level.count<PlaySound>();
    EXPECT_EQ(level.world.resource<GameProgress>().coins, 5);
    EXPECT_EQ(sounds, 5);
    EXPECT_EQ(level.world.count<Collectible>(), 0u);
}

TEST(Goal, asksForTheNextSceneOnceAfterItsDelay) {
    Level level{kFlat};
    level.addPlayer({40, kFloor});
    Entity goal = level.addBox({120, kFloor - 32}, {16, 32}, true);
    goal.addComponent<Goal>().next = {textId("scenes/two.scene.json")};
    goal.get<Goal>().endsGame = true;
    level.settle();
    level.hold(Key::Right);
    int asked = 0;
    for (int i = 0; i < 240; ++i) {
        level.tick();
        SceneRequests& requests = level.world.resource<SceneRequests>();
        if (requests.empty()) continue;
        ++asked;
        EXPECT_EQ(requests.next, textId("scenes/two.scene.json"));
        requests = {};
    }
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(level.world.resource<GameProgress>().levelFinished);
    EXPECT_TRUE(level.world.resource<GameProgress>().gameFinished);
}

TEST(SceneLink, followsConfirmAfterItsDelayAndStartsANewGame) {
    Level level{{}};
    Entity title = level.world.createEntity();
    SceneLink& link = title.addComponent<SceneLink>();
    link.scene = {textId("scenes/one.scene.json")};
    link.delay = 0.5f;
    link.newGame = true;
    level.world.resource<GameProgress>().coins = 7;
    level.hold(Key::Enter);
    level.tick();
    EXPECT_TRUE(level.world.resource<SceneRequests>().empty());
    level.hold(Key::Enter, false);
    level.run(40);
    level.hold(Key::Enter);
    level.tick();
    EXPECT_EQ(level.world.resource<SceneRequests>().next, textId("scenes/one.scene.json"));
    EXPECT_EQ(level.world.resource<GameProgress>().coins, 0);
}

TEST(SceneLink, reactsToAPress) {
    Level level{{}};
    Entity title = level.world.createEntity();
    title.addComponent<SceneLink>().scene = {textId("scenes/one.scene.json")};
    title.addComponent<SoundCues>().activate = {textId("assets/confirm.wav")};
    level.tick();
    EXPECT_EQ(level.count<PlaySound>(), 0);
    level.hold(Key::Enter);
    level.tick();
    ASSERT_EQ(level.count<PlaySound>(), 1);
    EXPECT_EQ(level.world.events<PlaySound>()[0].sound, (SoundId{textId("assets/confirm.wav")}));
}

TEST(Pause, opensItsSceneWhereThereIsAPlayer) {
    Level level{kFlat};
    level.world.addSystem<PauseSystem>();
    level.hold(Key::P);
    level.tick();
    EXPECT_TRUE(level.world.resource<SceneRequests>().empty()) << "the project has no pause scene";
    level.world.resource<PauseScene>().path = {textId("scenes/pause.scene.json")};
    level.hold(Key::P, false);
    level.tick();
    level.hold(Key::P);
    level.tick();
    EXPECT_TRUE(level.world.resource<SceneRequests>().empty()) << "the scene has no player";
    level.hold(Key::P, false);
    level.addPlayer({40, kFloor});
    level.tick();
    level.hold(Key::P);
    level.tick();
    EXPECT_EQ(level.world.resource<SceneRequests>().next, textId("scenes/pause.scene.json"));
    EXPECT_TRUE(level.world.resource<SceneRequests>().overlay);
}

TEST(Door, aCrateThatSleepsOnAButtonKeepsItPressed) {
    Level level{kFlat};
    Entity button = level.addBox({150, kFloor - 4}, {16, 4}, true);
    button.addComponent<Button>();
    Entity crate = level.addBox({150, kFloor - 20}, {16, 16});
    crate.addComponent<RigidBody>();
    level.run(240);
    EXPECT_TRUE(button.get<Button>().pressed);
    crate.destroy();
    level.run(20);
    EXPECT_FALSE(button.get<Button>().pressed);
}

TEST(Door, opensForAKeyAndWhileItsButtonIsPressed) {
    Level level{kFlat};
    level.addPlayer({40, kFloor});
    Entity key = level.addBox({60, kFloor - 10}, {8, 8}, true);
    key.addComponent<Collectible>().kind = CollectibleKind::Key;
    Entity locked = level.addBox({100, kFloor - 48}, {8, 48});
    locked.addComponent<Door>();
    Entity button = level.addBox({150, kFloor - 4}, {16, 4}, true);
    button.addComponent<Button>();
    Entity gate = level.addBox({300, kFloor - 48}, {8, 48});
    gate.addComponent<Door>().button = button;
    level.settle();
    level.hold(Key::Right);
    level.run(40);
    EXPECT_TRUE(locked.get<Door>().open);
    EXPECT_GT(level.at().x, 100.0f);
    EXPECT_EQ(level.world.resource<GameProgress>().keys, 0);
    bool opened = false;
    for (int i = 0; i < 60; ++i) level.tick(), opened = opened || gate.get<Door>().open;
    EXPECT_TRUE(opened);
    EXPECT_FALSE(gate.get<Door>().open) << "the player left the button";
    level.run(60);
    EXPECT_NEAR(level.at().x, 288.0f, 0.1f);
}

TEST(SoundCues, stepsAreHeardAtTheirFrames) {
    Level level{{}};
    level.world.addSystem<SoundCueSystem>();
    Entity walker = level.world.createEntity();
    walker.addComponent<SoundCues>().step = {textId("assets/step.wav")};
    level.world.beginTick();
    level.world.emit(AnimationFrameBegan{walker, textId("step")});
    level.world.emit(AnimationFrameBegan{walker, textId("blink")});
    level.world.update(Level::kTick);
    ASSERT_EQ(level.count<PlaySound>(), 1);
    EXPECT_EQ(level.world.events<PlaySound>()[0].sound.path, textId("assets/step.wav"));
}

TEST(Decor, bobsSpinsAndEnds) {
    Level level{{}};
    Entity coin = level.world.createEntity();
    coin.addComponent<Transform>(10.0f, 10.0f);
    Sprite& sprite = coin.addComponent<Sprite>();
    sprite.width = sprite.height = 16;
    coin.addComponent<Bob>();
    coin.addComponent<Spin>().rate = kPi;
    float lowest = 0.0f;
    float highest = 0.0f;
    for (int i = 0; i < 90; ++i) {
        level.tick();
        lowest = std::max(lowest, -coin.get<Sprite>().pivot.y * 16.0f);
        highest = std::min(highest, -coin.get<Sprite>().pivot.y * 16.0f);
    }
    EXPECT_NEAR(lowest, 2.0f, 0.01f);
    EXPECT_NEAR(highest, -2.0f, 0.01f);
    EXPECT_NEAR(std::abs(coin.get<Transform>().rotation), kPi / 2.0f, 1e-3f);
    EXPECT_EQ(coin.get<Transform>().position, (Vec2{10, 10}));
    coin.addComponent<Lifetime>().seconds = 0.5f;
    level.run(29);
    EXPECT_TRUE(coin.alive());
    level.run(2);
    EXPECT_FALSE(coin.alive());
}

TEST(GameProgress, labelsAreFilledFromIt) {
    World world;
    GameProgress& progress = world.resource<GameProgress>();
    progress.coins = 12;
    progress.deaths = 3;
    progress.ticks = 60 * 65;
    progress.level = world.texts().add("scenes/03_cave.scene.json");
    std::string out = "old";
    fillPlaceholders(world, "{coins}/{coinsTotal} x{deaths} {time} {levelName} {what} {", out);
    EXPECT_EQ(out, "12/0 x3 1:05 03_cave {what} {");
    fillPlaceholders(world, "", out);
    EXPECT_EQ(out, "");
}

TEST(KeyNames, areThoseThatThePlayerHasNow) {
    World world;
    std::string out;
    fillPlaceholders(world, "{key:Jump}", out);
    EXPECT_EQ(out, "{key:Jump}") << "without input";
    ActionMap map = ActionMap::defaults();
    map.bind("Jump", {*bindingFromText("Pad A"), *bindingFromText("K")});
    map.bind("Shoot", {*bindingFromText("Mouse Left")});
    map.bind("Wait", {});
    auto& input = world.resource<Input>();
    input.setMap(map);
    fillPlaceholders(world, "{key:Jump}, {key:Shoot}, {key:Wait}, {key:Horizontal}, {key:Fly}, {key:}", out);
    EXPECT_EQ(out, "K, Mouse Left, none, Left/Right, {key:Fly}, {key:}");
    map.bind("Jump", {*bindingFromText("J")});
    input.setMap(map);
    fillPlaceholders(world, "{key:Jump} jumps", out);
    EXPECT_EQ(out, "J jumps");
}

TEST(GameProgress, countsLevelsAndTheirCoinsOnce) {
    Level level{kFlat};
    level.addPlayer({40, kFloor});
    level.player.addComponent<SceneEntity>().scene = {textId("scenes/a.scene.json")};
    for (int i = 0; i < 3; ++i) level.addBox({300, 10}, {4, 4}, true).addComponent<Collectible>();
    level.run(10);
    const GameProgress& progress = level.world.resource<GameProgress>();
    EXPECT_EQ(progress.levelsReached.size(), 1u);
    EXPECT_EQ(progress.levelCoinsTotal, 3);
    level.player.get<SceneEntity>().scene = {textId("scenes/b.scene.json")};
    level.run(1);
    level.player.get<SceneEntity>().scene = {textId("scenes/a.scene.json")};
    level.run(1);
    EXPECT_EQ(progress.levelsReached.size(), 2u);
    EXPECT_EQ(progress.coinsTotal, 6);
    EXPECT_EQ(progress.ticks, 12u);
}

TEST(Parts, allComponentsAndFieldsHaveDescriptions) {
    TypeRegistry types;
    registerGameplayComponents(types);
    EXPECT_GE(types.all().size(), 19u);
    for (const TypeInfo& type : types.all()) {
        EXPECT_FALSE(type.doc.empty()) << type.name;
        for (const FieldInfo& field : type.fields) {
            const bool number = field.kind == FieldKind::Float || field.kind == FieldKind::Vec2;
            if (!number || field.transient) continue;
            EXPECT_NE(field.unit, Unit::None) << type.name << "." << field.name;
        }
    }
}

}  // namespace
}  // namespace plumb
