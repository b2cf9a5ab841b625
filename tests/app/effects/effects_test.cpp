#include "scene/effects.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "app/sound_output.hpp"
#include "core/text.hpp"
#include "gameplay/components.hpp"
#include "gameplay/delayed_events.hpp"
#include "gameplay/tweens.hpp"
#include "physics/simulation.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/particles.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/play_sound.hpp"
#include "tests/app/effects/effect_games.hpp"

// For each effect of a game: a game that does not require it does not run it; running it without need changes
// no bit; and a component that requires an effect which the scene pins off is reported.

namespace plumb {
namespace {

using namespace test;

const EffectRow& rowOf(std::size_t row) { return engineEffects().rows()[row]; }
std::size_t numberOf(std::string_view name) { return engineEffects().find(name); }

class EveryGameEffect : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryGameEffect, isNotRunInASceneWithoutIt) {
    PileGame game;
    game.play(30);
    EXPECT_FALSE(game.effects.isRequired(game.world, GetParam()));
    EXPECT_FALSE(game.effects.runs(game.world, GetParam()));
    EXPECT_EQ(game.effects.runsOf(game.world, GetParam()), 0u);
}

TEST_P(EveryGameEffect, isRunOnlyWhileSomethingRequiresIt) {
    if (rowOf(GetParam()).name == "tile_animation") return;  // required by a tileset; see EffectDevices
    // Timers and tweens are required by their own state, scripts by the components of a project:
    // ScriptContent.
    const std::set<std::string_view> others{"timers", "tweens", "scripts"};
    ASSERT_EQ(rowOf(GetParam()).requesters.empty(), others.count(rowOf(GetParam()).name) != 0);
    for (const EffectRequester& requester : rowOf(GetParam()).requesters) {
        PileGame game;
        game.play(2);
        const EntityId entity = game.world.createEntity().id();
        game.world.add<Transform>(entity);
        ASSERT_NE(game.world.add(requester.type(), entity), nullptr);
        EXPECT_EQ(requester.requesters(game.world), 1u) << requester.type().name;
        EXPECT_TRUE(game.effects.runs(game.world, GetParam())) << requester.type().name;
        if (!hasSystem(GetParam())) continue;
        game.play(3);
        EXPECT_GE(game.effects.runsOf(game.world, GetParam()), 3u) << requester.type().name;
        if (game.world.alive(entity)) game.world.destroy(entity);
        game.play(2);  // systems may do their final work in the first of these ticks
        const std::uint64_t runs = game.effects.runsOf(game.world, GetParam());
        game.play(3);
        EXPECT_EQ(game.effects.runsOf(game.world, GetParam()), runs) << requester.type().name;
    }
}

TEST_P(EveryGameEffect, isNeverRunIfPinnedOff) {
    if (!hasSystem(GetParam()) || rowOf(GetParam()).requesters.empty()) return;
    PileGame game;
    game.effects.setProgramPin(rowOf(GetParam()).name, Pin::Off);
    const EntityId entity = game.world.createEntity().id();
    game.world.add<Transform>(entity);
    game.world.add(rowOf(GetParam()).requesters.front().type(), entity);
    game.play(5);
    EXPECT_EQ(game.effects.runsOf(game.world, GetParam()), 0u);
    EXPECT_FALSE(game.effects.runs(game.world, GetParam()));
}

TEST_P(EveryGameEffect, changesNoBitIfPinnedOnWithoutNeed) {
    PileGame off, on;
    on.effects.setProgramPin(rowOf(GetParam()).name, Pin::On);
    for (int i = 0; i < 120; ++i) {
        off.play(1);
        on.play(1);
        ASSERT_EQ(off.world.hash(), on.world.hash()) << "after tick " << i;
    }
    EXPECT_EQ(off.effects.runsOf(off.world, GetParam()), 0u);
    if (hasSystem(GetParam())) {
        EXPECT_GE(on.effects.runsOf(on.world, GetParam()), 120u);
    }
}

/// Why --all-effects is refused with --replay.
TEST(GameEffects, allOfThemPinnedOnChangeTheHashButNotWhatMoves) {
    PileGame off, on;
    for (const EffectRow& row : on.effects.table().rows()) on.effects.setProgramPin(row.name, Pin::On);
    for (int i = 0; i < 120; ++i) {
        off.play(1);
        on.play(1);
        for (auto [entity, place] : std::as_const(off.world).query<const Transform>()) {
            const Transform& other = std::as_const(on.world).get<Transform>(entity.id());
            ASSERT_EQ(place.position, other.position) << "after tick " << i;
            ASSERT_EQ(place.rotation, other.rotation) << "after tick " << i;
        }
        ASSERT_NE(off.world.hash(), on.world.hash()) << "the pins are part of the physics' state";
    }
}

TEST(GameEffects, timersAndTweensRunWhileThereAreAny) {
    for (const Pin pin : {Pin::Auto, Pin::Off}) {
        PileGame game;
        game.effects.setProgramPin("timers", pin);
        game.effects.setProgramPin("tweens", pin);
        game.play(2);
        const EntityId entity = game.world.createEntity().id();
        game.world.add<Transform>(entity);
        emitAfter(game.world, 0.1f, TweenEnded{entity});
        tween(game.world, entity, &Transform::rotation, 1.0f, 0.1f);
        EXPECT_EQ(game.effects.runs(game.world, "timers"), pin == Pin::Auto);
        EXPECT_EQ(game.effects.runs(game.world, "tweens"), pin == Pin::Auto);
        game.play(60);
        const std::uint64_t expected = pin == Pin::Auto ? 6 : 0;
        EXPECT_EQ(game.effects.runsOf(game.world, "timers"), expected);
        EXPECT_EQ(game.effects.runsOf(game.world, "tweens"), expected);
        EXPECT_EQ(game.world.get<Transform>(entity).rotation, pin == Pin::Auto ? 1.0f : 0.0f);
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryGameEffect, testing::ValuesIn(gameEffects()),
                         [](const auto& tested) { return std::string{rowOf(tested.param).name}; });

/// Returns a JSON field with which a component requires an effect that its default values do not require.
std::string fieldsFor(std::string_view effect, std::string_view component) {
    if (effect == "restitution") return R"("bounciness": 0.5)";
    if (effect == "drag") return R"("linearDrag": 1)";
    if (effect == "motors") return R"("motor": true)";
    if (effect == "triggers") return R"("isTrigger": true)";
    if (effect == "one_way") return R"("oneWay": true)";
    if (effect == "conveyor") return R"("surfaceSpeed": 20)";
    if (effect == "locks") return R"("lockX": true)";
    static_cast<void>(component);
    return {};
}

std::string sceneWith(std::string_view effects, std::string_view component, std::string_view fields) {
    return format(R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "0000000000000007", "name": "torch", "components": {"{}": {}}}]})",
                  effects, component, format("{}{}{}", "{", fields, "}"));
}

