// Tests of animation state machines: states, transitions, conditions and parameters, in the model and on the
// page "States".

#include <algorithm>
#include <set>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/machine_preview.hpp"
#include "editor/model/assets/state_machine_edit.hpp"
#include "editor/model/play/game_session.hpp"
#include "scene/components/drawing/animator.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

constexpr const char* kFile = "assets/hero.anim.json";

/// A hero with states for standing, running and falling, and a trigger for being hit.
constexpr const char* kHero = R"({
  "format": 1,
  "clips": [
    {"name": "stand", "loop": "loop", "frames": [{"cell": [0, 0], "seconds": 0.1}, {"cell": [1, 0], "seconds": 0.1}]},
    {"name": "run", "loop": "loop", "frames": [{"cell": [0, 1], "seconds": 0.1}, {"cell": [1, 1], "seconds": 0.1}]},
    {"name": "fall", "loop": "once", "frames": [{"cell": [0, 2], "seconds": 0.1}]}
  ],
  "parameters": [
    {"name": "speed", "kind": "float", "default": 0},
    {"name": "grounded", "kind": "bool", "default": 1},
    {"name": "hit", "kind": "trigger", "default": 0}
  ],
  "states": [
    {"name": "stand", "clip": "stand"},
    {"name": "run", "clip": "run"},
    {"name": "fall", "clip": "fall"}
  ],
  "transitions": [
    {"from": "stand", "to": "run", "when": [{"parameter": "speed", "is": ">", "value": 12}]},
    {"from": "run", "to": "stand", "when": [{"parameter": "speed", "is": "<=", "value": 12}]},
    {"from": "*", "to": "fall", "when": [{"parameter": "grounded", "is": "==", "value": 0}]},
    {"from": "fall", "to": "stand", "when": [], "afterEnd": true}
  ]
})";

class StateMachineEdits : public EditorFixture {
protected:
    StateMachineEdits() {
        putFile(kFile, kHero);
        EXPECT_EQ(file.open(kFile), "");
        before = writeAnimationSet(file.set());
    }
    [[nodiscard]] const AnimationTransition& transition(int index) const {
        return file.set().transitions.at(static_cast<std::size_t>(index));
    }
    [[nodiscard]] std::string when(int index) const { return conditionsText(file.set(), transition(index)); }

    AnimationEdit file{workspace};
    StateMachineEdit edit{file};
    std::string before;
};

TEST_F(StateMachineEdits, addingChangingAndRemovingConditionsIsOneUndoStepEach) {
    edit.addCondition(0, 1);
    EXPECT_EQ(when(0), "speed > 12, grounded is on");
    edit.addCondition(0, 2);
    EXPECT_EQ(when(0), "speed > 12, grounded is on, hit is set");
    edit.setCondition(0, 0, {0, Comparison::GreaterOrEqual, 20.0f});
    edit.setCondition(0, 1, {1, Comparison::Equal, 0.0f});
    EXPECT_EQ(when(0), "speed >= 20, grounded is off, hit is set");
    edit.setCondition(0, 1, {0, Comparison::Equal, 0.0f});
    EXPECT_EQ(when(0), "speed >= 20, speed > 0, hit is set") << "another kind begins anew";
    edit.removeCondition(0, 0);
    edit.setAfterEnd(0, true);
    EXPECT_EQ(when(0), "speed > 0, hit is set, after its end");
    EXPECT_EQ(workspace.undo.size(), 7u);
    workspace.undo.jumpTo(0);
    EXPECT_EQ(fileText(kFile), kHero) << "byte for byte";
}

