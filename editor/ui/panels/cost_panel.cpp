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
constexpr float kCurvePart = 0.38f;    // of the panel, at most
constexpr float kMostWords = 760.0f;   // px at scale 1: longer lines are hard to read

void wrapped(const std::string& words, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

/// What a scene costs, how exact it is, and what another quality would do.
class CostPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        whatIf_.tend(ui.workspace);
        const Document& document = ui.workspace.document;
        if (document.objectCount() == 0 && !ui.workspace.play.running()) {
            whatIf_.cancel();
            return emptyState(ui, "Cost", "There is nothing to measure.",
                              "What a scene's physics costs, and how exact it is, is shown here.", {});
        }
        if (document.scenePath != scene_) whatIf_.forget(), scene_ = document.scenePath;
        if (!ImGui::BeginTabBar("cost pages")) return;
        const auto page = [&](const std::string& label, const char* name, const char* doc) {
            const bool open = ImGui::BeginTabItem(format("{}###{}", label, name).c_str());
            ui.widgets.mark(std::string{"Cost/page/"} + name, open ? "open" : label);
            tooltip(doc);
            return open;
        };
        if (page("Quality", "Quality", "What each quality would cost here, and how exact it would be"))
            drawQuality(ui), ImGui::EndTabItem();
        if (page(adviceLabel(ui), "Advice", "What can be made better in this scene"))
            drawAdvice(ui), ImGui::EndTabItem();
        if (page("Islands", "Islands", "What touches or is tied together, and is solved as one"))
            islands_.draw(ui), ImGui::EndTabItem();
        if (page("Stages", "Stages", "What each part of a tick takes"))
            drawStagesPage(ui), ImGui::EndTabItem();
        ImGui::EndTabBar();
    }

private:
    /// What was measured, beside what the scene says now: it may have been changed since.
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

    /// Measures, and says how far that is.
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
            ImGui::TextDisabled("stepping the same ticks at every quality; the game goes on");
            return;
        }
        const bool playing = workspace.play.running();
        const char* label = !playing             ? "Measure the scene's first 5 s"
                            : whatIf_.measured() ? "Measure again"
                                                 : "Measure the last 5 s";
        if (ImGui::Button(label)) whatIf_.begin(workspace);
        ui.widgets.mark("Cost/measure", label);
        tooltip(
            "Steps the same ticks again at every quality, and at a reference. The game itself is only read.");
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        if (!whatIf_.refusal().empty()) {
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::kWarning), "%s",
                               whatIf_.refusal().c_str());
            ui.widgets.mark("Cost/refusal", whatIf_.refusal());
        } else if (!whatIf_.measured()) {
            ImGui::TextDisabled("What would another quality cost here, and how exact would it be?");
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
        // All seven shall be in sight in a small window.
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8.0f), ui.px(2.0f)});
        drawSentences(ui, result);
        ImGui::PopStyleVar();
        ImGui::EndChild();
        if (clicked >= 0) apply(ui, qualityRemedy(clicked), result);
    }

    /// Shown before the first measurement.
    static void drawLesson(Ui& ui) {
        ImGui::Spacing();
        beginChild("lesson", {std::min(ImGui::GetContentRegionAvail().x, ui.px(kMostWords)), 0.0f}, false);
        wrapped(
            "The physics moves in small steps. More of them in a tick are more exact and take longer: that "
            "is "
            "the quality of a scene, from 0 (one step) to 6 (64 steps).",
            palette::kText);
        ImGui::Spacing();
        wrapped(
            "Measuring plays some seconds of this scene again at every quality and shows what each would "
            "cost "
            "and by how much bodies would be inside of each other, or joints open. What is below half a "
            "pixel "
            "cannot be seen: the cheapest quality that gets there is the one to take.",
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
                "Where bodies end up cannot be compared here: moved by {} at the start, half of them end "
                "more than "
                "{} elsewhere. Such a scene is chaotic; overlaps and joints can be compared all the same.",
                "0.01 mm", lengthWords(result.hair, result.scale));
            wrapped(words, palette::kTextDim);
            ui.widgets.mark("Cost/chaos", words);
        } else if (present != nullptr && present->away >= 0.0f) {
            const std::string words =
                format("Against the reference, half of the bodies are off by more than {} at this quality.",
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
            tooltip(ui.workspace.play.running() ? "In the game that plays; when it stops you may keep it"
                                                : "Sets it in the scene; undo takes it back");
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
            ImGui::TextUnformatted(seen ? "the best there is" : "enough for the eye");
            ImGui::PopStyleColor();
        }
        ImGui::PopID();
    }

    void drawAdvice(Ui& ui) {
        drawBar(ui);
        if (!whatIf_.measured()) {
            ImGui::Spacing();
            return wrapped("Advice comes from what was measured: measure first.", palette::kTextSoft);
        }
        const WhatIfResult result = shownResult(ui);
        if (!result.complete) return;
        const std::vector<Advice> all = advice(result);
        ImGui::Spacing();
        beginChild("advice", {std::min(ImGui::GetContentRegionAvail().x, ui.px(kMostWords * 1.2f)), 0.0f},
                   false);
        if (all.empty()) {
            wrapped("Nothing to change: this scene costs what it has to.", palette::kText);
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
            if (ImGui::Button("Select them")) ui.workspace.document.selection.set(one.about);
            ui.widgets.mark(format("Cost/about/{}", one.rule), format("{}", one.about.size()));
        }
        ImGui::Unindent(ui.px(20.0f));
        ImGui::Spacing();
        ImGui::PopID();
    }

    static void apply(Ui& ui, const CostRemedy& remedy, const WhatIfResult& result) {
        const ScenePhysics present = presentPhysics(result.settings, result.scale);
        applyRemedy(ui.workspace, remedy, present);
        // A quality that was chosen by hand is meant as it is.
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
