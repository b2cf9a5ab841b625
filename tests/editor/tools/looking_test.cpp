#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/ui/icons.hpp"
#include "input/input.hpp"
#include "physics/soft/softbody.hpp"
#include "render/view.hpp"
#include "scene/components/bodies/rope.hpp"
#include "scene/components/colliders/capsule_collider.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/fields/wind_field.hpp"
#include "scene/components/joints/mouse_joint.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::string_view kSoftScene = "scenes/soft.scene.json";
constexpr std::string_view kSoftText = R"({"format": 1, "entities": [
  {"id": "0000000000000001", "name": "rope", "components": {"Transform": {"position": [40, 20]},
   "Rope": {"to": [0, 120], "points": 13}}},
  {"id": "0000000000000002", "name": "flag", "components": {"Transform": {"position": [100, 20]},
   "Cloth": {"size": [80, 60], "columns": 9, "rows": 7}}},
  {"id": "0000000000000003", "name": "jelly", "components": {"Transform": {"position": [300, 100]},
   "Jelly": {"radius": 40, "points": 24}}}]})";

constexpr std::string_view kBallScene = "scenes/ball.scene.json";
constexpr std::string_view kBallText = R"({"format": 1, "entities": [
  {"id": "0000000000000001", "name": "camera", "components": {"Transform": {"position": [900, 700]},
   "Camera": {"zoom": 2}}},
  {"id": "0000000000000002", "name": "ball", "components": {"Transform": {"position": [950, 650]},
   "RigidBody": {"gravityScale": 0}, "CircleCollider": {"radius": 20}}},
  {"id": "0000000000000003", "name": "hand", "components": {"Transform": {}, "MouseDrag": {}}}]})";

/// Tests of the view: framing, picking and soft bodies.
class Looking : public EditorFixture {
protected:
    Looking() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            project.width = static_cast<int>(workspace.project.picture.x);
            project.height = static_cast<int>(workspace.project.picture.y);
            return makeGameSession(project, path, text);
        };
    }
    void open(std::string_view path, std::string_view text) {
        putFile(path, text);
        ASSERT_TRUE(workspace.open(path).ok());
        hands.rest(2);
    }
    [[nodiscard]] Vec2 onScreen(Vec2 world) const {
        return window.widgets().find("Viewport")->box.min + workspace.view.toScreenPoint(world);
    }
    /// True if the whole box, in world coordinates, is inside the viewport.
    [[nodiscard]] bool sees(const AABB& box) const {
        const AABB seen = visibleBox(workspace.view.view());
        return merged(seen, box) == seen;
    }
    /// Particles of a soft body in the edited scene, px.
    [[nodiscard]] std::vector<Vec2> particlesOf(std::string_view name) const {
        std::vector<Vec2> places;
        const auto* state = workspace.document.world.findResource<PhysicsState>();
        if (state == nullptr) return places;
        for (const SoftLinkage& linkage : state->softBodies) {
            if (linkage.entity != workspace.document.find(named(name))) continue;
            for (const auto& particle : physics::particlesOf(state->world, linkage.body)) {
                places.push_back(positionInPixels(particle.place, state->scale));
            }
        }
        return places;
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Looking, openingASceneShowsTheWholeCameraView) {
    for (const Vec2 picture : {Vec2{320, 180}, {640, 360}, {1280, 720}, {1920, 1080}, {400, 2000}}) {
        SCOPED_TRACE(picture.x);
        workspace.project.picture = picture;
        open(kBallScene, kBallText);
        const Vec2 half = picture * 0.25f;  // the camera has a zoom of 2
        EXPECT_TRUE(sees({Vec2{900, 700} - half, Vec2{900, 700} + half}));
        const float zoom = workspace.view.zoom();
        EXPECT_TRUE(zoom < 1.0f || zoom == std::floor(zoom)) << zoom;
        workspace.view.show({900, 700}, zoom < 1.0f ? zoom * 1.1f : zoom + 1.0f);
        const Vec2 withMargin = half + Vec2{12.0f, 12.0f} / workspace.view.zoom();
        EXPECT_FALSE(sees({Vec2{900, 700} - withMargin, Vec2{900, 700} + withMargin}))
            << "it could be larger";
    }
}