TEST_F(StateMachineEdits, editsWithoutChangeAreNoUndoStep) {
    edit.setCondition(0, 0, transition(0).when[0]);
    edit.setAfterEnd(3, true);
    edit.renameState(0, "run");
    edit.renameParameter(0, "");
    edit.moveTransition(0, -1);
    edit.beginWith(0);
    edit.addCondition(0, 7);
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(StateMachineEdits, removingAParameterRemovesItsConditions) {
    edit.addCondition(0, 1);
    edit.removeParameter(0);
    EXPECT_EQ(when(0), "grounded is on") << "the later ones still mean what they meant";
    EXPECT_EQ(when(1), "after its end") << "and not at once, which would never rest";
    EXPECT_EQ(when(2), "grounded is off");
    EXPECT_EQ(workspace.notice, "Removed speed and 2 conditions on it");
    workspace.undo.undo();
    workspace.undo.undo();
    EXPECT_EQ(writeAnimationSet(file.set()), before);
}

TEST_F(StateMachineEdits, parametersHaveUniqueNamesAndATypeAndALimitedNumber) {
    edit.addParameter(ParameterKind::Float);
    edit.addParameter(ParameterKind::Float);
    edit.renameParameter(3, "speed");
    EXPECT_EQ(file.set().parameters[3].name, "number") << "that name is taken";
    EXPECT_EQ(file.set().parameters[4].name, "number 2");
    edit.renameParameter(3, "vy");
    edit.setParameter(3, ParameterKind::Bool, 7.0f);
    EXPECT_EQ(file.set().parameters[3], (AnimationParameter{"vy", ParameterKind::Bool, 1.0f}));
    for (int i = 0; i < 9; ++i) edit.addParameter(ParameterKind::Trigger);
    EXPECT_EQ(file.set().parameters.size(), AnimationSet::kMaxParameters);
}

TEST_F(StateMachineEdits, anotherStateCanBeTheInitialOne) {
    edit.beginWith(2);
    EXPECT_EQ(file.set().states[0].name, "fall");
    EXPECT_EQ(file.set().states[1].name, "stand");
    EXPECT_EQ(transitionText(file.set(), transition(0)), "stand to run");
    EXPECT_EQ(transitionText(file.set(), transition(2)), "any to fall");
    EXPECT_EQ(transitionText(file.set(), transition(3)), "fall to stand");
}

TEST_F(StateMachineEdits, thePreviewFollowsEditsFromTheNextFrameOn) {
    MachinePreview preview{workspace.assets};
    preview.show(file.id());
    const auto step = [&] { preview.advance(1.0 / 60.0); };
    step();
    EXPECT_EQ(preview.state(), 0);
    EXPECT_EQ(preview.value(1), 1.0f) << "as it starts";
    preview.setValue(0, 15.0f);
    step();
    EXPECT_EQ(preview.state(), 1);
    ASSERT_NE(preview.frame(), nullptr);
    EXPECT_EQ(preview.frame()->cellY, 1);

    edit.setCondition(1, 0, {0, Comparison::Less, 20.0f});  // the parameter is 15
    step();
    EXPECT_EQ(preview.state(), 0);

    edit.addParameter(ParameterKind::Float, "vy");
    edit.removeParameter(1);
    step();
    EXPECT_EQ(preview.value(0), 15.0f) << "values stay with their names";
    preview.enter(2);
    step();
    EXPECT_EQ(preview.state(), 2);
    preview.restart();
    step();
    EXPECT_EQ(preview.state(), 0);
    EXPECT_EQ(preview.value(0), 0.0f);
}

TEST(GameParameters, areThoseThatSystemsOfTheEngineSet) {
    std::set<std::string> set;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator{test::sourceFolder() / "engine/gameplay"}) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = *readFile(entry.path());
        constexpr std::string_view kCall = "setParameter(world, ";
        for (std::size_t at = text.find(kCall); at != std::string::npos; at = text.find(kCall, at + 1)) {
            const std::size_t comma = text.find(',', at + kCall.size());
            if (text.compare(comma, 3, ", \"") != 0) continue;
            set.insert(text.substr(comma + 3, text.find('"', comma + 3) - comma - 3));
        }
    }
    std::set<std::string> known;
    for (const GameParameter& parameter : gameParameters()) known.insert(std::string{parameter.name});
    EXPECT_EQ(known, set);
}

}  // namespace