class EveryEffectRow : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryEffectRow, reportsComponentsThatRequireItIfPinnedOff) {
    const EffectRow& row = rowOf(GetParam());
    for (const EffectRequester& requester : row.requesters) {
        for (const char* pin : {"off", "on", "auto"}) {
            Game game;
            const std::string text =
                sceneWith(format(R"({"{}": "{}"})", row.name, pin), requester.type().name,
                          fieldsFor(row.name, requester.type().name));
            const Result<LoadReport> report =
                loadScene(game.world, {game.types}, "scenes/a.scene.json", text);
            ASSERT_TRUE(report.ok()) << text;
            const auto reported =
                std::find_if(report->problems.begin(), report->problems.end(), [&](const Error& problem) {
                    return problem.where == format("scenes/a.scene.json: effects.{}", row.name);
                });
            const bool wrong = std::string_view{pin} == "off" && !row.byDefault;
            ASSERT_EQ(reported != report->problems.end(), wrong) << text;
            if (!wrong) continue;
            EXPECT_NE(reported->what.find("torch @0000000000000007"), std::string::npos) << reported->text();
            EXPECT_NE(reported->what.find(requester.type().name), std::string::npos) << reported->text();
            EXPECT_FALSE(reported->remedy.empty());
            EXPECT_EQ(report->loaded, 1u);
            game.effects.followScenes(game.world);
            EXPECT_FALSE(game.effects.runs(game.world, GetParam()));
        }
    }
}

std::vector<std::size_t> allRows() {
    std::vector<std::size_t> rows(engineEffects().rows().size());
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
    return rows;
}

INSTANTIATE_TEST_SUITE_P(All, EveryEffectRow, testing::ValuesIn(allRows()),
                         [](const auto& tested) { return std::string{rowOf(tested.param).name}; });

