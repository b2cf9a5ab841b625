#include <cstdlib>

#include "editor/model/project/project_session.hpp"
#include "editor/model/view/thumbnail.hpp"
#include "editor/templates/project_templates.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor::ui {
namespace {

const Path kFonts = test::sourceFolder() / "assets/fonts";

/// The editor as it starts without a project, with a temporary home folder.
class Welcome : public testing::Test {
protected:
    Welcome()
        : home_{std::getenv("HOME") == nullptr ? "" : std::getenv("HOME")}, session{ProjectSession::none()} {
        ::setenv("HOME", home.path.c_str(), 1);
        window = std::make_unique<EditorWindow>(session->workspace(), log, nullptr, kFonts);
        hands = std::make_unique<Hands>(*window);
    }
    ~Welcome() override { ::setenv("HOME", home_.c_str(), 1); }

    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const WidgetMap::Widget* found = window->widgets().find(widget);
        return found == nullptr ? "not on the screen" : found->value;
    }
    void write(std::string_view field, std::string_view text) {
        hands->click(field);
        hands->key(Key::A, {.control = true});
        hands->type(text);
        hands->rest();
    }

private:
    std::string home_;

protected:
    test::TemporaryFolder home;
    LogBook log;
    std::unique_ptr<ProjectSession> session;
    std::unique_ptr<EditorWindow> window;
    std::unique_ptr<Hands> hands;
};

TEST_F(Welcome, withoutAProjectOnlyTheWelcomeScreenIsShown) {
    EXPECT_EQ(window->widgets().find("Menu/File"), nullptr);
    EXPECT_EQ(window->widgets().find("Welcome/Back"), nullptr) << "there is nothing to go back to";
    EXPECT_EQ(valueOf("Welcome/name"), "My Game");
    EXPECT_EQ(valueOf("Welcome/folder"), "~/Plumb/my-game");
    hands->key(Key::Escape);
    EXPECT_NE(window->widgets().find("Welcome/Create"), nullptr);
}

TEST_F(Welcome, allTemplatesFitIntoASmallWindow) {
    const auto boxOf = [&](const std::string& widget) {
        const WidgetMap::Widget* found = window->widgets().find(widget);
        EXPECT_NE(found, nullptr) << widget;
        return found == nullptr ? AABB{} : found->box;
    };
    float above = 0.0f;
    for (const ProjectTemplate& row : projectTemplates()) {
        const AABB card = boxOf("Welcome/template/" + std::string{row.id});
        const AABB what = boxOf("Welcome/what/" + std::string{row.id});
        EXPECT_GE(card.min.y, above) << row.id;
        EXPECT_GE(what.min.x, card.min.x) << row.id;
        EXPECT_LE(what.max.x, card.max.x - 12.0f) << row.what;
        EXPECT_LE(what.max.y, card.max.y - 2.0f) << row.what;
        above = card.max.y;
    }
    // The panel ends at 682 px of 720; below the button it has a message of two lines.
    EXPECT_LE(boxOf("Welcome/Create").max.y, 682.0f - 14.0f - 2 * 18.0f);
}

TEST_F(Welcome, anEmptyProjectIsCreatedAndOpened) {
    write("Welcome/name", "The Tower!");
    EXPECT_EQ(valueOf("Welcome/folder"), "~/Plumb/the-tower");
    hands->click("Welcome/Create");
    hands->rest(2);
    const Path made = home.path / "Plumb/the-tower";
    EXPECT_EQ(window->takeProject(), made.string());

    const auto opened = ProjectSession::open(made.string());
    ASSERT_TRUE(opened.ok());
    (*opened)->openFirst({});
    EXPECT_EQ((*opened)->workspace().project.name, "The Tower!");
    EXPECT_EQ((*opened)->workspace().document.scenePath, "scenes/level1.scene.json");
    EXPECT_EQ((*opened)->workspace().document.objectCount(), 1u);
    EXPECT_EQ((*opened)->validate(), 0);
}

TEST_F(Welcome, thePlatformerIsCopiedCompletely) {
    hands->click("Welcome/template/platformer");
    write("Welcome/name", "Mine");
    write("Welcome/folder", (home.path / "games/mine").string());
    hands->click("Welcome/Create");
    hands->rest(2);
    ASSERT_EQ(window->takeProject(), (home.path / "games/mine").string());
    const auto opened = ProjectSession::open((home.path / "games/mine").string());
    ASSERT_TRUE(opened.ok());
    EXPECT_EQ((*opened)->validate(), 0);
    EXPECT_EQ((*opened)->workspace().project.name, "Mine");
}

TEST_F(Welcome, theKitHasAllPrefabsAndOneEmptyLevel) {
    hands->click("Welcome/template/kit");
    hands->click("Welcome/Create");
    hands->rest(2);
    const Path made = home.path / "Plumb/my-game";
    ASSERT_EQ(window->takeProject(), made.string());
    const auto opened = ProjectSession::open(made.string());
    ASSERT_TRUE(opened.ok());
    (*opened)->openFirst({});
    EXPECT_EQ((*opened)->validate(), 0);
    Workspace& workspace = (*opened)->workspace();
    EXPECT_EQ(workspace.document.scenePath, "scenes/level1.scene.json");
    EXPECT_EQ(workspace.text(), *readFile(made / workspace.document.scenePath)) << "as the editor writes it";
    EXPECT_TRUE(std::filesystem::exists(made / "prefabs/player.prefab.json"));
    EXPECT_FALSE(std::filesystem::exists(made / "scenes/level2.scene.json"));
    std::size_t layers = 0;
    workspace.document.world.each<TileLayer>([&](Entity, const TileLayer& layer) {
        const TileGrid& cells = *workspace.document.world.tiles().find(layer.cells);
        EXPECT_EQ(cells, (TileGrid{cells.width(), cells.height()}));
        ++layers;
    });
    EXPECT_EQ(layers, 1u);
}

