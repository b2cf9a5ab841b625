// A prefab file does not store the position of its root entity, so nothing in the editor may move it.

#include "editor/model/document/root_place.hpp"

#include "editor/model/actions.hpp"
#include "editor/model/arrange.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/edit_fields.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/model/tools/shape_handles.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

/// The player with its lamp as a prefab, opened for editing.
class RootPlace : public EditorFixture {
protected:
    RootPlace() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        EXPECT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
        EXPECT_TRUE(workspace.save().ok());
        EXPECT_TRUE(editPrefab(workspace, prefabPath("hero")).ok());
        hands.rest(3);
    }
    [[nodiscard]] ObjectId root() const { return prefabRootOf(workspace.document); }
    [[nodiscard]] const Transform& placeOf(ObjectId id) const {
        return std::as_const(workspace.document.world).get<Transform>(workspace.document.find(id));
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const ui::WidgetMap::Widget* found = window.widgets().find(widget);
        return found == nullptr ? std::string{"none"} : found->value;
    }
    [[nodiscard]] Vec2 onScreen(Vec2 world) const {
        return window.widgets().find("Viewport")->box.min + workspace.view.toScreenPoint(world);
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(RootPlace, isNotShownInTheInspector) {
    ASSERT_EQ(workspace.document.selection.all(), std::vector{root()});
    EXPECT_EQ(valueOf("Inspector/Transform/position"), "stays");
    EXPECT_EQ(valueOf("Inspector/Transform/rotation"), "stays");
    EXPECT_EQ(valueOf("Inspector/Transform/position.x"), "none");
    EXPECT_NE(valueOf("Inspector/Transform/scale.x"), "none");
    workspace.document.selection.set({named("lamp")});
    hands.rest(2);
    EXPECT_EQ(valueOf("Inspector/Transform/position.x"), "10") << "what is below it has a place";
}

TEST_F(RootPlace, isNotMovedByDragsRotationOrArrowKeysAndANoticeExplainsWhy) {
    for (const Key tool : {Key::Q, Key::W, Key::E}) {
        hands.key(tool);
        workspace.document.selection.set({root()});
        hands.drag(onScreen({3.0f, 0.0f}), onScreen({40.0f, 30.0f}));
        EXPECT_EQ(workspace.undo.size(), 0u);
        EXPECT_EQ(placeOf(root()).position, Vec2{});
        if (tool != Key::E) {
            EXPECT_EQ(workspace.notice, kRootCannotMove);
        }
    }
    workspace.notice.clear();
    workspace.document.selection.set({root()});
    hands.key(Key::Right);
    EXPECT_EQ(workspace.notice, kRootCannotMove);
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(RootPlace, isNotMovedByDraggingOrScalingItWithItsChildren) {
    workspace.document.selection.set({named("lamp"), root()});
    const ToolContext context = workspace.tools();
    TransformDrag drag;
    drag.grab(context);
    drag.move(context, {5.0f, 0.0f});
    drag.finish(context);
    EXPECT_EQ(placeOf(root()).position, Vec2{});
    EXPECT_EQ(positionOf(named("lamp")), (Vec2{15.0f, -10.0f}));

    drag.grab(context);
    drag.scale(context, {2.0f, 2.0f});
    drag.finish(context);
    EXPECT_EQ(placeOf(root()).scale, (Vec2{2.0f, 2.0f}));
    EXPECT_EQ(placeOf(root()).position, Vec2{});
    EXPECT_EQ(placeOf(named("lamp")).scale, (Vec2{1.0f, 1.0f})) << "it grew with its parent";
}

TEST_F(RootPlace, isNotWrittenByResettingPastingOrArranging) {
    const TypeInfo& type = workspace.document.types().of<Transform>();
    const Transform pasted{{7.0f, 8.0f}, 1.0f, {3.0f, 3.0f}};
    setComponent(workspace, {root(), named("lamp")}, {&type, FieldValue::of(pasted).bytes}, "paste");
    EXPECT_EQ(placeOf(root()).position, Vec2{});
    EXPECT_EQ(placeOf(root()).rotation, 0.0f);
    EXPECT_EQ(placeOf(root()).scale, (Vec2{3.0f, 3.0f}));
    EXPECT_EQ(placeOf(named("lamp")).position, (Vec2{7.0f, 8.0f}));
    const std::vector<ObjectId> both{root(), named("lamp")};
    editFields(workspace, {type, *type.find("position"), both}, [](FieldValue& value, std::size_t) {
        value = FieldValue::of(Vec2{1.0f, 2.0f});
    });
    EXPECT_EQ(placeOf(root()).position, Vec2{});
    EXPECT_EQ(placeOf(named("lamp")).position, (Vec2{1.0f, 2.0f}));
    EXPECT_EQ(arrangeable(workspace.document, {root(), named("lamp")}), std::vector{named("lamp")});
}

TEST_F(RootPlace, hasNoPivotForTheShapeTool) {
    // The child has a pivot handle, the root has none.
    for (const ObjectId id : {named("lamp"), root()})
        workspace.document.world.add<Sprite>(workspace.document.find(id), Sprite{});
    workspace.document.world.remove<BoxCollider>(workspace.document.find(root()));
    const auto pivots = [&](ObjectId id) {
        const std::vector<ShapeHandle> spots = spotsOf(workspace.document, id);
        return std::count_if(spots.begin(), spots.end(),
                             [](const ShapeHandle& spot) { return spot.kind == ShapeHandleKind::Pivot; });
    };
    EXPECT_EQ(pivots(named("lamp")), 1);
    EXPECT_EQ(pivots(root()), 0);
    hands.key(Key::C);
    workspace.document.selection.set({root()});
    hands.drag(onScreen({0.0f, 0.0f}), onScreen({40.0f, 30.0f}));
    EXPECT_EQ(placeOf(root()).position, Vec2{});
    EXPECT_EQ(workspace.undo.size(), 0u);
    EXPECT_EQ(workspace.notice, kRootCannotMove);
}

}  // namespace
}  // namespace plumb::editor
