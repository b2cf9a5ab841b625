#include "editor/ui/widgets/script_source.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/lua_colors.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

// px at scale 1.
constexpr float kMargin = 58.0f;     // width of the breakpoints and the line numbers
constexpr float kDot = 4.5f;         // radius of a breakpoint
constexpr float kDotX = 12.0f;       // its center
constexpr float kNumberEnd = 48.0f;  // right end of the line numbers
constexpr float kSpace = 3.0f;       // between two lines
constexpr const char* kMenu = "breakpoint";

float lineHeight(const Ui& ui) { return std::floor(ImGui::GetTextLineHeight() + ui.px(kSpace)); }

const char* stateOf(const Breakpoint* breakpoint) {
    if (breakpoint == nullptr) return "";
    return !breakpoint->enabled ? "off" : breakpoint->condition.empty() ? "on" : "condition";
}

std::string helpFor(const Breakpoint* breakpoint) {
    if (breakpoint == nullptr) return "Click to stop the game at this line";
    std::string help = breakpoint->enabled ? "The game stops at this line" : "This breakpoint is turned off";
    if (!breakpoint->condition.empty()) help += format(" if {}", breakpoint->condition);
    return help + ".\nClick to remove it, right-click to edit it.";
}

void drawBreakpoint(const Ui& ui, ImDrawList& list, const Breakpoint& breakpoint, ImVec2 center) {
    if (!breakpoint.enabled) return list.AddCircle(center, ui.px(kDot), palette::kError, 0, ui.px(1.5f));
    list.AddCircleFilled(center, ui.px(kDot), palette::kError);
    if (breakpoint.condition.empty()) return;
    // Two bars, as of an equals sign.
    for (const float y : {-1.5f, 1.5f})
        list.AddLine({center.x - ui.px(2.0f), center.y + ui.px(y)},
                     {center.x + ui.px(2.0f), center.y + ui.px(y)}, palette::kOnStatus, ui.px(1.0f));
}

/// The first line from this one on that is neither empty nor a comment: the others never run.
int lineWithCode(const ScriptText& text, int line) {
    for (std::size_t i = static_cast<std::size_t>(line - 1); i < text.lines.size(); ++i) {
        const std::size_t begin = text.lines[i].find_first_not_of(" \t");
        if (begin != std::string::npos && text.lines[i].compare(begin, 2, "--") != 0)
            return static_cast<int>(i) + 1;
    }
    return line;
}

/// The line of the function that is chosen in the list of functions; 0 if it is in another file.
int markedLine(const Ui& ui, const ScriptText& text) {
    const Halt* halt = ui.workspace.debugger.halt();
    const std::size_t frame = ui.workspace.scripts.frame;
    if (halt == nullptr || frame >= halt->frames.size()) return 0;
    return halt->frames[frame].file == text.file ? halt->frames[frame].line : 0;
}

}  // namespace

void ScriptSource::draw(Ui& ui, const ScriptText& text, const std::string& widget) {
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kField);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
    beginChild("source", {0.0f, 0.0f}, false, ImGuiWindowFlags_HorizontalScrollbar);
    pushFont(ui.fonts.mono, ui.fonts.size);
    scroll(ui, text);
    const float height = lineHeight(ui);
    const int count = static_cast<int>(text.lines.size());
    const int first = std::clamp(static_cast<int>(ImGui::GetScrollY() / height), 0, count);
    const int end = std::min(first + static_cast<int>(ImGui::GetWindowHeight() / height) + 2, count);
    int inLong = 0;
    for (int i = 0; i < first; ++i) luaColors(text.lines[static_cast<std::size_t>(i)], inLong);
    const float top = ImGui::GetCursorPosY();
    for (int i = first; i < end; ++i) {
        ImGui::SetCursorPosY(top + height * static_cast<float>(i));
        drawLine(ui, text, i + 1, inLong, widget);
    }
    float widest = 0.0f;
    for (int i = first; i < end; ++i)
        widest = std::max(widest, ImGui::CalcTextSize(text.lines[static_cast<std::size_t>(i)].c_str()).x);
    ImGui::SetCursorPosY(top + height * static_cast<float>(count));
    ImGui::Dummy({ui.px(kMargin + 12.0f) + widest, 0.0f});
    ImGui::PopFont();
    drawMenu(ui, widget);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void ScriptSource::scroll(Ui& ui, const ScriptText& text) {
    const int line = ui.workspace.scripts.takeLine();
    if (line <= 0 || line > static_cast<int>(text.lines.size())) return;
    const float height = lineHeight(ui), window = ImGui::GetWindowHeight();
    const float y = height * static_cast<float>(line - 1);
    // Lines that are visible already do not move.
    if (y < ImGui::GetScrollY() + height || y > ImGui::GetScrollY() + window - 3.0f * height)
        ImGui::SetScrollY(std::max(y - window * 0.4f, 0.0f));
}

