#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/view/particle_preview.hpp"
#include "editor/ui/fields/curve_edit.hpp"
#include "editor/ui/fields/field_row.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "tests/editor/support/inspector_fixture.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::string_view kSize = "Inspector/ParticleEmitter/sizeOverLife";

std::string at(std::string_view part) { return format("{}/{}", kSize, part); }

/// An editor window with particle emitters.
class ParticlesInTheEditor : public Inspector {
protected:
    ParticlesInTheEditor() {
        ParticleEmitter emitter;
        emitter.sizeOverLife = Curve::line(1.0f, 0.0f);
        emitter.rate = 120.0f;
        give("crate", emitter);
        give("lamp", emitter);
    }
    [[nodiscard]] Curve curve(std::string_view name) const { return of<ParticleEmitter>(name).sizeOverLife; }
    void openCurve(std::initializer_list<const char*> names) {
        select(names);
        scrollTo(kSize);
        hands.click(kSize);
        hands.rest(3);
        ASSERT_NE(widget(at("canvas")), nullptr);
    }
    /// Scrolls the inspector with the mouse wheel until the field is visible.
    void scrollTo(std::string_view field) {
        constexpr float kLowest = 600.0f;  // px: lower edge of the visible part
        for (int i = 0; i < 60; ++i) {
            const WidgetMap::Widget* found = widget(field);
            if (found != nullptr && found->box.max.y < kLowest) return;
            hands.moveTo({1150.0f, 400.0f});
            const Event wheel{
                .kind = EventKind::MouseWheel, .position = {1150.0f, 400.0f}, .motion = {0.0f, -1.0f}};
            window.frame({{&wheel, 1}});
            hands.rest(2);
        }
        FAIL() << field << " is not to be found";
    }
    [[nodiscard]] int alive() const { return std::stoi(valueOf("Viewport/particles")); }
};

