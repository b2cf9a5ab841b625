#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "editor/model/project/project_session.hpp"
#include "editor/model/view/log_book.hpp"
#include "editor/templates/project_templates.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/components/triggers/goal.hpp"
#include "gameplay/components/triggers/kill_plane.hpp"
#include "gameplay/label_values.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/name.hpp"
#include "scene/components/transform.hpp"
#include "tests/support/temporary_folder.hpp"

// What is made of every template; of the two small games also how they play.

namespace plumb::editor {
namespace {

/// A project made from a template.
class TemplateGame : public ::testing::Test {
protected:
    void make(std::string_view id) {
        const Result<Path> made = createProject(*findTemplate(id), "Game", folder);
        ASSERT_TRUE(made.ok()) << made.error().text();
        session = std::move(*ProjectSession::open(folder.string()));
        session->openFirst({});
    }
    [[nodiscard]] Workspace& workspace() { return session->workspace(); }
    [[nodiscard]] World& game() { return workspace().play.world(); }

    void play(int ticks, std::initializer_list<Key> keys) {
        InputFrame input;
        input.setMouse({640.0f, 200.0f});
        for (const Key key : keys) input.set(key, true);
        for (int i = 0; i < ticks; ++i) workspace().play.step(input);
    }
    [[nodiscard]] EntityId named(std::string_view name) {
        const World& world = game();
        for (auto [entity, given] : world.query<const Name>()) {
            if (world.texts().find(given.text) == name) return entity.id();
        }
        ADD_FAILURE() << "there is no " << name;
        return {};
    }
    [[nodiscard]] Vec2 positionOf(std::string_view name) {
        return game().get<Transform>(named(name)).position;
    }
    [[nodiscard]] std::string shown(std::string_view word) {
        const auto* texts = game().findResource<LabelValues>();
        const std::string* text = texts == nullptr ? nullptr : texts->find(word);
        return text == nullptr ? "" : *text;
    }

private:
    test::TemporaryFolder home_;

protected:
    const Path folder = home_.path / "game";
    std::unique_ptr<ProjectSession> session;
};

class EachTemplate : public TemplateGame, public ::testing::WithParamInterface<std::string> {
protected:
    EachTemplate() { make(GetParam()); }
};

/// Keys of ten seconds: all directions, alone and together, and what the templates answer to.
InputFrame recorded(int tick) {
    InputFrame input;
    input.set(Key::Right, tick / 70 % 2 == 0);
    input.set(Key::Left, tick / 70 % 4 == 1);
    input.set(Key::Down, tick / 45 % 3 == 1);
    input.set(Key::Up, tick / 45 % 3 == 2);
    input.set(Key::Space, tick % 47 < 9);
    input.set(Key::Enter, tick % 200 == 100);
    input.set(Key::B, tick % 250 == 240);
    input.set(Key::R, tick == 400);
    input.setMouse({static_cast<float>(tick * 2), 150.0f});
    return input;
}

TEST_P(EachTemplate, makesFilesAsTheEditorWritesThem) {
    std::size_t files = 0;
    for (const char* part : {"scenes", "prefabs"}) {
        for (const std::string& name : filesBelow(folder / part, ".json")) {
            const std::string path = std::string{part} + "/" + name;
            ASSERT_TRUE(workspace().open(path).ok()) << path;
            EXPECT_EQ(workspace().text(), *readFile(folder / path)) << path;
            ++files;
        }
    }
    EXPECT_GE(files, 1u);
}

// The template "cpp" has to be built first: the tests code.project and code.player do that.
TEST_P(EachTemplate, playsTenSecondsWithoutAWarningAndTheSameTwice) {
    if (GetParam() == "cpp") return;
    EXPECT_EQ(session->validate(), 0);
    std::vector<std::uint64_t> hashes;
    const LogBook log;
    for (int run = 0; run < 2; ++run) {
        workspace().startPlaying(true);
        ASSERT_TRUE(workspace().play.running());
        for (int tick = 0; tick < 600; ++tick) workspace().play.step(recorded(tick));
        hashes.push_back(game().hash());
        workspace().stopPlaying();
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    for (const LogEntry& line : log.lines()) EXPECT_LT(line.level, LogLevel::Warning) << line.text;
}

std::vector<std::string> allTemplates() {
    std::vector<std::string> ids;
    for (const ProjectTemplate& row : projectTemplates()) ids.emplace_back(row.id);
    return ids;
}
INSTANTIATE_TEST_SUITE_P(All, EachTemplate, ::testing::ValuesIn(allTemplates()),
                         [](const auto& row) { return row.param; });

class TopDownTemplate : public TemplateGame {
protected:
    TopDownTemplate() {
        make("topdown");
        workspace().startPlaying(true);
        play(1, {});
    }
    /// Walks to a point, first along x. @return false if it does not get there
    bool walkTo(Vec2 goal) {
        for (const bool vertical : {false, true}) {
            const auto rest = [&] {
                const Vec2 way = goal - positionOf("hero");
                return vertical ? way.y : way.x;
            };
            for (int tick = 0; std::abs(rest()) > 1.0f; ++tick) {
                if (tick > 600) return false;
                const bool positive = rest() > 0.0f;
                play(1, {vertical ? (positive ? Key::Down : Key::Up) : (positive ? Key::Right : Key::Left)});
            }
        }
        return true;
    }
    const Vec2 home{120.0f, 272.0f};
};

TEST_F(TopDownTemplate, theHeroIsEquallyFastInEightDirections) {
    constexpr std::array kAxes{-1, 0, 1};
    for (const int x : kAxes) {
        for (const int y : kAxes) {
            const Vec2 from = positionOf("hero");
            InputFrame input;
            if (x != 0) input.set(x < 0 ? Key::Left : Key::Right, true);
            if (y != 0) input.set(y < 0 ? Key::Up : Key::Down, true);
            for (int tick = 0; tick < 10; ++tick) workspace().play.step(input);
            const Vec2 way = positionOf("hero") - from;
            const float speed = x == 0 && y == 0 ? 0.0f : 84.0f;  // px/s
            EXPECT_NEAR(length(way), speed * 10.0f / 60.0f, 0.05f) << x << " " << y;
            const Vec2 wanted = normalized(Vec2{static_cast<float>(x), static_cast<float>(y)}) * length(way);
            EXPECT_LT(length(way - wanted), 0.05f) << x << " " << y;
        }
    }
}

TEST_F(TopDownTemplate, wallsStopTheHero) {
    play(120, {Key::Left});
    EXPECT_NEAR(positionOf("hero").x, 48.0f + 5.0f, 1.0f) << "its radius from the wall";
}

TEST_F(TopDownTemplate, allCoinsOpenTheGateAndTheGateEndsTheGame) {
    constexpr std::array kToTheCoins{
        Vec2{72, 272},  Vec2{72, 296},  Vec2{112, 296}, Vec2{112, 136}, Vec2{168, 136}, Vec2{152, 136},
        Vec2{152, 66},  Vec2{72, 66},   Vec2{72, 88},   Vec2{72, 66},   Vec2{152, 66},  Vec2{152, 96},
        Vec2{248, 96},  Vec2{248, 69},  Vec2{248, 96},  Vec2{288, 96},  Vec2{288, 168}, Vec2{288, 140},
        Vec2{408, 140}, Vec2{520, 140}, Vec2{520, 72},  Vec2{520, 140}, Vec2{464, 140}, Vec2{464, 232},
        Vec2{408, 232}, Vec2{520, 232}, Vec2{520, 304}};
    for (const Vec2 point : kToTheCoins) {
        EXPECT_NE(shown("coins"), shown("all"));
        ASSERT_TRUE(walkTo(point)) << point.x << " " << point.y;
    }
    EXPECT_EQ(shown("coins"), "10");
    EXPECT_EQ(shown("all"), "10");
    EXPECT_EQ(shown("message"), "The gate is open");
    for (const Vec2 point : {Vec2{520, 232}, Vec2{464, 232}, Vec2{464, 140}, Vec2{288, 140}, Vec2{288, 64}}) {
        ASSERT_TRUE(walkTo(point)) << point.x << " " << point.y;
    }
    play(20, {Key::Up});
    EXPECT_EQ(shown("message").substr(0, 7), "Out in ");

    play(1, {Key::R});
    play(2, {});
    EXPECT_EQ(shown("coins"), "0") << "another game";
    EXPECT_EQ(positionOf("hero"), home);
}

TEST_F(TopDownTemplate, theGateIsShutBeforeAllCoinsAreTaken) {
    for (const Vec2 point : {Vec2{112, 272}, Vec2{112, 136}, Vec2{152, 136}, Vec2{152, 96}, Vec2{288, 96}}) {
        ASSERT_TRUE(walkTo(point)) << point.x << " " << point.y;
    }
    play(60, {Key::Up});
    EXPECT_NEAR(positionOf("hero").y, 48.0f + 5.0f, 1.0f);
    EXPECT_EQ(shown("message"), "");
}

TEST_F(TopDownTemplate, aChaserThatSeesTheHeroCatchesItAndItComesBack) {
    for (const Vec2 point : {Vec2{248, 272}, Vec2{288, 264}}) ASSERT_TRUE(walkTo(point));
    play(240, {});
    EXPECT_EQ(positionOf("hero"), home);
    play(10, {Key::Right});
    EXPECT_NEAR(positionOf("hero").x, home.x + 14.0f, 0.05f) << "it goes on";
}

class PhysicsTemplate : public TemplateGame {
protected:
    PhysicsTemplate() {
        make("physics");
        workspace().startPlaying(true);
        play(30, {});
    }
    [[nodiscard]] std::size_t bodies() { return game().count<RigidBody>(); }
};

TEST_F(PhysicsTemplate, theCarDrivesOverTheSeesaw) {
    const float rest = positionOf("car").x;
    EXPECT_NEAR(rest, 130.0f, 3.0f) << "it stands still until it is driven";
    play(200, {Key::Right});
    EXPECT_GT(positionOf("car").x, 550.0f) << "the end of the seesaw";
    play(1, {Key::R});
    play(30, {});
    EXPECT_NEAR(positionOf("car").x, rest, 0.01f) << "R begins again";
}

TEST_F(PhysicsTemplate, theStackStandsUntilItIsBlasted) {
    constexpr Vec2 kTop{1000.0f, 480.0f};  // place of the uppermost box
    const auto boxesAtTheTop = [&] {
        int count = 0;
        for (auto [entity, body, transform] : std::as_const(game()).query<const RigidBody, const Transform>())
            count += length(transform.position - kTop) < 3.0f ? 1 : 0;
        return count;
    };
    play(300, {});
    EXPECT_EQ(boxesAtTheTop(), 1);
    play(1, {Key::B});
    play(60, {});
    EXPECT_EQ(boxesAtTheTop(), 0);
}

TEST_F(PhysicsTemplate, theChainHoldsTheBallWhileTheMousePullsIt) {
    InputFrame pull;
    for (int tick = 0; tick < 240; ++tick) {
        pull.setMouse({760.0f - static_cast<float>(std::min(tick, 120)) * 4.0f, 498.0f});
        pull.mouseButtons = tick < 180 ? 1 : 0;
        workspace().play.step(pull);
        const float far = length(positionOf("wrecking ball") - positionOf("hook"));
        EXPECT_LT(far, 14 * 22.0f + 40.0f + 8.0f) << "tick " << tick;  // px: links, radius, tolerance
    }
    EXPECT_GT(std::abs(game().get<RigidBody>(named("wrecking ball")).velocity.x), 100.0f) << "it swings";
}

TEST_F(PhysicsTemplate, oldThingsVanishWhenManyAreDropped) {
    const std::size_t before = bodies();
    for (int dropped = 1; dropped <= 50; ++dropped) {
        play(1, {Key::Space});
        play(1, {});
        ASSERT_EQ(bodies(), before + static_cast<std::size_t>(std::min(dropped, 40)));
    }
}

class PlatformerTemplate : public TemplateGame, public ::testing::WithParamInterface<int> {};

TEST_P(PlatformerTemplate, hasAGoalInEachLevelAndAPlayerThatComesBackWhenItFalls) {
    make("platformer");
    ASSERT_TRUE(workspace().open("scenes/level" + std::to_string(GetParam()) + ".scene.json").ok());
    workspace().startPlaying(true);
    play(60, {});
    EXPECT_EQ(game().count<Goal>(), 1u);
    ASSERT_EQ(game().count<KillPlane>(), 1u);
    const EntityId player = named("player");
    const Vec2 home = game().get<Respawn>(player).place;
    game().get<Transform>(player).position.y = 2000.0f;
    play(2, {});
    EXPECT_GT(game().get<Respawn>(player).waiting, 0) << "it fell";
    play(120, {});
    EXPECT_EQ(game().get<Respawn>(player).waiting, 0);
    EXPECT_LT(length(game().get<Transform>(player).position - home), 32.0f);
}
INSTANTIATE_TEST_SUITE_P(Levels, PlatformerTemplate, ::testing::Range(1, 5));

}  // namespace
}  // namespace plumb::editor
