#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/game_loop.hpp"
#include "app/options/player_settings.hpp"
#include "app/recording/run_records.hpp"
#include "app/saved_game.hpp"
#include "app/screen.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "gameplay/components/controls/save_slot.hpp"
#include "gameplay/components/controls/scene_key.hpp"
#include "gameplay/game_functions.hpp"
#include "gameplay/game_requests.hpp"
#include "input/replay_link.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/transform.hpp"
#include "script/script_state.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

// Saved games in the loop of a game, with its recordings, and in scripts.

namespace plumb {
namespace {

// ---- the loop

class SavingGame : public Game {
public:
    int saveAt = 0, loadAt = 0, quitAt = 0;

private:
    void onUpdate(float) override {
        static_cast<void>(random().next());
        if (static_cast<int>(world.tick) == saveAt) saveGame(world, 2);
        if (static_cast<int>(world.tick) == loadAt) loadGame(world, 2);
        if (static_cast<int>(world.tick) == loadAt) loadAt = 0;
        if (static_cast<int>(world.tick) == quitAt) quitGame(world);
    }
};

class SavingLoop : public ::testing::Test {
protected:
    test::TemporaryFolder folder{test::memoryFolder()};
    std::vector<std::string> reported;

    SavingLoop() {
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) reported.push_back(line.text);
        });
    }
    ~SavingLoop() override { setLogSink(before_); }

    [[nodiscard]] PlayerOptions options() const {
        PlayerOptions options;
        options.headless = true;
        options.frames = 100;
        options.saves = (folder.path / "data").string();
        return options;
    }
    [[nodiscard]] bool isSaved() const { return fileExists(folder.path / "data" / "saves" / "2.save"); }

private:
    LogSink before_;
};

TEST_F(SavingLoop, savesAndLoadsBetweenTicks) {
    SavingGame game;
    game.saveAt = 30;
    game.loadAt = 80;
    EXPECT_EQ((GameLoop{game, nullptr, options(), "P"}.run()), 0);
    EXPECT_EQ(game.world.tick, 50u) << "20 ticks after tick 30";
    EXPECT_TRUE(hasSave(game.world, 2));
    EXPECT_FALSE(hasSave(game.world, 1));
    EXPECT_TRUE(reported.empty());
    SavingGame other;
    for (int i = 0; i < 50; ++i) tickGame(other, {});
    EXPECT_EQ(other.random().state, game.random().state);
}

TEST_F(SavingLoop, aGameThatSavedAndQuitInOneTickGoesOnWhenItIsLoaded) {
    SavingGame leaving;
    leaving.saveAt = leaving.quitAt = 30;
    EXPECT_EQ((GameLoop{leaving, nullptr, options(), "P"}.run()), 0);
    ASSERT_EQ(leaving.world.tick, 30u);
    SavingGame again;
    again.loadAt = 5;
    PlayerOptions options = this->options();
    options.frames = 50;
    EXPECT_EQ((GameLoop{again, nullptr, options, "P"}.run()), 0);
    EXPECT_EQ(again.world.tick, 75u) << "45 ticks after tick 30";
}

/// Saves in tick 20. From tick 40 on F9 is held, which loads the game.
class QuickLoadingGame : public Game {
public:
    int ticks = 0, loads = 0;

private:
    void onUpdate(float) override {
        ++ticks;
        if (ticks == 20) saveGame(world, 1);
        if (ticks == 40) {
            SDL_Event event{};
            event.type = SDL_KEYDOWN;
            event.key.keysym.scancode = SDL_SCANCODE_F9;
            event.key.keysym.sym = SDLK_F9;
            SDL_PushEvent(&event);
        }
        if (!input.isPressed(Key::F9)) return;
        ++loads;
        loadGame(world, 1);
    }
};

TEST_F(SavingLoop, aKeyThatIsHeldLoadsOnce) {
    const Result<std::unique_ptr<Screen>> screen = Screen::open({"test", 320, 180, false, {320.0f, 180.0f}});
    ASSERT_TRUE(screen) << screen.error().text();
    QuickLoadingGame game;
    PlayerOptions options = this->options();
    options.headless = false;
    EXPECT_EQ((GameLoop{game, screen->get(), options, "P"}.run()), 0);
    EXPECT_EQ(game.ticks, 100);
    EXPECT_EQ(game.loads, 1);
    EXPECT_LT(game.world.tick, 90u);
}