TEST(Effects, theTableHasEveryEffectOfThePhysicsOnceAndEveryNameOnce) {
    std::set<std::string_view> names;
    std::set<physics::Effect> ofPhysics;
    for (const EffectRow& row : engineEffects().rows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.doc.empty()) << row.name;
        if (row.physics != physics::Effect::Count) {
            EXPECT_TRUE(ofPhysics.insert(row.physics).second) << row.name;
        }
        EXPECT_EQ(row.isRequired == nullptr, row.physics != physics::Effect::Count) << row.name;
    }
    EXPECT_EQ(ofPhysics.size(), physics::kEffects);
}

TEST(Effects, componentsOfEarlierSystemsActInTheSameTick) {
    PileGame game;
    Entity ghost = game.world.createEntity();
    ghost.addComponent<Transform>();
    ghost.addComponent<Detonator>().after = 1.0f / 60.0f;
    ASSERT_EQ(game.world.count<Explosion>(), 0u);
    game.play(1);
    const auto& state = game.world.resource<PhysicsState>();
    EXPECT_EQ(physics::runsOf(game.world.resource<PhysicsState>().world, physics::Effect::Explosion), 1u);
    EXPECT_EQ(state.world.steps, 1u);
}

TEST(Effects, theLastParticlesAreRemovedWithTheLastEmitter) {
    PileGame game;
    Entity torch = game.world.createEntity();
    torch.addComponent<Transform>();
    torch.addComponent<ParticleEmitter>();
    game.play(20);
    ASSERT_FALSE(game.world.resource<Particles>().streams.empty());
    torch.destroy();
    game.play(1);
    EXPECT_TRUE(game.world.resource<Particles>().streams.empty());
    const std::uint64_t runs = game.effects.runsOf(game.world, "particles");
    game.play(3);
    EXPECT_EQ(game.effects.runsOf(game.world, "particles"), runs);
}

TEST(Effects, customSystemsAlwaysRun) {
    struct OwnSystem {
        int runs = 0;
        void update(World&, float) { ++runs; }
    };
    PileGame game;
    auto& own = game.world.addSystem<OwnSystem>();
    game.play(3);
    EXPECT_EQ(own.runs, 3);
}

// ---- Pins in scene files

LoadedScene sceneThatSays(World& world, std::string_view path, const Json& effects) {
    LoadedScene scene;
    scene.path = path;
    scene.id = {world.texts().add(path)};
    scene.effects = effects;
    scene.rest = std::make_shared<const SceneRest>();
    return scene;
}

TEST(Effects, theTopmostSceneWithAPinDecides) {
    Game game;
    auto& scenes = game.world.resource<LoadedScenes>().scenes;
    scenes.push_back(
        sceneThatSays(game.world, "below", {{"wind", "on"}, {"sound", "off"}, {"particles", "off"}}));
    scenes.push_back(sceneThatSays(game.world, "above", {{"sound", "on"}, {"particles", "auto"}}));
    game.effects.followScenes(game.world);
    EXPECT_EQ(game.effects.pinOf(numberOf("wind")), Pin::On);
    EXPECT_EQ(game.effects.pinnedBy(numberOf("wind")), "below");
    EXPECT_EQ(game.effects.pinOf(numberOf("sound")), Pin::On);
    EXPECT_EQ(game.effects.pinnedBy(numberOf("sound")), "above");
    EXPECT_EQ(game.effects.pinOf(numberOf("particles")), Pin::Auto);
    scenes.pop_back();
    game.effects.followScenes(game.world);
    EXPECT_EQ(game.effects.pinOf(numberOf("sound")), Pin::Off);
    EXPECT_EQ(game.effects.pinOf(numberOf("particles")), Pin::Off);
    scenes.clear();
    game.effects.followScenes(game.world);
    EXPECT_EQ(game.effects.pinOf(numberOf("sound")), Pin::Auto);
    EXPECT_EQ(game.effects.pinnedBy(numberOf("sound")), "");
}

