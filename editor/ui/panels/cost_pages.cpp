#include "editor/ui/panels/cost_pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/text.hpp"
#include "editor/model/cost/cost_words.hpp"
#include "editor/model/cost/stage_times.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::int64_t kRefresh = 15;  // ticks between two updates of the island table
constexpr float kNameWidth = 150.0f;   // px at scale 1
constexpr float kNumberWidth = 64.0f;  // px at scale 1
constexpr std::array<float, 8> kColumnWidths{50.0f,  60.0f,  48.0f,  52.0f,
                                             118.0f, 118.0f, 118.0f, 76.0f};  // px at scale 1
constexpr float kTickTime = 16.67f;  // ms, time budget of a tick at 60 Hz

std::string ms(float time) { return fixedText(static_cast<double>(time), time < 0.0995f ? 3 : 2); }

void textRight(Ui& ui, float width, const std::string& text) {
    const float left = ui.px(width) - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(left, 0.0f));
    ImGui::TextUnformatted(text.c_str());
}

void drawStage(Ui& ui, const StageTime& stage, float whole, float barWidth) {
    const std::string name{stage.name};
    ImGui::TextUnformatted(name.c_str());
    ui.widgets.mark("Cost/stage/" + name, ms(stage.median));
    if (!stage.doc.empty()) tooltip(stage.doc);
    ImGui::SameLine(ui.px(kNameWidth));
    textRight(ui, kNumberWidth, ms(stage.median));
    ui.widgets.mark("Cost/median/" + name, ms(stage.median));
    ImGui::SameLine(ui.px(kNameWidth + kNumberWidth));
    textRight(ui, kNumberWidth, ms(stage.p99));
    ui.widgets.mark("Cost/p99/" + name, ms(stage.p99));
    ImGui::SameLine(ui.px(kNameWidth + 2.0f * kNumberWidth + 14.0f));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto along = [&](float time) { return at.x + barWidth * std::clamp(time / whole, 0.0f, 1.0f); };
    list.AddRectFilled({at.x, at.y + line * 0.15f}, {at.x + barWidth, at.y + line * 0.85f}, palette::kField,
                       ui.px(2.0f));
    list.AddRectFilled({at.x, at.y + line * 0.15f},
                       {std::max(along(stage.median), at.x + 1.0f), at.y + line * 0.85f},
                       stage.inPhysics ? palette::kAccent : palette::kTextDim, ui.px(2.0f));
    const float p99 = along(stage.p99);
    list.AddRectFilled({p99 - ui.px(1.5f), at.y}, {p99 + ui.px(1.0f), at.y + line}, palette::kWarning);
    ImGui::Dummy({barWidth, line});
}

}  // namespace

void drawStagesPage(Ui& ui) {
    Profiler& profiler = ui.workspace.profiler;
    profiler.want();
    if (profiler.samples().empty()) {
        return emptyState(ui, "Cost", "There are no measurements yet.",
                          "The time of each part of a tick appears here while the game runs.", {"run.play"});
    }
    const StageTime tick = tickTime(profiler.samples());
    const std::string words = format("Median tick: {} ms, 99th percentile: {} ms, budget: {} ms.",
                                     ms(tick.median), ms(tick.p99), fixedText(16.7, 1));
    ImGui::TextUnformatted(words.c_str());
    ui.widgets.mark("Cost/tick", words);
    tooltip("CPU time of the main thread in the last second");
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    ImGui::TextUnformatted("part of a tick");
    ImGui::SameLine(ui.px(kNameWidth));
    textRight(ui, kNumberWidth, "median");
    ImGui::SameLine(ui.px(kNameWidth + kNumberWidth));
    textRight(ui, kNumberWidth, "p99");
    ImGui::SameLine(ui.px(kNameWidth + 2.0f * kNumberWidth + 14.0f));
    ImGui::TextUnformatted("ms; blue: physics; mark: 99th percentile");
    ImGui::PopStyleColor();
    beginChild("stages", {0.0f, 0.0f}, false);
    const std::vector<StageTime> stages = stageTimes(profiler.samples(), profiler.zones());
    float whole = 0.01f;
    for (const StageTime& stage : stages) {
        if (stage.name != "picture")
            whole = std::max(whole, stage.p99);  // the drawing time would dwarf all others
    }
    const float left = ui.px(kNameWidth + 2.0f * kNumberWidth + 14.0f);
    const float width = std::min(ImGui::GetContentRegionAvail().x - left - ui.px(8.0f), ui.px(620.0f));
    for (const StageTime& stage : stages) drawStage(ui, stage, std::min(whole, kTickTime), width);
    ImGui::EndChild();
}

void IslandsPage::refresh(const Ui& ui) {
    const PlayMode& play = ui.workspace.play;
    const std::int64_t now = play.ticks();
    const bool fresh = tick_ >= 0 && (play.paused() ? now == tick_ : std::abs(now - tick_) < kRefresh);
    if (fresh) return;
    tick_ = now;
    const Profiler& profiler = ui.workspace.profiler;
    float step = 0.0f;  // µs
    for (const StageTime& stage : stageTimes(profiler.samples(), profiler.zones())) {
        if (stage.inPhysics) step += stage.median * 1000.0f;
    }
    rows_ = islandRows(play.world(), step);
    sortIslands(rows_, by_, descending_);
}

