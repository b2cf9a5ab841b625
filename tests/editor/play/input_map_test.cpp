#include <imgui.h>

#include "app/project.hpp"
#include "ecs/world.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/input_map_edit.hpp"
#include "gameplay/components/controls/toggle_key.hpp"
#include "input/input.hpp"
#include "reflect/json_text.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kProject = R"({
  "name": "Test",
  "ours": [1, 2],
  "input": {
    "actions": {
      "Dash": ["X", "Pad B"],
      "Jump": ["Space"]
    }
  },
  "version": "1.0.0"
}
)";

using Kind = InputMapEdit::Kind;

class InputMapTest : public EditorFixture {
protected:
    InputMapTest() {
        putFile("project.json", kProject);
        edit.refresh();
    }
    [[nodiscard]] std::vector<std::string> keysOf(const InputMapEdit::Place& place) {
        edit.refresh();
        std::vector<std::string> texts;
        for (const InputMapEdit::Row& row : edit.rows()) {
            if (row.kind != place.kind || row.name != place.name) continue;
            for (const InputMapEdit::Part& part : row.parts) {
                if (part.key != place.part) continue;
                for (const Binding binding : part.bindings) texts.push_back(toText(binding));
            }
        }
        return texts;
    }
    [[nodiscard]] bool has(std::string_view name) {
        edit.refresh();
        for (const InputMapEdit::Row& row : edit.rows()) {
            if (row.name == name) return true;
        }
        return false;
    }
    [[nodiscard]] std::string file() const { return fileText("project.json"); }

    using Texts = std::vector<std::string>;
    const InputMapEdit::Place dash{Kind::Action, "Dash", ""};
    InputMapEdit edit{workspace};
};

TEST_F(InputMapTest, theFileIsReadOnTopOfTheDefaultActions) {
    EXPECT_EQ(keysOf(dash), (Texts{"X", "Pad B"}));
    EXPECT_EQ(keysOf({Kind::Action, "Jump", ""}), Texts{"Space"});
    EXPECT_EQ(keysOf({Kind::Axis, "Horizontal", "analog"}), Texts{"Pad LeftX"});
    for (const InputMapEdit::Row& row : edit.rows())
        EXPECT_EQ(row.ofProject, row.name == "Dash" || row.name == "Jump") << row.name;
}

TEST_F(InputMapTest, addingAndRemovingAKeyIsOneStepEachAndKeepsTheRestOfTheFile) {
    ASSERT_TRUE(edit.bind(dash, *bindingFromText("Mouse Right")).ok());
    EXPECT_EQ(keysOf(dash), (Texts{"X", "Pad B", "Mouse Right"}));
    std::string wanted{kProject};
    wanted.replace(wanted.find("\"Pad B\""), 7, "\"Pad B\", \"Mouse Right\"");
    EXPECT_EQ(file(), wanted);
    ASSERT_TRUE(edit.unbind(dash, 0).ok());
    EXPECT_EQ(keysOf(dash), (Texts{"Pad B", "Mouse Right"}));
    EXPECT_EQ(workspace.undo.size(), 2u);
    workspace.undo.undo();
    EXPECT_EQ(file(), wanted);
    workspace.undo.undo();
    EXPECT_EQ(file(), kProject);
    workspace.undo.redo();
    EXPECT_EQ(file(), wanted);
    const Result<Project> project = loadProject(workspace.project.root);
    ASSERT_TRUE(project.ok());
    ASSERT_EQ(project->warnings.size(), 1u);
    EXPECT_EQ(project->warnings.front().where, "project.json: ours") << "kept, but not a key of projects";
    EXPECT_EQ(project->actions.actions[static_cast<std::size_t>(project->actions.find(plumb::Action{"Dash"}))]
                  .bindings.size(),
              3u);
}