TEST_F(SavingLoop, goesOnIfLoadingFails) {
    SavingGame game;
    game.loadAt = 80;
    EXPECT_EQ((GameLoop{game, nullptr, options(), "P"}.run()), 0);
    EXPECT_EQ(game.world.tick, 100u);
    EXPECT_EQ(reported.size(), 1u);
    saveGame(game.world, 0);
    loadGame(game.world, 33);
    EXPECT_EQ(reported.size(), 3u) << "there are no such slots";
}

TEST_F(SavingLoop, aRecordingEndsWhenAGameIsLoadedAndItsReplayUsesNoFiles) {
    PlayerOptions options = this->options();
    options.record = (folder.path / "run.replay").string();
    {
        SavingGame game;
        game.saveAt = 30;
        game.loadAt = 80;
        EXPECT_EQ((GameLoop{game, nullptr, options, "P"}.run()), 0);
        ASSERT_EQ(reported.size(), 1u);
        EXPECT_NE(reported[0].find("the recording ends with tick 80"), std::string::npos) << reported[0];
    }
    std::filesystem::remove_all(folder.path / "data");
    options.replay = std::exchange(options.record, {});
    options.frames = -1;
    SavingGame game;
    game.saveAt = 30;
    game.loadAt = 80;
    EXPECT_EQ((GameLoop{game, nullptr, options, "P"}.run()), 0) << "the hashes are those of the recording";
    EXPECT_EQ(game.world.tick, 80u);
    EXPECT_TRUE(hasSave(game.world, 2)) << "as in the recording";
    EXPECT_FALSE(isSaved());
}

TEST_F(SavingLoop, aRecordingThatIsFullEndsWithOneWarning) {
    PlayerOptions options = this->options();
    options.record = (folder.path / "run.replay").string();
    RunRecords records;
    ASSERT_TRUE(records.begin(options, {}, {}));
    const World world;
    InputFrame frame;
    for (std::size_t i = 0; i < Replay::kMaxRuns + 1000; ++i) {
        frame.set(Key::A, i % 2 == 0);
        records.tickBegins(frame);
        records.tickEnds(world);
    }
    records.end(world);
    EXPECT_FALSE(records.failed());
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_NE(reported[0].find(format("the recording ends with tick {}", Replay::kMaxRuns)),
              std::string::npos)
        << reported[0];
    EXPECT_EQ(loadReplay(options.record)->ticks(), Replay::kMaxRuns);
}

TEST_F(SavingLoop, aReplayThatBeginsWithASavedGameIsNotRecordedWithoutIt) {
    Replay start;
    start.state = "saved";
    PlayerOptions recorded = options();
    recorded.record = (folder.path / "run.replay").string();
    EXPECT_FALSE(RunRecords{}.begin(recorded, start, {}));
    EXPECT_FALSE(fileExists(recorded.record));
    PlayerOptions linked = options();
    linked.printLink = true;
    RunRecords records;
    ASSERT_TRUE(records.begin(linked, start, {}));
    const Result<std::string> link = records.link(std::nullopt);
    ASSERT_FALSE(link);
    EXPECT_NE(link.error().what.find("begins with a saved game"), std::string::npos);
}

TEST(SaveSlot, isThatOfAnActionThatSavesOrLoads) {
    Game game;
    game.content.addSystems(game.world);
    const auto requestsOf = [&](MenuAction does, int slot) {
        const Entity entity = game.world.createEntity();
        SceneKey& key = entity.addComponent<SceneKey>();
        key.action = game.world.texts().add("Jump");
        key.does = does;
        if (slot > 0) entity.addComponent<SaveSlot>().slot = slot;
        InputFrame frame;
        frame.set(Key::Space, true);
        tickGame(game, frame);
        const GameRequests requests = game.world.resource<GameRequests>();
        game.world.destroy(entity.id());
        tickGame(game, {});
        return requests;
    };
    EXPECT_EQ(requestsOf(MenuAction::Save, 3).save, 3);
    EXPECT_EQ(requestsOf(MenuAction::Save, 0).save, 1);
    EXPECT_EQ(requestsOf(MenuAction::Load, 0).load, 1);
    EXPECT_TRUE(requestsOf(MenuAction::Options, 0).options);
    EXPECT_EQ(game.world.resource<GameRequests>().save, 0) << "each tick begins without requests";
}

