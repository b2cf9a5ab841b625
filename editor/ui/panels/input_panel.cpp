#include <algorithm>
#include <optional>

#include "core/text.hpp"
#include "editor/model/assets/input_map_edit.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

using Kind = InputMapEdit::Kind;

constexpr double kLookAgain = 0.5;    // s
constexpr float kNameWidth = 150.0f;  // px at scale 1
constexpr float kPartWidth = 70.0f;   // px at scale 1
constexpr float kChipHeight = 22.0f;  // px at scale 1
constexpr const char* kPress = "Press a key";
constexpr const char* kAddAction = "New action###add input";
constexpr const char* kAddAxis = "New axis###add input";

/// Returns the widget path of an action or axis part: "Input/Jump", "Input/Horizontal/negative".
std::string pathOf(const InputMapEdit::Place& place) {
    return format("Input/{}{}{}", place.name, place.part.empty() ? "" : "/", place.part);
}

/// Returns all possible bindings of a kind, even if no such device is connected.
std::vector<Binding> allOf(BindingKind kind) {
    std::size_t count = 0;
    switch (kind) {
        case BindingKind::Key: count = kKeyCount; break;
        case BindingKind::MouseButton: count = kMouseButtonCount; break;
        case BindingKind::PadButton: count = kPadButtonCount; break;
        default: count = kPadAxisCount; break;
    }
    std::vector<Binding> all;
    for (std::size_t code = kind == BindingKind::Key ? 1 : 0; code < count; ++code)
        all.push_back({kind, static_cast<std::uint8_t>(code)});
    return all;
}

/// Edits the project's input actions and axes, and the keys, buttons and sticks bound to them.
class InputPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        if (!edit_) edit_.emplace(ui.workspace);
        if (const double now = ImGui::GetTime();
            now >= nextLook_ || ui.workspace.document.sceneRevision != revision_) {
            problem_ = edit_->refresh();
            nextLook_ = now + kLookAgain;
            revision_ = ui.workspace.document.sceneRevision;
        }
        drawBar(ui);
        beginChild("map", {0.0f, 0.0f}, false);
        const std::vector<InputMapEdit::Row> rows = edit_->rows();  // a copy, as a change replaces the rows
        for (const InputMapEdit::Row& row : rows) drawRow(ui, row);
        ImGui::EndChild();
        drawPress(ui);
        drawAdd(ui);
    }