TEST_F(InputMapTest, isAFileOfItsOwnSoThatTheSceneIsAsSavedAsItWas) {
    ASSERT_TRUE(edit.bind(dash, *bindingFromText("Q")).ok());
    EXPECT_FALSE(workspace.unsaved()) << "the scene has not changed";
    EXPECT_EQ(workspace.undo.savedPosition(), 1u) << "the history says so too";
    ASSERT_TRUE(edit.rename(Kind::Action, "Dash", "Rush").ok());
    EXPECT_FALSE(workspace.unsaved());
    runAction(workspace, "entity.create");
    EXPECT_TRUE(workspace.unsaved());
    ASSERT_TRUE(edit.bind({Kind::Action, "Rush", ""}, *bindingFromText("K")).ok());
    EXPECT_TRUE(workspace.unsaved()) << "nor is what is changed saved by it";

    for (const std::size_t back : {3u, 2u, 1u, 0u}) {
        workspace.undo.undo();
        EXPECT_EQ(workspace.undo.size(), back);
        EXPECT_EQ(workspace.unsaved(), back > 2) << back;
    }
    workspace.undo.jumpTo(2);
    EXPECT_FALSE(workspace.unsaved());
    workspace.undo.jumpTo(4);
    EXPECT_TRUE(workspace.unsaved());
    ASSERT_TRUE(workspace.save().ok());
    workspace.undo.undo();
    EXPECT_FALSE(workspace.unsaved());
    workspace.undo.undo();
    EXPECT_TRUE(workspace.unsaved());
}

TEST_F(InputMapTest, theFilesOfOurProjectsAreWrittenAsTheyAre) {
    for (const char* name : {"platformer", "physics-playground"}) {
        const Path path = test::sourceFolder() / "projects" / name / "project.json";
        const std::string text = *readFile(path);
        EXPECT_EQ(writeJson(*parseJson(text, name)), text) << "a change of one key would change other lines";
    }
}

TEST_F(InputMapTest, changedDefaultActionsAreStoredInTheProject) {
    const InputMapEdit::Place left{Kind::Axis, "Horizontal", "negative"};
    ASSERT_TRUE(edit.unbind(left, 1).ok());
    EXPECT_EQ(keysOf(left), (Texts{"Left", "Pad Left"}));
    EXPECT_EQ(keysOf({Kind::Axis, "Horizontal", "positive"}), (Texts{"Right", "D", "Pad Right"}));
    EXPECT_FALSE(edit.rename(Kind::Axis, "Horizontal", "Sideways").ok()) << "games ask for it by this name";
    ASSERT_TRUE(edit.remove(Kind::Axis, "Horizontal").ok());
    EXPECT_EQ(keysOf(left), (Texts{"Left", "A", "Pad Left"})) << "as every game has it";
    EXPECT_FALSE(edit.remove(Kind::Axis, "Horizontal").ok());
}

TEST_F(InputMapTest, actionsAndAxesAreAddedRenamedAndRemoved) {
    ASSERT_TRUE(edit.add(Kind::Action, "Hook").ok());
    ASSERT_TRUE(edit.add(Kind::Axis, "Aim").ok());
    for (const char* wrong : {"", "Hook", " Hook", "Jump"})
        EXPECT_FALSE(edit.add(Kind::Action, wrong).ok()) << wrong;
    const InputMapEdit::Place aim{Kind::Axis, "Aim", "analog"};
    ASSERT_TRUE(edit.bind(aim, *bindingFromText("Pad RightX+")).ok());
    EXPECT_EQ(keysOf(aim), Texts{"Pad RightX"}) << "the whole stick";
    EXPECT_FALSE(edit.bind(aim, *bindingFromText("Pad RightX")).ok()) << "it has it";

    const std::string before = file();
    ASSERT_TRUE(edit.rename(Kind::Action, "Dash", "Rush").ok());
    EXPECT_EQ(workspace.notice, "Renamed Dash to Rush; no scene or prefab references it");
    EXPECT_TRUE(has("Rush"));
    EXPECT_FALSE(has("Dash"));
    EXPECT_LT(file().find("Rush"), file().find("Jump")) << "at its place";
    workspace.undo.undo();
    EXPECT_EQ(file(), before);
    ASSERT_TRUE(edit.remove(Kind::Action, "Hook").ok());
    EXPECT_FALSE(has("Hook"));
}

