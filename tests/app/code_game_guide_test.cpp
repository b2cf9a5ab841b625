#include <filesystem>
#include <fstream>
#include <plumb.hpp>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/screen.hpp"
#include "platform/image_file.hpp"
#include "tests/support/places.hpp"

// The second game of docs/code-games.md, verbatim, which needs only plumb.hpp, and tests of the document's
// statements about code games. The first one is projects/hello-code.

namespace plumb {
namespace {

// guide begin
// clang-format off
struct Coin {};   // a tag: entities are found by their components
struct Bullet {};

class Shooter : public Game {
    Entity hero;
    SoundId shot;
    TextureId spark;
    int score = 0;

    void onCreate() override {
        setBackground({29, 33, 53, 255});
        shot = assets.loadSound("shot.wav");
        spark = assets.loadTexture("spark.png");

        hero = world.createEntity();
        hero.addComponent<Name>(world.texts().add("hero"));
        hero.addComponent<Transform>(100.0f, 100.0f);
        hero.addComponent<RigidBody>();
        hero.addComponent<BoxCollider>(32, 32);

        auto floor = world.createEntity();
        floor.addComponent<Transform>(0.0f, 160.0f);
        floor.addComponent<BoxCollider>(2000, 20);
        floor.addComponent<StaticBody>();

        for (int i = 0; i < 5; ++i) {
            Entity coin = spawn("coin.prefab.json", {random().between(0.0f, 300.0f), 20.0f});
            coin.addComponent<Coin>();
        }
        auto camera = world.createEntity();
        camera.addComponent<Transform>(160.0f, 90.0f);
        camera.addComponent<Camera>();

        auto label = world.createEntity();
        label.addComponent<Transform>(8.0f, 8.0f);
        Label& text = label.addComponent<Label>();
        text.text = world.texts().add("Score {score}");
        text.screen = true;
    }

    void onUpdate(float) override {
        if (input.isPressed(MouseButton::Left)) shoot(mouseInWorld());
    }

    void onLateUpdate(float) override {  // the systems have run: what happened in this tick is known
        for (const ContactBegan& contact : world.events<ContactBegan>()) {
            if (world.has<Bullet>(contact.a)) world.destroy(contact.a);
            if (world.has<Bullet>(contact.b)) world.destroy(contact.b);
        }
        show("score", format("{}", score));
    }

    void shoot(Vec2 aim) {
        const Vec2 from = hero.get<Transform>().position;
        QueryFilter others;
        others.except = hero.id();
        const auto hit = castRay(world, from, aim - from, others);
        if (hit && world.has<Coin>(hit->entity)) ++score;
        play(shot);
        auto bullet = world.createEntity();
        bullet.addComponent<Transform>(from + Vec2{0.0f, -20.0f});
        bullet.addComponent<Sprite>(wholePicture(spark, 8, 8));
        bullet.addComponent<CircleCollider>(4.0f).offset = {4.0f, 4.0f};  // in the middle of the sprite
        bullet.addComponent<RigidBody>().velocity = aim - from;
        bullet.addComponent<Bullet>();
    }
};
// clang-format on
// guide end

/// Returns a text without the indentation of its lines.
std::string unindented(std::string_view text) {
    std::string result;
    for (const std::string_view line : split(text, '\n')) {
        result += trimmed(line);
        result += '\n';
    }
    return result;
}

/// Returns the C++ code of a document, block by block.
std::vector<std::string> codeOf(const std::string& document) {
    constexpr std::string_view kBegin = "```cpp\n";
    std::vector<std::string> blocks;
    for (std::size_t at = document.find(kBegin); at != std::string::npos; at = document.find(kBegin, at)) {
        at += kBegin.size();
        blocks.push_back(document.substr(at, document.find("\n```", at) - at));
    }
    return blocks;
}

/// The game of the guide with an open door, and its files.
class ShownShooter : public testing::Test {
protected:
    ShownShooter() {
        std::filesystem::create_directories(folder_ / "assets");
        const std::string coin = R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "coin",
            "components": {"Transform": {}, "StaticBody": {}, "BoxCollider": {"width": 10, "height": 10}}}]})";
        EXPECT_TRUE(writeFile(folder_ / "assets/coin.prefab.json", coin));
        Image spark{128, 128, {}};
        spark.rgba.assign(std::size_t{128} * 128 * 4, 0);
        for (int y = 32; y < 96; ++y) {  // transparent at its borders
            for (int x = 32; x < 96; ++x) {
                for (int i = 0; i < 4; ++i)
                    spark.rgba[static_cast<std::size_t>((y * 128 + x) * 4 + i)] = i == 1 ? 0 : 255;
            }
        }
        EXPECT_TRUE(writeFile(folder_ / "assets/spark.png", *encodePng(spark)));
        EXPECT_TRUE(writeFile(folder_ / "assets/shot.wav", "RIFF"));
        game_.assets = AssetStore{folder_, {}};
        game_.assets.logging = false;
        game_.world.resource<PictureSize>().size = {320.0f, 180.0f};
        static_cast<Game&>(game_).onCreate();
        game_.content.addSystems(game_.world);
    }
    ~ShownShooter() override { std::filesystem::remove_all(folder_); }

    void click(Vec2 place) {
        InputFrame frame;
        frame.setMouse(place);
        frame.mouseButtons = 1;
        tickGame(game_, frame);
    }

    Path folder_ = std::filesystem::temp_directory_path() / "plumb_code_guide" /
                   testing::UnitTest::GetInstance()->current_test_info()->name();
    Shooter game_;
};

