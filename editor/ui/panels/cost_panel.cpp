#include <algorithm>
#include <string>

#include "core/text.hpp"
#include "editor/model/cost/advice.hpp"
#include "editor/model/cost/cost_words.hpp"
#include "editor/model/cost/what_if.hpp"
#include "editor/ui/panels/cost_pages.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/work_precision.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kCurveWidth = 420.0f;  // px at scale 1
constexpr float kCurvePart = 0.38f;    // maximum share of the panel's width
constexpr float kMostWords = 760.0f;   // px at scale 1, maximum line width for readable text

void wrapped(const std::string& words, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

/// Physics time and accuracy of a scene, and of the same scene at other quality settings.
class CostPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        whatIf_.update(ui.workspace);
        const Document& document = ui.workspace.document;
        if (document.objectCount() == 0 && !ui.workspace.play.running()) {
            whatIf_.cancel();
            return emptyState(ui, "Cost", "The scene is empty.",
                              "Time and accuracy of the scene's physics are shown here.", {});
        }
        if (document.scenePath != scene_) whatIf_.forget(), scene_ = document.scenePath;
        if (!ImGui::BeginTabBar("cost pages")) return;
        const auto page = [&](const std::string& label, const char* name, const char* doc) {
            const bool open = ImGui::BeginTabItem(format("{}###{}", label, name).c_str());
            ui.widgets.mark(std::string{"Cost/page/"} + name, open ? "open" : label);
            tooltip(doc);
            return open;
        };
        if (page("Quality", "Quality", "Time and accuracy of this scene at each quality setting"))
            drawQuality(ui), ImGui::EndTabItem();
        if (page(adviceLabel(ui), "Advice", "Suggested improvements for this scene"))
            drawAdvice(ui), ImGui::EndTabItem();
        if (page("Islands", "Islands",
                 "Groups of bodies connected by contacts and joints, each solved as a unit"))
            islands_.draw(ui), ImGui::EndTabItem();
        if (page("Stages", "Stages", "Time of each part of a tick")) drawStagesPage(ui), ImGui::EndTabItem();
        ImGui::EndTabBar();
    }