namespace ui {
namespace {

class StateMachinePage : public StateMachineEdits {
protected:
    StateMachinePage()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.assetToEdit = kFile;
        hands.rest(3);
        hands.click("Animation/states");
        hands.rest(3);
    }
    [[nodiscard]] const std::string& valueOf(std::string_view widget) const {
        static const std::string none;
        const auto* found = window.widgets().find(widget);
        EXPECT_NE(found, nullptr) << widget;
        return found == nullptr ? none : found->value;
    }
    /// Opens a drop-down list and selects an item.
    void choose(const std::string& list, const std::string& item) {
        hands.click(list);
        hands.rest(2);
        hands.click(list + "/" + item);
        hands.rest(2);
    }
    void enter(std::string_view widget, std::string_view text) {
        hands.click(widget);
        hands.key(Key::A, {.control = true});
        hands.type(text);
        hands.key(Key::Enter);
        hands.rest(2);
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(StateMachinePage, conditionsOfASelectedTransitionAreEdited) {
    hands.click("Animation/arrow/0");
    hands.rest(2);
    EXPECT_EQ(valueOf("Animation/chosen"), "stand to run");
    choose("Animation/addCondition", "grounded");
    EXPECT_EQ(when(0), "speed > 12, grounded is on");
    choose("Animation/when/1/is", "is off");
    EXPECT_EQ(when(0), "speed > 12, grounded is off");
    choose("Animation/when/0/is", "<=");
    EXPECT_EQ(when(0), "speed <= 12, grounded is off");
    hands.enterNumber("Animation/when/0/value", "40");
    hands.rest(2);
    EXPECT_EQ(when(0), "speed <= 40, grounded is off");
    choose("Animation/when/1/parameter", "hit");
    EXPECT_EQ(when(0), "speed <= 40, hit is set");
    hands.click("Animation/when/0/remove");
    hands.rest(2);
    hands.click("Animation/afterEnd");
    hands.rest(2);
    EXPECT_EQ(when(0), "hit is set, after its end");
    EXPECT_NE(fileText(kFile).find(R"("afterEnd": true)"), std::string::npos) << "it is in the file at once";
    EXPECT_EQ(workspace.undo.size(), 7u);
    for (int i = 0; i < 7; ++i) hands.key(Key::Z, {.control = true});
    EXPECT_EQ(fileText(kFile), kHero);
}

TEST_F(StateMachinePage, aDragOfAValueIsOneStep) {
    hands.click("Animation/arrow/0");
    hands.rest(2);
    const Vec2 value = hands.middleOf("Animation/when/0/value");
    hands.drag(value, value + Vec2{30.0f, 0.0f});
    hands.rest(2);
    EXPECT_GT(transition(0).when[0].value, 12.0f);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(StateMachinePage, aTransitionIsDraggedOrSelectedFromAListAndRemoved) {
    hands.drag(hands.middleOf("Animation/state/run"), hands.middleOf("Animation/state/fall"));
    hands.rest(2);
    EXPECT_EQ(valueOf("Animation/chosen"), "run to fall") << "its conditions are what comes next";
    EXPECT_EQ(when(4), "after its end");
    hands.drag(hands.middleOf("Animation/any"), hands.middleOf("Animation/state/stand"));
    hands.rest(2);
    EXPECT_EQ(valueOf("Animation/chosen"), "any to stand");
    hands.click("Animation/remove");
    hands.rest(2);
    EXPECT_EQ(file.set().transitions.size(), 5u);
    hands.click("Animation/state/stand");
    hands.rest(2);
    choose("Animation/to", "fall");
    EXPECT_EQ(valueOf("Animation/chosen"), "stand to fall");
    EXPECT_EQ(transitionText(file.set(), transition(5)), "stand to fall");
}

TEST_F(StateMachinePage, deleteRemovesTheSelectedTransitionNotTheSelectedEntity) {
    workspace.document.selection.set({named("crate")});
    hands.click("Animation/arrow/1");
    hands.rest(2);
    hands.key(Key::Delete);
    hands.rest(2);
    EXPECT_TRUE(named("crate"));
    EXPECT_EQ(file.set().transitions.size(), 3u);
    EXPECT_EQ(window.widgets().find("Animation/chosen"), nullptr) << "and not the next one by a slip";
    hands.click("Scene/crate");
    hands.key(Key::Delete);
    hands.rest(2);
    EXPECT_FALSE(named("crate")) << "in the tree it means what is selected there";
}

TEST_F(StateMachinePage, parametersAreAddedRenamedAndRemoved) {
    choose("Animation/addParameter", "Trigger");
    EXPECT_EQ(valueOf("Animation/chosen"), "Parameter trigger");
    enter("Animation/parameterName", "dash");
    EXPECT_EQ(file.set().findParameter("dash"), 3);
    choose("Animation/parameterKind", "number");
    hands.enterNumber("Animation/initial", "2.5");
    hands.rest(2);
    EXPECT_EQ(file.set().parameters[3], (AnimationParameter{"dash", ParameterKind::Float, 2.5f}));
    choose("Animation/addParameter", "vy");
    EXPECT_NE(valueOf("Animation/asked").find("Vertical velocity"), std::string::npos);
    hands.click("Animation/parameter/speed");
    hands.rest(2);
    hands.click("Animation/remove");
    hands.rest(2);
    EXPECT_EQ(file.set().findParameter("speed"), -1);
    EXPECT_EQ(when(0), "after its end");
}

TEST_F(StateMachinePage, aStateIsRenamedAndGetsAnotherClipAndSpeed) {
    hands.click("Animation/state/fall");
    hands.rest(2);
    enter("Animation/stateName", "drop");
    choose("Animation/stateClip", "run");
    hands.enterNumber("Animation/stateSpeed", "-2");
    hands.rest(2);
    EXPECT_EQ(file.set().states[2], (AnimationState{"drop", 1, -2.0f}));
    hands.click("Animation/begin");
    hands.rest(2);
    EXPECT_EQ(file.set().states[0].name, "drop");
    EXPECT_EQ(valueOf("Animation/chosen"), "State drop");
}

TEST_F(StateMachinePage, theOrderOfTransitionsCanBeChanged) {
    hands.click("Animation/transition/3");
    hands.rest(2);
    hands.click("Animation/earlier");
    hands.rest(2);
    EXPECT_EQ(transitionText(file.set(), transition(2)), "fall to stand");
    EXPECT_EQ(valueOf("Animation/chosen"), "fall to stand") << "it stays in hand";
    hands.click("Animation/later");
    hands.rest(2);
    EXPECT_EQ(transitionText(file.set(), transition(3)), "fall to stand");
}

TEST_F(StateMachinePage, thePreviewFollowsTheParameters) {
    EXPECT_EQ(valueOf("Animation/machine"), "stand");
    hands.click("Animation/now/grounded");
    hands.rest(3);
    EXPECT_EQ(valueOf("Animation/machine"), "fall");
    EXPECT_EQ(workspace.undo.size(), 0u) << "trying is no change of the file";
    hands.click("Animation/now/grounded");
    hands.enterNumber("Animation/now/speed", "30");
    hands.rest(20);
    EXPECT_EQ(valueOf("Animation/machine"), "run");
    hands.click("Animation/arrow/0");
    hands.rest(2);
    hands.enterNumber("Animation/when/0/value", "50");
    hands.click("Animation/machine");
    hands.rest(2);
    EXPECT_EQ(valueOf("Animation/now/speed"), "0") << "a click begins anew";
    hands.enterNumber("Animation/now/speed", "30");
    hands.rest(10);
    EXPECT_EQ(valueOf("Animation/machine"), "stand") << "by the changed condition it takes 50";
}

TEST_F(StateMachinePage, theStateOfARunningGameIsShownWithoutChangingTheFile) {
    const EntityId crate = workspace.document.find(named("crate"));
    workspace.document.world.texts().add(kFile);  // the path by which the scene file references it
    workspace.document.world.add<Sprite>(crate);
    workspace.document.world.add<Animator>(crate, Animator{file.id()});
    workspace.makeSession = [this](const std::string& path, const std::string& text) {
        Project project;
        project.root = workspace.project.root;
        return makeGameSession(project, path, text);
    };
    workspace.settings.keys.bind(*findAction("run.play"), {Key::F12});
    hands.key(Key::F12);
    hands.rest(10);
    ASSERT_TRUE(workspace.play.running());
    World& world = workspace.play.world();
    auto& animator = world.get<Animator>(workspace.play.find(named("crate")));
    ASSERT_EQ(animator.parameters.size(), 3u);
    animator.parameters[0] = 77.0f;
    hands.rest(3);
    EXPECT_EQ(valueOf("Animation/machine"), "run") << "what the game plays, not the preview";
    EXPECT_EQ(valueOf("Animation/now/speed"), "77");
    hands.click("Animation/arrow/0");
    hands.rest(2);
    hands.click("Animation/afterEnd");
    hands.rest(2);
    EXPECT_EQ(workspace.notice, "Stop the game to edit animations (F12)");
    EXPECT_EQ(fileText(kFile), kHero);
}

TEST_F(StateMachinePage, allControlsAreReachableInANarrowPane) {
    workspace.settings.layout.move("Animation", Dock::Right);
    hands.rest(3);
    hands.click("Animation/preview");
    hands.rest(2);
    hands.click("Animation/states");
    hands.rest(2);
    hands.click("Animation/arrow/0");
    hands.rest(2);
    for (const char* part : {"Animation/addState", "Animation/graph", "Animation/remove",
                             "Animation/when/0/remove", "Animation/addParameter"}) {
        const auto* widget = window.widgets().find(part);
        ASSERT_NE(widget, nullptr) << part;
        EXPECT_LE(widget->box.max.x, 1280.0f) << part;
        EXPECT_LE(widget->box.max.y, 720.0f) << part;
    }
    hands.click("Animation/when/0/remove");
    hands.rest(2);
    EXPECT_TRUE(transition(0).when.empty());
}

TEST_F(StateMachinePage, itemsRemovedByUndoAreDeselected) {
    choose("Animation/addParameter", "Number");
    hands.key(Key::Z, {.control = true});
    hands.rest(2);
    EXPECT_EQ(window.widgets().find("Animation/chosen"), nullptr);
    EXPECT_EQ(file.set().parameters.size(), 3u);
}

}  // namespace
}  // namespace ui
}  // namespace plumb::editor
