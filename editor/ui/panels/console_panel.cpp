#include <algorithm>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/debug/text_editor.hpp"
#include "editor/model/view/log_view.hpp"
#include "editor/ui/panels/log_counts.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/list_arrow.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kTimeWidth = 66.0f;     // px at scale 1
constexpr float kChannelWidth = 66.0f;  // px at scale 1
constexpr float kLinkWidth = 120.0f;    // px at scale 1
constexpr float kSearchWidth = 60.0f;   // px at scale 1, minimum
constexpr float kGap = 4.0f;            // px at scale 1, between buttons

ImU32 colorOfLevel(LogLevel level) {
    switch (level) {
        case LogLevel::Warning: return palette::kWarning;
        case LogLevel::Error: return palette::kError;
        case LogLevel::Detail: return palette::kTextDim;
        case LogLevel::Note: break;
    }
    return palette::kText;
}

/// Returns a count with a noun: "3 errors", "1 note".
std::string counted(std::size_t count, std::string_view one) {
    return format("{} {}{}", count, one, count == 1 ? "" : "s");
}

void drawDot(ImDrawList& list, const Ui& ui, ImVec2 middle, ImU32 color) {
    list.AddCircleFilled(middle, ui.px(3.5f), color);
}

/// The log of engine, game and editor.
class ConsolePanel final : public Panel {
public:
    void draw(Ui& ui) override {
        view_.update(ui.log);
        drawBar(ui);
        if (ui.log.lines().empty()) {
            return emptyState(ui, "Console", "There are no messages yet.",
                              "Log messages of the game and of the editor appear here.", {"run.play"});
        }
        if (view_.rows().empty()) {
            ImGui::TextDisabled("No message matches the levels, the channels and the search text.");
            return;
        }
        drawLines(ui);
    }

private:
    void drawBar(Ui& ui) {
        struct Button {
            LogLevel level;
            const char* name;
        };
        for (const auto& [level, name] :
             {Button{LogLevel::Error, "error"}, Button{LogLevel::Warning, "warning"},
              Button{LogLevel::Note, "note"}}) {
            bool& shown = view_.levels[static_cast<std::size_t>(level)];
            // Colored only if there are messages of this level, so that red means errors.
            const std::size_t count = view_.count(level);
            const std::string label = counted(count, name);
            if (level != LogLevel::Error) nextTo(ui, buttonWidth(label));
            if (toggle(ui, label, format("Console/{}s", name), shown,
                       count > 0 ? colorOfLevel(level) : palette::kTextDim))
                shown = !shown;
            tooltip(format("{} messages of this level", shown ? "Hides" : "Shows"));
        }
        nextTo(ui, channelsWidth(ui));
        drawChannels(ui);
        drawSearch(ui);
        drawButtons(ui);
        view_.update(ui.log);
    }

    [[nodiscard]] static float buttonWidth(const std::string& label) {
        return ImGui::CalcTextSize(label.c_str()).x + ImGui::GetStyle().FramePadding.x * 2.0f;
    }
    /// Continues beside the last item, or on the next line if less than this width (px) is left.
    static void nextTo(const Ui& ui, float width) {
        ImGui::SameLine(0.0f, ui.px(kGap));
        if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    }

    /// Draws the search field in the width that the buttons
    /// after it leave free, or over the rest of its line.
    void drawSearch(Ui& ui) {
        float buttons = 0.0f;
        for (const char* label : {"Once", "Follow", "Copy", "Clear"})
            buttons += buttonWidth(label) + ui.px(kGap);
        nextTo(ui, ui.px(kSearchWidth));
        const float room = ImGui::GetContentRegionAvail().x;
        ImGui::SetNextItemWidth(room - buttons < ui.px(kSearchWidth) ? -1.0f : room - buttons);
        textField("##search", view_.search, 0, "Search");
        ui.widgets.mark("Console/search", view_.search);
    }

    void drawButtons(Ui& ui) {
        nextTo(ui, buttonWidth("Once"));
        if (toggle(ui, "Once", "Console/once", view_.once)) view_.once = !view_.once;
        tooltip("Shows equal messages once, with their count");
        nextTo(ui, buttonWidth("Follow"));
        if (toggle(ui, "Follow", "Console/follow", follows_)) follows_ = !follows_;
        tooltip("Scrolls to new messages; scrolling up turns this off");
        nextTo(ui, buttonWidth("Copy"));
        if (ImGui::Button("Copy")) {
            ui.workspace.clipboard = view_.text(ui.log);
            ui.workspace.notice = format("Copied {}", counted(view_.rows().size(), "line"));
        }
        ui.widgets.mark("Console/copy");
        tooltip("Copies all visible messages");
        nextTo(ui, buttonWidth("Clear"));
        if (ImGui::Button("Clear")) ui.log.clear();
        ui.widgets.mark("Console/clear");
    }

