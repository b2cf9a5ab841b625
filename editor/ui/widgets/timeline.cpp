#include "editor/ui/widgets/timeline.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/ui/icons.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kHeight = 40.0f;  // px at scale 1
constexpr float kTicksPerSecond = 60.0f;

/// Maps recorded ticks to screen positions; the track always spans 30 s.
struct Track {
    ImVec2 from;
    ImVec2 to;
    std::int64_t first = 0;  ///< tick at the left end

    [[nodiscard]] float at(std::int64_t tick) const {
        const float part = static_cast<float>(tick - first) / static_cast<float>(PlayRecording::kTicks);
        return from.x + std::clamp(part, 0.0f, 1.0f) * (to.x - from.x);
    }
    [[nodiscard]] std::int64_t tickAt(float x) const {
        const float part = (x - from.x) / std::max(to.x - from.x, 1.0f);
        return first + std::lround(part * static_cast<float>(PlayRecording::kTicks));
    }
};

std::string seconds(std::int64_t ticks) {
    return fixedText(static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond), 2);
}

std::string speedText(int speed) {
    return speed < 0 ? format("1/{}x", 1 << -speed) : format("{}x", 1 << speed);
}

/// Draws an icon button that runs an action.
void iconButton(Ui& ui, std::string_view id, const std::string& path) {
    const Action& action = *findAction(id);
    const bool enabled = action.enabled(ui.workspace);
    const float side = ui.px(26.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(path.c_str(), {side, side});
    ui.widgets.mark(path, enabled ? "" : "off");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (enabled && ImGui::IsItemHovered())
        list.AddRectFilled(at, {at.x + side, at.y + side}, palette::kHover, ui.px(4.0f));
    drawIcon(list, iconOfAction(id), {at.x + side * 0.5f, at.y + side * 0.5f}, ui.px(13.0f),
             enabled ? palette::kText : palette::kTextDim);
    tooltip(ui.workspace.settings.keys.labelOf(action));
    if (pressed) runAction(ui.workspace, id);
    ImGui::SameLine(0.0f, ui.px(2.0f));
}

/// Draws the button for pause and resume, always as wide
/// as its longest label, so that the track does not move.
void goButton(Ui& ui) {
    const PlayMode& play = ui.workspace.play;
    const bool past = play.inPast() && play.paused();
    const char* label = past ? "Resume from here" : play.paused() ? "Go on" : "Pause";
    if (past) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kChrome);
        ImGui::PushStyleColor(ImGuiCol_Button, palette::kPlay);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kPastLine);
    }
    const float width = ImGui::CalcTextSize("Resume from here").x + ui.px(14.0f);
    const bool pressed = ImGui::Button(format("{}###go", label).c_str(), {width, ui.px(26.0f)});
    if (past) ImGui::PopStyleColor(3);
    ui.widgets.mark("Timeline/go", label);
    tooltip(ui.workspace.settings.keys.labelOf(
        *findAction("run.pause"),
        past ? "Resumes the game from this tick; the recording after it is discarded" : label));
    if (pressed) runAction(ui.workspace, "run.pause");
    ImGui::SameLine(0.0f, ui.px(2.0f));
}

void drawSpeed(Ui& ui) {
    PlayMode& play = ui.workspace.play;
    const std::string now = speedText(play.speed());
    ImGui::PushStyleColor(ImGuiCol_Button, play.speed() == 0 ? palette::kNothing : palette::kAccentSoft);
    if (ImGui::Button(format("{}##speed", now).c_str(), {ui.px(44.0f), ui.px(26.0f)}))
        ImGui::OpenPopup("speeds");
    ImGui::PopStyleColor();
    ui.widgets.mark("Timeline/speed", now);
    tooltip(format("Game speed  ({} slower, {} faster)", keysFor(ui.workspace, "run.slower"),
                   keysFor(ui.workspace, "run.faster")));
    if (ImGui::BeginPopup("speeds")) {
        for (int speed = PlayMode::kFastest; speed >= PlayMode::kSlowest; --speed) {
            const std::string text = speedText(speed);
            if (ImGui::MenuItem(text.c_str(), nullptr, speed == play.speed())) play.setSpeed(speed);
            ui.widgets.mark("Timeline/speed/" + text);
        }
        ImGui::EndPopup();
    }
    ImGui::SameLine(0.0f, ui.px(8.0f));
}

void drawTicks(const Ui& ui, ImDrawList& list, const Track& track) {
    for (std::int64_t tick = track.first - track.first % 60 + 60; tick < track.first + PlayRecording::kTicks;
         tick += 60) {
        const bool strong = tick % 300 == 0;
        const float x = std::floor(track.at(tick));
        list.AddLine({x, strong ? track.from.y : track.to.y - ui.px(6.0f)}, {x, track.to.y},
                     strong ? palette::kTickMark : palette::kTick);
    }
}

