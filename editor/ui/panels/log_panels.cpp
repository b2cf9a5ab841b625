#include "core/text.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"

namespace plumb::editor::ui {
namespace {

ImU32 colorOfLevel(LogLevel level) {
    switch (level) {
        case LogLevel::Warning: return palette::kWarning;
        case LogLevel::Error: return palette::kError;
        case LogLevel::Detail: return palette::kTextDim;
        case LogLevel::Note: break;
    }
    return palette::kText;
}

/// What engine, game and editor said.
class ConsolePanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const std::deque<LogLine>& lines = ui.log.lines();
        if (lines.empty()) {
            return emptyState(ui, "Console", "Nothing has been said yet.",
                              "Messages of the game and of the editor appear here.", {"run.play"});
        }
        beginChild("lines", {0.0f, 0.0f}, false);
        for (const LogLine& line : lines) {
            ImGui::TextDisabled("%s", line.channel.c_str());
            ImGui::SameLine(ui.px(72.0f));
            ImGui::PushStyleColor(ImGuiCol_Text, colorOfLevel(line.level));
            ImGui::TextWrapped("%s", line.text.c_str());
            ImGui::PopStyleColor();
        }
        ui.widgets.mark("Console/last", lines.back().text);
        if (ui.log.count() != shown_) ImGui::SetScrollHereY(1.0f);
        shown_ = ui.log.count();
        ImGui::EndChild();
    }

private:
    std::size_t shown_ = 0;
};

/// All steps since the scene was opened; a click goes back or forth to one.
class HistoryPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        UndoStack& undo = ui.workspace.undo;
        if (undo.total() == 0) {
            return emptyState(ui, "History", "Nothing has been changed yet.",
                              "Every change appears here; a click goes back to before it, or forth again.");
        }
        beginChild("steps", {0.0f, 0.0f}, false);
        drawStep(ui, 0, "opened");
        for (std::size_t i = 0; i < undo.total(); ++i) {
            drawStep(ui, i + 1, undo.label(i));
        }
        ImGui::EndChild();
    }

private:
    static void drawStep(Ui& ui, std::size_t step, const std::string& label) {
        UndoStack& undo = ui.workspace.undo;
        const std::string text =
            format("{}  {}{}", step, label, undo.savedPosition() == step && step > 0 ? "   (saved)" : "");
        ImGui::PushID(static_cast<int>(step));
        ImGui::PushStyleColor(ImGuiCol_Text, step > undo.size() ? palette::kTextDim : palette::kText);
        const bool chosen = ImGui::Selectable(text.c_str(), step == undo.size());
        ImGui::PopStyleColor();
        ui.widgets.mark(format("History/{}", step), label);
        ImGui::PopID();
        if (chosen && ui.workspace.canEdit()) undo.jumpTo(step);
    }
};

}  // namespace

std::unique_ptr<Panel> makeConsolePanel() { return std::make_unique<ConsolePanel>(); }
std::unique_ptr<Panel> makeHistoryPanel() { return std::make_unique<HistoryPanel>(); }

}  // namespace plumb::editor::ui