    static bool toggle(Ui& ui, const std::string& label, const std::string& path, bool on,
                       ImU32 color = palette::kText) {
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::kAccentSoft : palette::kNothing);
        ImGui::PushStyleColor(ImGuiCol_Text, on ? color : palette::kTextDim);
        const bool pressed = ImGui::Button(format("{}##{}", label, path).c_str());
        ImGui::PopStyleColor(2);
        ui.widgets.mark(path, label);
        return pressed;
    }

    [[nodiscard]] std::string channelsLabel() const {
        const std::size_t hidden = view_.hiddenChannels.size();
        return hidden == 0 ? "All channels" : format("{} hidden", hidden);
    }
    /// Width of the channels button with its arrow, px.
    [[nodiscard]] float channelsWidth(const Ui& ui) const {
        return buttonWidth(channelsLabel()) + ui.px(20.0f);
    }

    void drawChannels(Ui& ui) {
        const std::string label = channelsLabel();
        const bool pressed = toggle(ui, label, "Console/channels", !view_.hiddenChannels.empty());
        ImGui::SameLine(0.0f, 0.0f);
        if (listArrow(ui, "Console/channels/list", ImGui::GetFrameHeight()) || pressed)
            ImGui::OpenPopup("channels");
        if (!ImGui::BeginPopup("channels")) return;
        for (const std::string& channel : view_.channels()) {
            const auto found = view_.hiddenChannels.find(channel);
            bool shown = found == view_.hiddenChannels.end();
            if (ImGui::Checkbox(channel.c_str(), &shown)) {
                if (shown)
                    view_.hiddenChannels.erase(found);
                else
                    view_.hiddenChannels.insert(channel);
            }
            ui.widgets.mark("Console/channel/" + channel, shown ? "on" : "off");
        }
        ImGui::EndPopup();
    }

    void drawLines(Ui& ui) {
        beginChild("lines", {0.0f, 0.0f}, false);
        const float width = ImGui::GetContentRegionAvail().x;
        measure(ui, width);
        // Draws only the visible rows; ImGuiListClipper needs rows of equal height.
        const float top = ImGui::GetCursorPosY();
        const float from = ImGui::GetScrollY() - top;
        const auto first = std::upper_bound(ends_.begin(), ends_.end(), from);
        for (auto at = first; at != ends_.end(); ++at) {
            const auto row = static_cast<std::size_t>(at - ends_.begin());
            const float start = row == 0 ? 0.0f : ends_[row - 1];
            if (start > from + ImGui::GetWindowHeight()) break;
            ImGui::SetCursorPosY(top + start);
            drawRow(ui, row, width, *at - start);
        }
        ImGui::SetCursorPosY(top + ends_.back());
        ImGui::Dummy({1.0f, 0.0f});
        follow(ui);
        ui.widgets.mark("Console/last", ui.log.lines()[view_.rows().back().line].text);
        ImGui::EndChild();
    }

    /// Scrolls to new messages. Scrolling up with the wheel
    /// turns following off, scrolling to the end turns it on.
    void follow(const Ui& ui) {
        const bool atEnd = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1.0f;
        if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0.0f)
            follows_ = ImGui::GetIO().MouseWheel < 0.0f && atEnd;
        if (follows_ && (ui.log.revision() != shown_ || !atEnd)) ImGui::SetScrollHereY(1.0f);
        shown_ = ui.log.revision();
    }

    [[nodiscard]] static float textWidth(const Ui& ui, float width) {
        return std::max(width - ui.px(kTimeWidth + kChannelWidth + kLinkWidth), ui.px(80.0f));
    }

    /// Computes the lower edge of each row, px, if the rows or the width have changed.
    void measure(const Ui& ui, float width) {
        if (measured_ == view_.revision() && width == measuredWidth_) return;
        measured_ = view_.revision();
        measuredWidth_ = width;
        ends_.clear();
        float y = 0.0f;
        const float gap = ui.px(3.0f);
        for (const LogView::Row& row : view_.rows()) {
            const std::string& text = ui.log.lines()[row.line].text;
            y += ImGui::CalcTextSize(text.c_str(), nullptr, false, textWidth(ui, width)).y + gap;
            ends_.push_back(y);
        }
    }

    void drawRow(Ui& ui, std::size_t index, float width, float height) {
        const LogView::Row& row = view_.rows()[index];
        const LogEntry& line = ui.log.lines()[row.line];
        const ObjectId object = entityIn(ui.workspace.document, line.text);
        const auto place = line.channel == "Script" ? scriptPlaceIn(line.text) : std::nullopt;
        const auto source = place || line.channel == "Code" ? sourcePlaceIn(line.text) : std::nullopt;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushID(static_cast<int>(index));
        allowOverlapBefore();
        const bool clicked = ImGui::InvisibleButton("line", {width, height});
        allowOverlapAfter();
        ui.widgets.mark(format("Console/{}", index), format("{} x{}", line.text, row.times));
        const bool hovered = ImGui::IsItemHovered();
        if (ImGui::BeginPopupContextItem("menu")) {
            if (ImGui::MenuItem("Copy line")) ui.workspace.clipboard = textOf(line);
            ui.widgets.mark("Console/menu/Copy line");
            if (ImGui::MenuItem("Hide this channel")) view_.hiddenChannels.insert(line.channel);
            ui.widgets.mark("Console/menu/Hide this channel");
            ImGui::EndPopup();
        }
        ImGui::PopID();

        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (hovered) list.AddRectFilled(at, {at.x + width, at.y + height}, palette::kHover, ui.px(3.0f));
        const std::string time =
            line.tick < 0 ? fixedText(line.seconds, 1) + " s" : format("tick {}", line.tick);
        list.AddText(at, palette::kTextDim, time.c_str());
        const float x = at.x + ui.px(kTimeWidth);
        list.PushClipRect({x, at.y}, {x + ui.px(kChannelWidth - 4.0f), at.y + height}, true);
        list.AddText({x, at.y}, palette::kTextDim, line.channel.c_str());
        list.PopClipRect();
        list.AddText(ui.fonts.text, ui.fonts.size, {x + ui.px(kChannelWidth), at.y}, colorOfLevel(line.level),
                     line.text.c_str(), nullptr, textWidth(ui, width));
        const std::string link = source   ? linkOf(*source)
                                 : object ? ui.workspace.document.nameOf(object)
                                          : "";
        const AABB linked = drawEnd(ui, list, row, link, {at.x + width, at.y}, height);
        if (hovered && (object || place || ImGui::GetIO().MousePos.x < x))
            tooltip(hint(ui, line, object, place));
        if (drawGoBack(ui, line, index, {at.x + width, at.y}, height)) return;
        if (source && (drawLink(ui, *source, index, linked) || (clicked && !place)))
            return openSource(ui.workspace, *source);
        if (clicked && place) return ui.workspace.scripts.show(*place);
        if (!clicked || !object) return;
        ui.workspace.document.selection.set({object});
        runAction(ui.workspace, "view.frame");
    }

    /// Makes the drawn link to a source a button. @return true if it was clicked
    static bool drawLink(Ui& ui, const ScriptPlace& source, std::size_t index, const AABB& box) {
        if (box.size().x <= 0.0f) return false;
        ImGui::SetCursorScreenPos({box.min.x, box.min.y});
        ImGui::PushID(static_cast<int>(index));
        const bool clicked = ImGui::InvisibleButton("source", {box.size().x, box.size().y});
        ImGui::PopID();
        ui.widgets.mark(format("Console/{}/source", index), linkOf(source));
        tooltip(format("Opens {}:{} in the text editor of Preferences > Editing", source.file, source.line));
        return clicked;
    }

    static void openSource(Workspace& workspace, const ScriptPlace& source) {
        const Result<Done> opened =
            openInTextEditor(workspace.settings.textEditor, workspace.project.root, source);
        workspace.notice = opened ? format("Opened {}:{}", source.file, source.line) : opened.error().text();
    }

    /// "slime.lua:12" of scripts/slime.lua
    static std::string linkOf(const ScriptPlace& place) {
        return format("{}:{}", place.file.substr(place.file.rfind('/') + 1), place.line);
    }

    /// Draws the button of an error in a script that rewinds the game to the tick before. @return true if it
    /// was clicked
    static bool drawGoBack(Ui& ui, const LogEntry& line, std::size_t index, ImVec2 end, float height) {
        ScriptDebugger& debugger = ui.workspace.debugger;
        const bool isPossible = line.channel == "Script" && line.level == LogLevel::Error &&
                                line.game == ui.workspace.play.games() && debugger.canGoBackTo(line.tick);
        if (!isPossible) return false;
        const float text = ImGui::GetTextLineHeight();
        const ImVec2 size{ImGui::CalcTextSize("Go back").x + ui.px(12.0f), text + ui.px(2.0f)};
        // Below the link to the line, or over it if the message has one line.
        const float top = height >= 2.0f * text + ui.px(2.0f) ? end.y + text + ui.px(2.0f) : end.y;
        const ImVec2 at{end.x - size.x - ui.px(6.0f), top};
        ImGui::SetCursorScreenPos(at);
        ImGui::PushID(static_cast<int>(index));
        const bool clicked = ImGui::InvisibleButton("go back", size);
        ImGui::PopID();
        ui.widgets.mark(format("Console/{}/goBack", index));
        tooltip("Rewinds the game to the tick before this error; F11 then steps through its lines");
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y},
                           ImGui::IsItemHovered() ? palette::kButtonHovered : palette::kButton, ui.px(4.0f));
        list.AddText({at.x + ui.px(6.0f), at.y + ui.px(1.0f)}, palette::kText, "Go back");
        if (!clicked) return false;
        if (debugger.goBackTo(line.tick)) ui.workspace.notice = debugger.notice();
        if (const auto place = scriptPlaceIn(line.text)) ui.workspace.scripts.show(*place);
        return true;
    }

    static std::string hint(const Ui& ui, const LogEntry& line, ObjectId object,
                            const std::optional<ScriptPlace>& place) {
        std::string text =
            format("{} s{}", fixedText(line.seconds, 2), line.tick < 0 ? "" : format(", tick {}", line.tick));
        if (place)
            text += format("\nClick to show {}:{}", place->file, place->line);
        else if (object)
            text += format("\nClick to select \"{}\"", ui.workspace.document.nameOf(object));
        return text;
    }

    /// Draws the repeat count and the name of the mentioned entity or line at the right edge. @return the box
    /// of the name, px on screen
    static AABB drawEnd(const Ui& ui, ImDrawList& list, const LogView::Row& row, const std::string& link,
                        ImVec2 end, float height) {
        float x = end.x - ui.px(6.0f);
        if (row.times > 1) {
            const std::string times = format("x{}", row.times);
            const float wide = ImGui::CalcTextSize(times.c_str()).x;
            list.AddRectFilled({x - wide - ui.px(8.0f), end.y}, {x, end.y + ImGui::GetTextLineHeight()},
                               palette::kAccentSoft, ui.px(7.0f));
            list.AddText({x - wide - ui.px(4.0f), end.y}, palette::kText, times.c_str());
            x -= wide + ui.px(14.0f);
        }
        if (link.empty()) return {};
        const float wide = ImGui::CalcTextSize(link.c_str()).x;
        const float left = end.x - ui.px(kLinkWidth - 6.0f);
        list.PushClipRect({left, end.y}, {x, end.y + height}, true);
        list.AddText({std::max(x - wide, left), end.y}, palette::kAccent, link.c_str());
        list.PopClipRect();
        return {{std::max(x - wide, left), end.y}, {x, end.y + ImGui::GetTextLineHeight()}};
    }

    LogView view_;
    std::vector<float> ends_;  ///< lower edge of each row, px
    std::size_t measured_ = 0;
    float measuredWidth_ = 0.0f;
    bool follows_ = true;
    std::size_t shown_ = 0;
};