TEST_F(Looking, openingASceneWithoutACameraShowsAllEntities) {
    open(kSoftScene, kSoftText);
    EXPECT_TRUE(sees({{40, 20}, {340, 140}}));
    EXPECT_GT(workspace.view.zoom(), 1.0f);
}

TEST_F(Looking, homeShowsAllAndWithControlWhatTheCameraSees) {
    open(kBallScene, kBallText);
    const View start = workspace.view.view();
    workspace.view.show({-5000, 0}, 10.0f);
    hands.key(Key::Home);
    EXPECT_TRUE(sees({{0, 0}, {970, 700}}));
    hands.key(Key::Home, {.control = true});
    EXPECT_EQ(workspace.view.view(), start);
    workspace.view.show({-5000, 0}, 10.0f);
    hands.key(Key::F, {.shift = true});
    EXPECT_TRUE(sees({{0, 0}, {970, 700}}));
}

TEST_F(Looking, theWholeGameIsVisibleInASmallWindow) {
    workspace.project.picture = {1920, 1080};
    open(kBallScene, kBallText);
    hands.key(Key::F5);
    hands.rest(3);
    EXPECT_TRUE(sees({Vec2{900, 700} - Vec2{479.9f, 269.9f}, Vec2{900, 700} + Vec2{479.9f, 269.9f}}));
}

TEST_F(Looking, theGameGetsTheMousePositionInItsOwnCoordinates) {
    open(kBallScene, kBallText);
    hands.key(Key::F5);
    hands.rest(3);
    World& played = workspace.play.world();
    const EntityId ball = workspace.play.find(named("ball"));
    hands.moveTo(onScreen({950, 650})), hands.rest(2), hands.press();
    hands.rest(10);
    EXPECT_TRUE(played.has<MouseJoint>(ball));
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("ball")})
        << "not the hand, which is always there";
    hands.moveTo(onScreen({880, 720})), hands.rest(120);
    EXPECT_LT(distance(played.get<Transform>(ball).position, {880, 720}), 4.0f);
    hands.release();
    hands.rest(10);
    EXPECT_FALSE(played.has<MouseJoint>(ball));
}

TEST_F(Looking, softBodiesAreDrawnAsAtTickZero) {
    open(kSoftScene, kSoftText);
    EXPECT_FALSE(workspace.physics.on);
    const std::vector<Vec2> rope = particlesOf("rope"), flag = particlesOf("flag");
    ASSERT_EQ(rope.size(), 13u);
    ASSERT_EQ(flag.size(), 63u);
    for (std::size_t i = 0; i < rope.size(); ++i) {
        EXPECT_LT(distance(rope[i], {40.0f, 20.0f + 10.0f * static_cast<float>(i)}), 1e-3f);
    }
    for (std::size_t i = 0; i < flag.size(); ++i) {
        const Vec2 cell{static_cast<float>(i % 9), static_cast<float>(i / 9)};
        EXPECT_LT(distance(flag[i], Vec2{100, 20} + cell * 10.0f), 1e-3f);
    }
    ASSERT_EQ(particlesOf("jelly").size(), 24u);
    for (const Vec2 place : particlesOf("jelly")) EXPECT_NEAR(distance(place, {300, 100}), 40.0f, 1e-3f);
}

TEST_F(Looking, softBodiesFollowEditsAndUndo) {
    open(kSoftScene, kSoftText);
    workspace.document.selection.set({named("jelly")});
    hands.rest(2);
    hands.enterNumber("Inspector/Jelly/radius", "60");
    ASSERT_EQ(particlesOf("jelly").size(), 24u);
    for (const Vec2 place : particlesOf("jelly")) EXPECT_NEAR(distance(place, {300, 100}), 60.0f, 1e-3f);
    hands.key(Key::Delete);
    EXPECT_TRUE(particlesOf("jelly").empty());
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(particlesOf("jelly").size(), 24u);
    hands.key(Key::Z, {.control = true});
    for (const Vec2 place : particlesOf("jelly")) EXPECT_NEAR(distance(place, {300, 100}), 40.0f, 1e-3f);
    hands.key(Key::A, {.control = true});
    hands.key(Key::Delete);
    EXPECT_TRUE(particlesOf("rope").empty());
}