constexpr std::string_view kMenu = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": [
    {"id": "0000000000000001", "name": "Dash", "components": {"SceneKey": {"action": "Dash"},
     "MenuItem": {"action": "Close"}, "Label": {"text": "Dash"}}},
    {"id": "0000000000000002", "prefab": "prefabs/bomb.prefab.json",
     "children": {"000000000000000a": {"components": {"ToggleKey": {"action": "Dash"}}}}}
  ]
})";
constexpr std::string_view kBomb =
    R"({"format": 1, "entities": [{"id": "0000000000000001", "components": {"Transform": {},
        "Detonator": {"action": "Dash"}}}, {"id": "000000000000000a", "components": {"ToggleKey": {}}}]})";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

TEST_F(InputMapTest, renamingAnActionRenamesItWhereverItIsNamedAndUndoGivesTheBytesBack) {
    putFile("scenes/menu.scene.json", kMenu);
    putFile("prefabs/bomb.prefab.json", kBomb);
    workspace.document.world.add<ToggleKey>(workspace.document.find(named("crate"))).action =
        workspace.document.world.texts().add("Dash");
    const auto inWorld = [&] {
        const World& world = workspace.document.world;
        return world.texts().find(world.get<ToggleKey>(workspace.document.find(named("crate"))).action);
    };
    const std::string project = file();
    ASSERT_TRUE(edit.rename(Kind::Action, "Dash", "Rush").ok());
    EXPECT_EQ(workspace.notice, "Renamed Dash to Rush, also in 3 places of 2 files; press Ctrl+Z to undo");
    EXPECT_EQ(fileText("scenes/menu.scene.json"),
              replaced(std::string{kMenu}, R"("action": "Dash")", R"("action": "Rush")"));
    EXPECT_EQ(fileText("prefabs/bomb.prefab.json"), replaced(std::string{kBomb}, "Dash", "Rush"));
    EXPECT_EQ(inWorld(), "Rush") << "also what is not saved yet";
    EXPECT_EQ(workspace.undo.size(), 1u);
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(fileText("scenes/menu.scene.json"), kMenu);
    EXPECT_EQ(fileText("prefabs/bomb.prefab.json"), kBomb);
    EXPECT_EQ(file(), project);
    EXPECT_EQ(inWorld(), "Dash");
    ASSERT_TRUE(workspace.undo.redo());
    EXPECT_NE(fileText("prefabs/bomb.prefab.json"), kBomb);
    EXPECT_EQ(inWorld(), "Rush");
}

TEST_F(InputMapTest, theOpenSceneIsRenamedInItsFileToo) {
    putFile("scenes/menu.scene.json", kMenu);
    putFile("prefabs/bomb.prefab.json", kBomb);
    ASSERT_TRUE(workspace.open("scenes/menu.scene.json").ok());
    workspace.safety.begin();
    ASSERT_TRUE(edit.rename(Kind::Action, "Dash", "Rush").ok());
    workspace.safety.lookAtFile();
    EXPECT_EQ(workspace.safety.onDisk(), FileWatch::State::Same) << "nothing else has changed it";
    EXPECT_EQ(workspace.text().find(R"("action": "Dash")"), std::string::npos);
    EXPECT_NE(workspace.text().find(R"("text": "Dash")"), std::string::npos) << "what only says so stays";
}

TEST_F(InputMapTest, renamingIsAllOrNothing) {
    putFile("scenes/menu.scene.json", kMenu);
    putFile("prefabs/bomb.prefab.json", kBomb);
    const std::string project = file();
    // Writing the last file fails, because a folder has the name of its temporary file.
    std::filesystem::create_directories(workspace.project.root / "prefabs/bomb.prefab.json.tmp~/x");
    const Result<Done> renamed = edit.rename(Kind::Action, "Dash", "Rush");
    EXPECT_FALSE(renamed.ok());
    EXPECT_EQ(file(), project);
    EXPECT_EQ(fileText("prefabs/bomb.prefab.json"), kBomb);
    EXPECT_EQ(fileText("scenes/menu.scene.json"), kMenu);
}

