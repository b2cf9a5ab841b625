// Random actions on real projects: the editor must not crash, undoing everything must restore the file byte
// for byte, and redoing everything must restore the edited text. PLUMB_MONKEY is the number of actions for
// each project, PLUMB_MONKEY_SEED the first seed. A failure prints its seed and the shortest sequence of
// actions found.

#include "tests/editor/support/monkey.hpp"

#include <numeric>

#include "tests/editor/support/monkey_life.hpp"
#include "tests/editor/support/project_copy.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

constexpr int kActionsOfOneLife = 2500;
constexpr double kShrinkSeconds = 120.0;

/// Returns a readable description of the first difference of two texts.
std::string difference(const std::string& wanted, const std::string& found) {
    const auto size = std::min(wanted.size(), found.size());
    const auto at = static_cast<std::size_t>(
        std::mismatch(wanted.begin(), wanted.begin() + static_cast<std::ptrdiff_t>(size), found.begin())
            .first -
        wanted.begin());
    const std::size_t from = at > 200 ? at - 200 : 0;
    return format("\nwanted: ...{}\nfound: ...{}", wanted.substr(from, 300), found.substr(from, 300));
}

/// Checks undo and redo of the whole history against the text of the scene before its first change.
class Beginning {
public:
    explicit Beginning(Workspace& workspace) : workspace_{workspace} { look(); }
    /// Must be called after each action: if another scene was opened, its text is the new reference.
    void look() {
        const UndoStack& undo = workspace_.undo;
        if (undo.total() == 0 || undo.cleared() != cleared_) {
            cleared_ = undo.cleared();
            known_ = undo.total() == 0;
            if (known_) text_ = workspace_.text();
        }
    }
    /// @return description of the failure after undoing and redoing everything; empty on success
    std::string undoneAndRedone() {
        if (workspace_.document.scenePath.empty()) return {};
        UndoStack& undo = workspace_.undo;
        const std::size_t position = undo.size();
        const std::string after = workspace_.text();
        undo.jumpTo(0);
        const std::string start = workspace_.text();
        if (known_ && start != text_) return "undoing everything" + difference(text_, start);
        undo.jumpTo(undo.total());
        undo.jumpTo(0);
        if (workspace_.text() != start)
            return "undoing everything again" + difference(start, workspace_.text());
        undo.jumpTo(position);
        if (workspace_.text() != after) return "redoing everything" + difference(after, workspace_.text());
        return {};
    }

private:
    Workspace& workspace_;
    std::string text_;
    std::size_t cleared_ = 0;
    bool known_ = false;
};

/// A copy of a real project with an editor window and a Monkey that acts in it.
class Cage {
public:
    Cage(const std::string& project, std::string_view scene, std::uint64_t seed)
        : scene_{format("scenes/{}.scene.json", scene)},
          copy_{project, scene},
          monkey_{workspace(), window_, seed},
          beginning_{workspace()} {
        workspace().assets.logging = false;
    }
    /// Performs action number `number`. @return its description
    std::string act(std::uint64_t number) {
        const std::uint64_t before = workspace().document.sceneRevision;
        std::string what = monkey_.act(number);
        changes_ += workspace().document.sceneRevision != before ? 1 : 0;
        plays_ += workspace().play.running() && workspace().play.ticks() > 0 ? 1 : 0;
        beginning_.look();
        if (workspace().document.objectCount() > 400) workspace().undo.jumpTo(workspace().undo.size() / 2);
        return what;
    }
    std::string check() {
        monkey_.calm();
        beginning_.look();
        return beginning_.undoneAndRedone();
    }
    void startOver() { static_cast<void>(workspace().open(scene_).ok()), beginning_.look(); }
    [[nodiscard]] bool lostTheScene() { return workspace().document.scenePath.empty(); }
    /// @return failure message if the actions changed or played too little to be a useful test; otherwise
    /// empty
    [[nodiscard]] std::string idle(std::size_t actions) const {
        // Most runs change and play ten times as much, but some unbind keys or stay in a dialog.
        if (changes_ < actions / 25) return format("it hardly changes anything: {} of {}", changes_, actions);
        if (plays_ < actions / 250) return format("it hardly plays: {} of {}", plays_, actions);
        return {};
    }

private:
    Workspace& workspace() { return copy_.workspace(); }

    std::string scene_;
    ProjectCopy copy_;
    LogBook log_;
    EditorWindow window_{copy_.workspace(), log_, nullptr, test::sourceFolder() / "assets/fonts"};
    Monkey monkey_;
    Beginning beginning_;
    std::size_t changes_ = 0, plays_ = 0;
};

std::string live(const std::string& project, std::string_view scene, std::uint64_t seed,
                 const std::vector<std::uint64_t>& numbers, const test::Lives::Tell& tell) {
    setLogSink([](const LogLine&) {});
    Cage cage{project, scene, seed};
    for (const std::uint64_t number : numbers) {
        tell(std::to_string(number));  // reported first, because the action may crash
        const std::string what = cage.act(number);
        tell("  " + what);
        if (number % 250 != 0) continue;
        if (std::string wrong = cage.check(); !wrong.empty()) return wrong;
        if (cage.lostTheScene() || number % 1000 == 0) cage.startOver();
    }
    if (std::string wrong = cage.check(); !wrong.empty()) return wrong;
    return numbers.size() < kActionsOfOneLife ? std::string{} : cage.idle(numbers.size());
}

void letLoose(const std::string& project, std::string_view scene) {
    const int actions = fromEnvironment("PLUMB_MONKEY", 5000);
    auto seed = static_cast<std::uint64_t>(fromEnvironment("PLUMB_MONKEY_SEED", 1));
    for (int done = 0; done < actions; done += kActionsOfOneLife, ++seed) {
        test::Lives lives{
            [&](const auto& numbers, const auto& tell) { return live(project, scene, seed, numbers, tell); }};
        std::vector<std::uint64_t> numbers(static_cast<std::size_t>(std::min(actions, kActionsOfOneLife)));
        std::iota(numbers.begin(), numbers.end(), std::uint64_t{1});
        const std::string wrong = lives.live(numbers);
        if (wrong.empty()) continue;
        const auto fewest = lives.shortest(numbers, kShrinkSeconds);
        const std::string again = lives.live(fewest);
        std::string list;
        for (const std::string& line : lives.report()) list += line + "\n";
        FAIL() << project << " with seed " << seed << ": " << wrong << "\nwith the fewest actions: " << again
               << "\n"
               << list;
    }
}

TEST(Monkey, whateverIsDoneToThePlatformerIsUndoneByteForByte) { letLoose("platformer", "level1"); }

TEST(Monkey, whateverIsDoneToThePlaygroundIsUndoneByteForByte) {
    letLoose("physics-playground", "softbodies");
}

TEST(Monkey, ofManyActionsOnlyThoseAreReportedThatLeadToTheFailure) {
    test::Lives lives{[](const std::vector<std::uint64_t>& numbers, const test::Lives::Tell& tell) {
        bool armed = false;
        for (const std::uint64_t number : numbers) {
            tell(std::to_string(number));
            armed |= number == 17;
            if (armed && number == 61) std::abort();
        }
        return std::string{};
    }};
    std::vector<std::uint64_t> numbers(100);
    std::iota(numbers.begin(), numbers.end(), std::uint64_t{1});
    EXPECT_EQ(lives.live(numbers), "killed by signal 6");
    EXPECT_EQ(lives.shortest(numbers, 30.0), (std::vector<std::uint64_t>{17, 61}));
}

}  // namespace
}  // namespace plumb::editor::ui
