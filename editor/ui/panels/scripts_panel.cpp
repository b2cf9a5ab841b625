#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/fitted_text.hpp"
#include "editor/ui/widgets/script_source.hpp"

namespace plumb::editor::ui {
namespace {

// px at scale 1.
constexpr float kFilesWidth = 150.0f;
constexpr float kDetailsWidth = 300.0f;
constexpr float kNameWidth = 104.0f;    // names of variables
constexpr float kLeastSource = 320.0f;  // the list of files makes room for the source
constexpr float kGap = 8.0f;            // between the parts of the panel
constexpr float kRow = 20.0f;           // height of a row of a list

struct Step {
    const char* action;
    const char* label;
};
constexpr std::array kSteps{Step{"script.into", "Into"}, Step{"script.over", "Over"},
                            Step{"script.out", "Out"}, Step{"script.back", "Back"}};

/// Shows the scripts of the project, the line at which the game is stopped, and the variables there.
class ScriptsPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const ScriptText* text = ui.workspace.scripts.shown();
        if (text == nullptr) {
            return emptyState(ui, "Scripts", "This project has no scripts yet.",
                              "Save a file like scripts/slime.lua in the project's folder; it appears here "
                              "and as a component. Its lines can stop the game, and be stepped back.");
        }
        const float room = ImGui::GetContentRegionAvail().x;
        const bool withFiles = room > ui.px(kFilesWidth + kDetailsWidth + kLeastSource);
        if (!withFiles) drawChoice(ui, *text);
        drawBar(ui);
        text = ui.workspace.scripts.shown();
        const float details = std::min(ui.px(kDetailsWidth), room * 0.45f);
        if (withFiles) {
            beginChild("files", {ui.px(kFilesWidth), 0.0f}, false);
            drawFiles(ui, *text);
            ImGui::EndChild();
            ImGui::SameLine(0.0f, ui.px(kGap));
        }
        const float width = ImGui::GetContentRegionAvail().x - details - ui.px(kGap);
        beginChild("text", {width, 0.0f}, false);
        source_.draw(ui, *text, "Scripts");
        ImGui::EndChild();
        ImGui::SameLine(0.0f, ui.px(kGap));
        beginChild("details", {0.0f, 0.0f}, false);
        drawDetails(ui);
        ImGui::EndChild();
    }

private:
    static void drawBar(Ui& ui) {
        for (const auto& [id, label] : kSteps) {
            const Action& action = *findAction(id);
            ImGui::BeginDisabled(!action.enabled(ui.workspace));
            const bool pressed = ImGui::Button(label);
            ImGui::EndDisabled();
            ui.widgets.mark(format("Scripts/{}", label), action.enabled(ui.workspace) ? "" : "off");
            tooltip(ui.workspace.settings.keys.labelOf(action));
            if (pressed) runAction(ui.workspace, id);
            ImGui::SameLine(0.0f, ui.px(4.0f));
        }
        ImGui::SameLine(0.0f, ui.px(12.0f));
        ImGui::AlignTextToFramePadding();
        const std::string state = stateInWords(ui.workspace);
        const bool isHalted = ui.workspace.debugger.halt() != nullptr;
        ImGui::PushStyleColor(ImGuiCol_Text, isHalted ? palette::kText : palette::kTextDim);
        fittedLine(state, ImGui::GetContentRegionAvail().x);
        ImGui::PopStyleColor();
        ui.widgets.mark("Scripts/state", state);
    }

    /// Draws the list of files as a combo box, where there is no room for a column.
    static void drawChoice(Ui& ui, const ScriptText& shown) {
        ImGui::SetNextItemWidth(ui.px(kFilesWidth));
        const bool isOpen = ImGui::BeginCombo("##files", nameOf(shown).c_str());
        ui.widgets.mark("Scripts/files", shown.file);
        tooltip(shown.file);
        std::string chosen;
        if (isOpen) {
            for (const ScriptText& text : ui.workspace.scripts.files()) {
                if (ImGui::Selectable(nameOf(text).c_str(), &text == &shown)) chosen = text.file;
                ui.widgets.mark(format("Scripts/file/{}", text.file), &text == &shown ? "shown" : "");
            }
            ImGui::EndCombo();
        }
        if (!chosen.empty()) ui.workspace.scripts.choose(chosen);
        ImGui::SameLine(0.0f, ui.px(kGap));
    }

    /// "enemies/slime.lua" of scripts/enemies/slime.lua
    static std::string nameOf(const ScriptText& text) { return text.file.substr(text.file.find('/') + 1); }

    static std::string stateInWords(const Workspace& workspace) {
        const PlayMode& play = workspace.play;
        // The file is shown beside it.
        if (const Halt* halt = workspace.debugger.halt())
            return format("Stopped at line {} in \"{}\", tick {}, step {}", halt->line,
                          nameOf(workspace, halt->entity), halt->moment.tick, halt->moment.line);
        if (!play.running())
            return format("Click beside a line number to stop there, then press {}",
                          keysFor(workspace, "run.play"));
        if (!play.paused()) return "The game is running";
        return format("Paused after tick {}; {} goes to the next line of a script", play.ticks(),
                      keysFor(workspace, "script.into"));
    }

    static std::string nameOf(const Workspace& workspace, EntityId entity) {
        const ObjectId id = workspace.play.idOf(entity);
        return id ? workspace.document.nameOf(id) : format("entity {}", entity.index);
    }

