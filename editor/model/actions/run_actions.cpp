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
};

}  // namespace

std::span<const Action> runActions() { return kRows; }

}  // namespace plumb::editor
