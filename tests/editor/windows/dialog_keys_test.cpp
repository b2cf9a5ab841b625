// Every modal dialog can be used without a mouse: Tab and Shift+Tab walk through its widgets, Enter presses
// the default button, Space the focused one, Escape cancels.

#include <algorithm>

#include "editor/model/prefabs/make_prefab.hpp"
#include "tests/editor/support/dialog_fixture.hpp"

namespace plumb::editor::ui {
namespace {

class DialogKeys : public DialogFixture {
protected:
    struct Dialog {
        const char* name;
        std::vector<std::string> stops;  ///< paths of all widgets that can be used, in the order of Tab
        bool hasDefault = true;          ///< Enter closes the dialog
        const char* typed = "";          ///< text for the field that has the focus, so that it can be closed
    };

    /// An editor in a workspace of its own, as each dialog changes the project.
    struct Desk {
        Workspace workspace;
        LogBook log;
        EditorWindow window;
        Hands hands;

        Desk(Workspace& of, PrefabLibrary* prefabs)
            : workspace{of.document.types(), of.assets, {of.project.root}, prefabs},
              window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"},
              hands{window} {}
        [[nodiscard]] bool shows(const std::string& path) const {
            return window.widgets().find(path) != nullptr;
        }
        [[nodiscard]] const std::string& focused() const { return window.widgets().focused(); }
    };

    void openIn(Desk& desk, std::string_view name) {
        Workspace& open = desk.workspace;
        ASSERT_TRUE(open.open(kScene).ok());
        desk.hands.rest(3);
        if (name == "New scene") runAction(open, "file.new");
        if (name == "Save as") runAction(open, "file.saveAs");
        if (name == "Export") runAction(open, "file.export");
        if (name == "Save layout") runAction(open, "layout.save");
        if (name == "Preferences") runAction(open, "edit.preferences");
        if (name == "Import") {
            putFile("maps/cave.tmx", "<map/>");
            open.importFrom = (root() / "maps").generic_string();
            runAction(open, "file.import");
        }
        if (name == "Make prefab") {
            open.document.selection.set({open.document.objects().back()});
            runAction(open, "entity.makePrefab");
        }
        if (name == "Overrides") {
            const ObjectId crate = open.document.objects()[3];
            ASSERT_TRUE(makePrefab(open, {crate}, prefabPath("crate")).ok());
            open.document.selection.set({crate});
            open.document.world.get<BoxCollider>(open.document.find(crate)).width = 50.0f;
            ++open.document.sceneRevision;
            runAction(open, "entity.overrides");
        }
        if (name == "Keep changes") {
            const TypeInfo& type = open.document.types().of<Transform>();
            for (const std::size_t i : {3u, 4u}) {
                PlayEdit edit{.object = open.document.objects()[i], .type = &type};
                edit.field = type.find("position");
                edit.value = FieldValue::of(Vec2{7.0f, 8.0f});
                open.offeredChanges.push_back({edit, "entity", "Transform.position", "[0, 0]", "[7, 8]"});
            }
        }
        if (name == "Image") {
            putFile("assets/hero.png", "");
            desk.hands.click("Tab/Assets");
            desk.hands.rest(40);
            desk.hands.click("Assets/assets/hero.png");
            desk.hands.clickAt(desk.hands.middleOf("Assets/assets/hero.png"));
        }
        desk.hands.rest(3);
    }

    /// Presses Tab until the first stop comes again. @return the stops, in order
    static std::vector<std::string> walk(Hands& hands, const EditorWindow& window, Modifiers held) {
        std::vector<std::string> stops;
        for (int i = 0; i < 40; ++i) {
            hands.key(Key::Tab, held);
            hands.rest(2);
            const std::string& now = window.widgets().focused();
            if (!stops.empty() && now == stops.front()) break;
            stops.push_back(now);
        }
        return stops;
    }

    /// Expects that Tab goes round all stops in order, and Shift+Tab back, wherever they begin.
    static void expectWalk(Hands& hands, const EditorWindow& window, std::vector<std::string> stops) {
        const auto turned = [&](const std::vector<std::string>& walked) {
            const auto first = std::find(stops.begin(), stops.end(), walked.front());
            std::rotate(stops.begin(), first == stops.end() ? stops.begin() : first, stops.end());
            return stops;
        };
        const std::vector<std::string> ahead = walk(hands, window, {});
        EXPECT_EQ(ahead, turned(ahead));
        std::reverse(stops.begin(), stops.end());
        const std::vector<std::string> back = walk(hands, window, {.shift = true});
        EXPECT_EQ(back, turned(back)) << "backward";
    }