TEST(CodeGameGuide, everyBlockIsPartOfAGameThatIsCompiled) {
    const auto guide = readFile(test::sourceFolder() / "docs/code-games.md");
    const auto game = readFile(test::sourceFolder() / "projects/hello-code/main.cpp");
    const auto self = readFile(test::sourceFolder() / "tests/app/code_game_guide_test.cpp");
    ASSERT_TRUE(guide && game && self);
    const std::string code = unindented(*game) + unindented(*self);
    const std::vector<std::string> blocks = codeOf(*guide);
    EXPECT_GE(blocks.size(), 10u);
    for (const std::string& block : blocks)
        EXPECT_NE(code.find("\n" + unindented(block)), std::string::npos) << block;
}

TEST_F(ShownShooter, itShootsAtTheMousePositionAndCounts) {
    World& world = game_.world;
    EXPECT_EQ(world.count<Coin>(), 5u);
    const Entity hero = game_.find("hero");
    ASSERT_TRUE(hero);
    EXPECT_FALSE(game_.find("missing"));
    tickGame(game_, InputFrame{});  // rays use the state of the last physics step
    const Entity coin = world.first<Coin>();
    click(coin.get<Transform>().position + Vec2{5.0f, 5.0f});
    EXPECT_EQ(*world.resource<LabelValues>().find("score"), "1");
    ASSERT_EQ(world.events<PlaySound>().size(), 1u);
    std::string text;
    fillPlaceholders(world, "Score {score}, {other}", text);
    EXPECT_EQ(text, "Score 1, {other}");
    EXPECT_EQ(world.count<Bullet>(), 1u);
    for (int tick = 0; tick < 240; ++tick) tickGame(game_, InputFrame{});
    EXPECT_EQ(world.count<Bullet>(), 0u) << "a bullet that hits something must be removed";
}

TEST_F(ShownShooter, changedTextsDoNotAccumulate) {
    tickGame(game_, InputFrame{});
    const std::size_t before = game_.world.texts().size();
    for (int i = 0; i < 1000; ++i) {
        game_.show("score", format("{} points", i));
        tickGame(game_, InputFrame{});
    }
    EXPECT_EQ(game_.world.texts().size(), before);
}

TEST_F(ShownShooter, aMissingPrefabIsReportedAndNothingIsCreated) {
    const std::size_t before = game_.world.entityCount();
    std::string logged;
    const LogSink sink = setLogSink([&](const LogLine& line) { logged += line.text; });
    EXPECT_FALSE(game_.spawn("dragon.prefab.json", {}));
    setLogSink(sink);
    EXPECT_NE(logged.find("dragon.prefab.json"), std::string::npos);
    EXPECT_EQ(game_.world.entityCount(), before);
}

/// Points the camera at the right end of a level of 1000 px, where the camera's limits stop it.
class AtTheLimit : public Game {
public:
    explicit AtTheLimit(Vec2& seen) : seen_{seen} {}

private:
    Vec2& seen_;
    Entity camera_;

    void onCreate() override {
        auto player = world.createEntity();
        player.addComponent<Transform>(990.0f, 90.0f);
        camera_ = world.createEntity();
        camera_.addComponent<Transform>(160.0f, 90.0f);
        Camera& camera = camera_.addComponent<Camera>();
        camera.follow = player.id();
        camera.limits = {0.0f, 0.0f, 1000.0f, 180.0f};
    }
    void onLateUpdate(float) override { seen_ = camera_.get<Transform>().position; }
};

TEST(CodeGameGuide, cameraLimitsUseTheImageSize) {
    const char* words[] = {"game", "--headless", "--frames", "60"};
    Engine engine("game", 320, 180, 4, words);
    Vec2 seen;
    EXPECT_EQ(engine.run<AtTheLimit>(seen), 0);
    EXPECT_EQ(seen, (Vec2{1000.0f - 160.0f, 90.0f}));
}

Color pixelAt(const Image& image, int x, int y) {
    const std::uint8_t* at = image.rgba.data() + (static_cast<std::size_t>(y * image.width + x)) * 4;
    return {at[0], at[1], at[2], at[3]};
}

TEST_F(ShownShooter, theBackgroundIsDrawnAndAWholeImageIsScaled) {
    game_.world.clear();
    const auto place = [&](float x, const Sprite& sprite) {
        Entity entity = game_.world.createEntity();
        entity.addComponent<Transform>(x, 40.0f);
        entity.addComponent<Sprite>(sprite);
    };
    const TextureId spark = game_.assets.loadTexture("spark.png");
    place(40.0f, game_.wholePicture(spark, 8, 8));
    place(80.0f, Sprite{spark, 8, 8});
    Result<std::unique_ptr<Screen>> screen =
        Screen::open({"test", 320, 180, false, {320.0f, 180.0f}, WindowScale::Fit});
    ASSERT_TRUE(screen);
    (*screen)->draw(game_.world, game_.assets, 1.0f);
    const Image image = (*screen)->picture();
    constexpr Color kBackground{29, 33, 53, 255};
    EXPECT_EQ(pixelAt(image, 200, 100), kBackground);
    EXPECT_EQ(pixelAt(image, 44, 44), (Color{255, 0, 255, 255})) << "the image's middle";
    EXPECT_EQ(pixelAt(image, 84, 44), kBackground) << "an unscaled cell shows the transparent corner";
}

}  // namespace
}  // namespace plumb
