#include <array>

#include "editor/model/actions/action_rows.hpp"

namespace plumb::editor {
namespace {

bool running(const Workspace& w) { return w.play.running(); }
bool canPlay(const Workspace& w) { return w.play.running() || !w.document.scenePath.empty(); }
void step(Workspace& w) {
    w.play.setPaused(true);
    w.play.step(w.gameInput ? w.gameInput() : InputFrame{});
}

void stepBack(Workspace& w) { w.play.seek(w.play.ticks() - 1); }
bool inPast(const Workspace& w) { return w.play.inPast(); }
template <int By>
void speedBy(Workspace& w) {
    w.play.setSpeed(w.play.speed() + By);
}

const std::array kRows{
    Action{"run.play", "Run", "Play", {Key::F5}, canPlay, [](Workspace& w) { w.togglePlay(); }, running},
    Action{"run.pause",
           "Run",
           "Pause",
           {Key::F6},
           running,
           [](Workspace& w) { w.play.setPaused(!w.play.paused()); },
           [](const Workspace& w) { return w.play.paused(); }},
    Action{"run.step", "Run", "Step one tick", {Key::F10}, running, step},
    Action{"run.stepBack", "Run", "Step back", shifted(Key::F10), running, stepBack},
    line("Run"),
    Action{"run.playPaused", "Run", "Play, paused before the first tick", shifted(Key::F5), editable,
           [](Workspace& w) { w.startPlaying(true); }},
    Action{"run.watch", "Run", "Watch the recording", shifted(Key::F6), inPast,
           [](Workspace& w) { w.play.playReplay(); }},
    line("Run"),
    Action{"run.slower", "Run", "Slower", {Key::F7}, always, speedBy<-1>},
    Action{"run.faster", "Run", "Faster", {Key::F8}, always, speedBy<1>},
    Action{"run.normal", "Run", "Normal speed", {Key::F9}, always, [](Workspace& w) { w.play.setSpeed(0); }},
};

}  // namespace

std::span<const Action> runActions() { return kRows; }

}  // namespace plumb::editor