TEST_F(SavingLoop, headlessRunsDoNotUseTheFilesOfThePlayer) {
    PlayerOptions options = this->options();
    options.saves.clear();
    SavingGame game;
    game.saveAt = 30;
    EXPECT_EQ((GameLoop{game, nullptr, options, "plumb-saved-game-test"}.run()), 0);
    EXPECT_FALSE(hasSave(game.world, 2));
}

TEST_F(SavingLoop, aReplayHasTheKeysOfItsPlayer) {
    Replay replay;
    replay.keys = R"({"actions":{"Jump":["K"]},"axes":{}})";
    InputFrame frame;
    frame.set(Key::K, true);
    replay.runs = {{frame, 3}};
    PlayerOptions options = this->options();
    options.replay = (folder.path / "run.replay").string();
    ASSERT_TRUE(writeFile(options.replay, writeReplay(replay)));
    EXPECT_EQ(loadReplay(options.replay)->keys, replay.keys);
    Game game;
    EXPECT_EQ((GameLoop{game, nullptr, options, "P"}.run()), 0);
    EXPECT_TRUE(game.input.isHeld(Action::Jump));
}

TEST_F(SavingLoop, aLinkHasTheKeysOfItsPlayerAndTheSlotsThatTheGameSaw) {
    PlayerOptions options = this->options();
    options.frames = 60;
    Replay replay;
    replay.project = "P";
    replay.keys = R"({"actions":{"Jump":["K"]},"axes":{}})";
    InputFrame frame;
    frame.set(Key::K, true);
    frame.saves = 2;
    replay.runs = {{frame, 3}};
    options.saves.clear();
    options.link = *linkOf(replay);
    Game game;
    EXPECT_EQ((GameLoop{game, nullptr, options, "P"}.run()), 0);
    EXPECT_TRUE(game.input.isHeld(Action::Jump));
    EXPECT_TRUE(hasSave(game.world, 2));
    EXPECT_FALSE(hasSave(game.world, 1));
}

TEST_F(SavingLoop, aRunHasNoLinkAfterAGameWasLoaded) {
    PlayerOptions options = this->options();
    options.printLink = true;
    SavingGame game;
    game.saveAt = 30;
    game.loadAt = 80;
    EXPECT_EQ((GameLoop{game, nullptr, options, "P"}.run()), 1);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_NE(reported[0].find("a saved game was loaded after tick 80"), std::string::npos) << reported[0];
}

// ---- scripts

class SavedScripts : public ::testing::Test {
protected:
    std::vector<Error> problems;

    /// A game with an entity that has the component Box of this script.
    std::unique_ptr<Game> play(const GameContent& content, int ticks) {
        auto game = std::make_unique<Game>(content);
        content.addSystems(game->world);
        const Entity entity = game->world.createEntity();
        entity.addComponent<Transform>();
        game->world.add(*game->types.find("Box"), entity.id());
        for (int i = 0; i < ticks; ++i) tickGame(*game, {});
        return game;
    }

    /// Another game, into which this one was loaded.
    std::unique_ptr<Game> loaded(Game& game, const GameContent& content) {
        const Result<std::string> saved = savedGame(game.world, "P");
        EXPECT_TRUE(saved);
        auto other = play(content, 3);
        const Result<Snapshot> snapshot = readSavedGame(*saved, other->world, "P", "test", problems);
        EXPECT_TRUE(snapshot);
        EXPECT_TRUE(other->load(*snapshot));
        return other;
    }

    /// The value of an integer of the component Box.
    static int valueOf(Game& game, const char* field) {
        const TypeInfo& type = *game.types.find("Box");
        const FieldInfo& info = *type.find(field);
        int value = 0;
        game.world.eachOf(type,
                          [&](EntityId, const void* at) { std::memcpy(&value, info.in(at), sizeof value); });
        return value;
    }
};

constexpr const char* kBox = R"(
local Box = script { total = integer { 0 } }
local shared = { calls = 0 }
count = 0
function Box:onCreate()
    self.made = true
    self.list = { 1, 2.5, "three", vec(4, 5), { deep = true } }
    self.me = self
    self.again = self.list
    self.list.loop = self.list
    self.place = self.transform
