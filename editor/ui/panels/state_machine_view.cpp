#include "editor/ui/panels/state_machine_view.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/sheet_cell.hpp"
#include "scene/components/drawing/animator.hpp"

namespace plumb::editor::ui {
namespace {

using Kind = MachinePart::Kind;

constexpr float kBeside = 400.0f;        // px at scale 1, minimum width for graph and details side by side
constexpr float kDetailsWidth = 232.0f;  // px at scale 1
constexpr float kLeastHeight = 110.0f;   // px at scale 1, minimum height of the graph above its details
constexpr float kValueWidth = 62.0f;     // px at scale 1
constexpr float kMostPicture = 96.0f;    // px at scale 1

template <class T>
const T& itemOf(const std::vector<T>& items, int index) {
    return items[static_cast<std::size_t>(index)];
}

}  // namespace

StateMachineView::StateMachineView(AnimationEdit& file)
    : file_{file}, edit_{file}, preview_{file.workspace().assets} {}

void StateMachineView::begin() {
    chosen_ = {};
    preview_.show(file_.id());
    preview_.restart();
}

const Animator* StateMachineView::inGame() const {
    const Workspace& workspace = file_.workspace();
    if (!workspace.play.running()) return nullptr;
    const World& world = workspace.play.world();
    const auto plays = [&](const Animator* animator) {
        return animator != nullptr && animator->animation == file_.id();
    };
    for (const ObjectId id : workspace.document.selection.all()) {
        const auto* animator = world.find<Animator>(workspace.shownEntity(id));
        if (plays(animator)) return animator;
    }
    for (auto [entity, animator] : world.query<const Animator>(withPaused)) {
        if (plays(&animator)) return &animator;
    }
    return nullptr;
}

void StateMachineView::dropStaleSelection() {
    const AnimationSet& set = edit_.set();
    const std::size_t count = chosen_.kind == Kind::State        ? set.states.size()
                              : chosen_.kind == Kind::Transition ? set.transitions.size()
                                                                 : set.parameters.size();
    if (chosen_.index >= static_cast<int>(count)) chosen_ = {};
}

void StateMachineView::drawParameters(Ui& ui) {
    dropStaleSelection();
    ImGui::TextDisabled("Parameters");
    tooltip("Parameters: values that the game sets and the conditions of transitions test");
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ui.px(32.0f));
    drawAddParameter(ui);
    if (edit_.set().parameters.empty())
        ImGui::TextWrapped("No parameters yet. Conditions of transitions need them.");
    for (int i = 0; i < static_cast<int>(edit_.set().parameters.size()); ++i) drawParameter(ui, i);
    ImGui::Separator();
}

void StateMachineView::drawAddParameter(Ui& ui) {
    const AnimationSet& set = edit_.set();
    const bool full = set.parameters.size() >= AnimationSet::kMaxParameters;
    ImGui::BeginDisabled(full);
    if (ImGui::SmallButton(" + ")) ImGui::OpenPopup("add parameter");
    ImGui::EndDisabled();
    ui.widgets.mark("Animation/addParameter");
    tooltip(full ? format("At most {} parameters", AnimationSet::kMaxParameters)
                 : std::string{"Add a parameter"});
    if (!ImGui::BeginPopup("add parameter")) return;
    const auto item = [&](const char* label, ParameterKind kind, std::string_view name,
                          std::string_view doc) {
        const bool clicked = ImGui::MenuItem(label);
        ui.widgets.mark(format("Animation/addParameter/{}", label));
        tooltip(doc);
        if (!clicked) return;
        const std::size_t before = edit_.set().parameters.size();
        edit_.addParameter(kind, name);
        if (edit_.set().parameters.size() > before) chosen_ = {Kind::Parameter, static_cast<int>(before)};
    };
    item("Number", ParameterKind::Float, {}, "A number; conditions compare it with a constant");
    item("On or off", ParameterKind::Bool, {}, "");
    item("Trigger", ParameterKind::Trigger, {},
         "Once set, it stays on until a transition that tests it is taken");
    ImGui::Separator();
    ImGui::TextDisabled("Set by the engine");
    for (const GameParameter& known : gameParameters()) {
        if (set.findParameter(known.name) >= 0) continue;
        item(std::string{known.name}.c_str(), known.kind, known.name, known.doc);
    }
    ImGui::EndPopup();
}

void StateMachineView::drawParameter(Ui& ui, int index) {
    const std::string name = itemOf(edit_.set().parameters, index).name;
    const float width = ImGui::GetContentRegionAvail().x - ui.px(kValueWidth + 6.0f);
    ImGui::PushID(index);
    ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});  // aligned with the value beside it
    const MachinePart part{Kind::Parameter, index};
    if (ImGui::Selectable(name.c_str(), chosen_ == part, 0,
                          {std::max(width, ui.px(30.0f)), ImGui::GetFrameHeight()}))
        chosen_ = part;
    ImGui::PopStyleVar();
    ui.widgets.mark("Animation/parameter/" + name);
    tooltip("Click to edit its name, kind and initial value");
    ImGui::SameLine(0.0f, ui.px(6.0f));
    drawValue(ui, index);
    ImGui::PopID();
}

