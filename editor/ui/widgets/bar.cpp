#include "editor/ui/widgets/bar.hpp"

#include <algorithm>

namespace plumb::editor::ui {
namespace {

constexpr ImGuiWindowFlags kBar = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

ImU32 chromeOf(const PlayMode& play) {
    if (!play.running()) return palette::kChrome;
    return play.paused() ? palette::kChromePaused : palette::kChromePlaying;
}

}  // namespace

void beginBar(const Ui& ui, const char* name, ImVec2 at, ImVec2 size, ImVec2 padding) {
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, chromeOf(ui.workspace.play));
    ImGui::Begin(name, nullptr, kBar);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

std::vector<bool> shownGroups(std::span<const BarGroup> groups, float room, float gap, float more) {
    std::vector<bool> shown(groups.size(), true);
    float width = -gap;
    for (const BarGroup& group : groups) width += group.width + gap;
    for (bool all = true; width > room; all = false) {
        std::size_t least = groups.size();
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (shown[i] && (least == groups.size() || groups[i].worth < groups[least].worth)) least = i;
        }
        if (least == groups.size()) break;
        shown[least] = false;
        width -= groups[least].width + gap;
        if (all) width += more + gap;
    }
    return shown;
}

}  // namespace plumb::editor::ui