void ScriptSource::drawLine(Ui& ui, const ScriptText& text, int line, int& inLong,
                            const std::string& widget) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = lineHeight(ui);
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
    if (line == markedLine(ui, text)) {
        const bool isHalt = ui.workspace.scripts.frame == 0;
        const float left = ImGui::GetWindowPos().x;
        list.AddRectFilled({left, at.y}, {right, at.y + height}, palette::kAccentSoft);
        list.AddRectFilled({left, at.y}, {left + ui.px(3.0f), at.y + height},
                           isHalt ? palette::kAccent : palette::kTextDim);
        ui.widgets.mark(widget + "/current", AABB{{left, at.y}, {right, at.y + height}}, format("{}", line));
    }
    drawMargin(ui, text, line, at, widget);
    const float y = at.y + std::floor(ui.px(kSpace) * 0.5f);
    float x = at.x + ui.px(kMargin);
    for (const ColoredPart& part : luaColors(text.lines[static_cast<std::size_t>(line - 1)], inLong)) {
        const char* from = part.text.data();
        const char* to = from + part.text.size();
        list.AddText({x, y}, part.color, from, to);
        x += ImGui::CalcTextSize(from, to).x;
    }
}

void ScriptSource::drawMargin(Ui& ui, const ScriptText& text, int line, ImVec2 at,
                              const std::string& widget) {
    Breakpoints& breakpoints = ui.workspace.debugger.breakpoints;
    const Breakpoint* breakpoint = breakpoints.find(text.file, line);
    const float height = lineHeight(ui);
    ImGui::PushID(line);
    const bool clicked = ImGui::InvisibleButton("margin", {ui.px(kNumberEnd + 4.0f), height});
    ImGui::PopID();
    ui.widgets.mark(format("{}/line/{}", widget, line), stateOf(breakpoint));
    const bool hovered = ImGui::IsItemHovered();
    const bool isEdited = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 center{at.x + ui.px(kDotX), at.y + height * 0.5f};
    if (breakpoint != nullptr) {
        drawBreakpoint(ui, list, *breakpoint, center);
    } else if (hovered) {
        list.AddCircle(center, ui.px(kDot), palette::kTextDim, 0, ui.px(1.0f));
    }
    const std::string number = format("{}", line);
    const float wide = ImGui::CalcTextSize(number.c_str()).x;
    list.AddText({at.x + ui.px(kNumberEnd) - wide, at.y + std::floor(ui.px(kSpace) * 0.5f)},
                 line == markedLine(ui, text) ? palette::kText : palette::kTextDim, number.c_str());
    if (isEdited) {
        edited_ =
            breakpoint != nullptr ? *breakpoint : Breakpoint{text.file, lineWithCode(text, line), {}, true};
        ImGui::OpenPopup(kMenu);
    }
    pushFont(ui.fonts.text, ui.fonts.size);
    tooltip(helpFor(breakpoint));
    ImGui::PopFont();
    if (clicked) breakpoints.toggle(text.file, breakpoint != nullptr ? line : lineWithCode(text, line));
}

void ScriptSource::drawMenu(Ui& ui, const std::string& widget) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8.0f), ui.px(6.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10.0f), ui.px(10.0f)});
    if (ImGui::BeginPopup(kMenu)) {
        Breakpoints& breakpoints = ui.workspace.debugger.breakpoints;
        const std::string path = widget + "/breakpoint";
        ImGui::TextDisabled("%s:%d", edited_.file.c_str(), edited_.line);
        ImGui::SetNextItemWidth(ui.px(260.0f));
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        const bool entered = textField("##condition", edited_.condition, ImGuiInputTextFlags_EnterReturnsTrue,
                                       "Stop if, e.g. self.speed > 40");
        ui.widgets.mark(path + "/condition", edited_.condition);
        tooltip("An expression of Lua with the variables of this line. Empty: the game always stops.");
        checkbox("On", edited_.enabled, false);
        ui.widgets.mark(path + "/enabled", edited_.enabled ? "on" : "off");
        ImGui::SameLine();
        const bool removed = ImGui::Button("Remove");
        ui.widgets.mark(path + "/remove");
        ImGui::SameLine();
        const bool applied = ImGui::Button("Set");
        ui.widgets.mark(path + "/set");
        if (removed) breakpoints.remove(edited_.file, edited_.line);
        if (entered || applied) breakpoints.set(edited_);
        if (entered || applied || removed) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace plumb::editor::ui
