// Performs the scripts that make the screenshots of docs/tutorial.md: every step of the tutorial must work,
// and the resulting level must be playable to its end.

#include <array>
#include <cstdlib>

#include "editor/model/play/game_session.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/ui/tour.hpp"
#include "gameplay/components/actors/patrol.hpp"
#include "gameplay/components/triggers/goal.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor::ui {
namespace {

// x positions of jumps over the gaps and the step, px
constexpr std::array kTakeOffs{286.0f, 440.0f, 590.0f};
constexpr int kSeconds = 30;

/// The editor as it starts on a new machine, with an empty home folder.
class Tutorial : public testing::Test {
protected:
    Tutorial()
        : home_{std::getenv("HOME") == nullptr ? "" : std::getenv("HOME")}, session_{ProjectSession::none()} {
        ::setenv("HOME", home.path.c_str(), 1);
        openWindow();
    }
    ~Tutorial() override { ::setenv("HOME", home_.c_str(), 1); }

    Result<Done> play(const Tour& tour) {
        return tour.play({[this]() -> const EditorWindow& { return *window_; },
                          [this]() -> const Workspace& { return session_->workspace(); },
                          [this](const std::vector<Event>& events) { frame(events); },
                          [this](std::string_view picture) {
                              pictures.emplace_back(picture);
                              return Result<Done>{Done{}};
                          }});
    }
    Workspace& workspace() { return session_->workspace(); }

    test::TemporaryFolder home;
    std::vector<std::string> pictures;

private:
    void openWindow() {
        window_ = std::make_unique<EditorWindow>(session_->workspace(), log_, nullptr,
                                                 test::sourceFolder() / "assets/fonts");
    }
    void frame(const std::vector<Event>& events) {
        window_->frame({events});
        const std::string project = window_->takeProject();
        if (project.empty()) return;
        Result<std::unique_ptr<ProjectSession>> next = ProjectSession::open(project);
        ASSERT_TRUE(next.ok()) << next.error().text();
        window_.reset();
        session_ = std::move(*next);
        session_->openFirst({});
        openWindow();
    }

    std::string home_;
    LogBook log_;
    std::unique_ptr<ProjectSession> session_;
    std::unique_ptr<EditorWindow> window_;
};

EntityId named(const World& world, std::string_view name) {
    for (auto [entity, given] : world.query<const Name>()) {
        if (world.texts().find(given.text) == name) return entity.id();
    }
    return {};
}

float xOf(const World& world, EntityId entity) {
    return world.alive(entity) ? world.get<Transform>(entity).position.x : -1000.0f;
}

/// Player input that runs to the right and jumps at gaps, steps and enemies.
InputFrame runToTheEnd(const World& world, EntityId player) {
    const float x = xOf(world, player);
    const float enemy = xOf(world, named(world, "gloomcap")) - x;
    bool jump = enemy > 0.0f && enemy < 44.0f;
    for (const float spot : kTakeOffs) jump = jump || (x > spot && x < spot + 60.0f);
    InputFrame hands;
    hands.set(Key::Right, true);
    hands.set(Key::Space, jump);
    return hands;
}

/// @return number of ticks until the goal is reached; nothing if it is not reached
std::optional<int> ticksToTheGoal(const Path& folder, const std::string& scene) {
    const Result<Project> project = loadProject(folder);
    const Result<std::string> text = readFile(folder / scene);
    if (!project || !text) return std::nullopt;
    const std::unique_ptr<PlaySession> game = makeGameSession(*project, scene, *text);
    for (int tick = 0; tick < kSeconds * 60; ++tick) {
        game->tick(runToTheEnd(game->world(), named(game->world(), "player")));
        for (auto [entity, goal] : std::as_const(game->world()).query<const Goal>()) {
            if (goal.leaving > 0) return tick;
        }
    }
    return std::nullopt;
}

TEST_F(Tutorial, itsStepsMakeALevelThatIsPlayedToItsEnd) {
    const Path folder = test::sourceFolder() / "docs/tutorial";
    const Result<Tour> tour = Tour::read(*readFile(folder / "tutorial.tour"), "tutorial.tour");
    ASSERT_TRUE(tour.ok()) << tour.error().text();
    const Result<Done> done = play(*tour);
    ASSERT_TRUE(done.ok()) << done.error().text();

    const std::string page = *readFile(test::sourceFolder() / "docs/tutorial.md");
    for (const std::string& picture : pictures) {
        EXPECT_TRUE(std::filesystem::exists(folder / picture)) << picture;
        EXPECT_NE(page.find("tutorial/" + picture), std::string::npos) << picture << " is not shown";
    }

    ASSERT_EQ(workspace().project.name, "Mushroom Hill");
    EXPECT_FALSE(workspace().unsaved());
    const World& world = workspace().document.world;
    EXPECT_EQ(world.get<Camera>(named(world, "camera")).follow, named(world, "player"));
    EXPECT_EQ(world.get<Patrol>(named(world, "gloomcap")).speed, 60.0f) << "what was tried while it played";
    std::vector<float> coins;
    for (auto [entity, name, at] : world.query<const Name, const Transform>()) {
        if (world.texts().find(name.text) == "coin") coins.push_back(at.position.x);
    }
    std::sort(coins.begin(), coins.end());
    EXPECT_EQ(coins, (std::vector{400.0f, 416.0f, 432.0f, 448.0f, 464.0f}));

    const Path made = home.path / "Plumb/mushroom-hill";
    const std::optional<int> ticks = ticksToTheGoal(made, "scenes/level1.scene.json");
    ASSERT_TRUE(ticks) << "the goal is not reached";
    EXPECT_GT(*ticks, 300);
}

}  // namespace
}  // namespace plumb::editor::ui