private:
    /// Returns the measurements together with the scene's present settings, which may have changed since.
    [[nodiscard]] WhatIfResult shownResult(const Ui& ui) const {
        WhatIfResult result = whatIf_.result();
        takePresent(ui.workspace, result.scale, result.settings);
        return result;
    }

    [[nodiscard]] std::vector<Advice> advice(const WhatIfResult& result) const {
        if (!result.complete || whatIf_.tape() == nullptr) return {};
        return adviceFor({result, *whatIf_.tape()});
    }

    [[nodiscard]] std::string adviceLabel(const Ui& ui) const {
        if (!whatIf_.measured()) return "Advice";
        const std::size_t count = advice(shownResult(ui)).size();
        return count == 0 ? std::string{"Advice"} : format("Advice ({})", count);
    }

    /// Draws the button that starts the measurement, and its progress.
    void drawBar(Ui& ui) {
        Workspace& workspace = ui.workspace;
        if (whatIf_.busy()) {
            if (ImGui::Button("Stop")) whatIf_.cancel();
            ui.widgets.mark("Cost/stop");
            ImGui::SameLine();
            ImGui::ProgressBar(whatIf_.progress(), {ui.px(220.0f), 0.0f});
            ui.widgets.mark("Cost/progress", format("{}", static_cast<int>(whatIf_.progress() * 100.0f)));
            ImGui::SameLine();
            ImGui::AlignTextToFramePadding();
            ImGui::TextDisabled("simulating the same ticks at every quality; the game continues");
            return;
        }
        const bool playing = workspace.play.running();
        const char* label = !playing             ? "Measure the scene's first 5 s"
                            : whatIf_.measured() ? "Measure again"
                                                 : "Measure the last 5 s";
        if (ImGui::Button(label)) whatIf_.begin(workspace);
        ui.widgets.mark("Cost/measure", label);
        tooltip(
            "Simulates the same ticks at every quality and with a reference solution. The game itself is not "
            "changed.");
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        if (!whatIf_.refusal().empty()) {
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::kWarning), "%s",
                               whatIf_.refusal().c_str());
            ui.widgets.mark("Cost/refusal", whatIf_.refusal());
        } else if (!whatIf_.measured()) {
            ImGui::TextDisabled("Compares time and accuracy of this scene at all quality settings.");
        } else {
            const WhatIfResult result = whatIf_.result();
            const std::string method = methodWords(result, whatIf_.wasPlaying(), whatIf_.tape()->leftOut);
            ImGui::TextDisabled("%s", method.substr(0, method.find(". ") + 1).c_str());
            ui.widgets.mark("Cost/method", method);
            tooltip(method);
        }
    }

    void drawQuality(Ui& ui) {
        drawBar(ui);
        if (!whatIf_.measured()) return drawLesson(ui);
        const WhatIfResult result = shownResult(ui);
        if (result.points.empty()) return;
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float width = std::min(ui.px(kCurveWidth), room.x * kCurvePart);
        beginChild("curve", {width, 0.0f}, false);
        const int clicked =
            drawWorkPrecision(ui, result, {width, std::min(ImGui::GetContentRegionAvail().y, ui.px(260.0f))});
        ImGui::EndChild();
        ImGui::SameLine(0.0f, ui.px(16.0f));
        beginChild("sentences", {std::min(ImGui::GetContentRegionAvail().x, ui.px(kMostWords)), 0.0f}, false);
        // Tight spacing, so that all seven qualities are visible in a small window.
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8.0f), ui.px(2.0f)});
        drawSentences(ui, result);
        ImGui::PopStyleVar();
        ImGui::EndChild();
        if (clicked >= 0) apply(ui, qualityRemedy(clicked), result);
    }

    /// Explains quality settings before the first measurement.
    static void drawLesson(Ui& ui) {
        ImGui::Spacing();
        beginChild("lesson", {std::min(ImGui::GetContentRegionAvail().x, ui.px(kMostWords)), 0.0f}, false);
        wrapped(
            "The physics divides each tick into substeps. More substeps are more accurate and take longer. "
            "The quality of a scene sets their number, from 0 (1 substep) to 6 (64 substeps).",
            palette::kText);
        ImGui::Spacing();
        wrapped(
            "The measurement simulates some seconds of this scene at every quality, and shows the time and "
            "the largest error: the penetration of shapes or the position error of joints. Errors below half "
            "a pixel are invisible, so the best choice is the cheapest quality with such errors.",
            palette::kTextSoft);
        ui.widgets.mark("Cost/lesson");
        ImGui::EndChild();
    }

    void drawSentences(Ui& ui, const WhatIfResult& result) {
        if (const std::string verdict = verdictWords(result); !verdict.empty()) {
            wrapped(verdict, palette::kText);
            ui.widgets.mark("Cost/verdict", verdict);
            ImGui::Spacing();
        }
        const WhatIfPoint* present = result.present();
        const WhatIfPoint* enough = result.complete ? enoughQuality(result) : nullptr;
        const WhatIfPoint* below = nullptr;
        for (const WhatIfPoint& point : result.points) {
            if (point.kind != WhatIfKind::Quality) continue;
            drawSentence(ui, result, point, below, &point == present, &point == enough);
            below = &point;
        }
        if (!result.complete) return;
        ImGui::Spacing();
        if (result.isChaotic) {
            const std::string words = format(
                "This scene is chaotic: after a displacement of {} at the start, half of the bodies end more "
                "than {} away. Final positions cannot be compared; overlaps and joint errors can.",
                "0.01 mm", lengthWords(result.hair, result.scale));
            wrapped(words, palette::kTextDim);
            ui.widgets.mark("Cost/chaos", words);
        } else if (present != nullptr && present->away >= 0.0f) {
            const std::string words = format(
                "At this quality, half of the bodies end more than {} away from the reference solution.",
                lengthWords(present->away, result.scale));
            wrapped(words, palette::kTextDim);
            ui.widgets.mark("Cost/away", words);
        }
    }

    void drawSentence(Ui& ui, const WhatIfResult& result, const WhatIfPoint& point, const WhatIfPoint* below,
                      bool isPresent, bool isEnough) {
        ImGui::PushID(point.quality);
        const std::string words = qualityWords(result, point, below);
        if (isPresent) {
            ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
            ImGui::TextUnformatted("now");
            ImGui::PopStyleColor();
        } else {
            ImGui::PushStyleColor(ImGuiCol_Button, isEnough ? palette::kAccentSoft : palette::kButton);
            if (ImGui::SmallButton("Use")) apply(ui, qualityRemedy(point.quality), result);
            ImGui::PopStyleColor();
            ui.widgets.mark(format("Cost/use/{}", point.quality), isEnough ? "enough" : "");
            tooltip(ui.workspace.play.running()
                        ? "Sets this quality in the running game; you can keep it when the game stops"
                        : "Sets this quality in the scene; can be undone");
        }
        ImGui::SameLine(ui.px(40.0f));
        const bool seen = pixelsOf(point.error(), result.scale) >= kSeenPixels;
        ImGui::PushStyleColor(ImGuiCol_Text, seen ? palette::kTextSoft : palette::kText);
        ImGui::TextUnformatted(words.c_str());
        ImGui::PopStyleColor();
        ui.widgets.mark(format("Cost/quality/{}", point.quality), words);
        if (isEnough) {
            ImGui::SameLine();
            ImGui::PushStyleColor(ImGuiCol_Text, palette::kPlay);
            ImGui::TextUnformatted(seen ? "most accurate" : "errors are invisible");
            ImGui::PopStyleColor();
        }
        ImGui::PopID();
    }

    void drawAdvice(Ui& ui) {
        drawBar(ui);
        if (!whatIf_.measured()) {
            ImGui::Spacing();
            return wrapped("Advice needs a measurement. Click the button above to measure.",
                           palette::kTextSoft);
        }
        const WhatIfResult result = shownResult(ui);
        if (!result.complete) return;
        const std::vector<Advice> all = advice(result);
        ImGui::Spacing();
        beginChild("advice", {std::min(ImGui::GetContentRegionAvail().x, ui.px(kMostWords * 1.2f)), 0.0f},
                   false);
        if (all.empty()) {
            wrapped("No advice: no setting of this scene needs a change.", palette::kText);
            ui.widgets.mark("Cost/advice/none");
        }
        for (const Advice& one : all) drawOne(ui, one, result);
        ImGui::EndChild();
    }

    void drawOne(Ui& ui, const Advice& one, const WhatIfResult& result) {
        ImGui::PushID(one.rule.data());
        ImGui::Bullet();
        wrapped(one.words, palette::kText);
        ui.widgets.mark(format("Cost/advice/{}", one.rule), one.words);
        ImGui::Indent(ui.px(20.0f));
        if (!one.remedy.label.empty()) {
            if (ImGui::Button(one.remedy.label.c_str())) apply(ui, one.remedy, result);
            ui.widgets.mark(format("Cost/remedy/{}", one.rule), one.remedy.label);
            if (!one.about.empty()) ImGui::SameLine();
        }
        if (!one.about.empty()) {
            if (ImGui::Button("Select entities")) ui.workspace.document.selection.set(one.about);
            ui.widgets.mark(format("Cost/about/{}", one.rule), format("{}", one.about.size()));
        }
        ImGui::Unindent(ui.px(20.0f));
        ImGui::Spacing();
        ImGui::PopID();
    }

    static void apply(Ui& ui, const CostRemedy& remedy, const WhatIfResult& result) {
        const ScenePhysics present = presentPhysics(result.settings, result.scale);
        applyRemedy(ui.workspace, remedy, present);
        // A quality set by hand must stay fixed, so automatic quality is switched off.
        if (remedy.field == "quality" && present.automaticQuality)
            applyRemedy(ui.workspace,
                        {remedy.label, "ScenePhysics", "automaticQuality", FieldValue::of(false), {}},
                        present);
    }

    WhatIf whatIf_;
    IslandsPage islands_;
    std::string scene_;
};

}  // namespace

std::unique_ptr<Panel> makeCostPanel() { return std::make_unique<CostPanel>(); }

}  // namespace plumb::editor::ui
