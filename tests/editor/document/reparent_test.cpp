#include "editor/model/commands/reparent.hpp"

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/document/entity_state.hpp"
#include "math/angle.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

class Reparenting : public EditorFixture {
protected:
    void put(std::string_view name, const Transform& transform) {
        workspace.document.world.get<Transform>(workspace.document.find(named(name))) = transform;
    }
    [[nodiscard]] Pose poseOf(std::string_view name) const {
        return worldPose(workspace.document.world, workspace.document.find(named(name)));
    }
    [[nodiscard]] const Transform& transformOf(std::string_view name) const {
        return workspace.document.world.get<Transform>(workspace.document.find(named(name)));
    }
    void give(std::string_view child, std::string_view parent, KeepPlace keep = KeepPlace::InWorld) {
        workspace.undo.push(std::make_unique<Reparent>(std::vector{named(child)},
                                                       parent.empty() ? ObjectId{} : named(parent), keep));
    }
};

TEST_F(Reparenting, localTransformFollowsTheFormulaOfARotatedAndScaledParent) {
    // The parent's x axis points down with scale 2, its y axis points left with scale 4.
    put("player", Transform{{40.0f, 100.0f}, kPi * 0.5f, {2.0f, 4.0f}});
    put("crate", Transform{{48.0f, 110.0f}, 0.25f, {6.0f, 2.0f}});

    give("crate", "player");

    const Transform& own = transformOf("crate");
    EXPECT_NEAR(own.position.x, 10.0f / 2.0f, 1e-4f);
    EXPECT_NEAR(own.position.y, -8.0f / 4.0f, 1e-4f);
    EXPECT_NEAR(own.rotation, 0.25f - kPi * 0.5f, 1e-6f);
    EXPECT_EQ(own.scale, (Vec2{3.0f, 0.5f}));
}

TEST_F(Reparenting, reparentedEntitiesKeepTheirWorldTransform) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        for (const char* name : {"player", "lamp", "crate", "sign"}) {
            put(name, Transform{{random.between(-300.0f, 300.0f), random.between(-300.0f, 300.0f)},
                                random.between(-3.0f, 3.0f),
                                {random.between(0.3f, 3.0f), random.between(0.3f, 3.0f)}});
        }
        const Pose before = poseOf("crate");
        const std::string text = workspace.text();

        give("crate", "lamp");
        const Pose inLamp = poseOf("crate");
        give("crate", "sign");
        const Pose inSign = poseOf("crate");
        give("crate", "");

        for (const Pose& pose : {inLamp, inSign, poseOf("crate")}) {
            EXPECT_LT(distance(pose.position, before.position), 0.01f);
            EXPECT_NEAR(wrapAngle(pose.rotation - before.rotation), 0.0f, 1e-5f);
            EXPECT_LT(distance(pose.scale, before.scale), 1e-4f);
        }
        while (workspace.undo.undo()) {
        }
        EXPECT_EQ(workspace.text(), text);
    }
}

TEST_F(Reparenting, undoAndRedoRestoreEveryByte) {
    put("player", Transform{{40.0f, 100.0f}, 0.7f, {1.3f, 0.6f}});
    const std::string before = workspace.text();
    give("sign", "player");
    const std::string after = workspace.text();
    EXPECT_NE(after, before);

    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
    workspace.undo.redo();
    EXPECT_EQ(workspace.text(), after);
}

TEST_F(Reparenting, localTransformStaysOnRequest) {
    give("crate", "player", KeepPlace::InParent);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200.0f, 64.0f}));
    EXPECT_EQ(poseOf("crate").position, (Vec2{240.0f, 164.0f}));
}

TEST_F(Reparenting, localTransformStaysInAParentWithScaleZero) {
    put("player", Transform{{40.0f, 100.0f}, 0.0f, {0.0f, 1.0f}});
    give("crate", "player");
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200.0f, 64.0f}));
    EXPECT_EQ(transformOf("crate").scale, (Vec2{1.0f, 1.0f}));
}

TEST_F(Reparenting, selectedChildrenMoveWithTheirSelectedParent) {
    const std::vector<ObjectId> roots =
        outermost(workspace.document, {named("lamp"), named("player"), named("crate")});
    EXPECT_EQ(roots, (std::vector{named("player"), named("crate")}));
}

}  // namespace
}  // namespace plumb::editor