TEST_F(Welcome, aFolderThatIsNotEmptyIsNotOverwritten) {
    ASSERT_TRUE(writeFile(home.path / "Plumb/my-game/diary.txt", "mine").ok());
    hands->click("Welcome/Create");
    hands->rest(2);
    EXPECT_NE(valueOf("Welcome/message").find("already exists there"), std::string::npos);
    EXPECT_EQ(window->takeProject(), "");
    EXPECT_EQ(*readFile(home.path / "Plumb/my-game/diary.txt"), "mine");
}

TEST_F(Welcome, aFolderWithoutAProjectBecomesOne) {
    std::filesystem::create_directories(home.path / "tower");
    write("Welcome/place", "~/tower");
    hands->click("Welcome/Open");
    hands->rest(2);
    EXPECT_EQ(valueOf("Welcome/name"), "tower");
    EXPECT_EQ(valueOf("Welcome/folder"), (home.path / "tower").string());
    hands->click("Welcome/Create");
    hands->rest(2);
    EXPECT_EQ(window->takeProject(), (home.path / "tower").string());
    EXPECT_TRUE(isProject(home.path / "tower"));
}

TEST_F(Welcome, aMissingFolderIsReported) {
    write("Welcome/place", "/nowhere/at/all");
    hands->key(Key::Enter);
    EXPECT_EQ(valueOf("Welcome/openMessage"), "There is no folder /nowhere/at/all");
}

TEST_F(Welcome, recentProjectsAreListedOpenedAndRemoved) {
    Settings& settings = session->workspace().settings;
    settings.remember((home.path / "gone").string());
    settings.remember((test::sourceFolder() / "projects/platformer").string());
    window->welcome({});
    hands->rest(2);
    EXPECT_EQ(valueOf("Welcome/recent/0"), "Wickwood");
    hands->clickAt(hands->middleOf("Welcome/recent/1"), MouseButton::Right);
    hands->rest();
    hands->click("Welcome/recent/1/forget");
    EXPECT_EQ(settings.recent.size(), 1u);
    hands->click("Welcome/recent/0");
    hands->rest(2);
    EXPECT_EQ(window->takeProject(), (test::sourceFolder() / "projects/platformer").string());
}

class WelcomeFromAProject : public EditorFixture {
protected:
    WelcomeFromAProject() : window{workspace, log, nullptr, kFonts}, hands{window} {}
    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(WelcomeFromAProject, itIsOpenedFromTheMenuAndLeftAndUnsavedChangesAreConfirmed) {
    workspace.document.selection.set({named("crate")});
    hands.key(Key::Delete);
    hands.click("Menu/File"), hands.rest();
    hands.click("Menu/File/Projects..."), hands.rest(2);
    ASSERT_NE(window.widgets().find("Welcome/Back"), nullptr);
    hands.key(Key::Delete);
    EXPECT_EQ(workspace.undo.size(), 1u) << "the scene behind it hears no keys";
    hands.click("Welcome/Back"), hands.rest(2);
    EXPECT_NE(window.widgets().find("Menu/File"), nullptr);

    hands.key(Key::O, {.shift = true, .control = true}), hands.rest(2);
    hands.click("Welcome/place");
    hands.type((test::sourceFolder() / "projects/platformer").string());
    hands.key(Key::Enter), hands.rest(2);
    EXPECT_EQ(window.takeProject(), "");
    hands.click("Unsaved/Discard"), hands.rest(2);
    EXPECT_EQ(window.takeProject(), (test::sourceFolder() / "projects/platformer").string());
}

TEST(Thumbnails, averageThePixelsOfAPartOfAnImage) {
    Image picture{40, 20, std::vector<std::uint8_t>(40 * 20 * 4, 255)};
    for (int y = 0; y < 20; ++y) {
        for (int x = 20; x < 40; ++x) picture.rgba[static_cast<std::size_t>(y * 40 + x) * 4] = 55;
    }
    const Image small = thumbnailOf(picture, {{-5.0f, -5.0f}, {90.0f, 90.0f}}, 4, 2);
    ASSERT_EQ(small.rgba.size(), 32u);
    EXPECT_EQ(small.rgba[0], 255);
    EXPECT_EQ(small.rgba[12], 55);
    const Image middle = thumbnailOf(picture, {{10.0f, 0.0f}, {30.0f, 20.0f}}, 1, 1);
    EXPECT_EQ(middle.rgba[0], 155);
    EXPECT_TRUE(thumbnailOf(picture, {{50.0f, 0.0f}, {60.0f, 10.0f}}, 4, 2).empty());
}

}  // namespace
}  // namespace plumb::editor::ui