private:
    void say(Ui& ui, const Result<Done>& done) {
        if (!done) ui.workspace.notice = done.error().text();
        error_ = done ? std::string{} : done.error().text();
    }

    void drawBar(Ui& ui) {
        for (const auto& [label, kind] :
             {std::pair{"Add action...", Kind::Action}, std::pair{"Add axis...", Kind::Axis}}) {
            if (ImGui::Button(label)) {
                adding_ = kind;
                newName_.clear();
                error_.clear();
                ImGui::OpenPopup(kAddAction);
            }
            ui.widgets.mark(format("Input/{}", label));
            ImGui::SameLine(0.0f, ui.px(4.0f));
        }
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        const std::size_t shared = edit_->shared();
        std::string text =
            ui.workspace.canEdit() ? "Changes are saved to project.json at once."
            : ui.workspace.play.inPast()
                ? "New keys apply when the game resumes from here; the recorded past keeps its keys."
                : "New keys apply in the running game from the next tick on.";
        if (shared > 0)
            text += format("  {} {} more than one action.",
                           shared == 1 ? std::string{"1 key"} : format("{} keys", shared),
                           shared == 1 ? "triggers" : "trigger");
        if (!problem_.empty()) text = problem_;
        ImGui::PushStyleColor(ImGuiCol_Text, problem_.empty() ? palette::kTextDim : palette::kWarning);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
        ui.widgets.mark("Input/state", text);
        tooltip(text);  // a narrow panel cuts the text off
    }

    void drawRow(Ui& ui, const InputMapEdit::Row& row) {
        ImGui::PushID(static_cast<int>(row.kind));
        ImGui::PushID(row.name.c_str());
        const float y = ImGui::GetCursorPosY();
        drawName(ui, row);
        ImGui::SetCursorPosY(y);
        for (const InputMapEdit::Part& part : row.parts) {
            ImGui::PushID(part.key.c_str());
            drawPart(ui, {row.kind, row.name, part.key}, part);
            ImGui::PopID();
        }
        ImGui::PopID();
        ImGui::PopID();
        ImGui::Dummy({0.0f, ui.px(2.0f)});
    }

    void drawName(Ui& ui, const InputMapEdit::Row& row) {
        if (renaming_ && renaming_->kind == row.kind && renaming_->name == row.name)
            return drawRename(ui, row);
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, row.ofProject ? palette::kText : palette::kTextDim);
        ImGui::Selectable(row.name.c_str(), false, 0, {ui.px(kNameWidth - 12.0f), ui.px(kChipHeight)});
        ImGui::PopStyleColor();
        ui.widgets.mark("Input/" + row.name, row.ofProject ? "project" : "default");
        tooltip(row.ofProject ? "Double-click to rename; right-click for more"
                              : "Default of the engine; a change is saved in the project");
        if (row.ofProject && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) beginRename(row);
        if (!ImGui::BeginPopupContextItem("menu")) return;
        if (ImGui::MenuItem("Rename", nullptr, false, row.ofProject)) beginRename(row);
        ui.widgets.mark("Input/menu/Rename");
        if (ImGui::MenuItem("Remove, or reset to default", nullptr, false, row.ofProject))
            say(ui, edit_->remove(row.kind, row.name));
        ui.widgets.mark("Input/menu/Remove");
        ImGui::EndPopup();
    }

    void beginRename(const InputMapEdit::Row& row) {
        renaming_ = InputMapEdit::Place{row.kind, row.name, {}};
        newName_ = row.name;
        focus_ = true;
    }

    void drawRename(Ui& ui, const InputMapEdit::Row& row) {
        if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(ui.px(kNameWidth - 12.0f));
        const bool done = textField("##name", newName_,
                                    ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        ui.widgets.mark("Input/rename", newName_);
        if (done) say(ui, edit_->rename(row.kind, row.name, newName_));
        if (done || ImGui::IsItemDeactivated()) renaming_.reset();
    }

    void drawPart(Ui& ui, const InputMapEdit::Place& place, const InputMapEdit::Part& part) {
        float left = ui.px(kNameWidth);
        const ImVec2 start{ImGui::GetCursorScreenPos().x - ImGui::GetCursorPosX(), 0.0f};
        if (!part.key.empty()) {
            ImGui::SetCursorPosX(left);
            ImGui::AlignTextToFramePadding();
            ImGui::TextDisabled("%s", part.key.c_str());
            left += ui.px(kPartWidth);
            ImGui::SameLine(left);
        } else {
            ImGui::SetCursorPosX(left);
        }
        for (std::size_t i = 0; i < part.bindings.size(); ++i) {
            const float width = chipWidth(ui, part.bindings[i]);
            placeNext(left, width, start.x);
            drawChip(ui, place, part.bindings[i], i, width);
            ImGui::SameLine(0.0f, ui.px(4.0f));
        }
        placeNext(left, ui.px(56.0f), start.x);
        drawButtons(ui, place);
    }

    /// Moves to the next line if an item of this width (px) does not fit.
    static void placeNext(float left, float width, float windowLeft) {
        const float x = ImGui::GetCursorScreenPos().x - windowLeft;
        if (x + width <= ImGui::GetWindowContentRegionMax().x || x <= left) return;
        ImGui::NewLine();
        ImGui::SetCursorPosX(left);
    }

    [[nodiscard]] static float chipWidth(const Ui& ui, Binding binding) {
        return ImGui::CalcTextSize(toText(binding).c_str()).x + ui.px(30.0f);
    }

    /// Draws a bound key with a cross that removes the binding.
    void drawChip(Ui& ui, const InputMapEdit::Place& place, Binding binding, std::size_t index, float width) {
        const std::string text = toText(binding);
        const std::vector<std::string> others = edit_->othersOf(binding, place);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ui.px(kChipHeight);
        const float cross = ui.px(20.0f);
        ImGui::PushID(static_cast<int>(index));
        ImGui::Dummy({width - cross, height});
        std::string conflict;
        for (const std::string& other : others) conflict += (conflict.empty() ? "" : "; ") + other;
        ui.widgets.mark(format("{}/{}", pathOf(place), text), conflict);
        if (!conflict.empty()) tooltip(format("{} is also bound to: {}", text, conflict));
        ImGui::SameLine(0.0f, 0.0f);
        const bool remove = ImGui::InvisibleButton("remove", {cross, height});
        const bool hovered = ImGui::IsItemHovered();
        ui.widgets.mark(format("{}/{}/remove", pathOf(place), text));
        tooltip("Removes this binding");
        ImGui::PopID();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{at.x + width, at.y + height};
        list.AddRectFilled(at, to, palette::kField, ui.px(4.0f));
        outline(list, at, to, others.empty() ? palette::kBorder : palette::kWarning, ui.px(4.0f));
        const float line = at.y + (height - ImGui::GetTextLineHeight()) * 0.5f;
        list.AddText({at.x + ui.px(8.0f), line}, palette::kText, text.c_str());
        const ImVec2 middle{to.x - cross * 0.5f, at.y + height * 0.5f};
        const float arm = ui.px(3.0f);
        const ImU32 color = hovered ? palette::kError : palette::kTextDim;
        list.AddLine({middle.x - arm, middle.y - arm}, {middle.x + arm, middle.y + arm}, color, ui.px(1.3f));
        list.AddLine({middle.x - arm, middle.y + arm}, {middle.x + arm, middle.y - arm}, color, ui.px(1.3f));
        if (remove) say(ui, edit_->unbind(place, index));
    }

    void drawButtons(Ui& ui, const InputMapEdit::Place& place) {
        const ImVec2 size{ui.px(26.0f), ui.px(kChipHeight)};
        if (ImGui::Button("+", size)) press_ = place;
        ui.widgets.mark(pathOf(place) + "/press");
        tooltip("Bind a key, or a button of the mouse or the gamepad, by pressing it");
        ImGui::SameLine(0.0f, ui.px(2.0f));
        if (ImGui::ArrowButton("list", ImGuiDir_Down)) ImGui::OpenPopup("all");
        ui.widgets.mark(pathOf(place) + "/list");
        tooltip("Select from a list");
        if (!ImGui::BeginPopup("all")) return;
        for (const auto& [label, kind] :
             {std::pair{"Keys", BindingKind::Key}, std::pair{"Mouse", BindingKind::MouseButton},
              std::pair{"Gamepad", BindingKind::PadButton}, std::pair{"Sticks", BindingKind::PadAxis},
              std::pair{"Sticks, positive", BindingKind::PadAxisPlus},
              std::pair{"Sticks, negative", BindingKind::PadAxisMinus}}) {
            const bool open = ImGui::BeginMenu(label);
            ui.widgets.mark(format("Input/list/{}", label));
            if (!open) continue;
            for (const Binding binding : allOf(kind)) {
                const std::string text = toText(binding);
                if (ImGui::MenuItem(text.c_str())) say(ui, edit_->bind(place, binding));
                ui.widgets.mark(format("Input/list/{}", text));
            }
            ImGui::EndMenu();
        }
        ImGui::EndPopup();
    }

    void drawPress(Ui& ui) {
        if (press_ && !ImGui::IsPopupOpen(kPress)) {
            pressed_.reset();
            overField_ = false;
            ImGui::OpenPopup(kPress);
            drawn_ = ImGui::GetFrameCount();
            ui.takeEvent = [this](const Event& event) { return take(event); };
        }
        ImGui::SetNextWindowSize({ui.px(360.0f), 0.0f});
        if (!ImGui::BeginPopupModal(kPress, nullptr, ImGuiWindowFlags_NoResize)) {
            if (press_) ui.takeEvent = nullptr;
            press_.reset();
            return;
        }
        drawn_ = ImGui::GetFrameCount();
        const std::string subject =
            press_->part.empty() ? press_->name : format("{}, {}", press_->name, press_->part);
        ImGui::TextUnformatted(format("for {}", subject).c_str());
        ImGui::InvisibleButton("field", {ImGui::GetContentRegionAvail().x, ui.px(64.0f)});
        overField_ = ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
        ui.widgets.mark("Input/field");
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        list.AddRectFilled(from, to, palette::kField, ui.px(4.0f));
        const char* words = "Press any key (Escape too), or click here with a mouse button.";
        const ImVec2 extent = ImGui::CalcTextSize(words);
        list.AddText({(from.x + to.x - extent.x) * 0.5f, (from.y + to.y - extent.y) * 0.5f},
                     palette::kTextDim, words);
        const bool leave = ImGui::Button("Cancel", {ui.px(110.0f), 0.0f});
        ui.widgets.mark("Input/cancel");
        if (pressed_) say(ui, edit_->bind(*press_, *pressed_));
        if (pressed_ || leave) {
            ImGui::CloseCurrentPopup();
            press_.reset();
            ui.takeEvent = nullptr;
        }
        ImGui::EndPopup();
    }

    /// Takes an input event as the new binding. True: the
    /// event is used up, no shortcut and no game receives it.
    bool take(const Event& event) {
        const std::optional<Binding> binding = plumb::editor::bindingOf(event);
        if (ImGui::GetFrameCount() > drawn_ + 1) return false;  // the dialog is no longer shown
        if (event.kind == EventKind::MouseDown && !overField_) return false;
        if (binding && !pressed_) pressed_ = binding;
        return binding.has_value();
    }

    void drawAdd(Ui& ui) {
        ImGui::SetNextWindowSize({ui.px(360.0f), 0.0f});
        if (!ImGui::BeginPopupModal(adding_ == Kind::Action ? kAddAction : kAddAxis, nullptr,
                                    ImGuiWindowFlags_NoResize))
            return;
        ImGui::TextDisabled("%s", adding_ == Kind::Action ? "Name of the action, as used in scenes and code"
                                                          : "Name of the axis, as used in code");
        if (ImGui::IsWindowAppearing() || std::exchange(typeAgain_, false)) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(-1.0f);
        bool done = textField("##name", newName_, ImGuiInputTextFlags_EnterReturnsTrue,
                              adding_ == Kind::Action ? "Dash" : "Aim");
        ui.widgets.mark("Input/new name", newName_);
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
        ImGui::TextWrapped("%s", error_.c_str());
        ImGui::PopStyleColor();
        done |= ImGui::Button("Add", {ui.px(110.0f), 0.0f});
        ui.widgets.mark("Input/add");
        ImGui::SameLine();
        const bool leave = ImGui::Button("Cancel", {ui.px(110.0f), 0.0f});
        ui.widgets.mark("Input/add cancel");
        if (done) say(ui, edit_->add(adding_, newName_));
        typeAgain_ = done && !error_.empty();
        if (leave || (done && !typeAgain_)) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }

    std::optional<InputMapEdit> edit_;
    double nextLook_ = 0.0;
    std::uint64_t revision_ = 0;
    std::string problem_;
    std::string error_;  ///< message of the last failed change
    std::string newName_;
    bool typeAgain_ = false;  ///< the name was rejected: focus the field again
    Kind adding_ = Kind::Action;
    std::optional<InputMapEdit::Place> renaming_;
    bool focus_ = false;
    std::optional<InputMapEdit::Place> press_;  ///< the action or axis part that gets the next key
    std::optional<Binding> pressed_;
    bool overField_ = false;
    int drawn_ = 0;  ///< last frame in which the dialog was shown
};

}  // namespace

std::unique_ptr<Panel> makeInputPanel() { return std::make_unique<InputPanel>(); }

}  // namespace plumb::editor::ui
