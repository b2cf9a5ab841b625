// Settings of the editor that are stored with a project between two sessions.

#include "editor/model/project/project_habits.hpp"

#include "editor/model/actions.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/project_copy.hpp"

namespace plumb::editor {
namespace {

class ProjectHabits : public EditorFixture {
protected:
    /// Opens the project in a new session and returns the grid.
    [[nodiscard]] GridSettings nextSession() const {
        TypeRegistry types = engineTypes();
        AssetStore assets{workspace.project.root};
        const Workspace next{types, assets, {workspace.project.root}};
        return next.grid;
    }
    [[nodiscard]] bool isThere(std::string_view path) const {
        return std::filesystem::exists(workspace.project.root / path);
    }
};

TEST_F(ProjectHabits, theGridIsRestored) {
    workspace.update(2.0);
    EXPECT_FALSE(isThere(".plumb/grid.json")) << "nothing was chosen yet";
    workspace.grid.size = {24.0f, 12.5f};
    workspace.grid.color = {10, 20, 30, 200};
    workspace.grid.angle = 0.5f;
    workspace.grid.snapAngles = false;
    ASSERT_TRUE(runAction(workspace, "view.snapHalf"));
    ASSERT_TRUE(runAction(workspace, "view.snap"));
    workspace.update(2.0);
    const GridSettings kept = nextSession();
    EXPECT_EQ(kept.size, (Vec2{24.0f, 12.5f}));
    EXPECT_EQ(kept.color, (Color{10, 20, 30, 200}));
    EXPECT_EQ(kept.angle, 0.5f);
    EXPECT_FALSE(kept.snapAngles);
    EXPECT_FALSE(kept.snap);
    EXPECT_EQ(kept.to, SnapTo::HalfGrid);
    EXPECT_EQ(fileText(".plumb/.gitignore"), "*\n") << "git never sees it";
}

TEST_F(ProjectHabits, invalidValuesAreReplacedByDefaults) {
    putFile(".plumb/grid.json",
            R"({"size": [0, "x"], "to": "nowhere", "angle": 900, "color": [1, 2], "snap": false})");
    const GridSettings kept = nextSession();
    EXPECT_EQ(kept.size, GridSettings{}.size);
    EXPECT_EQ(kept.to, SnapTo::Grid);
    EXPECT_LE(kept.angle, 1.6f);
    EXPECT_EQ(kept.color, GridSettings::kGridColor);
    EXPECT_FALSE(kept.snap) << "what is right counts";
    putFile(".plumb/grid.json", "no JSON");
    EXPECT_EQ(nextSession().size, GridSettings{}.size);
}

TEST_F(ProjectHabits, recentChoicesAreReadInOrderUpToTheLimit) {
    keepRecent(workspace, {"4 edit.undo", "0 scenes/level.scene.json", "3 x"});
    EXPECT_EQ(recentChoices(workspace, 2),
              (std::vector<std::string>{"4 edit.undo", "0 scenes/level.scene.json"}));
    putFile(".plumb/recent.json", R"({"not": "a list"})");
    EXPECT_TRUE(recentChoices(workspace, 2).empty());
}

}  // namespace
}  // namespace plumb::editor