void drawTrack(Ui& ui, ImDrawList& list, const Track& track) {
    const PlayMode& play = ui.workspace.play;
    const float round = ui.px(3.0f);
    list.AddRectFilled(track.from, track.to, palette::kField, round);
    const float now = track.at(play.ticks());
    list.AddRectFilled({track.at(play.oldest()), track.from.y}, {now, track.to.y}, palette::kPast, round);
    if (play.inPast())
        list.AddRectFilled({now, track.from.y}, {track.at(play.newest()), track.to.y}, palette::kAhead,
                           round);
    drawTicks(ui, list, track);
    for (const PlayEdit& edit : play.edits().log()) {
        const float x = track.at(edit.tick);
        const float r = ui.px(3.5f);
        const float y = track.from.y + r + 1.0f;
        list.AddQuadFilled({x - r, y}, {x, y - r}, {x + r, y}, {x, y + r}, palette::kWarning);
    }
    const ImU32 color = play.inPast() ? palette::kWarning : palette::kPastLine;
    list.AddRectFilled({now - ui.px(1.0f), track.from.y - ui.px(3.0f)},
                       {now + ui.px(1.0f), track.to.y + ui.px(3.0f)}, color);
    list.AddCircleFilled({now, track.from.y - ui.px(3.0f)}, ui.px(4.0f), color);
}

void scrub(Ui& ui, ImVec2 from, ImVec2 size) {
    PlayMode& play = ui.workspace.play;
    const Track track{{from.x, from.y + ui.px(7.0f)},
                      {from.x + size.x, from.y + size.y - ui.px(5.0f)},
                      std::max<std::int64_t>(play.newest() - PlayRecording::kTicks, 0)};
    ImGui::SetCursorScreenPos(from);
    ImGui::InvisibleButton("track", size);
    ui.widgets.mark("Timeline/track", format("{}", play.ticks()));
    const float mouse = ImGui::GetIO().MousePos.x;
    if (ImGui::IsItemActive()) {
        play.seek(track.tickAt(mouse));
    } else if (ImGui::IsItemHovered()) {
        const std::int64_t under = std::clamp(track.tickAt(mouse), play.oldest(), play.newest());
        if (const float wheel = ImGui::GetIO().MouseWheel; wheel != 0.0f)
            play.seek(play.ticks() + (wheel > 0.0f ? 1 : -1));
        tooltip(format("{} s ago, tick {}\nDrag to show a past tick; the wheel moves tick by tick",
                       seconds(play.newest() - under), under));
    }
    drawTrack(ui, *ImGui::GetWindowDrawList(), track);
}

}  // namespace

float timelineHeight(const Ui& ui) { return ui.px(kHeight); }

void drawTimeline(Ui& ui, ImVec2 from, ImVec2 size) {
    const PlayMode& play = ui.workspace.play;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, palette::kPanel);
    const float margin = ui.px(8.0f);
    const float top = from.y + (size.y - ui.px(26.0f)) * 0.5f;
    ImGui::PushID("timeline");
    ImGui::SetCursorScreenPos({from.x + margin, top});
    iconButton(ui, "run.stepBack", "Timeline/back");
    goButton(ui);
    iconButton(ui, "run.step", "Timeline/step");
    iconButton(ui, "run.watch", "Timeline/watch");
    drawSpeed(ui);
    const float left = ImGui::GetCursorScreenPos().x;
    const float right = from.x + size.x - margin;
    const std::string time = play.inPast() ? format("-{} s", seconds(play.newest() - play.ticks()))
                                           : format("{} s", seconds(play.ticks()));
    const std::string tick = format("tick {}", play.ticks());
    const float line = ImGui::GetTextLineHeight();
    const float middle = from.y + size.y * 0.5f;
    const ImU32 color = play.inPast() ? palette::kWarning : palette::kText;
    list.AddText({right - ImGui::CalcTextSize(time.c_str()).x, middle - line}, color, time.c_str());
    list.AddText({right - ImGui::CalcTextSize(tick.c_str()).x, middle}, palette::kTextDim, tick.c_str());
    const float end = right - ImGui::CalcTextSize("tick 00000").x - margin;
    if (end - left > ui.px(40.0f))
        scrub(ui, {left, from.y + ui.px(3.0f)}, {end - left, size.y - ui.px(6.0f)});
    ImGui::PopID();
}

}  // namespace plumb::editor::ui
