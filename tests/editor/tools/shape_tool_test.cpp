// Dragging the handles of colliders, joint anchors and pivots in the viewport.

#include "editor/model/tools/shape_tool.hpp"

#include <cmath>

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "math/angle.hpp"
#include "scene/components.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

class Shapes : public EditorFixture {
protected:
    Shapes() { workspace.document.selection.set({named("crate")}); }

    [[nodiscard]] World& world() { return workspace.document.world; }
    [[nodiscard]] EntityId crate() const { return workspace.document.find(named("crate")); }
    template <class T>
    [[nodiscard]] const T& of() const {
        return std::as_const(workspace.document.world).get<T>(crate());
    }
    /// Replaces the box collider of the crate by another shape, without an undo step.
    template <class T>
    T& give() {
        world().remove<BoxCollider>(crate());
        start_.clear();
        return world().add<T>(crate());
    }
    [[nodiscard]] std::vector<ShapeHandle> spots() const {
        return spotsOf(workspace.document, named("crate"));
    }
    [[nodiscard]] Vec2 spot(ShapeHandleKind kind, int part) const {
        for (const ShapeHandle& found : spots()) {
            if (found.kind == kind && found.part == part) return found.at;
        }
        ADD_FAILURE() << "no such spot";
        return {};
    }
    void drag(Vec2 from, Vec2 by, Pointer how = {}) {
        if (start_.empty()) start_ = workspace.text();
        for (int i = 0; i <= 8; ++i) {
            how.position = from + by * (static_cast<float>(i) / 8.0f);
            i == 0 ? tool.press(workspace.tools(), how) : tool.drag(workspace.tools(), how);
        }
        tool.release(workspace.tools(), how);
    }
    void click(Vec2 at, Modifiers held = {}) {
        if (start_.empty()) start_ = workspace.text();
        const Pointer pointer{.position = at, .modifiers = held};
        tool.press(workspace.tools(), pointer);
        tool.release(workspace.tools(), pointer);
    }
    void expectStepsAndUndo(std::size_t steps) {
        EXPECT_EQ(workspace.undo.size(), steps);
        const std::string after = workspace.text();
        workspace.undo.jumpTo(0);
        EXPECT_EQ(workspace.text(), start_);
        workspace.undo.jumpTo(steps);
        EXPECT_EQ(workspace.text(), after);
    }

    ShapeTool tool;
    std::string start_;
};

TEST_F(Shapes, draggedCornersAndSidesOfABoxFollowTheMouseAndTheOthersStay) {
    drag({231.0f, 95.0f}, {9.0f, -5.0f});  // lower right corner of the box
    EXPECT_EQ(of<BoxCollider>().width, 40.0f);
    EXPECT_EQ(of<BoxCollider>().height, 26.0f);
    EXPECT_EQ(of<BoxCollider>().offset, Vec2{});
    drag({200.0f, 77.0f}, {-10.0f, 55.0f});  // left side of the box
    EXPECT_EQ(of<BoxCollider>().offset, (Vec2{-10.0f, 0.0f}));
    EXPECT_EQ(of<BoxCollider>().width, 50.0f);
    EXPECT_EQ(of<BoxCollider>().height, 26.0f) << "a side moves one way only";
    drag(spot(ShapeHandleKind::Middle, 8), {3.0f, 4.0f});
    EXPECT_EQ(of<BoxCollider>().offset, (Vec2{-7.0f, 4.0f}));
    EXPECT_EQ(of<Transform>().position, (Vec2{200.0f, 64.0f}));
    expectStepsAndUndo(3);
}

TEST_F(Shapes, aBoxNeverTurnsInsideOut) {
    drag({200.0f, 64.0f}, {500.0f, 500.0f});
    EXPECT_EQ(of<BoxCollider>().width, 1.0f);
    EXPECT_EQ(of<BoxCollider>().offset, (Vec2{30.0f, 30.0f}));
}

TEST_F(Shapes, handlesSnapLikeEverythingElse) {
    drag({231.0f, 95.0f}, {11.0f, 3.0f}, {.snap = true});
    EXPECT_EQ(of<BoxCollider>().width, 40.0f) << "to x = 240";
    EXPECT_EQ(of<BoxCollider>().height, 32.0f) << "to y = 96";
    drag({240.0f, 96.0f}, {1.3f, 0.2f});
    EXPECT_EQ(of<BoxCollider>().width, 41.0f) << "whole pixels";
    drag({241.0f, 96.0f}, {30.0f, 8.0f}, {.modifiers = {.shift = true}});
    EXPECT_EQ(of<BoxCollider>().width, 71.0f);
    EXPECT_EQ(of<BoxCollider>().height, 32.0f) << "Shift keeps to one axis";
}

