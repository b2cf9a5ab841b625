#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/effects/effects_view.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"

namespace plumb::editor::ui {
namespace {

using Line = EffectsView::Line;

constexpr float kPinWidth = 38.0f;    // px at scale 1, width of one of the three pin buttons
constexpr float kTimeWidth = 62.0f;   // px at scale 1
constexpr float kShareWidth = 96.0f;  // px at scale 1
constexpr Pin kPins[] = {Pin::Auto, Pin::On, Pin::Off};

/// Formats a time given in ms as a number of µs: "12.3".
std::string micro(float milliseconds) {
    const double microseconds = static_cast<double>(milliseconds) * 1000.0;
    return fixedText(microseconds, microseconds < 9.995 ? 2 : microseconds < 99.95 ? 1 : 0);
}

std::string joined(const std::vector<std::string_view>& names) {
    std::string text;
    for (const std::string_view name : names) text += format("{}{}", text.empty() ? "" : ", ", name);
    return text;
}

/// Lists every effect: if it runs, which components need it, its time, and if the scene pins it on or off.
class EffectsPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        if (ui.workspace.play.running()) ui.workspace.profiler.want();
        view_.refresh(ui.workspace);
        const auto isListed = [](const Line& line) { return line.isRequired || line.pin != Pin::Auto; };
        if (std::none_of(view_.lines().begin(), view_.lines().end(), isListed)) {
            return emptyState(
                ui, "Effects", "No component of this scene needs an effect.",
                "Running effects, and the components that need them, appear here as components are added.");
        }
        drawBar(ui);
        constexpr ImGuiTableFlags kFlags =
            ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
        if (!ImGui::BeginTable("effects", 5, kFlags)) return;
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("Effect", ImGuiTableColumnFlags_WidthFixed, ui.px(170.0f));
        ImGui::TableSetupColumn("In this scene", ImGuiTableColumnFlags_WidthFixed, ui.px(3.0f * kPinWidth));
        ImGui::TableSetupColumn("µs a tick", ImGuiTableColumnFlags_WidthFixed, ui.px(kTimeWidth));
        ImGui::TableSetupColumn("of the tick", ImGuiTableColumnFlags_WidthFixed, ui.px(kShareWidth));
        ImGui::TableSetupColumn("Needed by", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableHeadersRow();
        drawGroup(ui, "Physics", true);
        drawGroup(ui, "Systems and devices", false);
        ImGui::EndTable();
    }

private:
    void drawBar(Ui& ui) {
        const std::size_t running = view_.running();
        for (const bool all : {true, false}) {
            const std::string label =
                all ? format("All {}", view_.lines().size()) : format("Running {}", running);
            ImGui::PushStyleColor(ImGuiCol_Button,
                                  all != onlyRunning_ ? palette::kAccentSoft : palette::kNothing);
            if (ImGui::Button((label + (all ? "###all" : "###running")).c_str())) onlyRunning_ = !all;
            ImGui::PopStyleColor();
            ui.widgets.mark(all ? "Effects/all" : "Effects/running", label);
            ImGui::SameLine(0.0f, ui.px(4.0f));
        }
        std::string text = "Times appear while the game runs.";
        if (view_.tickMilliseconds() > 0.0f)
            text = format("Mean tick of the last second: {} µs.", micro(view_.tickMilliseconds()));
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", text.c_str());
        ui.widgets.mark("Effects/summary", text);
        tooltip("CPU time of the main thread. Turning an effect off saves the time shown for it.");
    }

    void drawGroup(Ui& ui, const char* title, bool inPhysics) {
        bool first = true;
        for (const Line& line : view_.lines()) {
            if (line.inPhysics != inPhysics || (onlyRunning_ && !line.runs)) continue;
            if (std::exchange(first, false)) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextDisabled("%s", title);
            }
            drawLine(ui, line);
        }
    }

    void drawLine(Ui& ui, const Line& line) {
        const EffectRow& row = view_.table().rows()[line.row];
        const std::string path = format("Effects/{}", row.name);
        ImGui::TableNextRow();
        ImGui::PushID(static_cast<int>(line.row));
        ImGui::TableNextColumn();
        drawName(ui, row, line, path);
        ImGui::TableNextColumn();
        drawPin(ui, row, line, path);
        ImGui::TableNextColumn();
        drawCost(ui, line, path);
        ImGui::TableNextColumn();
        drawShare(ui, line);
        ImGui::TableNextColumn();
        drawRequesters(ui, row, line, path);
        ImGui::PopID();
    }

