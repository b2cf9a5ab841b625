// Kills the editor at random moments: saved work must not be lost, and of unsaved work at most the last 5 s
// or 20 actions. PLUMB_KILLS is the number of kills; the default is small.

#ifndef _WIN32

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/hash.hpp"
#include "core/random.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/set_field.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/editor/support/project_copy.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

/// A record that the editor in the child process writes about its state.
struct Note {
    enum Kind : std::uint32_t { Text, Saving, Saved } kind = Text;
    std::uint32_t action = 0;
    double seconds = 0.0;
    std::uint64_t hash = 0;  ///< hash of the scene's text
};

/// A forked child process that runs `life` until it is killed.
class Doomed {
public:
    template <class Life>
    explicit Doomed(Life life) {
        EXPECT_EQ(::pipe(pipe_), 0);
#ifdef F_SETPIPE_SZ
        ::fcntl(pipe_[1], F_SETPIPE_SZ, 1 << 20);
#endif
        child_ = ::fork();
        if (child_ != 0) return;
        ::close(pipe_[0]);
        life([this](const Note& note) { static_cast<void>(::write(pipe_[1], &note, sizeof note)); });
        ::_exit(0);
    }
    /// @return all records that the child process wrote
    std::vector<Note> killAfter(std::chrono::microseconds time) {
        ::close(pipe_[1]);
        std::this_thread::sleep_for(time);
        ::kill(child_, SIGKILL);
        std::vector<Note> notes;
        for (Note note; ::read(pipe_[0], &note, sizeof note) == sizeof note;) notes.push_back(note);
        ::close(pipe_[0]);
        int status = 0;
        ::waitpid(child_, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
        return notes;
    }

private:
    int pipe_[2] = {-1, -1};
    pid_t child_ = -1;
};

class Kill : public EditorFixture {
protected:
    [[nodiscard]] std::uint64_t hash() const { return hashText(workspace.text()); }
    [[nodiscard]] std::uint64_t hashOfFile() const { return hashText(fileText()); }

    /// Moves an entity to a random position.
    void move(ObjectId id, Random& random) {
        const TypeInfo& type = workspace.document.types().of<Transform>();
        std::vector<SetField::Change> change;
        change.push_back(
            {id, FieldValue::of(Vec2{random.between(-999.0f, 999.0f), random.between(0.0f, 99.0f)})});
        workspace.undo.push(std::make_unique<SetField>(type, *type.find("position"), std::move(change)));
        workspace.undo.endGesture();
    }

    /// Performs a random action of a user.
    void act(Random& random) {
        Document& document = workspace.document;
        if (random.below(3) == 0 || document.objectCount() < 5) {
            runAction(workspace, "entity.create");
        } else if (const ObjectId id =
                       document.objects()[random.below(static_cast<std::uint32_t>(document.objectCount()))];
                   random.below(2) == 0) {
            document.selection.set({id});
            constexpr std::array kActions{"edit.duplicate", "edit.delete", "entity.right", "edit.undo",
                                          "edit.redo"};
            runAction(workspace, kActions[random.below(kActions.size())]);
            workspace.undo.endGesture();
        } else if (document.world.has<Transform>(document.find(id))) {
            move(id, random);
        }
    }