/// Game state: number of ticks in which the action Dash was held.
struct Hits {
    int count = 0;
    void addTo(Hasher& hasher) const { hasher.add(static_cast<std::uint64_t>(count)); }
};
class KeysGame final : public PlaySession {
public:
    KeysGame() : world_{types_} { world_.resource<Input>(); }
    [[nodiscard]] World& world() override { return world_; }
    void tick(const InputFrame& input) override {
        auto& now = world_.resource<Input>();
        now.advance(input);
        if (now.isHeld(plumb::Action{"Dash"})) ++world_.resource<Hits>().count;
        ++world_.tick;
    }

private:
    TypeRegistry types_ = engineTypes();
    World world_;
};

TEST_F(InputMapTest, newKeysApplyToTheRunningGameAndRecordedTicksKeepTheOldOnes) {
    workspace.makeSession = [](const std::string&, const std::string&) {
        return std::make_unique<KeysGame>();
    };
    workspace.startPlaying(true);
    const auto hits = [&] { return workspace.play.world().resource<Hits>().count; };
    InputFrame held;
    held.set(Key::Q, true);
    const auto play = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) workspace.play.step(held);
    };
    play(20);
    EXPECT_EQ(hits(), 0) << "Q means nothing yet";
    ASSERT_TRUE(edit.bind(dash, *bindingFromText("Q")).ok());
    play(20);
    EXPECT_EQ(hits(), 20) << "from the next tick on";
    workspace.play.seek(18);
    EXPECT_EQ(hits(), 0);
    workspace.play.seek(25);
    EXPECT_EQ(hits(), 5) << "the past is what it was";
    workspace.play.seek(38);
    EXPECT_EQ(hits(), 18);
    workspace.play.seek(10);
    workspace.play.setPaused(false);  // continues from tick 10, which discards the later ticks
    workspace.update(0.0);
    play(5);
    EXPECT_EQ(hits(), 5) << "with the keys of now";
    workspace.play.seek(10);
    EXPECT_EQ(hits(), 0);
    workspace.play.seek(15);
    EXPECT_EQ(hits(), 5);
    workspace.stopPlaying();
    EXPECT_TRUE(workspace.offeredChanges.empty()) << "they are in project.json, not in the scene";
    EXPECT_FALSE(edit.rename(Kind::Action, "Stranger", "Else").ok());
}

TEST_F(InputMapTest, otherActionsOfTheSameKeyAreNamed) {
    ASSERT_TRUE(edit.bind(dash, *bindingFromText("W")).ok());
    EXPECT_EQ(edit.othersOf(*bindingFromText("W"), dash), Texts{"Vertical, negative"});
    EXPECT_EQ(edit.othersOf(*bindingFromText("X"), dash), Texts{"Attack"});
    EXPECT_TRUE(edit.othersOf(*bindingFromText("Pad B"), {Kind::Action, "Cancel", ""}) == Texts{"Dash"});
    EXPECT_GT(edit.shared(), 2u);
}

TEST_F(InputMapTest, aBrokenFileIsReportedAndNotOverwritten) {
    putFile("project.json", "{ \"input\": ");
    EXPECT_FALSE(edit.refresh().empty());
    EXPECT_TRUE(edit.rows().empty());
    EXPECT_FALSE(edit.bind(dash, *bindingFromText("W")).ok());
    EXPECT_FALSE(edit.add(Kind::Action, "Hook").ok());
    EXPECT_EQ(file(), "{ \"input\": ");
    putFile("project.json", R"({"input": {"actions": {"Dash": ["Spacce"]}}})");
    EXPECT_NE(edit.refresh().find("Space"), std::string::npos) << "did you mean";
}