TEST_F(ParticlesInTheEditor, aKeyIsDraggedForAllInOneStepAndEscapeGivesItBack) {
    openCurve({"crate", "lamp"});
    const Vec2 from = hands.middleOf(at("key1"));
    const AABB canvas = widget(at("canvas"))->box;
    hands.drag(from, from - Vec2{0.0f, canvas.size().y * 0.5f});
    EXPECT_NEAR(curve("crate").keys[1].value, 0.5f, 0.1f);
    EXPECT_EQ(curve("crate").keys[0], (CurveKey{0.0f, 1.0f}));
    EXPECT_EQ(curve("lamp"), curve("crate")) << "it goes to all";
    EXPECT_EQ(workspace.undo.size(), 1u);

    const Curve before = curve("crate");
    const Vec2 key = hands.middleOf(at("key1"));
    hands.rest(30);
    hands.moveTo(key), hands.rest(), hands.press();
    hands.moveTo(key - Vec2{40.0f, 30.0f}), hands.rest();
    EXPECT_NE(curve("crate"), before);
    hands.key(Key::Escape);
    hands.release(), hands.rest();
    EXPECT_EQ(curve("crate"), before);
    runAction(workspace, "edit.undo");
    EXPECT_EQ(curve("lamp"), Curve::line(1.0f, 0.0f));
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(ParticlesInTheEditor, aClickOnAKeyChangesNothing) {
    openCurve({"crate"});
    hands.clickAt(hands.middleOf(at("key1")) + Vec2{3.0f, -3.0f});
    EXPECT_EQ(curve("crate"), Curve::line(1.0f, 0.0f));
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(ParticlesInTheEditor, aDoubleClickAddsAKeyAndTheRightButtonTakesItOut) {
    openCurve({"crate"});
    doubleClick(at("canvas"));
    ASSERT_EQ(curve("crate").size(), 3u);
    EXPECT_NEAR(curve("crate").keys[1].at, 0.5f, 0.02f);
    EXPECT_NEAR(curve("crate").keys[1].value, 0.5f, 0.02f);
    hands.clickAt(hands.middleOf(at("key1")), MouseButton::Right);
    EXPECT_EQ(curve("crate"), Curve::line(1.0f, 0.0f));
    EXPECT_EQ(workspace.undo.size(), 2u);
    for (int i = 0; i < 2; ++i) {
        hands.rest(5);
        hands.clickAt(hands.middleOf(at("key0")), MouseButton::Right);
    }
    EXPECT_EQ(curve("crate").size(), 1u) << "the last key stays";
}

TEST_F(ParticlesInTheEditor, presetsAndTheShapeAreOneClickEach) {
    openCurve({"crate"});
    hands.click(at("Hump"));
    EXPECT_EQ(curve("crate"), Curve::hump(0.0f, 1.0f));
    hands.click(at("Smooth"));
    EXPECT_EQ(curve("crate").shape, CurveShape::Linear);
    hands.click(at("Constant"));
    EXPECT_EQ(curve("crate").size(), 1u);
    EXPECT_EQ(curve("crate").shape, CurveShape::Linear) << "a preset leaves the shape";
    for (const char* name : {"Up", "Down", "Ease"}) {
        hands.click(at(name));
        hands.rest();
    }
    EXPECT_EQ(curve("crate").size(), 4u);
    EXPECT_EQ(workspace.undo.size(), 6u);
}

TEST_F(ParticlesInTheEditor, curvesThatDifferShowADash) {
    ParticleEmitter other;
    other.sizeOverLife = Curve::hump(0.0f, 1.0f);
    give("lamp", other);
    openCurve({"lamp", "crate"});
    EXPECT_EQ(valueOf(kSize), kMixed);
    hands.click(at("Up"));
    hands.rest(2);
    EXPECT_EQ(valueOf(kSize), "smooth 0:0 1:1");
    EXPECT_EQ(curve("lamp"), curve("crate"));
}

TEST_F(ParticlesInTheEditor, selectedEmittersArePreviewedWithoutChangingTheDocument) {
    const std::uint64_t before = workspace.document.world.hash();
    EXPECT_EQ(widget("Viewport/particles"), nullptr) << "nothing is selected";
    select({"crate"});
    hands.rest(60);
    EXPECT_GT(alive(), 40);
    hands.click("Viewport/particles/restart");
    hands.rest(1);
    EXPECT_LT(alive(), 12);
    hands.click("Viewport/particles/burst");
    hands.rest(1);
    EXPECT_GT(alive(), 30) << "a handful at once";
    select({"player"});
    hands.rest(30);
    EXPECT_GT(alive(), 20) << "of the lamp in its hand";
    select({"sign"});
    EXPECT_EQ(widget("Viewport/particles"), nullptr);
    EXPECT_EQ(workspace.document.world.hash(), before);
    EXPECT_EQ(workspace.document.world.findResource<Particles>(), nullptr);
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(ParticlesInTheEditor, thePreviewFollowsEditsAndRestartsEmittersThatEnd) {
    ParticleEmitter once;
    once.rate = 0.0f;
    once.burst = 25;
    once.loop = once.playing = false;
    once.duration = 0.2f;
    once.lifetime = 0.3f;
    once.lifetimeSpread = 0.0f;
    give("crate", once);
    select({"crate"});
    int bursts = 0;
    bool empty = true;
    for (int i = 0; i < 120; ++i) {
        hands.rest(1);
        bursts += empty && alive() == 25 ? 1 : 0;
        empty = alive() == 0;
    }
    EXPECT_GE(bursts, 3);
    once.burst = 40;
    give("crate", once);
    int most = 0;
    for (int i = 0; i < 60; ++i) hands.rest(1), most = std::max(most, alive());
    EXPECT_EQ(most, 40);
}

TEST_F(ParticlesInTheEditor, theGameHasParticlesOfItsOwnAlsoAfterRewinding) {
    select({"crate"});
    runAction(workspace, "run.play");
    hands.rest(90);
    EXPECT_EQ(widget("Viewport/particles"), nullptr) << "no preview over the game";
    const auto* played = workspace.play.world().findResource<Particles>();
    ASSERT_NE(played, nullptr);
    workspace.play.setPaused(true);
    const std::int64_t tick = workspace.play.ticks();
    const std::uint64_t hash = workspace.play.world().hash();
    const std::size_t count = played->alive();
    EXPECT_GT(count, 50u);
    workspace.play.seek(5);
    EXPECT_LT(workspace.play.world().findResource<Particles>()->alive(), count / 2);
    workspace.play.seek(tick);
    EXPECT_EQ(workspace.play.world().hash(), hash);
    workspace.stopPlaying();
    hands.rest(5);
    EXPECT_NE(widget("Viewport/particles"), nullptr);
}

TEST_F(ParticlesInTheEditor, anEmitterAddedFromTheMenuIsSavedAndLoadedByteForByte) {
    ASSERT_TRUE(runAction(workspace, "entity.particles"));
    hands.rest(3);
    const ObjectId made = named("particles");
    ASSERT_TRUE(made);
    EXPECT_TRUE(workspace.document.selection.has(made));
    EXPECT_NE(widget("Viewport/particles"), nullptr) << "it is seen at once";
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_NE(fileText().find("\"ParticleEmitter\": {}"), std::string::npos) << "all as at first";
    EXPECT_NE(fileText().find("\"sizeOverLife\": [\"smooth\", [0, 1], [1, 0]]"), std::string::npos)
        << "a curve stands on one line";
    const std::string text = fileText();
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(workspace.text(), text);
}

TEST_F(ParticlesInTheEditor, aCameraIsAddedFromTheMenuToo) {
    ASSERT_TRUE(runAction(workspace, "entity.camera"));
    hands.rest(2);
    const ObjectId made = named("camera");
    ASSERT_TRUE(made);
    EXPECT_TRUE(workspace.document.world.get<Camera>(workspace.document.find(made)).enabled);
}

}  // namespace
}  // namespace plumb::editor::ui
