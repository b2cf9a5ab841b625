#include "editor/ui/dialogs/keys_page.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/action_groups.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kKeysWidth = 170.0f;  // px at scale 1: width of the column with the keys

std::string lower(std::string_view text) {
    std::string out{text};
    std::transform(out.begin(), out.end(), out.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
    });
    return out;
}

bool isModifier(Key key) { return key >= Key::LeftControl && key <= Key::RightSuper; }

/// Returns the group and the label of an action, e.g. "Edit: Undo".
std::string nameOf(const Action& action) { return format("{}: {}", groupOf(action), action.label); }

std::string textOf(const KeyBindings& keys, const Action& action) {
    std::string text;
    for (const Shortcut& one : keys.of(action)) text += (text.empty() ? "" : ", ") + one.text();
    return text;
}

}  // namespace

void KeysPage::stop() {
    listening_ = nullptr;
    wanted_.reset();
}

bool KeysPage::take(KeyBindings& keys, const Event& event) {
    if (listening_ == nullptr || event.kind != EventKind::KeyDown || isModifier(event.key)) return false;
    if (wanted_) {
        if (event.key == Key::Escape) stop();
        return true;
    }
    const Modifiers held = event.modifiers;
    if (event.key == Key::Escape && held == Modifiers{}) {
        stop();
        return true;
    }
    const Shortcut pressed{event.key, held.control, held.shift, held.alt};
    if (keys.conflict(*listening_, pressed) != nullptr) {
        wanted_ = pressed;
        return true;
    }
    keys.bind(*listening_, pressed);
    stop();
    return true;
}

bool KeysPage::matches(const KeyBindings& keys, const Action& action) const {
    const std::string wanted = lower(trimmed(search_.data()));
    return wanted.empty() || lower(nameOf(action)).find(wanted) != std::string::npos ||
           lower(textOf(keys, action)).find(wanted) != std::string::npos;
}

void KeysPage::draw(Ui& ui) {
    KeyBindings& keys = ui.workspace.settings.keys;
    const float reset = ui.px(120.0f);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - reset - ImGui::GetStyle().ItemSpacing.x);
    ImGui::InputTextWithHint("##search", "Search for an action or for keys, e.g. Ctrl+D", search_.data(),
                             search_.size());
    ui.widgets.mark("Preferences/Keys/search", search_.data());
    ImGui::SameLine();
    ImGui::BeginDisabled(!keys.anyChanged());
    if (ImGui::Button("Reset all", {reset, 0.0f})) keys.resetAll(), stop();
    ImGui::EndDisabled();
    ui.widgets.mark("Preferences/Keys/Reset all");
    tooltip("Resets all keys to their defaults");
    drawConflict(ui);
    ImGui::Spacing();
    std::size_t shown = 0;
    beginChild("actions", {0.0f, 0.0f}, false);
    if (ImGui::BeginTable("keys", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, ui.px(kKeysWidth));
        ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ui.px(118.0f));
        for (const Action& action : actionTable()) {
            if (action.id.empty() || !matches(keys, action)) continue;
            drawRow(ui, action);
            ++shown;
        }
        ImGui::EndTable();
    }
    if (shown == 0) ImGui::TextDisabled("No action has this name or these keys.");
    ImGui::EndChild();
}

void KeysPage::drawRow(Ui& ui, const Action& action) {
    KeyBindings& keys = ui.workspace.settings.keys;
    const std::string path = format("Preferences/Keys/{}", action.id);
    const bool changed = keys.isChanged(action);
    const bool listens = listening_ == &action;
    ImGui::PushID(action.id.data());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (changed) pushFont(ui.fonts.strong, ui.fonts.size);
    ImGui::TextUnformatted(nameOf(action).c_str());
    if (changed) ImGui::PopFont();
    ImGui::TableNextColumn();
    const std::string text = textOf(keys, action);
    if (listens) ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentPressed);
    const std::string label = listens        ? (wanted_ ? wanted_->text() : "Press keys...")
                              : text.empty() ? "none"
                                             : text;
    if (ImGui::Button((label + "###keys").c_str(), {-1.0f, 0.0f})) {
        stop();
        if (!listens) listening_ = &action;
    }
    if (listens) ImGui::PopStyleColor();
    ui.widgets.mark(path, listens ? "listening" : text);
    tooltip(listens ? "Press the new keys; Esc cancels" : "Click, then press the new keys");
    ImGui::TableNextColumn();
    if (!text.empty()) {
        if (ImGui::SmallButton("None")) keys.unbind(action), stop();
        ui.widgets.mark(path + "/none");
        tooltip("Removes all keys of this action");
    }
    if (changed) {
        if (!text.empty()) ImGui::SameLine();
        if (ImGui::SmallButton("Reset")) keys.reset(action), stop();
        ui.widgets.mark(path + "/reset");
        tooltip("Resets the keys to their default");
    }
    ImGui::PopID();
}

void KeysPage::drawConflict(Ui& ui) {
    if (listening_ == nullptr || !wanted_) return;
    KeyBindings& keys = ui.workspace.settings.keys;
    const Action* other = keys.conflict(*listening_, *wanted_);
    if (other == nullptr) return stop();
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::AlignTextToFramePadding();
    const std::string words = format("{} is already assigned to \"{}\".", wanted_->text(), nameOf(*other));
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark("Preferences/Keys/conflict", words);
    ImGui::SameLine();
    const bool take = ImGui::Button("Reassign");
    ui.widgets.mark("Preferences/Keys/Take");
    ImGui::SameLine();
    const bool leave = ImGui::Button("Cancel");
    ui.widgets.mark("Preferences/Keys/Leave");
    if (take) keys.bind(*listening_, *wanted_);
    if (take || leave) stop();
}

}  // namespace plumb::editor::ui
