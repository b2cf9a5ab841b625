#include <array>

#include "core/text.hpp"
#include "editor/model/actions/action_rows.hpp"
#include "editor/model/document/bounds.hpp"

namespace plumb::editor {
namespace {

void frameSelection(Workspace& w) {
    if (const auto box = boundsOf(w.document, w.document.selection.all())) w.view.frame(*box);
}
void frameAll(Workspace& w) {
    if (const auto box = boundsOf(w.document, w.document.objects())) w.view.frame(*box);
}

/// Zooms about the center of the view.
template <int Steps>
void zoomBy(Workspace& w) {
    w.view.zoomAt(w.view.view().size * 0.5f, static_cast<float>(Steps));
}

template <SnapTo To>
void snapTo(Workspace& w) {
    w.grid.to = To;
    w.grid.snap = true;
}
template <SnapTo To>
bool snapsTo(const Workspace& w) {
    return w.grid.to == To;
}
void hidePanels(Workspace& w) {
    w.settings.layout.hidden = !w.settings.layout.hidden;
    w.notice = w.settings.layout.hidden
                   ? w.settings.keys.shownOf(*findAction("view.hidePanels")).text() + " shows the panels"
                   : "";
}
template <std::size_t Index>
void usePreset(Workspace& w) {
    const LayoutPreset& preset = layoutPresets()[Index];
    w.settings.layout = preset.layout;
    w.notice = format("Layout {}: {}", preset.name, preset.what);
}

const std::array kRows{
    Action{"view.frame", "View", "Frame selection", {Key::F}, anySelection, frameSelection},
    Action{"view.all", "View", "Frame all", {Key::Home}, always, frameAll, nullptr, shifted(Key::F)},
    Action{"view.camera", "View", "Frame the camera's area", control(Key::Home), always,
           [](Workspace& w) { w.showStart(); }},
    Action{"view.actual", "View", "Actual size", control(Key::Digit0), always,
           [](Workspace& w) { w.view.setZoom(1.0f); }},
    Action{"view.closer", "View", "Zoom in", {Key::Equals}, always, zoomBy<2>, nullptr, {Key::PadPlus}},
    Action{"view.farther", "View", "Zoom out", {Key::Minus}, always, zoomBy<-2>, nullptr, {Key::PadMinus}},
    line("View"),
    Action{"view.snap", "View", "Snap", shifted(Key::S), always,
           [](Workspace& w) { w.grid.snap = !w.grid.snap; }, [](const Workspace& w) { return w.grid.snap; }},
    Action{"view.snapGrid",
           "View",
           "Snap to the grid's lines",
           {},
           always,
           snapTo<SnapTo::Grid>,
           snapsTo<SnapTo::Grid>},
    Action{"view.snapHalf",
           "View",
           "Snap to half the grid",
           {},
           always,
           snapTo<SnapTo::HalfGrid>,
           snapsTo<SnapTo::HalfGrid>},
    Action{"view.snapPixel",
           "View",
           "Snap to pixels",
           {},
           always,
           snapTo<SnapTo::Pixel>,
           snapsTo<SnapTo::Pixel>},
    Action{"view.snapAngles",
           "View",
           "Rotate in steps",
           {},
           always,
           [](Workspace& w) { w.grid.snapAngles = !w.grid.snapAngles; },
           [](const Workspace& w) { return w.grid.snapAngles; }},
    line("View"),
    Action{"view.physics",
           "View",
           "Physics",
           {Key::F3},
           always,
           [](Workspace& w) { w.physics.on = !w.physics.on; },
           [](const Workspace& w) { return w.physics.on; }},
    Action{"view.reach", "View", "Jump reach", shifted(Key::F3), always,
           [](Workspace& w) { w.toggleOverlay("reach"); },
           [](const Workspace& w) { return w.shows("reach"); }},
    Action{"view.trajectories", "View", "Trajectories", control(Key::F3), always,
           [](Workspace& w) { w.toggleOverlay("trajectories"); },
           [](const Workspace& w) { return w.shows("trajectories"); }},
    line("View"),
    Action{"view.hidePanels",
           "View",
           "Hide panels",
           {Key::Tab},
           always,
           hidePanels,
           [](const Workspace& w) { return w.settings.layout.hidden; }},
    Action{"layout.paint", "", "Paint", {Key::Digit1, false, false, true}, always, usePreset<0>},
    Action{"layout.logic", "", "Logic", {Key::Digit2, false, false, true}, always, usePreset<1>},
    Action{"layout.play", "", "Play", {Key::Digit3, false, false, true}, always, usePreset<2>},
    Action{"layout.save",
           "",
           "Save layout as...",
           {Key::L, true, true, false},
           always,
           ask<WindowRequest::NameLayout>},
    Action{"view.larger", "View", "Larger interface", control(Key::Equals), always,
           ask<WindowRequest::LargerText>},
    Action{"view.smaller", "View", "Smaller interface", control(Key::Minus), always,
           ask<WindowRequest::SmallerText>},
};

}  // namespace

std::span<const Action> viewActions() { return kRows; }

}  // namespace plumb::editor