    static void drawName(Ui& ui, const EffectRow& row, const Line& line, const std::string& path) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float tall = ImGui::GetTextLineHeight();
        const ImVec2 dot{at.x + ui.px(10.0f), at.y + tall * 0.5f};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (line.runs) {
            list.AddCircleFilled(dot, ui.px(3.5f), palette::kPlay);
        } else {
            list.AddCircle(dot, ui.px(3.0f), palette::kTextDim);
        }
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(22.0f));
        ImGui::PushStyleColor(ImGuiCol_Text, line.runs ? palette::kText : palette::kTextDim);
        ImGui::TextUnformatted(row.name.data(), row.name.data() + row.name.size());
        ImGui::PopStyleColor();
        ui.widgets.mark(path, line.runs ? "on" : "off");
        std::string about{row.doc};
        if (!line.zones.own.empty()) about += format("\nProfiler zones: {}", joined(line.zones.own));
        if (!line.zones.shared.empty())
            about += format("\nShared profiler zones: {}", joined(line.zones.shared));
        if (!row.device.empty()) about += format("\nDevice opened for this effect: {}", row.device);
        if (!line.pinnedBy.empty()) about += format("\nPinned by {}", line.pinnedBy);
        tooltip(about);
    }

    /// Draws the three buttons "auto | on | off" that pin the effect.
    static void drawPin(Ui& ui, const EffectRow& row, const Line& line, const std::string& path) {
        const bool possible = ui.workspace.canEdit() && !editsPrefab(ui.workspace);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float height = ImGui::GetTextLineHeight();
        const ImVec2 from = ImGui::GetCursorScreenPos();
        for (const Pin pin : kPins) {
            const std::string name{nameOf(pin)};
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const ImVec2 to{at.x + ui.px(kPinWidth), at.y + height};
            const bool pressed = ImGui::InvisibleButton(name.c_str(), {ui.px(kPinWidth), height});
            const bool chosen = line.pin == pin;
            ui.widgets.mark(path + "/" + name, chosen ? "chosen" : "");
            tooltip(!possible          ? "Stop the game to change the scene."
                    : pin == Pin::Auto ? "Runs while a component needs it."
                    : pin == Pin::On
                        ? "Always runs, even if no component needs it."
                        : "Never runs. When the scene opens, the console lists the components that need it.");
            if (chosen) {
                list.AddRectFilled(at, to, pin == Pin::Auto ? palette::kHover : palette::kAccentSoft,
                                   ui.px(3.0f));
            } else if (possible && ImGui::IsItemHovered()) {
                list.AddRectFilled(at, to, palette::kHover, ui.px(3.0f));
            }
            const ImVec2 size = ImGui::CalcTextSize(name.c_str());
            const bool strong = chosen && pin != Pin::Auto;
            list.AddText({(at.x + to.x - size.x) * 0.5f, at.y}, strong ? palette::kText : palette::kTextDim,
                         name.c_str());
            if (pressed && possible && !chosen) pinEffect(ui.workspace, row.name, pin);
            if (pin != Pin::Off) ImGui::SameLine(0.0f, 0.0f);
        }
        outline(list, from, {from.x + ui.px(3.0f * kPinWidth), from.y + height}, palette::kCellLine,
                ui.px(3.0f));
    }

    static void drawCost(Ui& ui, const Line& line, const std::string& path) {
        const bool shared = line.runs && !line.zones.shared.empty() && line.zones.own.empty();
        const std::string text = line.measured ? micro(line.milliseconds) : shared ? "shared" : "";
        const float wide = ImGui::CalcTextSize(text.c_str()).x;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kTimeWidth - 8.0f) - wide);
        if (line.measured) {
            ImGui::TextUnformatted(text.c_str());
        } else {
            ImGui::TextDisabled("%s", text.c_str());
        }
        ui.widgets.mark(path + "/cost", text);
        if (shared)
            tooltip(
                format("Measured as part of {}, which other effects use too.\nplumb-player --effects "
                       "measures how much time turning this effect off saves.",
                       joined(line.zones.shared)));
    }

    static void drawShare(Ui& ui, const Line& line) {
        if (!line.measured) return;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetTextLineHeight();
        const float width = ui.px(kShareWidth - 8.0f);
        ImGui::Dummy({width, height});
        ImGui::GetWindowDrawList()->AddRectFilled(
            {at.x, at.y + height * 0.25f},
            {at.x + std::max(width * std::clamp(line.share, 0.0f, 1.0f), 1.0f), at.y + height * 0.8f},
            palette::kAccent, ui.px(2.0f));
        tooltip(format("{} % of the tick", fixedText(100.0 * static_cast<double>(line.share), 1)));
    }

    static void drawRequesters(Ui& ui, const EffectRow& row, const Line& line, const std::string& path) {
        if (line.requesters.empty() && line.isRequired) {
            ImGui::TextDisabled("needed by tiles or game code");
            return;
        }
        if (line.requesters.empty()) {
            const std::string names = "none of: " + missingRequesters(row);
            ImGui::TextDisabled("%s", names.c_str());
            ui.widgets.mark(path + "/none", names);
            return;
        }
        bool first = true;
        for (const EffectCount& requester : line.requesters) {
            if (!std::exchange(first, false)) ImGui::SameLine(0.0f, ui.px(10.0f));
            const std::string text = format("{} {}", requester.type->name, requester.count);
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const ImVec2 size = ImGui::CalcTextSize(text.c_str());
            const bool pressed = ImGui::InvisibleButton(text.c_str(), {size.x, ImGui::GetTextLineHeight()});
            ui.widgets.mark(format("{}/{}", path, requester.type->name), format("{}", requester.count));
            ImDrawList& list = *ImGui::GetWindowDrawList();
            list.AddText(at, palette::kAccent, text.c_str());
            if (ImGui::IsItemHovered())
                list.AddLine({at.x, at.y + size.y}, {at.x + size.x, at.y + size.y}, palette::kAccent);
            tooltip("Selects the entities with this component");
            if (pressed) selectRequesters(ui.workspace, row, *requester.type);
        }
    }

    EffectsView view_;
    bool onlyRunning_ = false;
};

}  // namespace

std::unique_ptr<Panel> makeEffectsPanel() { return std::make_unique<EffectsPanel>(); }

}  // namespace plumb::editor::ui