    static std::vector<Dialog> dialogs() {
        return {
            {"New scene", {"New/name", "New/Create", "New/Cancel"}, true, "cave"},
            {"Save as", {"SaveAs/name", "SaveAs/Save", "SaveAs/Cancel"}, true, "cave"},
            {"Export", {"Export/target", "Export/folder", "Export/Export", "Export/Cancel"}},
            {"Save layout", {"Layout/name", "Layout/Save", "Layout/Cancel"}, true, "mine"},
            {"Make prefab", {"MakePrefab/name", "MakePrefab/Make", "MakePrefab/Cancel"}},
            {"Overrides",
             {"Overrides/0/revert", "Overrides/0/apply", "Overrides/revert all", "Overrides/apply all",
              "Overrides/Close"}},
            {"Import", {"Import/up", "Import/place", "Import/cave.tmx", "Import/Cancel"}, false},
            {"Keep changes", {"Keep/0", "Keep/1", "Keep/keep", "Keep/nothing"}},
            {"Image", {"Image/animation", "Image/tileset", "Image/close"}},
            {"Preferences",
             {"Preferences/Look", "Preferences/Keys", "Preferences/Editing", "Preferences/theme/dark",
              "Preferences/theme/light", "Preferences/scale", "Preferences/scale/100",
              "Preferences/scale/150", "Preferences/scale/200", "Preferences/text", "Preferences/Close"}},
        };
    }

    void forEachDialog(const std::function<void(Desk&, const Dialog&)>& check) {
        for (const Dialog& dialog : dialogs()) {
            SCOPED_TRACE(dialog.name);
            putFile(kScene, kSceneText);
            for (const char* made : {".plumb", "prefabs", "maps", "scenes/cave.scene.json"})
                std::filesystem::remove_all(root() / made);
            PrefabLibrary prefabs{workspace.document.types(), root()};
            Desk desk{workspace, &prefabs};
            openIn(desk, dialog.name);
            ASSERT_TRUE(desk.shows(dialog.stops.back())) << "the dialog is not there";
            check(desk, dialog);
        }
    }
};

TEST_F(DialogKeys, tabWalksThroughAllWidgetsOfADialogAndShiftTabBack) {
    forEachDialog(
        [](Desk& desk, const Dialog& dialog) { expectWalk(desk.hands, desk.window, dialog.stops); });
}

TEST_F(DialogKeys, tabWalksThroughTheQuestionsAboutUnsavedWork) {
    const std::vector<Dialog> questions{
        {"Unsaved", {"Unsaved/Save", "Unsaved/Discard", "Unsaved/Cancel"}},
        {"Changed", {"Changed/theirs", "Changed/mine", "Changed/beside", "Changed/compare"}},
        {"Backups", {"Backups/0", "Backups/cancel"}},
        {"Recovery", {"Recovery/0/look", "Recovery/0/recover", "Recovery/0/discard", "Recovery/later"}}};
    for (const Dialog& question : questions) {
        SCOPED_TRACE(question.name);
        putFile(kScene, kSceneText);
        std::filesystem::remove_all(root() / ".plumb");
        Session session{workspace, root()};
        open(session, question.name);
        ASSERT_TRUE(session.shows(question.stops.back())) << "the dialog is not there";
        expectWalk(session.hands, session.window, question.stops);
        answerAll(session);
    }
}

TEST_F(DialogKeys, escapeClosesADialogAlsoOutOfATextField) {
    forEachDialog([](Desk& desk, const Dialog& dialog) {
        desk.hands.key(Key::Escape);
        desk.hands.rest(2);
        EXPECT_FALSE(desk.shows(dialog.stops.back()));
        EXPECT_FALSE(desk.workspace.unsaved() && std::string_view{dialog.name} != "Overrides")
            << "nothing was done";
    });
}

TEST_F(DialogKeys, enterPressesTheDefaultButton) {
    forEachDialog([](Desk& desk, const Dialog& dialog) {
        desk.hands.type(dialog.typed);
        desk.hands.key(Key::Enter);
        desk.hands.rest(2);
        EXPECT_EQ(desk.shows(dialog.stops.back()), !dialog.hasDefault);
    });
}

TEST_F(DialogKeys, enterAndSpacePressTheButtonToWhichTabHasLed) {
    for (const Key key : {Key::Enter, Key::Space}) {
        SCOPED_TRACE(nameOf(key));
        putFile(kScene, kSceneText);
        Session session{workspace, root()};
        open(session, "Unsaved");
        for (int i = 0; i < 3 && session.window.widgets().focused() != "Unsaved/Cancel"; ++i) {
            session.hands.key(Key::Tab, {.shift = true});
            session.hands.rest(2);
        }
        ASSERT_EQ(session.window.widgets().focused(), "Unsaved/Cancel");
        session.hands.key(key);
        session.hands.rest(2);
        EXPECT_FALSE(session.shows("Unsaved/Save"));
        EXPECT_TRUE(session.workspace.unsaved()) << "the default button, Save, was not meant";
        EXPECT_FALSE(session.window.wantsQuit());
    }
}

TEST_F(DialogKeys, withoutADialogTabStillHidesThePanels) {
    Session session{workspace, root()};
    ASSERT_TRUE(session.workspace.open(kScene).ok());
    session.hands.rest(3);
    session.hands.key(Key::Tab);
    EXPECT_TRUE(session.workspace.settings.layout.hidden);
}

}  // namespace
}  // namespace plumb::editor::ui
