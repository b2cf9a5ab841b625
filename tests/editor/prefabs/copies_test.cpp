// Order of copies among their siblings, and the notices in the status bar.

#include <algorithm>

#include "core/random.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/tools/select_tool.hpp"
#include "editor/model/tree_edit.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

using Names = std::vector<std::string>;

class Copies : public EditorFixture {
protected:
    /// Names of all entities in file order; those added since the last select() end with an apostrophe.
    [[nodiscard]] Names order() const {
        Names names;
        for (const ObjectId id : workspace.document.objects()) {
            const bool before = std::find(known_.begin(), known_.end(), id) != known_.end();
            names.push_back(workspace.document.nameOf(id) + (before ? "" : "'"));
        }
        return names;
    }
    void select(std::initializer_list<std::string_view> names) {
        std::vector<ObjectId> ids;
        for (const std::string_view name : names) ids.push_back(named(name));
        workspace.document.selection.set(std::move(ids));
        known_ = workspace.document.objects();
    }
    void expectExactUndo(const std::string& before) {
        const std::string after = workspace.text();
        const std::vector<ObjectId> line = workspace.document.objects();
        ASSERT_TRUE(workspace.undo.undo());
        EXPECT_EQ(workspace.text(), before);
        EXPECT_EQ(workspace.document.objects(), known_);
        ASSERT_TRUE(workspace.undo.redo());
        EXPECT_EQ(workspace.text(), after);
        EXPECT_EQ(workspace.document.objects(), line);
    }

private:
    std::vector<ObjectId> known_;
};

TEST_F(Copies, standBehindTheirOriginalsAndTheChildrenOfThese) {
    select({"player", "sign"});
    ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
    EXPECT_EQ(order(),
              (Names{"camera", "player", "lamp", "player'", "lamp'", "crate", "sign", "sign'", "ground"}));
    expectExactUndo(std::string{kSceneText});
    EXPECT_EQ(workspace.notice, "Duplicated 2 entities and 1 below them");
}

TEST_F(Copies, keepTheirParentAndStandBehindTheirSibling) {
    select({"crate", "sign"});
    ASSERT_TRUE(
        moveInTree(workspace.document, workspace.undo, {named("crate"), named("sign")}, {named("player")}));
    const std::string before = workspace.text();
    select({"crate"});
    ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
    const std::vector<ObjectId> copy = workspace.document.selection.all();
    ASSERT_EQ(copy.size(), 1u);
    EXPECT_EQ(positionOf(copy.front()), positionOf(named("crate")));
    EXPECT_EQ(order(), (Names{"camera", "player", "lamp", "crate", "crate'", "sign", "ground"}));
    expectExactUndo(before);
}

TEST_F(Copies, arePastedBehindTheirOriginalsOrAtTheEndIfTheseAreMissing) {
    select({"crate"});
    ASSERT_TRUE(runAction(workspace, "edit.copy"));
    EXPECT_EQ(workspace.notice, "Copied crate");
    ASSERT_TRUE(runAction(workspace, "edit.paste"));
    EXPECT_EQ(workspace.notice, "Pasted crate");
    EXPECT_EQ(order(), (Names{"camera", "player", "lamp", "crate", "crate'", "sign", "ground"}));
    expectExactUndo(std::string{kSceneText});
    ASSERT_TRUE(workspace.undo.undo());

    select({"crate"});
    ASSERT_TRUE(runAction(workspace, "edit.cut"));
    EXPECT_EQ(workspace.notice, "Cut crate");
    ASSERT_TRUE(runAction(workspace, "edit.paste"));
    EXPECT_EQ(order(), (Names{"camera", "player", "lamp", "sign", "ground", "crate'"}));
}

TEST_F(Copies, ofInstancesAndOfTheirPartsStandBehindTheInstance) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    const std::string before = workspace.text();
    select({"player"});
    ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
    const std::string after = workspace.text();
    const std::size_t copy = after.rfind("hero.prefab.json");
    EXPECT_NE(copy, after.find("hero.prefab.json"));
    EXPECT_LT(copy, after.find("\"crate\"")) << "it is written between its original and what followed";
    expectExactUndo(before);
    ASSERT_TRUE(workspace.undo.undo());

    select({"lamp"});
    ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
    EXPECT_LT(workspace.text().find("\"lamp\""), workspace.text().find("\"crate\""));
    expectExactUndo(before);
}