/// The dragged corner follows the mouse and the opposite corner stays, for any rotation and scale of the
/// entity.
TEST_F(Shapes, anyCornerOfAnyRotatedAndScaledBoxFollowsTheMouse) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        world().get<Transform>(crate()) =
            Transform{{random.between(-200.0f, 200.0f), random.between(-200.0f, 200.0f)},
                      random.between(-3.0f, 3.0f),
                      {random.between(0.3f, 3.0f), random.between(-3.0f, -0.3f)}};
        BoxCollider& box = world().get<BoxCollider>(crate());
        box.offset = {random.between(-20.0f, 20.0f), random.between(-20.0f, 20.0f)};
        box.width = random.between(40.0f, 80.0f);
        box.height = random.between(40.0f, 80.0f);
        const int corner = static_cast<int>(random.below(4)) * 2;
        const Vec2 opposite = spot(ShapeHandleKind::Corner, (corner + 4) % 8);
        const Vec2 from = spot(ShapeHandleKind::Corner, corner);
        const Vec2 by{std::round(random.between(-6.0f, 6.0f)), std::round(random.between(-6.0f, 6.0f))};
        drag(from, by);
        EXPECT_NEAR(distance(spot(ShapeHandleKind::Corner, corner), from + by), 0.0f, 1e-3f);
        EXPECT_NEAR(distance(spot(ShapeHandleKind::Corner, (corner + 4) % 8), opposite), 0.0f, 1e-3f);
    }
}

TEST_F(Shapes, aCircleHasHandlesForRadiusAndCenter) {
    give<CircleCollider>().radius = 10.0f;
    drag({210.0f, 64.0f}, {5.0f, 40.0f});
    EXPECT_EQ(of<CircleCollider>().radius, 15.0f);
    drag({200.0f, 64.0f}, {-4.0f, 2.0f});
    EXPECT_EQ(of<CircleCollider>().offset, (Vec2{-4.0f, 2.0f}));
    expectStepsAndUndo(2);
}

TEST_F(Shapes, aCapsuleIsDraggedByItsBox) {
    give<CapsuleCollider>() = CapsuleCollider{16.0f, 32.0f};
    drag({208.0f, 96.0f}, {0.0f, 8.0f});
    EXPECT_EQ(of<CapsuleCollider>().height, 40.0f);
    EXPECT_EQ(of<CapsuleCollider>().width, 16.0f);
    expectStepsAndUndo(1);
}

class Outlines : public Shapes {
protected:
    Outlines() {
        auto& polygon = give<PolygonCollider>();
        for (const Vec2 point : {Vec2{0.0f, 0.0f}, Vec2{40.0f, 0.0f}, Vec2{40.0f, 40.0f}, Vec2{0.0f, 40.0f}})
            polygon.points.push(point);
    }
    [[nodiscard]] std::vector<Vec2> points() const {
        const auto& polygon = of<PolygonCollider>();
        return {polygon.points.begin(), polygon.points.end()};
    }
};

TEST_F(Outlines, cornersAreDragged) {
    drag({240.0f, 64.0f}, {10.0f, -4.0f});
    EXPECT_EQ(points()[1], (Vec2{50.0f, -4.0f}));
    drag(spot(ShapeHandleKind::Middle, -1), {2.0f, 3.0f});
    EXPECT_EQ(of<PolygonCollider>().offset, (Vec2{2.0f, 3.0f}));
    expectStepsAndUndo(2);
}

TEST_F(Outlines, aPressOnAnEdgeInsertsACornerAndDragsItAsOneStep) {
    drag({220.0f, 64.0f}, {0.0f, -10.0f});
    EXPECT_EQ(points(), (std::vector<Vec2>{
                            {0.0f, 0.0f}, {20.0f, -10.0f}, {40.0f, 0.0f}, {40.0f, 40.0f}, {0.0f, 40.0f}}));
    drag({200.0f, 84.0f}, {-6.0f, 0.0f});
    EXPECT_EQ(points().back(), (Vec2{-6.0f, 20.0f})) << "on the line from the last corner to the first";
    expectStepsAndUndo(2);
}

TEST_F(Outlines, controlClickRemovesACornerButKeepsAtLeastThree) {
    click({240.0f, 64.0f}, {.control = true});
    EXPECT_EQ(points(), (std::vector<Vec2>{{0.0f, 0.0f}, {40.0f, 40.0f}, {0.0f, 40.0f}}));
    click({240.0f, 104.0f}, {.control = true});
    EXPECT_EQ(points().size(), 3u);
    expectStepsAndUndo(1);
}

TEST_F(Outlines, deleteRemovesTheLastDraggedCornerOtherwiseTheEntity) {
    workspace.useTool("tool.shape");
    const Pointer at{.position = {240.0f, 64.0f}};
    workspace.tool().press(workspace.tools(), at);
    workspace.tool().release(workspace.tools(), at);
    const Event del{.kind = EventKind::KeyDown, .key = Key::Delete};
    ASSERT_TRUE(runShortcut(workspace, del));
    EXPECT_EQ(points().size(), 3u);
    ASSERT_TRUE(runShortcut(workspace, del));
    EXPECT_FALSE(named("crate")) << "no corner is chosen any more";
}