TEST_F(InputMapTest, eventsOfAllDevicesAreBindings) {
    const auto text = [](const Event& event) {
        const auto binding = bindingOf(event);
        return binding ? toText(*binding) : "";
    };
    EXPECT_EQ(text({.kind = EventKind::KeyDown, .key = Key::Escape}), "Escape");
    EXPECT_EQ(text({.kind = EventKind::KeyDown, .key = Key::A, .repeated = true}), "");
    EXPECT_EQ(text({.kind = EventKind::KeyUp, .key = Key::A}), "");
    EXPECT_EQ(text({.kind = EventKind::MouseDown, .mouseButton = MouseButton::Right}), "Mouse Right");
    EXPECT_EQ(text({.kind = EventKind::PadDown, .padButton = PadButton::Y}), "Pad Y");
    EXPECT_EQ(text({.kind = EventKind::PadAxisMoved, .padAxis = PadAxis::RightX, .value = -0.9f}),
              "Pad RightX-");
    EXPECT_EQ(text({.kind = EventKind::PadAxisMoved, .padAxis = PadAxis::RightX, .value = 0.2f}), "");
}

class InputPanelTest : public InputMapTest {
protected:
    InputPanelTest() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        // A tall pane in which all rows are visible.
        workspace.settings.layout.move("Input", Dock::Right);
        workspace.settings.layout.resize(Edge::Right, 0.5f);
        hands.rest(2);
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(InputPanelTest, aKeyIsPressedForAnAction) {
    hands.click("Input/Dash/press");
    hands.rest(2);
    hands.key(Key::Escape);
    hands.rest(2);
    EXPECT_EQ(keysOf(dash), (Texts{"X", "Pad B", "Escape"})) << "Escape is a key too";
    EXPECT_EQ(window.widgets().find("Input/field"), nullptr);
    hands.click("Input/Dash/press");
    hands.rest(2);
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(keysOf(dash), (Texts{"X", "Pad B", "Escape", "Z"})) << "and no shortcut acts meanwhile";
    hands.rest(2);
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(keysOf(dash), (Texts{"X", "Pad B", "Escape"}));
}

TEST_F(InputPanelTest, aMouseButtonIsBoundByPressingItInTheFieldAndCancelBindsNothing) {
    hands.click("Input/Dash/press");
    hands.rest(2);
    hands.clickAt(hands.middleOf("Input/field"), MouseButton::Right);
    EXPECT_EQ(keysOf(dash).back(), "Mouse Right");
    hands.rest(2);
    hands.click("Input/Dash/press");
    hands.rest(2);
    hands.click("Input/cancel");
    EXPECT_EQ(keysOf(dash).size(), 3u);
    hands.rest(2);
    hands.key(Key::W);
    EXPECT_EQ(keysOf(dash).size(), 3u);
    EXPECT_EQ(workspace.toolIndex(), 1u) << "W is the tool again";
}

TEST_F(InputPanelTest, keysAreRemovedAndSelectedFromLists) {
    EXPECT_NE(window.widgets().find("Input/Dash/X")->value.find("Attack"), std::string::npos);
    hands.click("Input/Dash/X/remove");
    EXPECT_EQ(keysOf(dash), Texts{"Pad B"});
    hands.click("Input/Dash/list");
    hands.rest(2);
    hands.click("Input/list/Gamepad");
    hands.rest(2);
    hands.click("Input/list/Pad LeftShoulder");
    EXPECT_EQ(keysOf(dash), (Texts{"Pad B", "Pad LeftShoulder"}));
}

TEST_F(InputPanelTest, anActionIsAddedAndRenamed) {
    hands.click("Input/Add action...");
    hands.rest(2);
    hands.type("Jump");
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_NE(window.widgets().find("Input/add"), nullptr) << "there is one of this name";
    hands.key(Key::A, {.control = true});
    hands.type("Hook");
    hands.click("Input/add");
    EXPECT_TRUE(has("Hook"));
    hands.rest(2);
    hands.clickAt(hands.middleOf("Input/Dash"), MouseButton::Right);
    hands.rest(2);
    hands.click("Input/menu/Rename");
    hands.rest(2);
    hands.key(Key::A, {.control = true});
    hands.type("Rush");
    hands.key(Key::Enter);
    EXPECT_TRUE(has("Rush"));
    EXPECT_FALSE(has("Dash"));
}

}  // namespace
}  // namespace plumb::editor
