#include <utility>

#include "gameplay/game_requests.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/play_sound.hpp"
#include "scene/scene_requests.hpp"
#include "scene/systems/camera_system.hpp"
#include "tests/gameplay/level.hpp"

namespace plumb {
namespace {

/// A menu with three items, created in another order than they are listed.
struct MenuLevel : Level {
    Entity menu, first, second, third, cursor;

    MenuLevel() : Level{{}} {
        world.addSystem<MenuSystem>();
        cursor = world.createEntity();
        cursor.addComponent<Transform>();
        menu = world.createEntity();
        menu.addComponent<Menu>().cursor = cursor;
        menu.addComponent<SoundCues>().step = {textId("assets/select.wav")};
        third = item(9, MenuAction::Quit);
        first = item(1, MenuAction::Close);
        second = item(5, MenuAction::GoTo);
        second.get<MenuItem>().scene = {textId("scenes/title.scene.json")};
    }
    Entity item(int order, MenuAction action) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(100.0f, static_cast<float>(order) * 10.0f);
        entity.addComponent<Label>();
        MenuItem& made = entity.addComponent<MenuItem>();
        made.order = order;
        made.action = action;
        return entity;
    }
    void press(Key key) {
        hold(key);
        tick();
        hold(key, false);
    }
    SceneRequests requests() { return std::exchange(world.resource<SceneRequests>(), {}); }
};

TEST(Menu, movesByOneItemPerPressAndWrapsAround) {
    MenuLevel level;
    level.tick();
    const auto selected = [&level] { return level.menu.get<Menu>().selected; };
    EXPECT_EQ(level.cursor.get<Transform>().position, (Vec2{88, 10}));
    EXPECT_EQ(level.first.get<Label>().color, level.menu.get<Menu>().selectedColor);
    level.hold(Key::Down);
    level.run(30);
    EXPECT_EQ(selected(), 1) << "a held key counts once";
    EXPECT_EQ(level.first.get<Label>().color, level.menu.get<Menu>().color);
    EXPECT_EQ(level.cursor.get<Transform>().position, (Vec2{88, 50}));
    level.hold(Key::Down, false);
    level.tick();
    level.press(Key::Down);
    EXPECT_EQ(level.count<PlaySound>(), 1);
    level.tick();
    EXPECT_EQ(selected(), 2);
    level.press(Key::Down);
    level.tick();
    EXPECT_EQ(selected(), 0);
    level.press(Key::Up);
    EXPECT_EQ(selected(), 2);
}

TEST(Menu, activatesTheItemOnConfirm) {
    MenuLevel level;
    level.tick();
    level.press(Key::Enter);
    EXPECT_TRUE(level.requests().close);
    level.tick();
    level.press(Key::Down);
    level.tick();
    level.press(Key::Enter);
    EXPECT_EQ(level.requests().next, textId("scenes/title.scene.json"));
    level.tick();
    level.press(Key::Down);
    level.tick();
    level.press(Key::Enter);
    EXPECT_TRUE(level.requests().quit);
}

TEST(Menu, aMouseThatRestsOnAnItemWhenTheGameBeginsDoesNotSelectIt) {
    MenuLevel level;
    level.world.resource<PictureSize>().size = {320.0f, 180.0f};
    for (Entity item : {level.first, level.second, level.third})
        item.get<Label>().text = level.world.texts().add("item");
    level.run(3);  // where the mouse is becomes known with its first event
    level.frame.setMouse(level.third.get<Transform>().position + Vec2{2.0f, 2.0f});
    level.run(3);
    EXPECT_EQ(level.menu.get<Menu>().selected, 0);
    level.frame.setMouse(level.third.get<Transform>().position + Vec2{3.0f, 2.0f});
    level.tick();
    EXPECT_EQ(level.menu.get<Menu>().selected, 2);
}

TEST(Menu, itemsThatLoadAnEmptySlotAreDimAndSkipped) {
    MenuLevel level;
    Entity load = level.item(0, MenuAction::Load);
    load.addComponent<SaveSlot>().slot = 3;
    const auto selected = [&level] { return level.menu.get<Menu>().selected; };
    level.tick();
    EXPECT_EQ(selected(), 1);
    EXPECT_LT(load.get<Label>().color.a, 100);
    level.press(Key::Up);
    level.tick();
    EXPECT_EQ(selected(), 3);
    level.press(Key::Down);
    level.tick();
    EXPECT_EQ(selected(), 1) << "not the first, which loads";
    level.frame.saves = 1u << 2;  // slot 3
    level.press(Key::Up);
    level.tick();
    EXPECT_EQ(selected(), 0);
    EXPECT_EQ(load.get<Label>().color, level.menu.get<Menu>().selectedColor);
    level.press(Key::Enter);
    EXPECT_EQ(std::exchange(level.world.resource<GameRequests>().load, 0), 3);
    level.tick();
    level.frame.saves = 0;
    level.tick();
    EXPECT_EQ(selected(), 1);
    for (Entity item : {level.first, level.second, level.third}) level.world.destroy(item.id());
    level.press(Key::Enter);
    EXPECT_EQ(level.world.resource<GameRequests>().load, 0) << "although no other item is left";
}

TEST(Menu, theMousePointsAndPresses) {
    MenuLevel level;
    level.world.resource<PictureSize>().size = {320.0f, 180.0f};
    for (Entity item : {level.first, level.second, level.third})
        item.get<Label>().text = level.world.texts().add("choose me");
    const auto selected = [&level] { return level.menu.get<Menu>().selected; };
    const auto moveTo = [&level](Vec2 place) {
        level.frame.setMouse(place);
        level.tick();
    };
    moveTo({300.0f, 170.0f});
    level.tick();
    moveTo({120.0f, 54.0f});
    EXPECT_EQ(selected(), 1);
    EXPECT_EQ(level.count<PlaySound>(), 1);
    level.press(Key::Up);
    EXPECT_EQ(selected(), 0) << "a resting mouse does not override keys";
    moveTo({300.0f, 150.0f});
    level.frame.mouseButtons = 1;
    level.tick();
    EXPECT_EQ(selected(), 0);
    EXPECT_TRUE(level.requests().empty()) << "a click outside of all items";
    level.frame.mouseButtons = 0;
    moveTo({120.0f, 54.0f});
    level.frame.mouseButtons = 1;
    level.tick();
    EXPECT_EQ(level.requests().next, textId("scenes/title.scene.json"));
    level.second.get<Label>().screen = true;
    level.second.get<Transform>().position = {10.0f, 160.0f};
    level.frame.mouseButtons = 0;
    moveTo({1.0f, 1.0f});
    Entity camera = level.world.createEntity();
    camera.addComponent<Transform>(5000.0f, 5000.0f);
    camera.addComponent<Camera>();
    level.press(Key::Up);
    level.tick();
    moveTo({14.0f, 163.0f});
    EXPECT_EQ(selected(), 1) << "items with `screen` ignore the camera";
}

TEST(Menu, pauseAndCancelCloseIt) {
    for (const Key key : {Key::P, Key::Escape, Key::Backspace}) {
        MenuLevel level;
        level.tick();
        level.press(key);
        EXPECT_TRUE(level.requests().close);
        level.menu.get<Menu>().closes = false;
        level.tick();
        level.press(key);
        EXPECT_TRUE(level.requests().empty());
    }
}

}  // namespace
}  // namespace plumb