TEST(Effects, aSceneCanPinEffectsOfThePhysics) {
    PileGame floats, falls;
    floats.world.resource<LoadedScenes>().scenes.push_back(
        sceneThatSays(floats.world, "space", {{"gravity", "off"}, {"wind", "on"}}));
    floats.play(30);
    falls.play(30);
    const auto& still = floats.world.resource<PhysicsState>().world.manifest;
    EXPECT_EQ(still.pinnedOff, physics::Manifest::bit(physics::Effect::Gravity));
    EXPECT_EQ(still.pinnedOn, physics::Manifest::bit(physics::Effect::Wind));
    EXPECT_EQ(floats.effects.runsOf(floats.world, "gravity"), 0u);
    EXPECT_EQ(floats.effects.runsOf(floats.world, "wind"), 30u);
    EXPECT_EQ(falls.effects.runsOf(falls.world, "gravity"), 30u);
}

TEST(Effects, aSceneWithPinsIsSavedByteForByteAndUnknownOnesAreReported) {
    const std::string text = R"({
  "format": 1,
  "effects": {
    "particles": "off",
    "partikles": "on",
    "wind": 3,
    "sound": "auto"
  },
  "layers": [],
  "entities": []
}
)";
    Game game;
    const Result<LoadReport> report = loadScene(game.world, {game.types}, "scenes/a.scene.json", text);
    ASSERT_TRUE(report.ok());
    ASSERT_EQ(report->problems.size(), 2u);
    EXPECT_EQ(report->problems[0].where, "scenes/a.scene.json: effects.partikles");
    EXPECT_NE(report->problems[0].remedy.find("did you mean \"particles\"?"), std::string::npos);
    EXPECT_NE(report->problems[0].remedy.find("tile_animation"), std::string::npos) << "lists all effects";
    EXPECT_EQ(report->problems[1].where, "scenes/a.scene.json: effects.wind");
    EXPECT_NE(report->problems[1].what.find("found 3"), std::string::npos);
    EXPECT_EQ(sceneToJson(game.world, {game.types}, report->scene), text);
}

TEST(Effects, anOverlayThatRequiresAnEffectPinnedOffBelowIsReported) {
    Game game;
    auto& scenes = game.world.resource<LoadedScenes>().scenes;
    scenes.push_back(sceneThatSays(game.world, "below", {{"particles", "off"}}));
    scenes.push_back(sceneThatSays(game.world, "above", Json::object()));
    Entity torch = game.world.createEntity();
    torch.addComponent<ParticleEmitter>();
    torch.addComponent<SceneEntity>(SceneEntity{7, 0, scenes.back().id});
    std::vector<Error> problems;
    std::vector<Pin> pins(engineEffects().rows().size(), Pin::Auto);
    pins[numberOf("particles")] = Pin::Off;
    engineEffects().checkNeeds(game.world, scenes.back().id, "above", pins, problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].where, "above: effects.particles");
    problems.clear();
    engineEffects().checkNeeds(game.world, scenes.front().id, "below", pins, problems);
    EXPECT_TRUE(problems.empty());
}

// ---- Devices

class Sounds {
public:
    explicit Sounds(Game& game)
        : output{game.assets, [this]() -> Result<std::unique_ptr<AudioDevice>> {
                     ++opened;
                     return Error{"audio", "none here", ""};
                 }} {}
    int opened = 0;
    SoundOutput output;
};

TEST(Effects, theAudioDeviceStaysClosedUntilTheFirstSound) {
    PileGame game;
    Sounds sounds{game};
    for (int i = 0; i < 10; ++i) {
        game.play(1);
        sounds.output.listen(game.world);
        sounds.output.play();
    }
    EXPECT_EQ(sounds.opened, 0);
    game.world.emit(PlaySound{.sound = {textId("boom.wav")}, .tick = game.world.tick});
    sounds.output.listen(game.world);
    sounds.output.play();
    EXPECT_EQ(sounds.opened, 1);
}

TEST(Effects, theAudioDeviceIsOpenedAtOnceWhenPinnedOnAndNeverWhenPinnedOff) {
    for (const Pin pin : {Pin::On, Pin::Off}) {
        PileGame game;
        game.effects.setProgramPin("sound", pin);
        Sounds sounds{game};
        game.play(1);
        sounds.output.listen(game.world);
        EXPECT_EQ(sounds.opened, pin == Pin::On ? 1 : 0);
        game.world.createEntity().addComponent<Music>().sound = {textId("tune.ogg")};
        game.world.emit(PlaySound{.sound = {textId("boom.wav")}, .tick = game.world.tick});
        sounds.output.listen(game.world);
        sounds.output.play();
        EXPECT_EQ(sounds.opened, pin == Pin::On ? 1 : 0);
    }
}

}  // namespace
}  // namespace plumb
