#include <array>

#include "editor/model/document/bounds.hpp"
#include "tests/editor/keys/desk.hpp"
#include "tests/editor/support/script_game.hpp"

namespace plumb::editor::ui {
namespace {

/// Moves the view to an empty region, far from all entities.
void lookAway(KeyTrials& at) { at.workspace.view.show({5000.0f, 5000.0f}, 3.0f), at.hands.rest(); }

void framesAll(KeyTrials& at) {
    lookAway(at);
    at.press();
    const auto box = boundsOf(at.workspace.document, at.workspace.document.objects());
    EXPECT_EQ(at.workspace.view.view().center, box->center());
    EXPECT_LT(box->size().x * at.workspace.view.zoom(), at.workspace.view.view().size.x) << "all of it";
}

/// Expects that the keys zoom around the center of the view.
template <bool Closer>
void zooms(KeyTrials& at) {
    const View before = at.workspace.view.view();
    at.press();
    EXPECT_EQ(at.workspace.view.zoom() > before.zoom, Closer);
    EXPECT_LT(distance(at.workspace.view.view().center, before.center), 0.01f);
}

template <std::size_t Index>
void showsLayout(KeyTrials& at) {
    at.workspace.settings.layout = layoutPresets()[(Index + 1) % 3].layout;
    at.press();
    const std::string start = format("Layout {}", layoutPresets()[Index].name);
    EXPECT_EQ(at.workspace.notice.substr(0, start.size()), start);
    // The layouts are distinguished by their front tabs.
    EXPECT_EQ(at.valueOf("Tab/Tiles"), Index == 0 ? "front" : "");
    EXPECT_EQ(at.valueOf("Tab/History"), Index == 2 ? "front" : "");
    EXPECT_EQ(at.valueOf("Tab/Scene"), Index == 1 ? "front" : Index == 0 ? "front" : "");
}

void switchesOverlay(KeyTrials& at, std::string_view overlay) {
    ASSERT_FALSE(at.workspace.shows(overlay));
    at.press();
    EXPECT_TRUE(at.workspace.shows(overlay));
    at.press();
    EXPECT_FALSE(at.workspace.shows(overlay));
    EXPECT_FALSE(at.workspace.unsaved());
}

/// A game with scripts that is stopped at line 11 of tick 1: the call of a function.
class Stopped {
public:
    explicit Stopped(KeyTrials& at) : at_{at} {
        at.workspace.makeSession = [this](const std::string&, const std::string&) { return game_.start(); };
        at.workspace.debugger.breakpoints.toggle("scripts/counter.lua", 11);
        at.play(3);
        EXPECT_EQ(line(), 11);
    }
    ~Stopped() { at_.workspace.play.stop(); }
    Stopped(const Stopped&) = delete;
    Stopped& operator=(const Stopped&) = delete;

