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

// ---- lines of scripts

bool halted(const Workspace& w) { return w.debugger.halt() != nullptr; }

template <void (ScriptDebugger::*Step)(const InputFrame&)>
void stepLine(Workspace& w) {
    (w.debugger.*Step)(w.gameInput ? w.gameInput() : InputFrame{});
    if (!w.debugger.notice().empty()) w.notice = w.debugger.notice();
}
void stepLineBack(Workspace& w) {
    w.debugger.stepBack();
    if (!w.debugger.notice().empty()) w.notice = w.debugger.notice();
}
void toggleBreakpoint(Workspace& w) {
    const Halt* halt = w.debugger.halt();
    w.debugger.breakpoints.toggle(halt->file, halt->line);
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
    line("Run"),
    Action{
        "script.into", "Run", "Next script line", {Key::F11}, running, stepLine<&ScriptDebugger::stepInto>},
    Action{"script.over",
           "Run",
           "Step over",
           {Key::F10},
           halted,
           stepLine<&ScriptDebugger::stepOver>,
           nullptr,
           {},
           During::Halted},
    Action{"script.out", "Run", "Step out", shifted(Key::F11), halted, stepLine<&ScriptDebugger::stepOut>},
    Action{"script.back",
           "Run",
           "Previous script line",
           shifted(Key::F10),
           running,
           stepLineBack,
           nullptr,
           {},
           During::Halted},
    Action{"script.breakpoint",
           "Run",
           "Breakpoint here",
           {Key::F9},
           halted,
           toggleBreakpoint,
           [](const Workspace& w) {
               const Halt* halt = w.debugger.halt();
               return halt != nullptr && w.debugger.breakpoints.find(halt->file, halt->line) != nullptr;
           },
           {},
           During::Halted},
};

}  // namespace

std::span<const Action> runActions() { return kRows; }

}  // namespace plumb::editor
