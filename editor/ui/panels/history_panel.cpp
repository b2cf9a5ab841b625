#include "core/text.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kRowHeight = 21.0f;  // px at scale 1
constexpr float kNumber = 40.0f;     // px at scale 1: left edge of the label

/// Lists all undo steps since the scene was opened; a click undoes or redoes up to that step.
class HistoryPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const UndoStack& undo = ui.workspace.undo;
        if (undo.total() == 0) {
            return emptyState(ui, "History", "There are no changes yet.",
                              "Every change appears here; click one to undo or redo up to it.");
        }
        drawSummary(ui, undo);
        collect(undo);
        beginChild("steps", {0.0f, 0.0f}, false);
        const float height = ui.px(kRowHeight);
        if (undo.size() != shown_ || undo.total() != total_) scrollToPresent(undo, height);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows_.size()), height);
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
                drawRow(ui, rows_[static_cast<std::size_t>(i)], height);
        }
        ImGui::PopStyleVar();
        ImGui::EndChild();
    }

private:
    /// An undo step, or a note about discarded redo steps.
    struct Row {
        std::size_t position = 0;
        const UndoStack::Lost* lost = nullptr;
    };

    static void drawSummary(Ui& ui, const UndoStack& undo) {
        std::string text = format("{} {} can be undone, {} redone", undo.size(),
                                  undo.size() == 1 ? "step" : "steps", undo.total() - undo.size());
        if (undo.savedPosition() == UndoStack::kNever) {
            text += "; the saved state is no longer among them";
        } else if (!undo.isSaved()) {
            const bool ahead = undo.size() > undo.savedPosition();
            const std::size_t away =
                ahead ? undo.size() - undo.savedPosition() : undo.savedPosition() - undo.size();
            text += format("; {} {} the saved state", away, ahead ? "after" : "before");
        }
        ImGui::TextDisabled("%s", text.c_str());
        ui.widgets.mark("History/summary", text);
    }

    void collect(const UndoStack& undo) {
        rows_.clear();
        auto lost = undo.lost().begin();
        for (std::size_t position = 0; position <= undo.total(); ++position) {
            rows_.push_back({position, nullptr});
            for (; lost != undo.lost().end() && lost->position == position; ++lost)
                rows_.push_back({position, &*lost});
        }
    }

    void scrollToPresent(const UndoStack& undo, float height) {
        shown_ = undo.size();
        total_ = undo.total();
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (rows_[i].position != shown_ || rows_[i].lost != nullptr) continue;
            const float top = height * static_cast<float>(i);
            const float room = ImGui::GetWindowHeight();
            if (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + room)
                ImGui::SetScrollY(top - room * 0.5f);
        }
    }

    static void drawRow(Ui& ui, const Row& row, float height) {
        row.lost == nullptr ? drawStep(ui, row.position, height) : drawLost(ui, *row.lost, height);
    }

    static void drawStep(Ui& ui, std::size_t step, float height) {
        UndoStack& undo = ui.workspace.undo;
        const std::string label = step == 0 ? "opened" : undo.label(step - 1);
        const std::string subject = step == 0 ? std::string{} : undo.subject(step - 1);
        const bool present = step == undo.size();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        ImGui::PushID(static_cast<int>(step));
        const bool chosen = ImGui::InvisibleButton("step", {width, height});
        ImGui::PopID();
        ui.widgets.mark(format("History/{}", step), label + (subject.empty() ? "" : ": " + subject));

        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{at.x + width, at.y + height};
        if (present) {
            list.AddRectFilled(at, to, palette::kAccentSoft, ui.px(4.0f));
        } else if (ImGui::IsItemHovered()) {
            list.AddRectFilled(at, to, palette::kHover, ui.px(4.0f));
        }
        const bool undone = step > undo.size();
        const float line = at.y + (height - ImGui::GetTextLineHeight()) * 0.5f;
        const ImU32 color = undone ? palette::kTextDim : palette::kText;
        const std::string number = format("{}", step);
        const float wide = ImGui::CalcTextSize(number.c_str()).x;
        list.AddText({at.x + ui.px(kNumber - 12.0f) - wide, line}, palette::kTextDim, number.c_str());
        list.AddText({at.x + ui.px(kNumber), line}, color, label.c_str());
        float x = at.x + ui.px(kNumber + 12.0f) + ImGui::CalcTextSize(label.c_str()).x;
        list.AddText({x, line}, undone ? palette::kTextDim : palette::kAccent, subject.c_str());
        if (undo.savedPosition() == step) {
            const float saved = ImGui::CalcTextSize("saved").x;
            list.AddText({to.x - saved - ui.px(8.0f), line}, palette::kPlay, "saved");
            ui.widgets.mark("History/saved", number);
        }
        if (chosen && ui.workspace.canEdit()) undo.jumpTo(step);
    }

    /// Draws a note about undone steps that were discarded because another change was made.
    static void drawLost(Ui& ui, const UndoStack::Lost& lost, float height) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({ImGui::GetContentRegionAvail().x, height});
        const std::string text = format("{} {} discarded here, the last one: {}", lost.steps,
                                        lost.steps == 1 ? "undone step was" : "undone steps were", lost.last);
        ui.widgets.mark(format("History/{}/lost", lost.position), text);
        tooltip("Another change was made, so they cannot be redone.");
        const float line = at.y + (height - ImGui::GetTextLineHeight()) * 0.5f;
        ImGui::GetWindowDrawList()->AddText({at.x + ui.px(kNumber + 16.0f), line}, palette::kTextDim,
                                            text.c_str());
    }

    std::vector<Row> rows_;
    std::size_t shown_ = 0;  ///< undo position that was scrolled into view
    std::size_t total_ = 0;
};

}  // namespace

std::unique_ptr<Panel> makeHistoryPanel() { return std::make_unique<HistoryPanel>(); }

}  // namespace plumb::editor::ui