void IslandsPage::draw(Ui& ui) {
    ui.workspace.profiler.want();
    if (!ui.workspace.play.running()) {
        tick_ = -1;
        return emptyState(ui, "Cost", "Islands exist only while the game runs.",
                          "An island is a group of bodies connected by contacts and joints; the solver "
                          "treats it as a unit.",
                          {"run.play"});
    }
    refresh(ui);
    const std::string words = rows_.empty()
                                  ? std::string{"All bodies are asleep; sleeping islands take no time."}
                                  : format(
                                        "{} {} awake. An island is a group of bodies connected by contacts "
                                        "and joints; click to select it.",
                                        rows_.size(), rows_.size() == 1 ? "island is" : "islands are");
    ImGui::TextDisabled("%s", words.c_str());
    ui.widgets.mark("Cost/islands", format("{}", rows_.size()));
    if (rows_.empty()) return;
    struct Column {
        const char* title;
        const char* doc;
    };
    static constexpr std::array<Column, 8> kColumns{{
        {"bodies", "Number of dynamic bodies"},
        {"contacts", "Number of touching contacts, including those with static bodies"},
        {"joints", "Number of joints"},
        {"quality", "Quality of the island: 2^quality substeps per tick"},
        {"speed", "Speed of the fastest body: residual motion if the bodies should be at rest"},
        {"overlap", "Maximum penetration depth of two shapes"},
        {"joint gap", "Maximum position error of a joint"},
        {"cost, about",
         "Estimated share of the measured step time, by number of bodies, contacts, joints and substeps"},
    }};
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                       ImGuiTableFlags_Sortable | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("islands", static_cast<int>(kColumns.size()), kFlags)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        const bool isCost = i + 1 == kColumns.size();
        ImGui::TableSetupColumn(kColumns[i].title,
                                ImGuiTableColumnFlags_WidthFixed |
                                    ImGuiTableColumnFlags_PreferSortDescending |
                                    (isCost ? ImGuiTableColumnFlags_DefaultSort : 0),
                                ui.px(kColumnWidths[i]));
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i));
        ImGui::TableHeader(kColumns[i].title);
        ui.widgets.mark(format("Cost/sort/{}", kColumns[i].title));
        if (*kColumns[i].doc != '\0') tooltip(kColumns[i].doc);
    }
    if (ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs(); specs != nullptr && specs->SpecsDirty) {
        if (specs->SpecsCount > 0) {
            by_ = static_cast<IslandColumn>(specs->Specs[0].ColumnIndex);
            descending_ = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
        }
        sortIslands(rows_, by_, descending_);
        specs->SpecsDirty = false;
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            drawRow(ui, static_cast<std::size_t>(i));
    }
    ImGui::EndTable();
}

void IslandsPage::drawRow(Ui& ui, std::size_t index) {
    const IslandRow row = rows_[index];
    const physics::IslandReport& island = row.report;
    const auto* state = ui.workspace.play.world().findResource<PhysicsState>();
    const PixelScale scale = state == nullptr ? PixelScale{} : state->scale;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(island.first.index));
    const bool clicked = ImGui::Selectable(format("{}", island.bodies).c_str(), chosen_ == island.first,
                                           ImGuiSelectableFlags_SpanAllColumns);
    ui.widgets.mark(format("Cost/island/{}", index), format("{}", island.bodies));
    ImGui::PopID();
    const auto cell = [](const std::string& text, bool isLarge = false) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, isLarge ? palette::kWarning : palette::kText);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
    };
    const auto seen = [&](float metres) { return pixelsOf(metres, scale) >= kSeenPixels; };
    cell(format("{}", island.contacts));
    cell(format("{}", island.joints));
    cell(format("{}", static_cast<int>(island.quality)));
    cell(format("{} m/s ({} px/s)", fixedText(static_cast<double>(island.speed), 2),
                fixedText(static_cast<double>(pixelsOf(island.speed, scale)), 0)));
    cell(lengthWords(island.overlap, scale), seen(island.overlap));
    cell(island.joints == 0 ? "-" : lengthWords(island.jointError, scale), seen(island.jointError));
    cell(format("{} µs", fixedText(static_cast<double>(row.microseconds), row.microseconds < 10.0f ? 1 : 0)));
    if (!clicked) return;
    chosen_ = island.first;
    std::vector<ObjectId> objects;
    for (const EntityId entity : entitiesOfIsland(ui.workspace.play.world(), island.first)) {
        if (const ObjectId id = ui.workspace.play.idOf(entity)) objects.push_back(id);
    }
    ui.workspace.document.selection.set(std::move(objects));
}

}  // namespace plumb::editor::ui
