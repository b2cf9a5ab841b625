// Paths of moving platforms and patrolling walkers are shown and can be dragged like other shapes.

#include <algorithm>

#include "editor/model/actions.hpp"
#include "editor/model/overlays/trajectories.hpp"
#include "editor/model/tools/motion_paths.hpp"
#include "gameplay/components/actors/moving_platform.hpp"
#include "gameplay/components/actors/patrol.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

class SetWays : public EditorFixture {
protected:
    template <class T>
    T& give(std::string_view name, const T& component) {
        World& world = workspace.document.world;
        const EntityId entity = workspace.document.find(named(name));
        world.add<T>(entity);
        world.get<T>(entity) = component;
        ++workspace.document.sceneRevision;
        workspace.document.selection.set({named(name)});
        return world.get<T>(entity);
    }
    [[nodiscard]] MotionPath wayOf(std::string_view name) const {
        const auto way = motionPathOf(workspace.document.world, workspace.document.find(named(name)));
        EXPECT_TRUE(way);
        return way.value_or(MotionPath{});
    }
    /// Drags with the shape tool.
    void drag(Vec2 from, Vec2 to) {
        runAction(workspace, "tool.shape");
        Pointer pointer;
        pointer.position = from;
        workspace.tool().press(workspace.tools(), pointer);
        pointer.position = to;
        workspace.tool().drag(workspace.tools(), pointer);
        workspace.tool().release(workspace.tools(), pointer);
    }
};

TEST_F(SetWays, aPlatformMovesFromItsPositionToTheOtherEnd) {
    give("crate", MovingPlatform{.way = {64.0f, -16.0f}});
    EXPECT_EQ(wayOf("crate").from, (Vec2{200.0f, 64.0f}));
    EXPECT_EQ(wayOf("crate").to, (Vec2{264.0f, 48.0f}));
    EXPECT_FALSE(motionPathOf(workspace.document.world, workspace.document.find(named("sign"))));
}

TEST_F(SetWays, thePathOfARunningPlatformDoesNotMoveWithIt) {
    MovingPlatform& platform = give("crate", MovingPlatform{.way = {64.0f, 0.0f}});
    platform.started = true;
    platform.home = {200.0f, 64.0f};
    World& world = workspace.document.world;
    world.get<Transform>(workspace.document.find(named("crate"))).position.x = 230.0f;
    EXPECT_EQ(wayOf("crate").from, (Vec2{200.0f, 64.0f}));
}

TEST_F(SetWays, aWalkerTurnsAtItsLimitsAndASideWithoutLimitIsOpen) {
    give("crate", Patrol{.leftLimit = 40.0f});
    const MotionPath way = wayOf("crate");
    EXPECT_EQ(way.from.x, 160.0f);
    EXPECT_TRUE(way.endsFrom);
    EXPECT_FALSE(way.endsTo);
}

TEST_F(SetWays, theEndOfAPlatformsWayIsDraggedAsOneStep) {
    give("crate", MovingPlatform{.way = {64.0f, 0.0f}});
    workspace.grid.snap = false;
    drag({264.0f, 64.0f}, {280.0f, 100.0f});
    EXPECT_EQ(wayOf("crate").to, (Vec2{280.0f, 100.0f}));
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200.0f, 64.0f})) << "it stands where it stood";
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_EQ(wayOf("crate").to, (Vec2{264.0f, 64.0f}));
}

TEST_F(SetWays, limitsOfAWalkerAreDraggedAndRemoved) {
    give("crate", Patrol{.leftLimit = 40.0f});
    drag(wayOf("crate").to, {290.0f, 64.0f});
    const auto patrol = [&] {
        return workspace.document.world.get<Patrol>(workspace.document.find(named("crate")));
    };
    EXPECT_EQ(patrol().rightLimit, 90.0f);
    drag({160.0f, 64.0f}, {199.0f, 64.0f});
    EXPECT_EQ(patrol().leftLimit, 0.0f) << "as short as that is none";
}

TEST_F(SetWays, thePathOfAChildIsShownInWorldSpace) {
    give("lamp", MovingPlatform{.way = {8.0f, 0.0f}});
    EXPECT_EQ(wayOf("lamp").from, (Vec2{50.0f, 90.0f}));
    drag({58.0f, 90.0f}, {70.0f, 90.0f});
    EXPECT_EQ(wayOf("lamp").to, (Vec2{70.0f, 90.0f}));
}

TEST_F(SetWays, trajectoriesOfAllBodiesIncludePlatformsAndWalkers) {
    give("crate", MovingPlatform{});
    give("sign", Patrol{});
    Trajectories trajectories;
    trajectories.update(workspace, true);
    const auto has = [&](std::string_view name) {
        return std::any_of(trajectories.ways().begin(), trajectories.ways().end(),
                           [&](const Trajectories::Way& way) { return way.object == named(name); });
    };
    EXPECT_TRUE(has("crate"));
    EXPECT_TRUE(has("sign"));
    EXPECT_FALSE(has("ground"));
}

}  // namespace
}  // namespace plumb::editor
