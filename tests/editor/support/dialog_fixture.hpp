#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "editor/model/actions.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {

/// Helpers for tests of the dialogs about unsaved or conflicting work; after each dialog saving must work.
class DialogFixture : public EditorFixture {
protected:
    /// An editor window with a workspace of its own, in which the dialogs are opened.
    struct Session {
        Workspace workspace;
        LogBook log;
        EditorWindow window;
        Hands hands;

        Session(Workspace& of, const Path& root)
            : workspace{of.document.types(), of.assets, {root}},
              window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"},
              hands{window} {}

        [[nodiscard]] bool shows(std::string_view path) const {
            return window.widgets().find(path) != nullptr;
        }
        void create() { ASSERT_TRUE(runAction(workspace, "entity.create")); }
        void save() { hands.key(Key::S, {.control = true}), hands.rest(3); }
        void quit() { hands.key(Key::Q, {.control = true}), hands.rest(3); }
        void closeWindow() {
            const std::array events{Event{.kind = EventKind::Quit}};
            window.frame({events});
            hands.rest(3);
        }
    };

    [[nodiscard]] Path root() const { return workspace.project.root; }
    [[nodiscard]] std::string changedText() const {
        std::string text{kSceneText};
        return text.replace(text.find("[200, 64]"), 9, "[201, 64]");
    }
    void changeOutside(std::string_view scene = kScene) {
        putFile(scene, changedText() + std::string(static_cast<std::size_t>(++edits_), '\n'));
    }

    void open(Session& session, std::string_view dialog) {
        if (dialog == "Recovery") {
            putFile(".plumb/session1/scenes+level.scene.json.journal",
                    "{\"journal\":1,\"scene\":\"scenes/level.scene.json\"}\n" + changedText());
        }
        ASSERT_TRUE(session.workspace.open(kScene).ok());
        session.workspace.safety.begin();
        session.hands.rest(3);
        if (dialog == "Recovery") return;
        session.create();
        if (dialog == "Changed") {
            changeOutside();
            session.hands.rest(70);
        } else if (dialog == "Backups") {
            ASSERT_TRUE(session.workspace.save().ok());
            session.hands.key(Key::B, {.control = true, .alt = true});
            session.hands.rest(3);
        } else {
            session.quit();
        }
    }

    /// Closes all open dialogs, so that keys reach the editor again.
    void answerAll(Session& session) {
        for (int i = 0; i < 5; ++i) {
            if (session.shows("Changed/mine")) session.hands.click("Changed/mine");
            session.hands.key(Key::Escape);
            session.hands.rest(3);
        }
    }

    /// Expects that `save` writes the file. It may instead report why not and open the dialog "Changed"; once
    /// this is answered, a second save must write the file.
    void expectSaves(Session& session, const std::function<void()>& save) {
        session.workspace.notice.clear();
        const std::string mine = session.workspace.text();
        save();
        if (fileText(session.workspace.document.scenePath) != mine) {
            EXPECT_NE(session.workspace.notice, "") << "nothing was written, and nothing was said";
            ASSERT_TRUE(session.shows("Changed/mine")) << "nothing was asked";
            session.hands.click("Changed/mine");
            session.hands.rest(3);
            save();
        }
        EXPECT_EQ(fileText(session.workspace.document.scenePath), mine);
        EXPECT_FALSE(session.workspace.unsaved());
    }

    void expectSavingWorks(Session& session, bool changedMeanwhile) {
        if (session.workspace.document.scenePath.empty()) {
            ADD_FAILURE() << "no scene is open any more";
            return;
        }
        session.create();
        if (changedMeanwhile) changeOutside(session.workspace.document.scenePath);
        expectSaves(session, [&] { session.save(); });
        session.create();
        if (changedMeanwhile) changeOutside(session.workspace.document.scenePath);
        expectSaves(session, [&] {
            session.quit();
            session.hands.click("Unsaved/Save");
            session.hands.rest(3);
        });
        EXPECT_TRUE(session.window.wantsQuit());
    }

private:
    int edits_ = 0;  // number of extra newlines, so that each outside change differs from the one before
};

}  // namespace plumb::editor::ui