end
function Box:onTick()
    shared.calls = shared.calls + 1
    count = count + 1
    self.list[1] = self.list[1] + 1
    self.place.x = self.list[1]
    assert(self.made and self.me == self and self.again == self.list and self.list.loop == self.list)
    assert(self.list[3] == "three" and self.list[4] == vec(4, 5) and self.list[5].deep)
    self.total = shared.calls * 1000 + count
end
function Box:onLoad()
    self.transform.y = 7
end
return Box
)";

TEST_F(SavedScripts, goOnWithTheirValues) {
    GameContent content{Module{}, problems};
    static_cast<void>(content.useScripts({{"box", kBox}}, problems));
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const auto game = play(content, 40);
    const auto other = loaded(*game, content);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(other->world.hash(), game->world.hash());
    for (int i = 0; i < 10; ++i) {
        tickGame(*game, {});
        tickGame(*other, {});
    }
    Transform& loaded = other->world.first<Transform>().get<Transform>();
    EXPECT_EQ(loaded.position, (Vec2{51.0f, 7.0f})) << "onLoad was called, and onCreate was not";
    loaded.position.y = 0.0f;
    game->world.first<Transform>().get<Transform>().position.y = 0.0f;
    EXPECT_EQ(valueOf(*other, "total"), 50050);
    EXPECT_EQ(valueOf(*game, "total"), 50050);
}

TEST_F(SavedScripts, thatAreDamagedLeaveTheGameAsItWas) {
    GameContent content{Module{}, problems};
    static_cast<void>(content.useScripts({{"box", kBox}}, problems));
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const auto source = play(content, 0);
    source->world.resource<ScriptState>().saved = "damaged";
    const Result<std::string> saved = savedGame(source->world, "P");
    ASSERT_TRUE(saved);
    const auto game = play(content, 40);
    const Result<Snapshot> snapshot = readSavedGame(*saved, game->world, "P", "test", problems);
    ASSERT_TRUE(snapshot);
    const std::uint64_t hash = game->world.hash();
    const Result<Done> loaded = game->load(*snapshot);
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().what.find("damaged"), std::string::npos);
    EXPECT_EQ(game->world.hash(), hash);
    for (int i = 0; i < 10; ++i) tickGame(*game, {});
    EXPECT_EQ(valueOf(*game, "total"), 50050);
}

// ---- the guide

/// The text of the first block of this language in docs/shipping.md; empty if there is none.
std::string blockOf(const std::string& language) {
    const Result<std::string> text = readFile(test::sourceFolder() / "docs" / "shipping.md");
    const std::string begin = "```" + language + "\n";
    const std::size_t from = text ? text->find(begin) : std::string::npos;
    if (from == std::string::npos) return {};
    const std::size_t start = from + begin.size();
    return text->substr(start, text->find("```", start) - start);
}

TEST(ShippingGuide, itsScriptLoadsASavedGame) {
    std::vector<Error> problems;
    GameContent content{Module{}, problems};
    static_cast<void>(content.useScripts({{"continue", blockOf("lua")}}, problems));
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    Game game{content};
    content.addSystems(game.world);
    const Entity entity = game.world.createEntity();
    const Label& label = entity.addComponent<Label>();
    game.world.add(*game.types.find("Continue"), entity.id());
    tickGame(game, {});
    EXPECT_EQ(label.color.a, 0x40);
    InputFrame frame;
    frame.saves = 1;
    tickGame(game, frame);
    EXPECT_EQ(label.color.a, 0xff);
    EXPECT_EQ(game.world.resource<GameRequests>().load, 0);
    frame.set(Key::E, true);
    tickGame(game, frame);
    EXPECT_EQ(game.world.resource<GameRequests>().load, 1);
}

TEST(ShippingGuide, itsSettingsAreValid) {
    PlayerSettings project;
    project.keys = ActionMap::defaults();
    std::vector<Error> warnings;
    const PlayerSettings settings = settingsFromText(blockOf("json"), project, "settings.json", warnings);
    EXPECT_TRUE(warnings.empty()) << warnings[0].text();
    EXPECT_EQ(settings.music, 0.5f);
    EXPECT_NE(settings.keys, project.keys);
    EXPECT_EQ(settingsText(settings, project), blockOf("json"));
}

}  // namespace
}  // namespace plumb
