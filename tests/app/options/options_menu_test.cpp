#include "app/options/options_menu.hpp"

#include <cstdlib>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "app/options/options_view.hpp"
#include "app/screen.hpp"
#include "core/random.hpp"
#include "platform/image_file.hpp"
#include "platform/paths.hpp"
#include "tests/app/options/options_fixture.hpp"

namespace plumb {
namespace {

using test::areValid, test::keyDown, test::project;

TEST(OptionsMenu, aHeldKeyOnlyMoves) {
    OptionsMenu menu{project(), project()};
    menu.open();
    Event held = keyDown(Key::Enter);
    held.repeated = true;
    menu.handle(held, {});
    EXPECT_EQ(menu.settings(), project()) << "not the row Fullscreen";
    held.key = Key::F10;
    EXPECT_EQ(menu.handle(held, {}), OptionsMenu::Request::None);
    EXPECT_TRUE(menu.isOpen());
    held.key = Key::Down;
    menu.handle(held, {});
    EXPECT_EQ(menu.selected(), 1u);
}

TEST(OptionsMenu, keysChangeSettingsAndCloseIt) {
    OptionsMenu menu{project(), project()};
    EXPECT_FALSE(menu.isOpen());
    menu.open();
    menu.handle(keyDown(Key::Enter), {});
    EXPECT_TRUE(menu.settings().fullscreen);
    menu.handle(keyDown(Key::Down), {});
    menu.handle(keyDown(Key::Right), {});
    EXPECT_EQ(menu.settings().scale, 1);
    menu.handle(keyDown(Key::Left), {});
    menu.handle(keyDown(Key::Left), {});
    EXPECT_EQ(menu.settings().scale, PlayerSettings::kMostScale);
    for (int i = 0; i < 3; ++i) menu.handle(keyDown(Key::Down), {});
    menu.handle(keyDown(Key::Left), {});
    EXPECT_NEAR(menu.settings().master, 0.9f, 1e-6f);
    EXPECT_EQ(menu.handle(keyDown(Key::Escape), {}), OptionsMenu::Request::Close);
    EXPECT_FALSE(menu.isOpen());
    menu.open();
    menu.handle(keyDown(Key::Up), {});
    EXPECT_EQ(menu.handle(keyDown(Key::Enter), {}), OptionsMenu::Request::Quit);
}

/// Opens the page of the keys.
void openKeys(OptionsMenu& menu) {
    menu.open();
    for (int i = 0; i < 3; ++i) menu.handle(keyDown(Key::Up), {});
    menu.handle(keyDown(Key::Enter), {});
}

TEST(OptionsMenu, bindsKeysAndNamesConflicts) {
    OptionsMenu menu{project(), project()};
    openKeys(menu);
    EXPECT_EQ(menu.title(), "Controls");
    EXPECT_EQ(menu.rows()[0].label, "Jump");
    EXPECT_FALSE(menu.warns()) << "Space is Confirm, too, as the game has it";
    menu.handle(keyDown(Key::Enter), {});
    EXPECT_TRUE(menu.captures());
    menu.handle(keyDown(Key::X), {});
    EXPECT_FALSE(menu.captures());
    const std::vector<Binding>& jump = menu.settings().keys.actions[0].bindings;
    ASSERT_EQ(jump.size(), 2u);
    EXPECT_EQ(toText(jump[0]), "X");
    EXPECT_EQ(toText(jump[1]), "Pad A") << "those of the gamepad stay";
    EXPECT_EQ(menu.hint(), "X is also Attack");
    EXPECT_TRUE(menu.warns());

    menu.handle(keyDown(Key::Enter), {});
    menu.handle(keyDown(Key::Escape), {});
    EXPECT_TRUE(menu.isOpen());
    EXPECT_EQ(toText(menu.settings().keys.actions[0].bindings[0]), "X") << "Escape keeps the present ones";

    Event pad;
    pad.kind = EventKind::PadDown;
    pad.padButton = PadButton::RightShoulder;
    menu.handle(keyDown(Key::Enter), {});
    menu.handle(pad, {});
    EXPECT_EQ(toText(menu.settings().keys.actions[0].bindings[1]), "Pad RightShoulder");

    for (int i = 0; i < 2; ++i) menu.handle(keyDown(Key::Up), {});
    menu.handle(keyDown(Key::Enter), {});
    EXPECT_EQ(menu.settings(), project()) << "the standard keys";
}

TEST(OptionsMenu, doesNotBindWhatOpensIt) {
    OptionsMenu menu{project(), project()};
    openKeys(menu);
    Event back;
    back.kind = EventKind::PadDown;
    back.padButton = PadButton::Back;
    for (const Event& event : {keyDown(Key::F10), keyDown(Key::F11), keyDown(Key::Escape), back}) {
        menu.handle(keyDown(Key::Enter), {});
        ASSERT_TRUE(menu.captures());
        menu.handle(event, {});
        EXPECT_FALSE(menu.captures());
        EXPECT_TRUE(menu.isOpen());
        EXPECT_EQ(menu.settings(), project());
    }
}

TEST(OptionsMenu, offersWindowsThatFitOnTheDisplay) {
    PlayerSettings large = project();
    large.scale = 7;  // chosen on a larger display
    OptionsMenu menu{large, project()};
    menu.setMostScale(3);
    menu.open();
    menu.handle(keyDown(Key::Down), {});
    for (const int expected : {0, 1, 2, 3, 0}) {
        menu.handle(keyDown(Key::Right), {});
        EXPECT_EQ(menu.settings().scale, expected);
    }
}

Event stick(PadAxis axis, float value) {
    Event event;
    event.kind = EventKind::PadAxisMoved;
    event.padAxis = axis;
    event.value = value;
    return event;
}

TEST(OptionsMenu, aPushOfTheStickThatIsBoundDoesNotMoveTheSelection) {
    OptionsMenu menu{project(), project()};
    openKeys(menu);
    menu.handle(keyDown(Key::Enter), {});
    menu.handle(stick(PadAxis::LeftY, 0.7f), {});
    ASSERT_FALSE(menu.captures());
    EXPECT_EQ(toText(menu.settings().keys.actions[0].bindings.back()), "Pad LeftY+");
    menu.handle(stick(PadAxis::LeftY, 1.0f), {});
    EXPECT_EQ(menu.selected(), 0u) << "it is the same push";
    menu.handle(stick(PadAxis::LeftY, 0.0f), {});
    menu.handle(stick(PadAxis::LeftY, 0.9f), {});
    EXPECT_EQ(menu.selected(), 1u);
    menu.handle(keyDown(Key::Enter), {});
    menu.handle(stick(PadAxis::LeftY, 1.0f), {});
    EXPECT_TRUE(menu.captures()) << "the push that selected the row does not bind it";
}

TEST(OptionsMenu, aStickThatWasHeldWhenItClosedMovesItAfterReopening) {
    OptionsMenu menu{project(), project()};
    menu.open();
    menu.handle(stick(PadAxis::LeftY, 1.0f), {});
    ASSERT_EQ(menu.selected(), 1u);
    menu.handle(keyDown(Key::Escape), {});
    menu.open();
    menu.handle(stick(PadAxis::LeftY, 1.0f), {});
    EXPECT_EQ(menu.selected(), 1u);
}

TEST(OptionsMenu, showsTheSelectedRowAfterThePageOfTheKeys) {
    OptionsMenu menu{project(), project()};
    menu.layOut({640.0f, 200.0f});
    openKeys(menu);
    menu.handle(keyDown(Key::Escape), {});
    EXPECT_EQ(menu.title(), "Options");
    EXPECT_EQ(menu.rows()[menu.selected()].label, "Controls");
    EXPECT_LT(menu.selected(), menu.firstShown() + menu.shownRows());
    EXPECT_GE(menu.selected(), menu.firstShown());
}

TEST(OptionsMenu, doesNotBindKeysInARecording) {
    OptionsMenu menu{project(), project()};
    menu.allowKeys(false);
    openKeys(menu);
    menu.handle(keyDown(Key::Enter), {});
    EXPECT_FALSE(menu.captures());
    menu.handle(keyDown(Key::X), {});
    EXPECT_EQ(menu.settings(), project());
}

Event randomEvent(Random& random) {
    Event event;
    constexpr EventKind kKinds[] = {EventKind::KeyDown,    EventKind::KeyUp,        EventKind::MouseMoved,
                                    EventKind::MouseDown,  EventKind::MouseUp,      EventKind::MouseWheel,
                                    EventKind::PadDown,    EventKind::PadAxisMoved, EventKind::TextInput,
                                    EventKind::FileDropped};
    constexpr Key kKeys[] = {Key::Up, Key::Down, Key::Left, Key::Right, Key::Enter, Key::A, Key::Backspace};
    event.kind = kKinds[random.below(10)];
    event.key = kKeys[random.below(7)];
    event.mouseButton = static_cast<MouseButton>(random.below(kMouseButtonCount));
    event.padButton = static_cast<PadButton>(random.below(kPadButtonCount));
    event.padAxis = static_cast<PadAxis>(random.below(kPadAxisCount));
    event.value = random.between(-1.0f, 1.0f);
    event.motion = {0.0f, random.between(-1.0f, 1.0f)};
    return event;
}

TEST(OptionsMenu, staysValidForAnyEvents) {
    Random random = Random::seeded(9);
    OptionsMenu menu{project(), project()};
    bool keysChanged = false;
    for (int i = 0; i < 50'000; ++i) {
        if (!menu.isOpen()) menu.open();
        const Vec2 screen{640.0f, random.below(2) == 0 ? 360.0f : 480.0f};
        menu.layOut(screen);
        static_cast<void>(
            menu.handle(randomEvent(random), {random.between(0.0f, 640.0f), random.between(0.0f, 480.0f)}));
        ASSERT_LT(menu.selected(), menu.rows().size());
        ASSERT_TRUE(areValid(menu.settings()));
        ASSERT_FALSE(menu.hint().empty());
        keysChanged = keysChanged || menu.settings().keys != project().keys;
    }
    EXPECT_TRUE(keysChanged);
}

class OptionsPlaces : public ::testing::TestWithParam<PixelSize> {};

TEST_P(OptionsPlaces, rowsAreInsideOfThePanelAndThePanelInsideOfTheScreen) {
    const Vec2 screen = optionsScreen(GetParam());
    const AABB all{{}, screen};
    const auto isInside = [](const AABB& outer, const AABB& inner) {
        return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.max.x <= outer.max.x &&
               inner.max.y <= outer.max.y;
    };
    for (const bool keys : {false, true}) {
        OptionsMenu menu{project(), project()};
        if (keys) {
            openKeys(menu);
        } else {
            menu.open();
        }
        for (std::size_t step = 0; step < menu.rows().size(); ++step) {
            menu.layOut(screen);
            ASSERT_TRUE(isInside(all, menu.panel()));
            ASSERT_GE(menu.selected(), menu.firstShown());
            ASSERT_LT(menu.selected(), menu.firstShown() + menu.shownRows()) << "the selected row is shown";
            float end = menu.panel().min.y + OptionsMenu::kHead;
            for (std::size_t i = menu.firstShown(); i < menu.firstShown() + menu.shownRows(); ++i) {
                const AABB& box = menu.rows()[i].box;
                ASSERT_TRUE(isInside(menu.panel(), box));
                ASSERT_GE(box.min.y, end - 1e-3f);
                ASSERT_TRUE(isInside(box, OptionsMenu::valueBox(menu.rows()[i])));
                end = box.max.y;
            }
            menu.handle(keyDown(Key::Down), {});
        }
    }
}

INSTANTIATE_TEST_SUITE_P(For, OptionsPlaces,
                         ::testing::Values(PixelSize{640, 360}, PixelSize{1280, 720}, PixelSize{1920, 1080},
                                           PixelSize{800, 600}, PixelSize{320, 180}, PixelSize{360, 640}));

TEST(OptionsMenu, isDrawnOverTheGame) {
    for (const PixelSize size : {PixelSize{640, 360}, PixelSize{1280, 720}}) {
        Result<std::unique_ptr<Screen>> screen =
            Screen::open({"test", size.width, size.height, false, {320.0f, 180.0f}, WindowScale::Fit});
        ASSERT_TRUE(screen) << screen.error().text();
        World world;
        AssetStore assets{{}, engineAssets()};
        OptionsMenu menu{project(), project()};
        const Vec2 view = optionsScreen((*screen)->window().drawableSize());
        const auto draw = [&](const std::string& name) {
            menu.layOut(view);
            (*screen)->draw(world, assets, 1.0f);
            (*screen)->drawOver(
                assets, view, [&](LabelDrawing& labels, DrawList& list) { drawOptions(menu, labels, list); });
            Image image = (*screen)->picture();
            // PLUMB_SHOTS=/tmp/shots saves what is drawn, to look at it.
            if (const char* folder = std::getenv("PLUMB_SHOTS")) {
                const Result<std::string> png = encodePng(image);
                ASSERT_TRUE(png);
                ASSERT_TRUE(
                    writeFile(Path{folder} / (name + "_" + std::to_string(size.width) + ".png"), *png));
            }
            const std::size_t middle =
                (static_cast<std::size_t>(image.height / 2) * static_cast<std::size_t>(image.width) +
                 static_cast<std::size_t>(image.width / 2)) *
                4;
            EXPECT_GT(int{image.rgba[middle]} + image.rgba[middle + 1] + image.rgba[middle + 2], 20);
        };
        menu.open();
        for (int i = 0; i < 4; ++i) menu.handle(keyDown(Key::Down), {});
        menu.handle(keyDown(Key::Left), {});
        draw("options");
        openKeys(menu);
        draw("controls");
        menu.handle(keyDown(Key::Enter), {});
        draw("capture");
        menu.handle(keyDown(Key::X), {});
        draw("conflict");
        for (int i = 0; i < 11; ++i) menu.handle(keyDown(Key::Down), {});
        draw("scrolled");
    }
}

}  // namespace
}  // namespace plumb
