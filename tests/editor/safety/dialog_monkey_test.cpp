// Opens and closes dialogs at random; afterwards saving must work or report why it does not. PLUMB_DIALOGS is
// the number of random runs; a failure prints the seed and all actions.

#include "app/project.hpp"
#include "core/random.hpp"
#include "editor/model/play/game_session.hpp"
#include "tests/editor/support/dialog_fixture.hpp"
#include "tests/editor/support/project_copy.hpp"

namespace plumb::editor::ui {
namespace {

constexpr int kSteps = 24;

/// Actions that open a dialog or may lead to one.
constexpr std::array kOpening{"file.open",     "file.new",       "file.backups",      "file.import",
                              "edit.find",     "edit.commands",  "edit.preferences",  "edit.keys",
                              "layout.save",   "entity.prefab",  "entity.makePrefab", "entity.overrides",
                              "run.play",      "run.playPaused", "file.quit",         "file.welcome",
                              "entity.create", "entity.rename",  "file.saveAs"};

class DialogMonkey : public DialogFixture {
protected:
    std::uint32_t below(std::size_t count) { return random_.below(static_cast<std::uint32_t>(count)); }

    std::string openSomething(Session& session) {
        const char* id = kOpening[below(kOpening.size())];
        runAction(session.workspace, id);
        return id;
    }

    std::string pressSomething(Session& session) {
        constexpr std::array kKeys{Key::Escape, Key::Enter, Key::Tab, Key::Down, Key::Space};
        const Key key = kKeys[below(kKeys.size())];
        session.hands.key(key);
        return std::string{nameOf(key)};
    }

    /// Clicks a random widget, with preference for widgets of an open dialog.
    std::string clickSomething(Session& session) {
        std::vector<std::string> names;
        for (const auto& [name, widget] : session.window.widgets().all()) {
            const bool makesProjects = name.find("Create") != std::string::npos && name.find("Welcome") == 0;
            if (!makesProjects) names.push_back(name);
        }
        std::vector<std::string> fronts;
        for (const std::string& name : names) {
            for (const char* dialog :
                 {"Recovery/", "Changed/", "Backups/", "Unsaved/", "Keep/", "New/", "SaveAs/", "MakePrefab/",
                  "Overrides/", "Import/", "Finder/", "Preferences/", "Layout/"}) {
                if (name.find(dialog) == 0) fronts.push_back(name);
            }
        }
        const std::vector<std::string>& from = fronts.empty() || below(6) == 0 ? names : fronts;
        if (from.empty()) return "nothing";
        const std::string name = from[below(from.size())];
        session.hands.click(name);
        return "click " + name;
    }

    std::string changeInGame(Session& session) {
        if (!session.workspace.play.running()) return "nothing";
        const TypeInfo* type = session.workspace.document.types().find("Transform");
        session.workspace.play.edit(session.workspace.document.objects().front(), *type,
                                    *type->find("position"), FieldValue::of(Vec2{7.0f, 8.0f}));
        session.workspace.stopPlaying();
        return "changed in the game";
    }

    std::string act(Session& session) {
        switch (below(12)) {
            case 0:
            case 1:
            case 2: return openSomething(session);
            case 3:
            case 4: return pressSomething(session);
            case 5:
            case 6:
            case 7: return clickSomething(session);
            case 8: session.hands.clickAt({3.0f, 300.0f}); return "click outside";
            case 9: session.closeWindow(); return "close the window";
            case 10:
                if (below(2) == 0) return changeInGame(session);
                changeOutside(), session.hands.rest(70);
                return "changed by another program";
            default: session.save(); return "save";
        }
    }

    void live(std::uint64_t seed) {
        random_ = Random::seeded(seed);
        putFile(kScene, kSceneText);
        putFile("scenes/cave.scene.json", kSceneText);
        std::filesystem::remove_all(root() / ".plumb");
        Session session{workspace, root()};
        session.workspace.makeSession = [&](const std::string& path, const std::string& text) {
            Project project;
            project.root = root();
            return makeGameSession(project, path, text);
        };
        constexpr std::array kFirst{"Recovery", "Changed", "Backups", "Unsaved"};
        open(session, kFirst[below(kFirst.size())]);
        std::string done;
        for (int i = 0; i < kSteps && !session.window.wantsQuit(); ++i) {
            done += act(session) + "; ";
            session.hands.rest(static_cast<int>(below(4)));
            // another project was opened, which needs another editor
            if (!session.window.takeProject().empty()) return;
        }
        if (session.window.wantsQuit()) return;
        SCOPED_TRACE(format("seed {}: {}", seed, done));
        settle(session);
        if (session.workspace.document.scenePath.empty()) return;  // the scene was deleted outside the editor
        expectSavingWorks(session, below(3) == 0);
    }

    /// Leaves the welcome screen and the game and closes all dialogs.
    void settle(Session& session) {
        for (int i = 0; i < 3; ++i) {
            answerAll(session);
            session.workspace.stopPlaying();
            session.hands.rest(2);
        }
    }

private:
    Random random_ = Random::seeded(1);
};

TEST_F(DialogMonkey, savingWorksAfterAnyDialogsInAnyOrder) {
    const int lives = fromEnvironment("PLUMB_DIALOGS", 60);
    const auto first = static_cast<std::uint64_t>(fromEnvironment("PLUMB_DIALOGS_SEED", 1));
    for (int i = 0; i < lives && !HasFailure(); ++i) live(first + static_cast<std::uint64_t>(i));
}

}  // namespace
}  // namespace plumb::editor::ui