TEST_F(Copies, thatAreDraggedWithAltStandBehindTheirOriginals) {
    select({"crate"});
    SelectTool tool;
    const ToolContext context = workspace.tools();
    const Modifiers alt{false, false, true};
    tool.press(context, {.position = {210.0f, 70.0f}, .modifiers = alt});
    for (const float x : {230.0f, 260.0f}) tool.drag(context, {.position = {x, 70.0f}, .modifiers = alt});
    tool.release(context, {.position = {260.0f, 70.0f}, .modifiers = alt});
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_EQ(order(), (Names{"camera", "player", "lamp", "crate", "crate'", "sign", "ground"}));
    EXPECT_EQ(positionOf(workspace.document.selection.all().front()), (Vec2{250.0f, 64.0f}));
    expectExactUndo(std::string{kSceneText});
}

TEST_F(Copies, propertyUndoAndRedoOfAnyCopiesAreExact) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    Random random = Random::seeded(5);
    std::vector<std::string> texts{workspace.text()};
    const std::size_t first = workspace.undo.size();
    for (int i = 0; i < 40; ++i) {
        const std::vector<ObjectId> all = workspace.document.objects();
        std::vector<ObjectId> some;
        for (std::uint32_t n = 0; n <= random.below(3); ++n)
            some.push_back(all[random.below(static_cast<std::uint32_t>(all.size()))]);
        std::sort(some.begin(), some.end());
        some.erase(std::unique(some.begin(), some.end()), some.end());
        workspace.document.selection.set(some);
        if (i % 3 == 0 && moveInTree(workspace.document, workspace.undo, some, {}))
            texts.push_back(workspace.text());
        if (i % 2 == 0) {
            ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
        } else {
            ASSERT_TRUE(runAction(workspace, "edit.copy"));
            ASSERT_TRUE(runAction(workspace, "edit.paste"));
        }
        texts.push_back(workspace.text());
        ASSERT_EQ(workspace.undo.size(), first + texts.size() - 1) << i;
    }
    for (int round = 0; round < 2; ++round) {
        for (std::size_t step = texts.size(); step-- > 0;) {
            workspace.undo.jumpTo(first + step);
            ASSERT_EQ(workspace.text(), texts[step]) << step;
        }
        for (std::size_t step = 0; step < texts.size(); ++step) {
            workspace.undo.jumpTo(first + step);
            ASSERT_EQ(workspace.text(), texts[step]) << step;
        }
    }
}

/// Notices in the status bar.
class StatusNews : public EditorFixture {
protected:
    StatusNews() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}
    [[nodiscard]] std::string notice() {
        hands.rest();
        return window.widgets().find("Status/notice")->value;
    }
    [[nodiscard]] Vec2 onScreen(Vec2 world) {
        return window.widgets().find("Viewport")->box.min + workspace.view.toScreenPoint(world);
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(StatusNews, sayWhatWasDoneLast) {
    workspace.document.selection.set({named("player")});
    hands.key(Key::D, {.control = true});
    EXPECT_EQ(notice(), "Duplicated player and 1 below it");
    hands.key(Key::Delete);
    EXPECT_EQ(notice(), "Deleted player and 1 below it");
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(notice(), "Undid: delete entity");

    workspace.document.selection.set({named("crate")});
    hands.key(Key::Right);
    EXPECT_EQ(notice(), "Did: move crate") << "what has no word of its own is named by its step";
    hands.key(Key::D, {.control = true});
    hands.key(Key::D, {.control = true});
    EXPECT_EQ(notice(), "Duplicated crate");
}

TEST_F(StatusNews, sayThatACopyWasDraggedAndKeepTheHintsOfTileTools) {
    workspace.document.selection.set({named("crate")});
    hands.key(Key::Right);
    hands.held = {.alt = true};
    hands.drag(onScreen({215.0f, 80.0f}), onScreen({255.0f, 80.0f}));
    hands.held = {};
    EXPECT_EQ(notice(), "Did: drag a copy (crate)");
    hands.key(Key::B);
    const std::string hint = notice();
    EXPECT_EQ(hint.find("Brush: "), 0u);
    workspace.undo.push(createEntity(workspace.document, "new", {}));
    workspace.undo.endGesture();
    EXPECT_EQ(notice(), hint);
}

TEST_F(StatusNews, countThePartsOfPrefabsEverywhere) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    ASSERT_TRUE(workspace.save().ok());
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(notice(), "Opened scenes/level.scene.json: 6 entities");
    EXPECT_NE(window.widgets().find("Status/state")->value.find("0 of 6 selected"), std::string::npos);
}

}  // namespace
}  // namespace plumb::editor
