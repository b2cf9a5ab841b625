#include "editor/ui/fields/typing.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr int kPatience = 5;  // maximum frames to wait for the keyboard focus

/// ImGui callback that resizes the string, and filters Tab, which moves to the next value instead.
int keepText(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCharFilter) return data->EventChar == '\t' ? 1 : 0;
    auto& text = *static_cast<std::string*>(data->UserData);
    text.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = text.data();
    return 0;
}

}  // namespace

bool Typing::reached(const std::string& path) {
    before_ = std::exchange(last_, path);
    const bool here = wantNext_ || (!wanted_.empty() && wanted_ == path);
    if (here) {
        wantNext_ = false;
        wanted_.clear();
    }
    return here;
}

void Typing::begin(Ui& ui, const std::string& path, Over over) {
    if (!path_.empty()) finish(ui, false);
    path_ = path;
    text_ = over.before;
    over_ = std::move(over);
    problem_.clear();
    focus_ = drawn_ = true;
    active_ = false;
    waiting_ = 0;
}

bool Typing::input() {
    constexpr ImGuiInputTextFlags kFlags =
        ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_AutoSelectAll |
        ImGuiInputTextFlags_CallbackCharFilter | ImGuiInputTextFlags_CallbackResize;
    if (over_.lines) {
        const ImVec2 size{ImGui::CalcItemWidth(), ImGui::GetTextLineHeight() * 4.5f};
        ImGui::InputTextMultiline("##typed", text_.data(), text_.capacity() + 1, size, kFlags, &keepText,
                                  &text_);
        return false;
    }
    return ImGui::InputText("##typed", text_.data(), text_.capacity() + 1,
                            kFlags | ImGuiInputTextFlags_EnterReturnsTrue, &keepText, &text_);
}

void Typing::draw(Ui& ui) {
    drawn_ = true;
    if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
    const bool refused = !problem_.empty();
    ImVec4 red = colorOf(palette::kError);
    red.w = 0.3f;  // translucent, so that the text stays readable
    if (refused) ImGui::PushStyleColor(ImGuiCol_FrameBg, red);
    const bool entered = input();
    if (refused) ImGui::PopStyleColor();
    ui.widgets.mark(path_, text_);
    if (ImGui::IsItemActive()) {
        active_ = true;
        waiting_ = 0;
        if (over_.preview && (refused || text_ != over_.before)) say(ui, over_.preview(text_));
        if (!pressed(Key::Tab)) return;
        wantNext_ = !ImGui::GetIO().KeyShift;
        if (!wantNext_) wanted_ = before_;
        dropActiveItem();
        return finish(ui, false);
    }
    if (active_ && ImGui::IsItemDeactivated()) {
        if (pressed(Key::Escape)) return path_.clear();
        return finish(ui, entered);
    }
    if (++waiting_ > kPatience) path_.clear();
}

void Typing::say(Ui& ui, const Result<std::string>& text) const {
    const std::string words = text ? *text : text.error().text();
    const float wrap = ImGui::GetFontSize() * 20.0f;
    const float width =
        ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap).x + ImGui::GetStyle().WindowPadding.x * 2.0f;
    // The message is below the field, but inside the window.
    const float right = ImGui::GetIO().DisplaySize.x - ui.px(4.0f);
    const ImVec2 at{std::max(std::min(ImGui::GetItemRectMin().x, right - width), 0.0f),
                    ImGui::GetItemRectMax().y + ui.px(3.0f)};
    ImGui::SetNextWindowPos(at);
    ImGui::BeginTooltip();
    ImGui::PushStyleColor(ImGuiCol_Text, text ? palette::kText : palette::kError);
    ImGui::PushTextWrapPos(wrap);
    ImGui::TextUnformatted(words.c_str());
    ui.widgets.mark(path_ + "/says", words);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::EndTooltip();
}

void Typing::finish(Ui& ui, bool stay) {
    // `path_` is cleared first, as the call below may draw the value again or start typing at another one.
    const std::string path = std::exchange(path_, std::string{});
    if (text_ == over_.before) return;
    const auto take = over_.take;
    const Result<Done> taken = take(ui.workspace, text_);
    ui.workspace.undo.endGesture();
    if (taken) return;
    ui.workspace.notice = format("\"{}\": {}", text_, taken.error().text());
    if (!stay) return;
    path_ = path;
    problem_ = taken.error().text();
    focus_ = true;
    active_ = false;
    waiting_ = 0;
}

void Typing::endFrame(Ui& ui) {
    last_.clear();
    before_.clear();
    wantNext_ = false;
    if (!std::exchange(drawn_, false) && !path_.empty()) finish(ui, false);
}

}  // namespace plumb::editor::ui