TEST_F(Looking, softBodiesAreSelectedByAClickOnAnyPart) {
    open(kSoftScene, kSoftText);
    hands.clickAt(onScreen({300, 130}));
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("jelly")});
    hands.clickAt(onScreen({170, 70}));
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("flag")});
    hands.clickAt(onScreen({40, 130}));
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("rope")});
}

TEST_F(Looking, theBoundsOfARotatedColliderContainAllOfIt) {
    World& world = workspace.document.world;
    const auto boxOf = [&]<class Collider>(const Collider& collider) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(100.0f, 100.0f).rotation = kPi / 2.0f;
        world.add<Collider>(entity.id(), collider);
        return boundsOf(world, entity.id());
    };
    const auto near = [](const AABB& a, const AABB& b) {
        return distance(a.min, b.min) < 0.01f && distance(a.max, b.max) < 0.01f;
    };
    CapsuleCollider capsule{10, 40};
    EXPECT_TRUE(near(boxOf(BoxCollider{10, 40}), {{60, 100}, {100, 110}}));
    EXPECT_TRUE(near(boxOf(capsule), {{60, 100}, {100, 110}}));
    PolygonCollider wedge;
    for (const Vec2 point : {Vec2{0, 0}, {10, 0}, {0, 40}}) wedge.points.push(point);
    wedge.rounding = 2.0f;
    EXPECT_TRUE(near(boxOf(wedge), {{58, 98}, {102, 112}}));
}

TEST_F(Looking, entitiesWithoutAPositionAreNeitherFramedNorPicked) {
    open("scenes/keys.scene.json", R"({"format": 1, "entities": [
      {"id": "0000000000000001", "name": "key", "components": {"SceneKey": {}}},
      {"id": "0000000000000002", "name": "crate", "components": {"Transform": {"position": [4000, 3000]},
       "BoxCollider": {"width": 100, "height": 50}}}]})");
    EXPECT_FALSE(sees({{0, 0}, {1, 1}}));
    EXPECT_TRUE(sees({{4000, 3000}, {4100, 3050}}));
    EXPECT_FALSE(pickFirst(workspace.document, {0, 0}, 5.0f));
    EXPECT_TRUE(pickInside(workspace.document, {{-10, -10}, {10, 10}}).empty());
}

TEST_F(Looking, aForceFieldIsPickedInItsRegionBehindAllElse) {
    open("scenes/wind.scene.json", R"({"format": 1, "entities": [
      {"id": "0000000000000001", "name": "crate", "components": {"Transform": {"position": [100, 100]},
       "BoxCollider": {"width": 50, "height": 50}}},
      {"id": "0000000000000002", "name": "wind", "components": {"Transform": {"position": [0, 0]},
       "WindField": {"size": [400, 300]}}}]})");
    EXPECT_TRUE(sees({{0, 0}, {400, 300}}));
    EXPECT_EQ(pickFirst(workspace.document, {120, 120}, 1.0f), named("crate"));
    EXPECT_EQ(pickFirst(workspace.document, {300, 200}, 1.0f), named("wind"));
    EXPECT_EQ(pickInside(workspace.document, {{0, 0}, {400, 300}}), std::vector{named("crate")});
}

TEST_F(Looking, theTreeMarksSoftBodiesAndFields) {
    open(kSoftScene, kSoftText);
    for (const char* name : {"rope", "flag", "jelly"})
        EXPECT_EQ(iconOf(workspace.document.world, workspace.document.find(named(name))), Icon::Soft) << name;
    const EntityId rope = workspace.document.find(named("rope"));
    workspace.document.world.remove<Rope>(rope);
    EXPECT_EQ(iconOf(workspace.document.world, rope), Icon::Entity);
    workspace.document.world.add<WindField>(rope);
    EXPECT_EQ(iconOf(workspace.document.world, rope), Icon::Field);
}

}  // namespace
}  // namespace plumb::editor::ui