void StateMachineView::drawValue(Ui& ui, int index) {
    const AnimationParameter& parameter = itemOf(edit_.set().parameters, index);
    const Animator* game = inGame();
    const auto slot = static_cast<std::size_t>(index);
    float value = game == nullptr                  ? preview_.value(index)
                  : slot < game->parameters.size() ? game->parameters[slot]
                                                   : parameter.initial;
    ImGui::BeginDisabled(game != nullptr);
    ImGui::SetNextItemWidth(ui.px(kValueWidth));
    bool changed = false;
    if (parameter.kind == ParameterKind::Float) {
        changed = ImGui::DragFloat("##now", &value, 0.5f, 0.0f, 0.0f, "%.4g");
    } else if (parameter.kind == ParameterKind::Bool) {
        bool on = value != 0.0f;
        changed = ImGui::Checkbox("##now", &on);
        value = on ? 1.0f : 0.0f;
    } else if (ImGui::Button(value != 0.0f ? "is set" : "Set", {ui.px(kValueWidth), 0.0f})) {
        changed = true;
        value = 1.0f;
    }
    ui.widgets.mark("Animation/now/" + parameter.name, format("{}", value));
    ImGui::EndDisabled();
    tooltip(game == nullptr ? "Value in the preview; change it to try the transitions"
                            : "Value in the running game");
    if (changed) preview_.setValue(index, value);
}

void StateMachineView::drawBar(Ui& ui, int clip) {
    ImGui::SameLine();
    if (ImGui::SmallButton("Add state")) {
        const std::size_t before = edit_.set().states.size();
        edit_.addState(clip);
        if (edit_.set().states.size() > before) chosen_ = {Kind::State, static_cast<int>(before)};
    }
    ui.widgets.mark("Animation/addState");
    tooltip("A state that plays the selected clip");
}

void StateMachineView::drawGraph(Ui& ui, int clip) {
    dropStaleSelection();
    preview_.show(file_.id());
    preview_.advance(static_cast<double>(ImGui::GetIO().DeltaTime));
    drawBar(ui, clip);
    if (edit_.set().states.empty()) {
        ImGui::TextWrapped(
            "No states: the game's code selects the clips. To use a state machine, select a clip and add a "
            "state.");
        return waitForKeys(ui);
    }
    const AnimationSet set = edit_.set();  // a copy, as an edit replaces the set
    const ImVec2 all = ImGui::GetContentRegionAvail();
    const bool wide = all.x >= ui.px(kBeside);
    const float gap = ui.px(10.0f);
    const ImVec2 room{wide ? all.x - std::max(ui.px(kDetailsWidth), std::floor(all.x * 0.36f)) - gap : all.x,
                      wide ? std::max(all.y, ui.px(60.0f)) : std::max(all.y * 0.5f, ui.px(kLeastHeight))};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float picture = std::clamp(room.y * 0.2f, ui.px(32.0f), ui.px(kMostPicture));
    if (ImGui::InvisibleButton("picture", {picture, picture})) preview_.restart();
    tooltip("Preview. Click to restart it in the first state, with the initial parameter values");
    ImGui::SetCursorScreenPos(start);
    const Animator* game = inGame();
    const GraphInput hands =
        drawStateGraph(ui, set, chosen_, game == nullptr ? preview_.state() : game->state, room);
    drawPicture(ui, start, picture);
    ImGui::SetCursorScreenPos(wide ? ImVec2{start.x + room.x + gap, ImGui::GetWindowPos().y}
                                   : ImVec2{start.x, start.y + room.y + ui.px(4.0f)});
    beginChild("details", {0.0f, 0.0f}, false);
    details_.draw(ui, edit_, chosen_);
    ImGui::EndChild();
    take(hands);
    waitForKeys(ui);
}

/// Draws the current frame of the preview or game into the corner that the ring of states leaves free.
void StateMachineView::drawPicture(Ui& ui, ImVec2 at, float side) {
    const AABB box{{at.x, at.y}, {at.x + side, at.y + side}};
    const Animator* game = inGame();
    const AnimationSet& set = edit_.set();
    AnimationFrame shown;
    bool there = false;
    if (game == nullptr) {
        if (const AnimationFrame* frame = preview_.frame()) shown = *frame, there = true;
    } else if (game->clip >= 0 && game->clip < static_cast<int>(set.clips.size())) {
        const auto& frames = itemOf(set.clips, game->clip).frames;
        there = game->frame >= 0 && game->frame < static_cast<int>(frames.size());
        if (there) shown = itemOf(frames, game->frame);
    }
    const int state = game == nullptr ? preview_.state() : game->state;
    const bool named = state >= 0 && state < static_cast<int>(set.states.size());
    ui.widgets.mark("Animation/machine", box, named ? itemOf(set.states, state).name : "");
    if (there) drawSheetCell(ui, file_, shown, box);
}

void StateMachineView::take(const GraphInput& hands) {
    if (hands.chosen) chosen_ = *hands.chosen;
    if (hands.entered >= 0) preview_.enter(hands.entered);
    if (!hands.joined) return;
    const std::size_t before = edit_.set().transitions.size();
    edit_.addTransition(hands.joined->first, hands.joined->second);
    if (edit_.set().transitions.size() > before) chosen_ = {Kind::Transition, static_cast<int>(before)};
}

void StateMachineView::waitForKeys(Ui& ui) {
    const bool wants = ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) && chosen_.kind != Kind::None;
    keysSeen_ = ImGui::GetFrameCount();
    if (wants && !ui.takeEvent) {
        ui.takeEvent = [this](const Event& event) { return takeKey(event); };
        waits_ = true;
    } else if (!wants && std::exchange(waits_, false)) {
        ui.takeEvent = nullptr;
    }
}

bool StateMachineView::takeKey(const Event& event) {
    const bool seen = ImGui::GetFrameCount() <= keysSeen_ + 1;
    if (!seen || anyPopupOpen() || ImGui::GetIO().WantTextInput) return false;
    if (!file_.workspace().settings.keys.matches(*findAction("edit.delete"), event)) return false;
    removePart(edit_, chosen_);
    return true;
}

}  // namespace plumb::editor::ui