    /// Performs random actions in a window without a screen and saves now and then.
    template <class Tell>
    void work(EditorWindow& window, Random random, Tell tell) {
        workspace.safety.begin();
        constexpr float kPerAction = 0.3f;  // s
        for (std::uint32_t i = 1; i < 100'000; ++i) {
            act(random);
            tell({Note::Text, i, static_cast<double>(static_cast<float>(i) * kPerAction), hash()});
            if (random.below(60) == 0) {
                tell({Note::Saving, i, 0.0, hash()});
                if (workspace.save().ok()) tell({Note::Saved, i, 0.0, hash()});
            }
            window.frame({{}, {1280, 720}, {1280, 720}, kPerAction});
        }
    }
};

std::chrono::microseconds between(Random& random, float least, float most) {
    return std::chrono::microseconds{static_cast<int>(random.between(least, most) * 1000.0f)};
}

TEST_F(Kill, savingLosesNothingWhenItIsKilledAnywhere) {
    const int kills = fromEnvironment("PLUMB_KILLS", 12);
    Random random = Random::seeded(3);
    for (const int entities : {6, 300, 4000}) {
        SCOPED_TRACE(entities);
        while (workspace.document.objectCount() < static_cast<std::size_t>(entities)) {
            runAction(workspace, "edit.selectAll"), runAction(workspace, "edit.duplicate");
        }
        ASSERT_TRUE(workspace.save().ok());
        // ms; long enough for several saves
        const float longest = 40.0f + 0.1f * static_cast<float>(entities);
        std::size_t saves = 0;
        for (int i = 0; i < kills; ++i) {
            const std::uint64_t before = hashOfFile();
            const std::uint64_t seed = random.next64();
            Doomed editor{[&](auto tell) {
                Random moves = Random::seeded(seed);
                while (true) {
                    move(workspace.document.objects().front(), moves);
                    tell(Note{Note::Saving, 0, 0.0, hash()});
                    if (workspace.save().ok()) tell(Note{Note::Saved, 0, 0.0, hash()});
                }
            }};
            std::uint64_t saved = before, saving = before;
            for (const Note& note : editor.killAfter(between(random, 0.0f, longest))) {
                (note.kind == Note::Saved ? saved : saving) = note.hash;
                saves += note.kind == Note::Saved ? 1 : 0;
            }
            ASSERT_TRUE(hashOfFile() == saved || hashOfFile() == saving) << "kill " << i;
            workspace.safety.takeTheirs();  // this process continues with the file that the killed one left
            ASSERT_EQ(hash(), hashOfFile());
        }
        EXPECT_GT(saves, 0u);
    }
}

TEST_F(Kill, anEditorKilledAtAnyMomentLosesAtMostTwentyActionsOrFiveSeconds) {
    const int kills = fromEnvironment("PLUMB_KILLS", 15);
    LogBook log;
    EditorWindow window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"};
    Random random = Random::seeded(5);
    std::size_t recovered = 0, most = 0;
    for (int i = 0; i < kills; ++i) {
        SCOPED_TRACE(i);
        const std::uint64_t seed = random.next64();
        const std::uint64_t before = hashOfFile();
        Doomed editor{[&](auto tell) { work(window, Random::seeded(seed), tell); }};
        const std::vector<Note> notes = editor.killAfter(between(random, 1.0f, 250.0f));
        std::uint64_t saved = before, saving = before;
        Note last{Note::Text, 0, 0.0, before};
        for (const Note& note : notes) {
            if (note.kind == Note::Text) last = note;
            if (note.kind == Note::Saving) saving = note.hash;
            if (note.kind == Note::Saved) saved = note.hash;
        }
        ASSERT_TRUE(hashOfFile() == saved || hashOfFile() == saving) << "the user's file is damaged";

        // Restart the editor.
        Workspace again{workspace.document.types(), workspace.assets, workspace.project};
        ASSERT_TRUE(again.open(kScene).ok());
        again.safety.begin();
        ASSERT_LE(again.safety.lost().size(), 1u);
        if (!again.safety.lost().empty()) {
            ASSERT_EQ(again.safety.lost()[0].scene, kScene);
            ASSERT_TRUE(again.safety.recover(0).ok());
            EXPECT_TRUE(again.unsaved());
            ASSERT_TRUE(hashOfFile() == saved || hashOfFile() == saving) << "recovering wrote into the file";
            ++recovered;
        }
        const std::uint64_t has = hashText(again.text());
        Note known{Note::Text, 0, 0.0, before};
        for (const Note& note : notes) {
            if (note.kind == Note::Text && note.hash == has) known = note;
        }
        ASSERT_EQ(known.hash, has) << "what was recovered never was";
        const std::size_t lost = last.action - known.action;
        EXPECT_TRUE(lost <= 20 || last.seconds - known.seconds <= 5.0) << lost << " actions are lost";
        most = std::max(most, lost);
        ASSERT_TRUE(again.save().ok());
        Workspace third{workspace.document.types(), workspace.assets, workspace.project};
        third.safety.begin();
        EXPECT_TRUE(third.safety.lost().empty()) << "it is offered once";
        workspace.safety.takeTheirs();
    }
    EXPECT_GT(recovered, static_cast<std::size_t>(kills) / 2);
    std::printf("%d kills: %zu with work to recover, at most %zu actions lost\n", kills, recovered, most);
}

}  // namespace
}  // namespace plumb::editor::ui

#endif
