#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "editor/model/profiler/profiler.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "physics/simulation.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kBar = 3.0f;           // px at scale 1, width of a tick's bar
constexpr float kGraphHeight = 84.0f;  // px at scale 1
constexpr float kLowestGraph = 44.0f;
constexpr float kGraphPart = 0.28f;       // maximum height of the graph, ratio to the panel's height
constexpr float kCountsWidth = 168.0f;    // px at scale 1
constexpr float kTick = 1000.0f / 60.0f;  // ms, time budget of a tick at 60 Hz

std::string ms(float time) { return fixedText(static_cast<double>(time), time < 9.995f ? 2 : 1); }

/// Returns the smallest number of the series 0.5, 1, 2, 5, 10 … that is at least the value.
float roundedUp(float value) {
    float step = 0.5f;
    for (const float factor : {2.0f, 2.0f, 2.5f, 2.0f, 2.0f, 2.5f, 2.0f, 2.0f, 2.5f, 2.0f}) {
        if (step >= value) break;
        step *= factor;
    }
    return std::max(step, value);
}

/// Returns the effects that a stage of the physics serves:
/// "contacts, triggers". Empty: the stage always runs.
std::string effectsOfStage(std::string_view stage) {
    std::string names;
    for (const physics::StageInfo& info : physics::stages()) {
        if (info.name != stage) continue;
        for (std::uint32_t i = 0; i < physics::kEffects; ++i) {
            const auto effect = static_cast<physics::Effect>(i);
            if ((info.effects & physics::Manifest::bit(effect)) == 0) continue;
            names += format("{}{}", names.empty() ? "" : ", ", physics::nameOf(effect));
        }
    }
    return names;
}

/// Shows the time of each tick of the running game.
class ProfilerPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        Profiler& profiler = ui.workspace.profiler;
        profiler.want();
        if (profiler.samples().empty()) {
            return emptyState(ui, "Profiler", "There are no measurements yet.",
                              "The time of each tick appears here while the game runs.", {"run.play"});
        }
        chosen_ = chosenSample(profiler);
        drawBar(ui, profiler);
        drawGraph(ui, profiler);
        beginChild("zones", {ImGui::GetContentRegionAvail().x - ui.px(kCountsWidth), 0.0f}, false);
        drawTable(ui, profiler);
        ImGui::EndChild();
        ImGui::SameLine();
        beginChild("counts", {0.0f, 0.0f}, false);
        drawCounts(ui, profiler.samples()[chosen_]);
        ImGui::EndChild();
    }