struct LogCounts {
    std::size_t errors = 0;
    std::size_t warnings = 0;

    static LogCounts of(const LogBook& log) {
        LogCounts counts;
        for (const LogEntry& line : log.lines()) {
            counts.errors += line.level == LogLevel::Error ? 1 : 0;
            counts.warnings += line.level == LogLevel::Warning ? 1 : 0;
        }
        return counts;
    }
    /// Returns "2 errors, 1 warning", or an empty text if there are none.
    [[nodiscard]] std::string text() const {
        if (errors == 0) return warnings == 0 ? std::string{} : counted(warnings, "warning");
        return warnings == 0 ? counted(errors, "error")
                             : format("{}, {}", counted(errors, "error"), counted(warnings, "warning"));
    }
};

}  // namespace

float logCountsWidth(const Ui& ui) {
    const std::string text = LogCounts::of(ui.log).text();
    return text.empty() ? 0.0f : ImGui::CalcTextSize(text.c_str()).x + ui.px(12.0f);
}

void drawLogCounts(Ui& ui) {
    const LogCounts counts = LogCounts::of(ui.log);
    const std::string text = counts.text();
    if (text.empty()) return;
    ImGui::SameLine(0.0f, ui.px(22.0f));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    if (ImGui::InvisibleButton("log counts", {logCountsWidth(ui), line}))
        ui.workspace.panelToShow = "Console";
    ui.widgets.mark("Status/log", text);
    tooltip("Shows the Console panel");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = counts.errors > 0 ? palette::kError : palette::kWarning;
    drawDot(list, ui, {at.x + ui.px(4.0f), at.y + line * 0.5f}, color);
    list.AddText({at.x + ui.px(12.0f), at.y}, color, text.c_str());
}

std::unique_ptr<Panel> makeConsolePanel() { return std::make_unique<ConsolePanel>(); }

}  // namespace plumb::editor::ui
