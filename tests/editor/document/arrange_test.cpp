// Aligning and distributing entities, and snapping.

#include "editor/model/arrange.hpp"

#include <algorithm>

#include "core/random.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

class Arranging : public EditorFixture {
protected:
    [[nodiscard]] AABB boxOf(ObjectId id) const {
        return boundsOf(workspace.document.world, workspace.document.find(id));
    }
    [[nodiscard]] std::vector<ObjectId> some() const {
        return {named("crate"), named("player"), named("camera")};
    }
    void scatter(std::uint64_t seed) {
        Random random = Random::seeded(seed);
        World& world = workspace.document.world;
        for (const char* name : {"crate", "player", "camera", "lamp"}) {
            world.get<Transform>(workspace.document.find(named(name))) =
                Transform{{random.between(-300.0f, 300.0f), random.between(-300.0f, 300.0f)},
                          random.between(-1.0f, 1.0f),
                          {random.between(0.5f, 2.0f), random.between(0.5f, 2.0f)}};
        }
    }
};

constexpr const char* kActions[] = {"arrange.left",         "arrange.center",    "arrange.right",
                                    "arrange.top",          "arrange.middle",    "arrange.bottom",
                                    "arrange.spreadAcross", "arrange.spreadDown"};

TEST_F(Arranging, edgesAndCentersAreAligned) {
    struct Case {
        const char* action;
        float (*line)(const AABB&);
    };
    const Case cases[] = {{"arrange.left", [](const AABB& box) { return box.min.x; }},
                          {"arrange.center", [](const AABB& box) { return box.center().x; }},
                          {"arrange.right", [](const AABB& box) { return box.max.x; }},
                          {"arrange.top", [](const AABB& box) { return box.min.y; }},
                          {"arrange.middle", [](const AABB& box) { return box.center().y; }},
                          {"arrange.bottom", [](const AABB& box) { return box.max.y; }}};
    for (const Case& one : cases) {
        SCOPED_TRACE(one.action);
        scatter(3);
        workspace.document.selection.set(some());
        const AABB whole = *boundsOf(workspace.document, some());
        ASSERT_TRUE(runAction(workspace, one.action));
        for (const ObjectId id : some()) EXPECT_NEAR(one.line(boxOf(id)), one.line(whole), 1e-2f);
    }
}

TEST_F(Arranging, gapsBecomeEqualAndTheOuterEntitiesStay) {
    scatter(5);
    workspace.document.selection.set({named("crate"), named("player"), named("camera"), named("sign")});
    const AABB whole = *boundsOf(workspace.document, workspace.document.selection.all());
    ASSERT_TRUE(runAction(workspace, "arrange.spreadAcross"));
    std::vector<AABB> boxes;
    for (const ObjectId id : workspace.document.selection.all()) boxes.push_back(boxOf(id));
    std::sort(boxes.begin(), boxes.end(),
              [](const AABB& a, const AABB& b) { return a.center().x < b.center().x; });
    const float gap = boxes[1].min.x - boxes[0].max.x;
    EXPECT_NEAR(boxes[2].min.x - boxes[1].max.x, gap, 1e-2f);
    EXPECT_NEAR(boxes[3].min.x - boxes[2].max.x, gap, 1e-2f);
    EXPECT_NEAR(boundsOf(workspace.document, workspace.document.selection.all())->min.x, whole.min.x, 1e-2f);
}

TEST_F(Arranging, arrangingTwiceEqualsOnceAndUndoRestoresTheBytes) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        for (const char* action : kActions) {
            SCOPED_TRACE(format("{} {}", seed, action));
            scatter(seed);
            workspace.document.selection.set(some());
            const std::string before = workspace.text();
            const std::size_t steps = workspace.undo.size();
            ASSERT_TRUE(runAction(workspace, action));
            const std::string once = workspace.text();
            const std::size_t after = workspace.undo.size();
            EXPECT_LE(after, steps + 1) << "one step";
            runAction(workspace, action);
            EXPECT_EQ(workspace.text(), once);
            EXPECT_EQ(workspace.undo.size(), after);
            workspace.undo.jumpTo(steps);
            EXPECT_EQ(workspace.text(), before);
        }
    }
}

TEST_F(Arranging, lockedEntitiesStayAndChildrenMoveWithTheirParents) {
    workspace.document.view.setLocked(named("crate"), true);
    const std::vector<ObjectId> ids{named("crate"), named("player"), named("lamp"), named("camera")};
    EXPECT_EQ(arrangeable(workspace.document, ids), (std::vector{named("player"), named("camera")}));
}

// Snapping.

TEST_F(Arranging, thingsSnapToTheGridToHalfOfItOrToPixels) {
    GridSettings& grid = workspace.grid;
    EXPECT_EQ(grid.step(), (Vec2{16.0f, 16.0f}));
    ASSERT_TRUE(runAction(workspace, "view.snapHalf"));
    EXPECT_EQ(grid.step(), (Vec2{8.0f, 8.0f}));
    ASSERT_TRUE(runAction(workspace, "view.snapPixel"));
    EXPECT_EQ(grid.step(), (Vec2{1.0f, 1.0f}));
    grid.snap = false;
    ASSERT_TRUE(runAction(workspace, "view.snapGrid"));
    EXPECT_TRUE(grid.snap) << "a choice of the grid switches snapping on";
    EXPECT_TRUE(isOn(*findAction("view.snapGrid"), workspace));
    EXPECT_FALSE(isOn(*findAction("view.snapHalf"), workspace));
    Pointer pointer;
    pointer.snap = true;
    pointer.grid = {8.0f, 8.0f};
    pointer.position = {13.0f, 2.0f};
    EXPECT_EQ(dragOffset({0.0f, 0.0f}, {0.0f, 0.0f}, pointer), (Vec2{16.0f, 0.0f}));
}

}  // namespace
}  // namespace plumb::editor