    [[nodiscard]] int line() const {
        const Halt* halt = at_.workspace.debugger.halt();
        return halt == nullptr ? 0 : halt->line;
    }

private:
    ScriptGame game_;
    KeyTrials& at_;
};

constexpr std::array kTrials{
    KeyTrial{"F", "view.frame",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 lookAway(at);
                 at.press();
                 EXPECT_EQ(at.workspace.view.view().center,
                           boundsOf(at.workspace.document, {at.named("crate")})->center());
             }},
    KeyTrial{"Home", "view.all", framesAll},
    KeyTrial{"Shift+F", "view.all", framesAll},
    KeyTrial{"Ctrl+Home", "view.camera",
             [](KeyTrials& at) {
                 lookAway(at);
                 at.press();
                 EXPECT_EQ(at.workspace.view.view().center, at.positionOf(at.named("camera")));
             }},
    KeyTrial{"Ctrl+0", "view.actual",
             [](KeyTrials& at) {
                 lookAway(at);
                 at.press();
                 EXPECT_EQ(at.workspace.view.zoom(), 1.0f);
                 EXPECT_NE(at.valueOf("Status/state").find("100%"), std::string::npos);
             }},
    KeyTrial{"Shift+S", "view.snap",
             [](KeyTrials& at) {
                 EXPECT_EQ(at.valueOf("Toolbar/Snap"), "on");
                 at.press();
                 EXPECT_EQ(at.valueOf("Toolbar/Snap"), "off");
                 EXPECT_FALSE(at.workspace.grid.snap);
             }},
    KeyTrial{"F3", "view.physics",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_EQ(at.valueOf("Overlay/physics"), "on");
                 at.press();
                 EXPECT_EQ(at.valueOf("Overlay/physics"), "off");
             }},
    KeyTrial{"Shift+F3", "view.reach", [](KeyTrials& at) { switchesOverlay(at, "reach"); }},
    KeyTrial{"Ctrl+F3", "view.trajectories", [](KeyTrials& at) { switchesOverlay(at, "trajectories"); }},
    KeyTrial{"Tab", "view.hidePanels",
             [](KeyTrials& at) {
                 ASSERT_TRUE(at.shown("Scene/crate"));
                 at.press();
                 EXPECT_FALSE(at.shown("Scene/crate"));
                 EXPECT_TRUE(at.shown("Viewport"));
                 at.press();
                 EXPECT_TRUE(at.shown("Scene/crate"));
             }},
    KeyTrial{"Equals", "view.closer", zooms<true>},
    KeyTrial{"PadPlus", "view.closer", zooms<true>},
    KeyTrial{"Minus", "view.farther", zooms<false>},
    KeyTrial{"PadMinus", "view.farther", zooms<false>},
    KeyTrial{"Alt+1", "layout.paint", showsLayout<0>},
    KeyTrial{"Alt+2", "layout.logic", showsLayout<1>},
    KeyTrial{"Alt+3", "layout.play", showsLayout<2>},
    KeyTrial{"Ctrl+Shift+L", "layout.save",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Layout/name"));
             }},
    KeyTrial{"Ctrl+Equals", "view.larger",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_EQ(at.workspace.settings.scale, 1.125f);
             }},
    KeyTrial{"Ctrl+Minus", "view.smaller",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_EQ(at.workspace.settings.scale, 0.875f);
             }},
    KeyTrial{"F5", "run.play",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.workspace.play.running());
                 EXPECT_FALSE(at.workspace.play.paused());
                 at.press();
                 EXPECT_FALSE(at.workspace.play.running());
                 EXPECT_EQ(at.workspace.text(), kSceneText);
             }},
    KeyTrial{"F6", "run.pause",
             [](KeyTrials& at) {
                 at.play(5);
                 at.press();
                 const std::int64_t tick = at.workspace.play.ticks();
                 at.hands.rest(5);
                 EXPECT_EQ(at.workspace.play.ticks(), tick);
                 at.press();
                 at.hands.rest(5);
                 EXPECT_GT(at.workspace.play.ticks(), tick);
             }},
    KeyTrial{"F10", "run.step",
             [](KeyTrials& at) {
                 at.play(5);
                 at.workspace.play.setPaused(true);
                 const std::int64_t tick = at.workspace.play.ticks();
                 at.press();
                 EXPECT_EQ(at.workspace.play.ticks(), tick + 1);
             }},
    KeyTrial{"Shift+F10", "run.stepBack",
             [](KeyTrials& at) {
                 at.play(10);
                 at.workspace.play.setPaused(true);
                 const std::int64_t tick = at.workspace.play.ticks();
                 at.press();
                 EXPECT_EQ(at.workspace.play.ticks(), tick - 1);
             }},
    KeyTrial{"F11", "script.into",
             [](KeyTrials& at) {
                 const Stopped game{at};
                 at.press();
                 EXPECT_EQ(game.line(), 2) << "the function";
             }},
    KeyTrial{"F10", "script.over",
             [](KeyTrials& at) {
                 const Stopped game{at};
                 at.press();
                 EXPECT_EQ(game.line(), 12);
             }},
    KeyTrial{"Shift+F11", "script.out",
             [](KeyTrials& at) {
                 const Stopped game{at};
                 at.press("F11");
                 at.press();
                 EXPECT_EQ(game.line(), 12);
             }},
    KeyTrial{"Shift+F10", "script.back",
             [](KeyTrials& at) {
                 const Stopped game{at};
                 at.press();
                 EXPECT_EQ(game.line(), 10);
             }},
    KeyTrial{"F9", "script.breakpoint",
             [](KeyTrials& at) {
                 const Stopped game{at};
                 at.press();
                 EXPECT_TRUE(at.workspace.debugger.breakpoints.all().empty());
             }},
    KeyTrial{"Shift+F5", "run.playPaused",
             [](KeyTrials& at) {
                 at.press();
                 at.hands.rest(5);
                 ASSERT_TRUE(at.workspace.play.running());
                 EXPECT_EQ(at.workspace.play.ticks(), 0);
             }},
    KeyTrial{"Shift+F6", "run.watch",
             [](KeyTrials& at) {
                 at.play(20);
                 at.workspace.play.setPaused(true);
                 const std::int64_t newest = at.workspace.play.newest();
                 at.workspace.play.seek(newest - 5);
                 at.press();
                 at.hands.rest(10);
                 EXPECT_EQ(at.workspace.play.ticks(), newest) << "to the end of what was recorded";
                 EXPECT_EQ(at.workspace.play.newest(), newest);
             }},
    KeyTrial{"F7", "run.slower",
             [](KeyTrials& at) {
                 at.play(2), at.press();
                 EXPECT_EQ(at.valueOf("Timeline/speed"), "1/2x");
             }},
    KeyTrial{"F8", "run.faster",
             [](KeyTrials& at) {
                 at.play(2), at.press();
                 EXPECT_EQ(at.valueOf("Timeline/speed"), "2x");
             }},
    KeyTrial{"F9", "run.normal",
             [](KeyTrials& at) {
                 at.play(2);
                 at.workspace.play.setSpeed(2);
                 at.press();
                 EXPECT_EQ(at.valueOf("Timeline/speed"), "1x");
             }},
};

}  // namespace

std::span<const KeyTrial> viewAndRunTrials() { return kTrials; }

}  // namespace plumb::editor::ui
