#include <array>

#include "tests/editor/support/dialog_fixture.hpp"

namespace plumb::editor::ui {
namespace {

/// A dialog about unsaved or conflicting work, and its buttons.
struct Dialog {
    const char* name;
    const char* shown;  ///< path of a widget that is visible while the dialog is open
    std::vector<const char*> buttons;
};

const std::array kDialogs{
    Dialog{"Recovery",
           "Recovery/later",
           {"Recovery/later", "Recovery/0/recover", "Recovery/0/discard", "Recovery/0/look"}},
    Dialog{
        "Changed", "Changed/mine", {"Changed/mine", "Changed/theirs", "Changed/beside", "Changed/compare"}},
    Dialog{"Backups", "Backups/cancel", {"Backups/cancel", "Backups/0"}},
    Dialog{"Unsaved", "Unsaved/Cancel", {"Unsaved/Cancel", "Unsaved/Save", "Unsaved/Discard"}},
};

/// Ways to close a dialog other than by its buttons.
constexpr std::array kWaysOut{"Esc", "a click outside", "the window's close button", "nothing"};

class SafetyDialogsTest : public DialogFixture {
protected:
    void play(const Dialog& dialog, std::string_view way, bool changedMeanwhile) {
        putFile(kScene, kSceneText);
        std::filesystem::remove_all(root() / ".plumb");
        Session session{workspace, root()};
        open(session, dialog.name);
        ASSERT_TRUE(session.shows(dialog.shown)) << "the dialog is not there";
        Hands& hands = session.hands;
        if (way == "Esc") {
            hands.key(Key::Escape);
        } else if (way == "a click outside") {
            hands.clickAt({3.0f, 300.0f});
        } else if (way == "the window's close button") {
            session.closeWindow();
        } else if (way != "nothing") {
            hands.click(way);
        }
        hands.rest(3);
        if (way == "nothing") {
            // These keys must reach the dialog, not the editor.
            session.save();
            session.quit();
        }
        if (session.window.wantsQuit()) return;  // nothing had to be saved, or the changes were discarded
        answerAll(session);
        expectSavingWorks(session, changedMeanwhile);
    }
};

TEST_F(SafetyDialogsTest, howeverOneIsClosedSavingGoesOn) {
    for (const Dialog& dialog : kDialogs) {
        std::vector<std::string_view> ways{kWaysOut.begin(), kWaysOut.end()};
        ways.insert(ways.end(), dialog.buttons.begin(), dialog.buttons.end());
        for (const std::string_view way : ways) {
            for (const bool changed : {false, true}) {
                SCOPED_TRACE(format("{}, closed by {}{}", dialog.name, way,
                                    changed ? ", then changed by another program" : ""));
                play(dialog, way, changed);
            }
        }
    }
}

TEST_F(SafetyDialogsTest, theConflictThatIsLeftOpenIsAskedAgainBySaving) {
    Session session{workspace, root()};
    open(session, "Changed");
    session.hands.key(Key::Escape);
    session.hands.rest(70);
    EXPECT_FALSE(session.shows("Changed/mine")) << "it was closed";
    EXPECT_NE(session.workspace.notice.find("saving asks"), std::string::npos) << session.workspace.notice;
    session.save();
    EXPECT_TRUE(session.shows("Changed/mine"));
    EXPECT_EQ(fileText().substr(0, changedText().size()), changedText()) << "theirs is not written over";
}

TEST_F(SafetyDialogsTest, aQuestionThatAnotherDialogHidesComesBack) {
    Session session{workspace, root()};
    open(session, "Recovery");
    session.create();
    session.closeWindow();
    ASSERT_TRUE(session.shows("Unsaved/Cancel"));
    EXPECT_FALSE(session.shows("Recovery/later"));
    session.hands.click("Unsaved/Cancel");
    session.hands.rest(3);
    EXPECT_TRUE(session.shows("Recovery/later"));
}

}  // namespace
}  // namespace plumb::editor::ui
