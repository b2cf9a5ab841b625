// Random actions on real projects: nothing crashes, undoing everything brings the file back byte for byte,
// and redoing everything what was made of it. PLUMB_MONKEY says how many actions; the seed is in the report.

#include "tests/editor/support/monkey.hpp"

#include <map>

#include "scene/components/transform.hpp"
#include "tests/editor/support/project_copy.hpp"

namespace plumb::editor::ui {
namespace {

/// The text of the scene before its first change, and how far undo went since then.
class Beginning {
public:
    explicit Beginning(Workspace& workspace) : workspace_{workspace} { look(); }
    /// After each action: another scene may have been opened.
    void look() {
        const UndoStack& undo = workspace_.undo;
        if (undo.total() == 0 || undo.cleared() != cleared_) {
            cleared_ = undo.cleared();
            known_ = undo.total() == 0;
            if (known_) text_ = workspace_.text();
        }
    }
    void expectUndoneAndRedone() {
        if (workspace_.document.scenePath.empty()) return;
        UndoStack& undo = workspace_.undo;
        const std::size_t position = undo.size();
        const std::string after = workspace_.text();
        undo.jumpTo(0);
        const std::string start = workspace_.text();
        if (known_) {
            ASSERT_EQ(start, text_) << "undoing everything";
        }
        undo.jumpTo(undo.total());
        undo.jumpTo(0);
        ASSERT_EQ(workspace_.text(), start) << "undoing everything again";
        undo.jumpTo(position);
        ASSERT_EQ(workspace_.text(), after) << "redoing everything";
    }

private:
    Workspace& workspace_;
    std::string text_;
    std::size_t cleared_ = 0;
    bool known_ = false;
};

void letLoose(const std::string& project, std::string_view scene, std::uint64_t seed, int actions) {
    SCOPED_TRACE(format("{} with seed {}", project, seed));
    ProjectCopy copy{project, scene};
    Workspace& workspace = copy.workspace();
    workspace.assets.logging = false;
    LogBook log;
    EditorWindow window{workspace, log, nullptr, Path{PLUMB_SOURCE_DIR} / "assets/fonts"};
    Monkey monkey{workspace, window, seed};
    Beginning beginning{workspace};
    std::vector<std::string> last;
    std::size_t changes = 0, plays = 0;
    for (int i = 1; i <= actions; ++i) {
        const std::uint64_t before = workspace.document.sceneRevision;
        last.push_back(monkey.act());
        changes += workspace.document.sceneRevision != before ? 1 : 0;
        plays += workspace.play.running() && workspace.play.ticks() > 0 ? 1 : 0;
        beginning.look();
        if (workspace.document.objectCount() > 400) workspace.undo.jumpTo(workspace.undo.size() / 2);
        if (i % 250 != 0 && i != actions) continue;
        monkey.calm();
        beginning.look();
        ASSERT_NO_FATAL_FAILURE(beginning.expectUndoneAndRedone())
            << "after action " << i << "; the last ones: " << last[last.size() - 1] << ", "
            << last[last.size() - 2];
        if (workspace.document.scenePath.empty() || i % 1000 == 0) {
            ASSERT_TRUE(workspace.open(format("scenes/{}.scene.json", scene)).ok());
        }
    }
    EXPECT_GT(changes, static_cast<std::size_t>(actions) / 12) << "it hardly changes anything";
    EXPECT_GT(plays, static_cast<std::size_t>(actions) / 50) << "it hardly plays";
}

TEST(Monkey, whateverIsDoneToThePlatformerIsUndoneByteForByte) {
    const int actions = fromEnvironment("PLUMB_MONKEY", 5000);
    for (std::uint64_t part = 0; part * 5000 < static_cast<std::uint64_t>(actions); ++part)
        ASSERT_NO_FATAL_FAILURE(letLoose("platformer", "level1", part + 1, std::min(actions, 5000)));
}

TEST(Monkey, whateverIsDoneToThePlaygroundIsUndoneByteForByte) {
    const int actions = fromEnvironment("PLUMB_MONKEY", 5000);
    for (std::uint64_t part = 0; part * 5000 < static_cast<std::uint64_t>(actions); ++part)
        ASSERT_NO_FATAL_FAILURE(
            letLoose("physics-playground", "softbodies", part + 1, std::min(actions, 5000)));
}

}  // namespace
}  // namespace plumb::editor::ui