TEST_F(Outlines, anOutlineWithTheMaximumOfCornersGetsNoMore) {
    auto& polygon = world().get<PolygonCollider>(crate());
    while (!polygon.points.full()) polygon.points.push({0.0f, 40.0f});
    drag({220.0f, 64.0f}, {0.0f, -10.0f});
    EXPECT_EQ(points().size(), polygon.points.capacity());
}

TEST_F(Outlines, escapeTakesTheDragBack) {
    const std::string before = workspace.text();
    tool.press(workspace.tools(), {.position = {220.0f, 64.0f}});
    tool.drag(workspace.tools(), {.position = {220.0f, 30.0f}});
    EXPECT_TRUE(tool.cancel(workspace.tools()));
    EXPECT_EQ(workspace.text(), before);
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Shapes, anOpenChainHasNoClosingEdge) {
    auto& chain = give<ChainCollider>();
    for (const Vec2 point : {Vec2{0.0f, 0.0f}, Vec2{40.0f, 0.0f}, Vec2{40.0f, 40.0f}})
        chain.points.push(point);
    EXPECT_EQ(edgesOf(workspace.document, named("crate")).size(), 2u);
    chain.loop = true;
    EXPECT_EQ(edgesOf(workspace.document, named("crate")).size(), 3u);
    click({240.0f, 64.0f}, {.control = true});
    EXPECT_EQ(of<ChainCollider>().points.size(), 3u) << "a loop needs three";
    world().get<ChainCollider>(crate()).loop = false;
    click({240.0f, 64.0f}, {.control = true});
    EXPECT_EQ(of<ChainCollider>().points.size(), 2u);
}

TEST_F(Shapes, anchorsOfJointsAreDraggedAtBothEnds) {
    auto& joint = world().add<DistanceJoint>(crate());
    joint.other = workspace.document.find(named("player"));
    joint.anchor = {5.0f, 5.0f};
    joint.otherAnchor = {8.0f, 12.0f};
    drag({205.0f, 69.0f}, {7.0f, 1.0f});
    EXPECT_EQ(of<DistanceJoint>().anchor, (Vec2{12.0f, 6.0f}));
    drag({48.0f, 112.0f}, {2.0f, -2.0f});
    EXPECT_EQ(of<DistanceJoint>().otherAnchor, (Vec2{10.0f, 10.0f})) << "in the other one";
    EXPECT_EQ(of<DistanceJoint>().other, workspace.document.find(named("player")));
    world().get<DistanceJoint>(crate()).autoAnchor = true;
    for (const ShapeHandle& found : spots()) {
        EXPECT_FALSE(found.kind == ShapeHandleKind::Anchor && found.part == 1) << "it follows by itself";
    }
}

/// Dragging the pivot moves the origin of the entity; sprite, colliders and children keep their world
/// positions.
TEST_F(Shapes, movingThePivotKeepsTheSpriteCollidersAndChildrenInPlace) {
    Sprite& sprite = world().add<Sprite>(crate());
    sprite.width = 40;
    sprite.height = 20;
    Document& document = workspace.document;
    const EntityId lamp = document.find(named("lamp"));
    setParent(world(), lamp, crate());
    world().get<Transform>(crate()) = Transform{{200.0f, 64.0f}, 0.5f, {2.0f, 2.0f}};
    const AABB before = boundsOf(world(), crate());
    const Vec2 child = worldPose(world(), lamp).position;
    drag({200.0f, 64.0f}, {10.0f, 20.0f});
    EXPECT_EQ(of<Transform>().position, (Vec2{200.0f, 64.0f})) << "the corner of the box lies over it";
    workspace.undo.jumpTo(0);
    world().get<BoxCollider>(crate()).offset = {4.0f, 3.0f};
    const AABB shown = boundsOf(world(), crate());
    start_.clear();
    drag({200.0f, 64.0f}, {10.0f, 20.0f});
    EXPECT_EQ(of<Transform>().position, (Vec2{210.0f, 84.0f}));
    EXPECT_NE(of<Sprite>().pivot, Vec2{});
    const AABB now = boundsOf(world(), crate());
    EXPECT_NEAR(distance(now.min, shown.min), 0.0f, 1e-3f);
    EXPECT_NEAR(distance(now.max, shown.max), 0.0f, 1e-3f);
    EXPECT_NEAR(distance(worldPose(world(), lamp).position, child), 0.0f, 1e-3f);
    EXPECT_NE(before.min, Vec2{});
    expectStepsAndUndo(1);
}

TEST_F(Shapes, aClickBesideTheHandlesSelects) {
    click({110.0f, 25.0f});
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("sign")});
    workspace.document.selection.set({named("crate")});
    workspace.document.view.setLocked(named("crate"), true);
    drag({231.0f, 95.0f}, {9.0f, -5.0f});
    EXPECT_EQ(of<BoxCollider>().width, 31.0f) << "locked";
}

}  // namespace
}  // namespace plumb::editor
