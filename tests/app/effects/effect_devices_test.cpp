#include <gtest/gtest.h>

#include "app/game_loop.hpp"
#include "app/screen.hpp"
#include "core/file.hpp"
#include "gameplay/components.hpp"
#include "tests/app/effects/effect_games.hpp"
#include "tests/support/temporary_folder.hpp"

// Devices of the player are opened only when a component or a pin requires them.

namespace plumb {
namespace {

using test::PileGame;

class EffectDevices : public testing::Test {
protected:
    EffectDevices() {
        Result<std::unique_ptr<Screen>> opened =
            Screen::open({"test", 64, 36, false, {64.0f, 36.0f}, WindowScale::Fit});
        EXPECT_TRUE(opened) << opened.error().text();
        screen = std::move(*opened);
    }
    void play(Game& game, int frames) {
        PlayerOptions options;
        options.frames = frames;
        EXPECT_EQ((GameLoop{game, screen.get(), options, "test"}.run()), 0);
    }

    std::unique_ptr<Screen> screen;
};

TEST_F(EffectDevices, gamepadsAreOpenedIfAComponentReadsInput) {
    PileGame alone, menu;
    menu.world.createEntity().addComponent<Menu>();
    play(alone, 3);
    EXPECT_EQ(alone.effects.runsOf(alone.world, "pads"), 0u);
    play(menu, 3);
    EXPECT_EQ(menu.effects.runsOf(menu.world, "pads"), 1u) << "gamepads must be opened once";
}

TEST_F(EffectDevices, gamepadsThatArePinnedOffStayClosed) {
    PileGame game;
    game.world.createEntity().addComponent<Menu>();
    game.effects.setProgramPin("pads", Pin::Off);
    play(game, 3);
    EXPECT_EQ(game.effects.runsOf(game.world, "pads"), 0u);
}

TEST_F(EffectDevices, theRendererIsCreatedForTheFirstFrame) {
    PileGame game;
    play(game, 3);
    EXPECT_EQ(game.effects.runsOf(game.world, "picture"), 0u);
    Entity seen = game.world.createEntity();
    seen.addComponent<Transform>(10.0f, 10.0f);
    seen.addComponent<Sprite>(TextureId{}, 8, 8);
    screen->draw(game.world, game.assets, 1.0f);
    screen->draw(game.world, game.assets, 1.0f);
    EXPECT_EQ(game.effects.runsOf(game.world, "picture"), 1u);
}

TEST_F(EffectDevices, withDrawingPinnedOffTheFrameIsBlack) {
    PileGame game;
    Entity seen = game.world.createEntity();
    seen.addComponent<Transform>(0.0f, 0.0f);
    seen.addComponent<Sprite>(TextureId{}, 64, 36);
    const auto isBlack = [&] {
        screen->draw(game.world, game.assets, 1.0f);
        const Image image = screen->picture();
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
            if (image.rgba[i] != 0) return false;
        }
        return true;
    };
    EXPECT_FALSE(isBlack());
    game.effects.setProgramPin("picture", Pin::Off);
    EXPECT_TRUE(isBlack());
}

TEST_F(EffectDevices, onlyTilesThatChangeAreAnimated) {
    test::TemporaryFolder folder;
    const auto tileset = [](std::string_view tiles) {
        return std::string{R"({"format": 1, "image": "none.png", "tileSize": [16, 16], "columns": 4, )"} +
               R"("count": 8, "tiles": [)" + std::string{tiles} + "]}";
    };
    const std::string still = tileset(R"({"id": 1, "collision": "full"})");
    const std::string moves =
        tileset(R"({"id": 1, "animation": [{"tile": 1, "seconds": 0.1}, {"tile": 2, "seconds": 0.1}]})");
    ASSERT_TRUE(writeFile(folder.path / "still.tileset.json", still).ok());
    ASSERT_TRUE(writeFile(folder.path / "moves.tileset.json", moves).ok());
    for (const char* name : {"still.tileset.json", "moves.tileset.json"}) {
        PileGame game;
        game.assets = AssetStore{folder.path};
        game.assets.logging = false;
        const bool changes = std::string_view{name} == "moves.tileset.json";
        TileLayer layer;
        game.assets.load(AssetKind::Tileset, name);
        layer.tileset = {game.world.texts().add(name)};
        TileGrid grid{2, 2};
        grid.set(0, 0, cellOf(1));
        layer.cells = game.world.tiles().add(grid);
        Entity ground = game.world.createEntity();
        ground.addComponent<Transform>();
        ground.addComponent<TileLayer>(layer);
        EXPECT_EQ(game.effects.runs(game.world, "tile_animation"), changes) << name;
        game.play(1);
        screen->draw(game.world, game.assets, 1.0f);
        EXPECT_EQ(game.effects.runsOf(game.world, "tile_animation"), changes ? 1u : 0u) << name;
        game.effects.setProgramPin("tile_animation", Pin::Off);
        screen->draw(game.world, game.assets, 1.0f);
        EXPECT_EQ(game.effects.runsOf(game.world, "tile_animation"), changes ? 1u : 0u) << name;
    }
}

}  // namespace
}  // namespace plumb
