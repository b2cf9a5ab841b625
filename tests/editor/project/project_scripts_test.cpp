#include <gtest/gtest.h>

#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/templates/project_templates.hpp"
#include "gameplay/label_values.hpp"
#include "scene/components.hpp"
#include "script/script_api.hpp"
#include "tests/support/temporary_folder.hpp"

// A project made from the template "lua", and the definitions of its scripts.

namespace plumb::editor {
namespace {

class ProjectScripts : public ::testing::Test {
protected:
    ProjectScripts() {
        EXPECT_TRUE(createProject(*findTemplate("lua"), "Game", folder).ok());
        open();
    }
    void open() {
        session.reset();
        session = std::move(*ProjectSession::open(folder.string()));
        session->openFirst({});
    }
    [[nodiscard]] Workspace& workspace() { return session->workspace(); }
    [[nodiscard]] Path definitions() const { return folder / ".plumb/plumb.d.lua"; }

    void play(int ticks, std::initializer_list<Key> keys) {
        InputFrame input;
        for (const Key key : keys) input.set(key, true);
        for (int i = 0; i < ticks; ++i) workspace().play.step(input);
    }
    [[nodiscard]] Vec2 playerPosition() {
        for (const ObjectId id : workspace().document.objects()) {
            if (workspace().document.nameOf(id) == "player")
                return workspace().play.world().get<Transform>(workspace().play.find(id)).position;
        }
        return {};
    }
    [[nodiscard]] std::string score() {
        const auto* texts = workspace().play.world().findResource<LabelValues>();
        const std::string* text = texts == nullptr ? nullptr : texts->find("score");
        return text == nullptr ? "" : *text;
    }

private:
    test::TemporaryFolder home_;

protected:
    const Path folder = home_.path / "game";
    std::unique_ptr<ProjectSession> session;
};

TEST_F(ProjectScripts, ofTheTemplateAreValidAndWrittenAsTheEditorDoes) {
    EXPECT_EQ(session->validate(), 0);
    EXPECT_EQ(workspace().project.name, "Game");
    EXPECT_EQ(workspace().document.scenePath, "scenes/level1.scene.json");
    EXPECT_EQ(workspace().text(), *readFile(folder / "scenes/level1.scene.json"));
    EXPECT_NE(readFile(folder / ".luarc.json")->find("\"workspace.library\": [\".plumb\"]"),
              std::string::npos);
}

TEST_F(ProjectScripts, withAHandlerOfAnotherNameAreNotValid) {
    const std::string lift = "local Lift = script {}\nfunction Lift:onTik() end\nreturn Lift\n";
    ASSERT_TRUE(writeFile(folder / "scripts/lift.lua", lift).ok());
    open();
    testing::internal::CaptureStdout();
    const int code = session->validate();
    const std::string text = testing::internal::GetCapturedStdout();
    EXPECT_EQ(code, 1);
    EXPECT_NE(text.find("scripts/lift.lua: the engine does not call \"onTik\"; name the function onTick"),
              std::string::npos)
        << text;
}

TEST_F(ProjectScripts, ofTheTemplateWalkJumpTakeCoinsAndComeBack) {
    workspace().startPlaying(true);
    play(60, {});
    const Vec2 start = playerPosition();
    EXPECT_EQ(score(), "0");
    play(10, {Key::Space});
    EXPECT_LT(playerPosition().y, start.y - 20.0f) << "it jumps";
    play(60, {});
    EXPECT_NEAR(playerPosition().y, start.y, 1.0f);
    play(40, {Key::Right});
    EXPECT_GT(playerPosition().x, start.x + 100.0f) << "it walks";
    EXPECT_EQ(score(), "1");
    play(240, {});
    play(40, {Key::Left});
    EXPECT_EQ(score(), "2") << "the coin came back";
    play(600, {Key::Left});
    EXPECT_LT(playerPosition().y, 450.0f) << "it comes back when it falls";
}

TEST_F(ProjectScripts, areDescribedInAFileForEditorsOfText) {
    const std::string text = *readFile(definitions());
    EXPECT_EQ(text, scriptDefinitions(workspace().document.types()));
    EXPECT_NE(text.find("---@class Player : Script\n"), std::string::npos);
    EXPECT_EQ(*readFile(folder / ".plumb/.gitignore"), "*\n");
}

TEST_F(ProjectScripts, areDescribedAgainOnlyAfterAChange) {
    const auto old = std::filesystem::file_time_type{} + std::chrono::hours{1};
    std::filesystem::last_write_time(definitions(), old);
    open();
    EXPECT_EQ(std::filesystem::last_write_time(definitions()), old);

    const std::string lift = "return script { height = number { 90, unit = 'px' } }";
    ASSERT_TRUE(writeFile(folder / "scripts/lift.lua", lift).ok());
    workspace().followCode(100.0);
    const std::string text = *readFile(definitions());
    EXPECT_NE(text.find("---@class Lift : Script\n"), std::string::npos);
    EXPECT_NE(text.find("---@field height number (px)\n"), std::string::npos);
}

TEST_F(ProjectScripts, theirDefinitionsAreNoAssets) {
    ASSERT_TRUE(std::filesystem::exists(definitions()));
    AssetCatalog catalog{folder};
    catalog.refresh();
    EXPECT_FALSE(catalog.all().empty());
    for (const AssetItem& item : catalog.all()) EXPECT_NE(item.path[0], '.') << item.path;
}

TEST(ProjectWithoutScripts, hasNoDefinitions) {
    const test::TemporaryFolder home;
    ASSERT_TRUE(createProject(*findTemplate("empty"), "Game", home.path / "game").ok());
    const auto session = ProjectSession::open((home.path / "game").string());
    ASSERT_TRUE(session.ok());
    EXPECT_FALSE(std::filesystem::exists(home.path / "game/.plumb/plumb.d.lua"));
}

}  // namespace
}  // namespace plumb::editor