    static void drawFiles(Ui& ui, const ScriptText& shown) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const Halt* halt = ui.workspace.debugger.halt();
        const float height = ui.px(kRow);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
        std::string chosen;
        for (const ScriptText& text : ui.workspace.scripts.files()) {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float width = ImGui::GetContentRegionAvail().x;
            if (ImGui::InvisibleButton(text.file.c_str(), {width, height})) chosen = text.file;
            ui.widgets.mark(format("Scripts/file/{}", text.file), &text == &shown ? "shown" : "");
            tooltip(text.file);
            const ImVec2 to{at.x + width, at.y + height};
            if (&text == &shown) {
                list.AddRectFilled(at, to, palette::kAccentSoft, ui.px(4.0f));
            } else if (ImGui::IsItemHovered()) {
                list.AddRectFilled(at, to, palette::kHover, ui.px(4.0f));
            }
            const bool isHere = halt != nullptr && halt->file == text.file;
            const std::string name = fittedText(nameOf(text), width - ui.px(16.0f));
            list.AddText({at.x + ui.px(8.0f), at.y + (height - ImGui::GetTextLineHeight()) * 0.5f},
                         isHere ? palette::kAccent : palette::kText, name.c_str());
        }
        ImGui::PopStyleVar();
        if (!chosen.empty()) ui.workspace.scripts.choose(chosen);
    }

    static void drawDetails(Ui& ui) {
        const Halt* halt = ui.workspace.debugger.halt();
        if (halt == nullptr || halt->frames.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
            ImGui::TextWrapped("%s",
                               "Functions and variables appear here while the game is stopped at a "
                               "line.");
            ImGui::PopStyleColor();
            return;
        }
        drawFrames(ui, *halt);
        const std::size_t frame = std::min(ui.workspace.scripts.frame, halt->frames.size() - 1);
        heading(ui, format("Variables of {}", halt->frames[frame].function));
        for (const ScriptVariable& variable : halt->frames[frame].variables)
            drawValue(ui, "variable", variable.name, variable.value, {});
        const std::vector<ScriptView::Property> properties = ui.workspace.scripts.properties();
        if (properties.empty()) return;
        heading(ui, format("Properties of {}", nameOf(ui.workspace, halt->entity)));
        for (const ScriptView::Property& property : properties)
            if (drawValue(ui, "property", property.name, property.value, property.field)) break;
    }

    static void heading(Ui& ui, const std::string& text) {
        ImGui::Dummy({0.0f, ui.px(4.0f)});
        ImGui::TextDisabled("%s", text.c_str());
    }

    static void drawFrames(Ui& ui, const Halt& halt) {
        ImGui::TextDisabled("Functions");
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float height = ui.px(kRow);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
        for (std::size_t i = 0; i < halt.frames.size(); ++i) {
            const ScriptFrame& frame = halt.frames[i];
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float width = ImGui::GetContentRegionAvail().x;
            ImGui::PushID(static_cast<int>(i));
            const bool clicked = ImGui::InvisibleButton("frame", {width, height});
            ImGui::PopID();
            const std::string place = format("{}:{}", frame.file, frame.line);
            ui.widgets.mark(format("Scripts/frame/{}", i), format("{} {}", frame.function, place));
            const ImVec2 to{at.x + width, at.y + height};
            if (i == ui.workspace.scripts.frame) {
                list.AddRectFilled(at, to, palette::kAccentSoft, ui.px(4.0f));
            } else if (ImGui::IsItemHovered()) {
                list.AddRectFilled(at, to, palette::kHover, ui.px(4.0f));
            }
            const float y = at.y + (height - ImGui::GetTextLineHeight()) * 0.5f;
            list.AddText({at.x + ui.px(8.0f), y}, palette::kText, frame.function.c_str());
            const std::string link =
                format("{}:{}", frame.file.substr(frame.file.rfind('/') + 1), frame.line);
            const float wide = ImGui::CalcTextSize(link.c_str()).x;
            list.AddText({to.x - wide - ui.px(8.0f), y}, palette::kTextDim, link.c_str());
            if (!clicked) continue;
            ui.workspace.scripts.frame = i;
            ui.workspace.scripts.show({frame.file, frame.line});
        }
        ImGui::PopStyleVar();
    }

    /// Draws a name and its value; a field has a button that goes back to its last change.
    /// @return true if the button was clicked: what is shown has changed
    static bool drawValue(Ui& ui, const char* kind, const std::string& name, const std::string& value,
                          const WatchedField& field) {
        const std::string path = format("Scripts/{}/{}", kind, name);
        const float left = ImGui::GetCursorPosX() + ui.px(8.0f);
        const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
        const float button = field.type == nullptr
                                 ? 0.0f
                                 : ImGui::CalcTextSize("Last change").x +
                                       2.0f * ImGui::GetStyle().FramePadding.x + ui.px(8.0f);
        ImGui::SetCursorPosX(left);
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextSoft);
        fittedLine(name, ui.px(kNameWidth - 8.0f));
        ImGui::PopStyleColor();
        ImGui::SameLine(left + ui.px(kNameWidth));
        fittedLine(value, right - left - ui.px(kNameWidth) - button);
        ui.widgets.mark(path, value);
        if (field.type == nullptr) return false;
        ImGui::SameLine(right - button + ui.px(8.0f));
        ImGui::PushID(path.c_str());
        // Without a background, so that the values are what is read first.
        ImGui::PushStyleColor(ImGuiCol_Button, palette::kNothing);
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
        const bool clicked = ImGui::SmallButton("Last change");
        ImGui::PopStyleColor(2);
        ImGui::PopID();
        ui.widgets.mark(path + "/back");
        tooltip("Runs back to the line that has changed this value last");
        if (!clicked) return false;
        ui.workspace.debugger.runBackToChange(field);
        ui.workspace.notice = ui.workspace.debugger.notice();
        return true;
    }

    ScriptSource source_;
};

}  // namespace

std::unique_ptr<Panel> makeScriptsPanel() { return std::make_unique<ScriptsPanel>(); }

}  // namespace plumb::editor::ui
