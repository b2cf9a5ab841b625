#include "app/game.hpp"

#include <gtest/gtest.h>

#include "app/engine.hpp"
#include "app/game_content.hpp"
#include "core/log.hpp"
#include "gameplay/game_functions.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/play_sound.hpp"
#include "scene/systems/camera_system.hpp"

// What games in code can ask of Game and Engine.

namespace plumb {
namespace {

constexpr Vec2 kPicture{320.0f, 180.0f};

class CodeGameApi : public testing::Test {
protected:
    CodeGameApi() {
        game_.assets.logging = false;
        game_.world.resource<PictureSize>().size = kPicture;
        game_.content.addSystems(game_.world);
    }

    Game game_;
    World& world_ = game_.world;
};

TEST_F(CodeGameApi, theCameraOfAGameWithoutOneShowsTheSame) {
    const View without = cameraView(world_, kPicture, 1.0f);
    const Entity camera = game_.camera();
    EXPECT_EQ(cameraView(world_, kPicture, 1.0f), without);
    tickGame(game_, InputFrame{});
    EXPECT_EQ(cameraView(world_, kPicture, 1.0f), without);
    EXPECT_EQ(game_.camera(), camera);
    EXPECT_EQ(world_.count<Camera>(), 1u);
}

TEST_F(CodeGameApi, theCameraIsTheFirstEnabledOne) {
    Entity made[2];
    for (Entity& camera : made) {
        camera = world_.createEntity();
        camera.addComponent<Transform>();
        camera.addComponent<Camera>();
    }
    EXPECT_EQ(game_.camera(), made[0]);
    made[0].get<Camera>().enabled = false;
    EXPECT_EQ(game_.camera(), made[1]);
    EXPECT_EQ(world_.count<Camera>(), 2u);
}

TEST_F(CodeGameApi, aTextIsALabelOnTheScreen) {
    const Entity text = game_.addText("Score {score}", {312.0f, 6.0f}, 16.0f, LabelAlign::Right);
    const auto& label = text.get<Label>();
    EXPECT_EQ(world_.texts().find(label.text), "Score {score}");
    EXPECT_EQ(text.get<Transform>().position, (Vec2{312.0f, 6.0f}));
    EXPECT_EQ(label.size, 16.0f);
    EXPECT_EQ(label.align, LabelAlign::Right);
    EXPECT_TRUE(label.screen);
    EXPECT_EQ(game_.addText("a", {}).get<Label>().size, Label{}.size);
}

TEST_F(CodeGameApi, bodiesFallWithTheGravityThatIsSet) {
    const auto speedAfterASecond = [this] {
        const Entity ball = world_.createEntity();
        ball.addComponent<Transform>(0.0f, 0.0f);
        ball.addComponent<RigidBody>();
        ball.addComponent<CircleCollider>(4.0f);
        for (int tick = 0; tick < 60; ++tick) tickGame(game_, InputFrame{});
        const Vec2 speed = ball.get<RigidBody>().velocity;
        ball.destroy();
        return speed;
    };
    EXPECT_NEAR(speedAfterASecond().y, 980.0f, 1.0f);
    game_.setGravity({-120.0f, 0.0f});
    EXPECT_NEAR(speedAfterASecond().x, -120.0f, 0.2f);
    game_.setGravity({});
    EXPECT_EQ(speedAfterASecond(), (Vec2{}));
}

TEST_F(CodeGameApi, aSoundIsPlayedByTheNameOfItsFile) {
    const LogSink sink = setLogSink([](const LogLine&) {});  // there is no such file
    tickGame(game_, InputFrame{});
    game_.play("hit.wav", 0.5f);
    game_.play(game_.assets.loadSound("hit.wav"));
    setLogSink(sink);
    const auto played = world_.events<PlaySound>();
    ASSERT_EQ(played.size(), 2u);
    EXPECT_EQ(played[0].sound, played[1].sound);
    EXPECT_EQ(played[0].volume, 0.5f);
}

/// Ends in its fifth tick.
class Ending : public Game {
public:
    Ending(int& ticks, Vec2& picture) : ticks_{ticks}, picture_{picture} {}

private:
    int& ticks_;
    Vec2& picture_;

    void onCreate() override { picture_ = world.resource<PictureSize>().size; }
    void onUpdate(float) override {
        if (++ticks_ == 5) quitGame(world);
    }
};

TEST(CodeGameEngine, quitGameEndsAGameInCode) {
    const char* words[] = {"game", "--headless", "--frames", "60"};
    Engine engine("game", 640, 360, 4, words);
    int ticks = 0;
    Vec2 picture;
    EXPECT_EQ(engine.run<Ending>(ticks, picture), 0);
    EXPECT_EQ(ticks, 5);
    EXPECT_EQ(picture, (Vec2{640.0f, 360.0f})) << "the image is as large as the window unless it is set";
}

TEST(CodeGameEngine, theImageMayHaveAnotherSizeThanTheWindow) {
    const char* words[] = {"game", "--headless", "--frames", "60"};
    Engine engine("game", 640, 360, 4, words);
    engine.settings().picture = kPicture;
    int ticks = 0;
    Vec2 picture;
    EXPECT_EQ(engine.run<Ending>(ticks, picture), 0);
    EXPECT_EQ(picture, kPicture);
}

TEST(ScreenSettings, optionsOverrideTheSizeOfTheWindowOnly) {
    ScreenSettings settings{"game", 640, 360, false, kPicture, WindowScale::Integer, true};
    PlayerOptions options;
    const auto size = [&] {
        const ScreenSettings made = withOptions(settings, options);
        EXPECT_EQ(made.picture, kPicture);
        EXPECT_EQ(made.scaling, WindowScale::Integer);
        EXPECT_TRUE(made.smooth);
        return PixelSize{made.windowWidth, made.windowHeight};
    };
    EXPECT_EQ(size(), (PixelSize{640, 360}));
    options.scale = 3;
    EXPECT_EQ(size(), (PixelSize{960, 540}));
    options.window = {500, 400};
    EXPECT_EQ(size(), (PixelSize{500, 400})) << "--window overrides --scale";
    EXPECT_FALSE(withOptions(settings, options).fullscreen);
    options.fullscreen = true;
    EXPECT_TRUE(withOptions(settings, options).fullscreen);
    settings.fullscreen = true;
    options.fullscreen = false;
    EXPECT_TRUE(withOptions(settings, options).fullscreen);
}

}  // namespace
}  // namespace plumb
