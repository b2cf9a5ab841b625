// Switching between projects without restarting the editor.

#include "editor/ui/open_project.hpp"

#include <cstring>

#include "core/log.hpp"
#include "editor/model/actions.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor::ui {
namespace {

class ProjectChange : public testing::Test {
protected:
    ProjectChange() {
        make("first", "hero");
        make("second", "villain");
        start("first");
    }

    [[nodiscard]] std::string folder(std::string_view name) const { return (root_.path / name).string(); }
    [[nodiscard]] Path root(std::string_view name) const { return root_.path / name; }
    /// Creates a project whose scene has an entity with this name.
    void make(const std::string& name, const std::string& entity) {
        std::string scene{kSceneText};
        scene.replace(scene.find("\"crate\""), 7, '"' + entity + '"');
        EXPECT_TRUE(writeFile(root(name) / "project.json", R"({"name": ")" + name + R"("})").ok());
        EXPECT_TRUE(writeFile(root(name) / kScene, scene).ok());
        EXPECT_TRUE(writeFile(root(name) / "assets" / (name + ".txt"), name).ok());
    }
    void start(std::string_view name) {
        auto session = ProjectSession::open(folder(name));
        ASSERT_TRUE(session.ok());
        (*session)->openFirst({});
        open = std::make_unique<OpenProject>(std::move(*session), log, nullptr);
        w().safety.begin();
        hands = std::make_unique<Hands>(open->window());
    }
    void go(std::string_view name) {
        hands.reset();
        ASSERT_TRUE(open->change(folder(name)).ok());
        hands = std::make_unique<Hands>(open->window());
    }
    [[nodiscard]] Workspace& w() { return open->workspace(); }
    [[nodiscard]] ObjectId named(std::string_view name) {
        for (const ObjectId id : w().document.objects()) {
            if (w().document.nameOf(id) == name) return id;
        }
        return {};
    }
    [[nodiscard]] bool shows(std::string_view widget) {
        return open->window().widgets().find(widget) != nullptr;
    }
    void nudge() {
        w().document.selection.set({named("player")});
        hands->key(Key::Right);
        hands->rest(2);
        ASSERT_TRUE(w().unsaved());
    }

private:
    test::TemporaryFolder root_;

protected:
    LogBook log;
    std::unique_ptr<OpenProject> open;
    std::unique_ptr<Hands> hands;
};

TEST_F(ProjectChange, theSceneCanBeShownOnceMoreForThePictureOfAProjectThatIsLeft) {
    runAction(w(), "file.welcome");
    hands->rest(3);
    ASSERT_FALSE(shows("Viewport")) << "the screen on which another project is chosen covers it";
    open->window().showScene();
    hands->rest();
    EXPECT_TRUE(shows("Viewport")) << "in the very next frame";
}

TEST_F(ProjectChange, nothingOfTheFirstProjectIsVisibleInTheSecond) {
    nudge();
    w().grid.size = {99.0f, 99.0f};
    w().view.show({777.0f, 777.0f}, 5.0f);
    runAction(w(), "tool.scale");
    logWarning("Editor", "said in the first");
    hands->click("Tab/Assets");
    hands->rest(40);
    EXPECT_TRUE(shows("Assets/assets/first.txt"));
    EXPECT_EQ(open->title(), "* first - Plumb");
    go("second");
    EXPECT_EQ(open->title(), "second - Plumb");
    EXPECT_EQ(w().undo.total(), 0u);
    EXPECT_TRUE(w().document.selection.empty());
    EXPECT_TRUE(named("villain"));
    EXPECT_FALSE(named("hero"));
    EXPECT_EQ(w().grid.size, GridSettings{}.size);
    EXPECT_NE(w().view.view().center, (Vec2{777.0f, 777.0f}));
    EXPECT_EQ(w().toolIndex(), 0u);
    for (const LogEntry& line : log.lines()) EXPECT_EQ(line.text.find("in the first"), std::string::npos);
    hands->click("Tab/Assets");
    hands->rest(40);
    EXPECT_TRUE(shows("Assets/assets/second.txt"));
    EXPECT_FALSE(shows("Assets/assets/first.txt"));
}

TEST_F(ProjectChange, preferencesAreKeptAndBothProjectsAreRecent) {
    w().settings.theme = Theme::Light;
    w().settings.layout.show("Input");
    const PaneLayout layout = w().settings.layout;
    go("second");
    EXPECT_EQ(w().settings.theme, Theme::Light);
    EXPECT_EQ(w().settings.layout, layout);
    go("first");
    EXPECT_EQ(w().settings.recent, (std::vector<std::string>{folder("first"), folder("second")}));
    EXPECT_EQ(w().settings.theme, Theme::Light);
}

TEST_F(ProjectChange, eachProjectHasItsOwnGrid) {
    w().grid.size = {24.0f, 24.0f};
    go("second");
    w().grid.size = {8.0f, 8.0f};
    go("first");
    EXPECT_EQ(w().grid.size, (Vec2{24.0f, 24.0f}));
    go("second");
    EXPECT_EQ(w().grid.size, (Vec2{8.0f, 8.0f}));
}

TEST_F(ProjectChange, unsavedChangesAreConfirmedAndDiscardedOnesAreBackedUp) {
    nudge();
    w().projectToOpen = folder("second");
    w().request = WindowRequest::OpenProject;
    hands->rest(2);
    EXPECT_EQ(open->window().takeProject(), "") << "it asks first";
    hands->click("Unsaved/Discard");
    hands->rest(2);
    ASSERT_EQ(open->window().takeProject(), folder("second"));
    w().update(2.0);
    w().safety.finish();
    go("second");
    EXPECT_TRUE(w().safety.lost().empty());
    EXPECT_TRUE(w().safety.backups.of(kScene).empty()) << "of the other project";
    go("first");
    EXPECT_TRUE(w().safety.lost().empty()) << "the journal went with the project";
    EXPECT_EQ(w().safety.backups.of(kScene).size(), 1u);
    EXPECT_FALSE(w().unsaved());
    EXPECT_NE(*readFile(w().safety.backups.of(kScene).front().path), w().text());
}

TEST_F(ProjectChange, aRunningGameEndsAndTheNextProjectPlaysItsOwn) {
    hands->key(Key::F5);
    hands->rest(2);
    ASSERT_TRUE(w().play.running());
    go("second");
    EXPECT_FALSE(w().play.running());
    EXPECT_TRUE(w().offeredChanges.empty());
    hands->key(Key::F5);
    hands->rest(2);
    ASSERT_TRUE(w().play.running());
    EXPECT_TRUE(w().play.world().alive(w().play.find(named("villain"))));
    go("first");
    EXPECT_FALSE(w().play.running());
}

TEST_F(ProjectChange, componentsOfBothMayHaveTheSameName) {
    const auto declare = [&](std::string_view project, const std::string& properties) {
        const std::string script = "return script { " + properties + " }";
        EXPECT_TRUE(writeFile(root(project) / "scripts/thing.lua", script).ok());
    };
    declare("first", "amount = number { 3 }");
    declare("second", "name = text { 'new' }, amount = vector { vec(7, 8) }, left = integer { 9 }");
    hands.reset();
    open.reset();
    start("first");
    const auto thing = [&] { return w().document.types().find("Thing"); };
    const auto add = [&](std::string_view entity) {
        return w().document.world.add(*thing(), w().document.find(named(entity)));
    };
    ASSERT_NE(thing(), nullptr);
    add("hero");
    const std::uint64_t before = w().document.world.hash();
    std::uint64_t whileLeaving = 0;
    hands.reset();
    const auto leaving = [&] { whileLeaving = w().document.world.hash(); };
    ASSERT_TRUE(open->change(folder("second"), leaving).ok());
    EXPECT_EQ(whileLeaving, before) << "the first project is complete until it is closed";

    ASSERT_NE(thing(), nullptr);
    const void* added = add("villain");
    Vec2 amount;
    std::memcpy(&amount, thing()->find("amount")->in(added), sizeof amount);
    EXPECT_EQ(amount, (Vec2{7.0f, 8.0f}));
}

TEST_F(ProjectChange, filesOfTheOtherProjectAreNoLongerWatched) {
    go("second");
    const std::string before = w().text();
    std::string changed = *readFile(root("first") / kScene);
    EXPECT_TRUE(writeFile(root("first") / kScene, changed.replace(changed.find("hero"), 4, "stranger")).ok());
    hands->rest(60);
    EXPECT_EQ(w().text(), before);
    EXPECT_EQ(w().safety.onDisk(), FileWatch::State::Same);
    go("first");
    EXPECT_TRUE(named("stranger"));
}

TEST_F(ProjectChange, aProjectThatCannotBeOpenedLeavesThisOneAsItIs) {
    nudge();
    logWarning("Editor", "said in the first");
    EXPECT_FALSE(open->change(folder("nowhere")).ok());
    EXPECT_EQ(open->title(), "* first - Plumb");
    EXPECT_EQ(w().undo.size(), 1u);
    EXPECT_FALSE(w().notice.empty());
    bool said = false;
    for (const LogEntry& line : log.lines())
        said = said || line.text.find("in the first") != std::string::npos;
    EXPECT_TRUE(said);
}

}  // namespace
}  // namespace plumb::editor::ui