private:
    /// Returns the index of the clicked sample while the profiler stores it, else of the last sample.
    std::size_t chosenSample(const Profiler& profiler) {
        const auto& samples = profiler.samples();
        if (pinned_) {
            const auto found =
                std::find_if(samples.begin(), samples.end(),
                             [&](const Profiler::Sample& sample) { return sample.tick == pinned_; });
            if (found != samples.end()) return static_cast<std::size_t>(found - samples.begin());
            pinned_.reset();
        }
        return samples.size() - 1;
    }

    void choose(Profiler& profiler, std::size_t sample) {
        pinned_ = profiler.samples()[sample].tick;
        profiler.held = true;
    }

    void drawBar(Ui& ui, Profiler& profiler) {
        ImGui::PushStyleColor(ImGuiCol_Button, profiler.held ? palette::kAccentSoft : palette::kNothing);
        if (ImGui::Button("Hold")) {
            profiler.held = !profiler.held;
            if (!profiler.held) pinned_.reset();
        }
        ImGui::PopStyleColor();
        ui.widgets.mark("Profiler/hold", profiler.held ? "on" : "off");
        tooltip("Freezes the graph while the game continues. A click on a tick freezes it too.");
        ImGui::SameLine(0.0f, ui.px(4.0f));
        drawSpikes(ui, profiler);
        ImGui::SameLine(0.0f, ui.px(4.0f));
        drawGoThere(ui, profiler);
        ImGui::SameLine();
        float sum = 0.0f, worst = 0.0f;
        for (const Profiler::Sample& sample : profiler.samples()) {
            sum += sample.milliseconds;
            worst = std::max(worst, sample.milliseconds);
        }
        const Profiler::Sample& shown = profiler.samples()[chosen_];
        const std::string text =
            format("tick {}: {} ms, drawing {} ms.  Last {} ticks: mean {} ms, maximum {} ms", shown.tick,
                   ms(shown.milliseconds), ms(shown.drawing), profiler.samples().size(),
                   ms(sum / static_cast<float>(profiler.samples().size())), ms(worst));
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", text.c_str());
        ui.widgets.mark("Profiler/summary", text);
        tooltip("CPU time of the main thread. At 60 Hz a tick and its drawing together have 16.7 ms.");
    }

    void drawSpikes(Ui& ui, Profiler& profiler) {
        const std::vector<std::size_t> spikes = spikesOf(profiler.samples());
        const std::string label =
            format("{} {}###spikes", spikes.size(), spikes.size() == 1 ? "spike" : "spikes");
        ImGui::PushStyleColor(ImGuiCol_Text, spikes.empty() ? palette::kTextDim : palette::kWarning);
        const bool pressed = ImGui::Button(label.c_str());
        ImGui::PopStyleColor();
        ui.widgets.mark("Profiler/spikes", format("{}", spikes.size()));
        tooltip("Ticks that took much longer than the others. Click to go to the previous one.");
        if (!pressed || spikes.empty()) return;
        const auto next = std::lower_bound(spikes.begin(), spikes.end(), chosen_);
        choose(profiler, next == spikes.begin() ? spikes.back() : *std::prev(next));
    }

    void drawGoThere(Ui& ui, const Profiler& profiler) {
        PlayMode& play = ui.workspace.play;
        const std::int64_t tick = profiler.samples()[chosen_].tick;
        const bool possible = play.running() && tick >= play.oldest() && tick <= play.newest();
        ImGui::PushStyleColor(ImGuiCol_Text, possible ? palette::kText : palette::kTextDim);
        if (ImGui::Button("Go there") && possible) play.seek(tick);
        ImGui::PopStyleColor();
        ui.widgets.mark("Profiler/go");
        tooltip("Pauses the game and shows its state after this tick");
    }

    void drawGraph(Ui& ui, Profiler& profiler) {
        const auto& samples = profiler.samples();
        const float bar = std::max(std::floor(ui.px(kBar)), 2.0f);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float tall = std::clamp(room.y * kGraphPart, ui.px(kLowestGraph), ui.px(kGraphHeight));
        const ImVec2 size{room.x, std::floor(tall)};
        ImGui::InvisibleButton("graph", size);
        ui.widgets.mark("Profiler/graph");
        const bool hovered = ImGui::IsItemHovered();
        const bool pressed = ImGui::IsItemActive();
        const std::size_t count =
            std::min(samples.size(), static_cast<std::size_t>(std::max(size.x / bar, 1.0f)));
        const std::size_t first = samples.size() - count;
        float most = 0.0f;
        for (std::size_t i = first; i < samples.size(); ++i)
            most = std::max(most, samples[i].milliseconds + samples[i].drawing);
        const float whole = roundedUp(most);

        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{at.x + size.x, at.y + size.y};
        list.AddRectFilled(at, to, palette::kField, ui.px(3.0f));
        const float left = to.x - bar * static_cast<float>(count);
        const auto height = [&](float time) { return std::floor(time / whole * (size.y - ui.px(4.0f))); };
        for (std::size_t i = first; i < samples.size(); ++i) {
            const float x = left + bar * static_cast<float>(i - first);
            const float game = std::max(height(samples[i].milliseconds), 1.0f);
            const float all = game + height(samples[i].drawing);
            if (i == chosen_) list.AddRectFilled({x, at.y}, {x + bar - 1.0f, to.y}, palette::kAccentSoft);
            list.AddRectFilled({x, to.y - all}, {x + bar - 1.0f, to.y - game}, palette::kTextDim);
            list.AddRectFilled({x, to.y - game}, {x + bar - 1.0f, to.y},
                               samples[i].again ? palette::kWarning : palette::kAccent);
        }
        for (const std::size_t spike : spikesOf(profiler.samples())) {
            if (spike < first) continue;
            const float x = left + bar * (static_cast<float>(spike - first) + 0.5f);
            list.AddTriangleFilled({x - ui.px(3.0f), at.y}, {x + ui.px(3.0f), at.y}, {x, at.y + ui.px(5.0f)},
                                   palette::kError);
        }
        drawScale(ui, list, at, to, whole, height);
        if (!hovered && !pressed) return;
        const float under =
            std::clamp((ImGui::GetIO().MousePos.x - left) / bar, 0.0f, static_cast<float>(count) - 1.0f);
        const std::size_t sample = first + static_cast<std::size_t>(under);
        if (pressed) choose(profiler, sample);
        const Profiler::Sample& shown = samples[sample];
        tooltip(format("tick {}{}\n{} ms, and {} ms for drawing", shown.tick,
                       shown.again ? ", simulated again" : "", ms(shown.milliseconds), ms(shown.drawing)));
    }

    template <class Height>
    static void drawScale(const Ui& ui, ImDrawList& list, ImVec2 at, ImVec2 to, float whole, Height height) {
        const auto line = [&](float time, const std::string& label) {
            const float y = to.y - height(time);
            list.AddLine({at.x, y}, {to.x, y}, palette::kCellLine);
            list.AddText({at.x + ui.px(4.0f), y + ui.px(1.0f)}, palette::kTextDim, label.c_str());
        };
        line(whole, format("{} ms", ms(whole)));
        line(whole * 0.5f, format("{}", ms(whole * 0.5f)));
        if (kTick >= whole) return;
        // The label is at the right: in a low graph it would cover a label at the left.
        const char* label = "16.7";
        const float y = to.y - height(kTick);
        list.AddLine({at.x, y}, {to.x, y}, palette::kError);
        list.AddText({to.x - ImGui::CalcTextSize(label).x - ui.px(4.0f), y + ui.px(1.0f)}, palette::kTextDim,
                     label);
    }

    void drawTable(Ui& ui, Profiler& profiler) {
        constexpr ImGuiTableFlags kFlags =
            ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
        if (!ImGui::BeginTable("zones", 5, kFlags)) return;
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("System", ImGuiTableColumnFlags_WidthStretch);
        for (const char* column : {"tick", "mean", "worst"})
            ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthFixed, ui.px(58.0f));
        ImGui::TableSetupColumn("of the tick", ImGuiTableColumnFlags_WidthFixed, ui.px(110.0f));
        ImGui::TableHeadersRow();
        float mean = 0.0f;
        for (const Profiler::Sample& sample : profiler.samples()) mean += sample.milliseconds;
        mean /= static_cast<float>(profiler.samples().size());
        for (const Profiler::Row& row : rowsOf(profiler.samples(), profiler.zones(), chosen_))
            drawRow(ui, profiler, row, mean);
        ImGui::EndTable();
    }

    void drawRow(Ui& ui, Profiler& profiler, const Profiler::Row& row, float mean) {
        const Profiler::Zone& zone = profiler.zones()[row.zone];
        const std::string name{zone.name};
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(row.zone));
        if (zone.inPhysics) ImGui::Indent(ui.px(14.0f));
        ImGui::PushStyleColor(ImGuiCol_Text, zone.inPhysics ? palette::kTextDim : palette::kText);
        ImGui::TextUnformatted(name.c_str());
        ImGui::PopStyleColor();
        if (zone.inPhysics) ImGui::Unindent(ui.px(14.0f));
        ui.widgets.mark("Profiler/zone/" + name, ms(row.mean));
        if (zone.inPhysics) {
            const std::string effects = effectsOfStage(zone.name);
            tooltip(effects.empty() ? "A stage of the physics that always runs"
                                    : format("A stage of the physics, needed for: {}", effects));
        }
        const auto number = [&](float time) {
            ImGui::TableNextColumn();
            const std::string text = ms(time);
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(40.0f) - ImGui::CalcTextSize(text.c_str()).x);
            ImGui::TextUnformatted(text.c_str());
        };
        number(row.chosen);
        number(row.mean);
        number(row.worst);
        ui.widgets.mark("Profiler/worst/" + name, format("{}", row.worstTick));
        if (ImGui::IsItemClicked()) {
            const auto& samples = profiler.samples();
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (samples[i].tick == row.worstTick) choose(profiler, i);
            }
        }
        tooltip(format("The maximum was in tick {}; click to show that tick", row.worstTick));
        ImGui::TableNextColumn();
        drawBar(ui, row, zone.inPhysics, mean);
        ImGui::PopID();
    }

    /// Draws the share of the tick as a bar. A stage that runs on several threads has a thin bar per thread;
    /// the empty part of a thread's bar is time spent waiting for the others.
    static void drawBar(Ui& ui, const Profiler::Row& row, bool inPhysics, float mean) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float line = ImGui::GetTextLineHeight(), width = ui.px(100.0f);
        ImGui::Dummy({width, line});
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const auto x = [&](float time) {
            return at.x + width * (mean > 0.0f ? std::clamp(time / mean, 0.0f, 1.0f) : 0.0f);
        };
        const float top = at.y + line * 0.25f, height = line * 0.55f;
        const auto bar = [&](float from, float to, float y, float high, ImU32 color) {
            if (x(to) > x(from)) list.AddRectFilled({x(from), y}, {x(to), y + high}, color, ui.px(1.0f));
        };
        const std::vector<float>& busy = row.threads.busy;
        const ImU32 color = inPhysics ? palette::kTextDim : palette::kAccent;
        if (busy.size() < 2 || row.threads.shared <= 0.0f) return bar(0.0f, row.mean, top, height, color);
        const float alone = std::max(row.mean - row.threads.shared, 0.0f);
        const float each = height / static_cast<float>(busy.size());
        bar(0.0f, alone + row.threads.shared, top, height, palette::kCellLine);
        std::string text = format("Single-threaded: {} ms; multithreaded: {} ms, of which busy:", ms(alone),
                                  ms(row.threads.shared));
        for (std::size_t i = 0; i < busy.size(); ++i) {
            const float y = top + each * static_cast<float>(i);
            bar(i == 0 ? 0.0f : alone, alone + busy[i], y, std::max(each - 1.0f, 1.0f),
                i == 0 ? color : palette::kAccent);
            text += format("\nthread {}: {} ms", i + 1, ms(busy[i]));
        }
        tooltip(text);
    }

    static void drawCounts(Ui& ui, const Profiler::Sample& sample) {
        const Profiler::Counts& counts = sample.counts;
        const auto row = [&](const char* name, std::uint32_t number) {
            ImGui::TextDisabled("%s", name);
            const std::string text = format("{}", number);
            ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
            ImGui::TextUnformatted(text.c_str());
            ui.widgets.mark(format("Profiler/count/{}", name), text);
        };
        row("entities", counts.entities);
        row("bodies", counts.bodies);
        row("awake", counts.awake);
        row("contacts", counts.contacts);
        row("draw calls", counts.drawCalls);
        row("sprites", counts.sprites);
        ImGui::Spacing();
        ImGui::TextUnformatted("Active effects");
        tooltip(
            "Physics effects that run, and the number of bodies, shapes, joints or fields that need them");
        for (std::size_t i = 0; i < physics::kEffects; ++i) {
            if (counts.requesters[i] > 0)
                row(std::string{physics::nameOf(static_cast<physics::Effect>(i))}.c_str(),
                    counts.requesters[i]);
        }
    }

    std::size_t chosen_ = 0;              ///< index of the shown sample, in this frame
    std::optional<std::int64_t> pinned_;  ///< the clicked tick
};

}  // namespace

std::unique_ptr<Panel> makeProfilerPanel() { return std::make_unique<ProfilerPanel>(); }

}  // namespace plumb::editor::ui
