// Presses every key of the action table in the real window and checks the effect of its action. The keys are
// written out here, so that the test fails if a key in the table changes.

#include <algorithm>
#include <cctype>

#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

std::vector<KeyTrial> allTrials() {
    std::vector<KeyTrial> all;
    for (const auto trials : {fileAndEditTrials(), entityTrials(), toolAndTileTrials(), viewAndRunTrials()})
        all.insert(all.end(), trials.begin(), trials.end());
    return all;
}

/// Returns the test name, for example edit_redo_CtrlShiftZ for Ctrl+Shift+Z of "edit.redo".
std::string nameOfTrial(const testing::TestParamInfo<KeyTrial>& info) {
    std::string name = format("{}_{}", info.param.action, info.param.keys);
    std::replace(name.begin(), name.end(), '.', '_');
    std::erase_if(name, [](char c) { return c != '_' && std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return name;
}

}  // namespace

TEST_P(KeyTrials, doWhatTheirRowSays) {
    const Action* action = findAction(GetParam().action);
    ASSERT_NE(action, nullptr);
    GetParam().attempt(*this);
}
INSTANTIATE_TEST_SUITE_P(Keys, KeyTrials, testing::ValuesIn(allTrials()), nameOfTrial);

TEST(KeyTable, everyKeyIsTried) {
    const std::vector<KeyTrial> trials = allTrials();
    for (const Action& action : actionTable()) {
        for (const Shortcut& keys : {action.shortcut, action.alternative}) {
            if (keys.key == Key::None) continue;
            const auto mine = [&](const KeyTrial& trial) {
                return trial.action == action.id && trial.keys == keys.text();
            };
            EXPECT_EQ(std::count_if(trials.begin(), trials.end(), mine), 1)
                << action.id << " is not tried with " << keys.text() << ": add a row to tests/editor/keys";
        }
    }
}

TEST_F(Desk, keysDoNothingWhereTextIsTyped) {
    change();
    const std::string text = workspace.text();
    const std::vector<ObjectId> selected = workspace.document.selection.all();
    const View view = workspace.view.view();
    hands.click("Scene/filter");
    for (const KeyTrial& trial : allTrials()) {
        SCOPED_TRACE(trial.keys);
        // Escape and Tab are meant to leave the text field.
        if (trial.keys == "Escape" || trial.keys == "Tab") continue;
        press(trial.keys);
        ASSERT_EQ(workspace.text(), text);
        ASSERT_EQ(workspace.document.selection.all(), selected);
        ASSERT_EQ(workspace.view.view().center, view.center);
        ASSERT_EQ(workspace.view.view().zoom, view.zoom);
        ASSERT_EQ(toolInHand(), "tool.select");
        ASSERT_FALSE(workspace.play.running());
        ASSERT_FALSE(workspace.settings.layout.hidden);
        ASSERT_FALSE(window.wantsQuit());
        ASSERT_TRUE(workspace.unsaved());
    }
}

}  // namespace plumb::editor::ui
