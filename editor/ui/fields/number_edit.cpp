#include "editor/ui/fields/number_edit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "editor/model/document/field_number.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr double kFinest = 0.01;  // unit of all changes and drag step with Alt, in normal drag steps

/// Draws the unit at the right end of the last item, if there is room beside the number.
void drawUnit(const Ui& ui, const char* number, const char* unit) {
    if (*unit == '\0') return;
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    const float half = (to.x - from.x) * 0.5f;
    const float width = ImGui::CalcTextSize(unit).x + ui.px(5.0f);
    if (ImGui::CalcTextSize(number).x * 0.5f + width + ui.px(3.0f) > half) return;
    const float top = from.y + (to.y - from.y - ImGui::GetTextLineHeight()) * 0.5f;
    ImGui::GetWindowDrawList()->AddText({to.x - width, top}, palette::kTextDim, unit);
}

/// Returns the results of a typed expression for display: "= 52", or for several entities "= 26, 42, 58, … of
/// 5".
Result<std::string> previewOf(const std::vector<double>& old, std::size_t count, std::string_view text) {
    std::string words = "=";
    for (std::size_t i = 0; i < old.size(); ++i) {
        const Result<double> value = typedNumber(text, {old[i], i, count});
        if (!value) return value.error();
        words += format("{}{}", i == 0 ? " " : ", ", numberText(*value));
    }
    return old.size() < count ? format("{}, … of {}", words, count) : words;
}

Typing::Over overNumber(const FieldRow& row, std::size_t at) {
    constexpr std::size_t kShown = 4;  // maximum number of results shown while typing
    const auto& [type, field, objects] = row.target;
    std::vector<double> old;
    for (const ObjectId id : objects.first(std::min(kShown, objects.size()))) {
        for (const FieldValue& value : readFields(row.ui.workspace, {type, field, {&id, 1}}))
            old.push_back(numberAt(field, value, at));
    }
    const bool mixed = row.shared.mixed.any(at, numberSize(field));
    Typing::Over over;
    over.before = mixed ? std::string{} : shortestText(numberAt(field, row.shared.value, at));
    // The ids are stored, because other entities may be selected when the text is applied.
    over.take = [type = &type, info = &field, at,
                 ids = std::vector<ObjectId>(objects.begin(), objects.end())](Workspace& workspace,
                                                                              std::string_view text) {
        return typeNumber(workspace, {*type, *info, ids}, at, text);
    };
    over.preview = [old = std::move(old), count = objects.size()](std::string_view text) {
        return previewOf(old, count, text);
    };
    return over;
}

}  // namespace

void NumberEdit::draw(const FieldRow& row, const std::string& path, std::size_t at, float width) {
    const bool reached = typing_.reached(path);
    ImGui::SetNextItemWidth(width);
    if (typing_.on(path)) return typing_.draw(row.ui);
    drag(row, path, at);
    const bool asks =
        ImGui::IsItemHovered() && (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ||
                                   (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::GetIO().KeyCtrl));
    if (!reached && !asks) return;
    if (asks) dropActiveItem();
    typing_.begin(row.ui, path, overNumber(row, at));
}

void NumberEdit::drag(const FieldRow& row, const std::string& path, std::size_t at) {
    const auto& [ui, name, target, shared] = row;
    const FieldInfo& field = target.field;
    const bool mixed = shared.mixed.any(at, numberSize(field));
    const bool held = path_ == path;
    const double now = mixed ? 0.0 : numberAt(field, shared.value, at);
    const double by = dragged_ - start_;
    const std::string text = !mixed ? numberText(now)
                             : held ? format("{}{}", by < 0.0 ? "" : "+", numberText(by))
                                    : std::string{kMixed};
    double value = held ? dragged_ : now;
    const NumberRange range = numberRange(field);
    const bool limited = range.limited && !mixed;
    ImGui::PushStyleColor(ImGuiCol_Text, mixed && !held ? palette::kTextDim : palette::kText);
    ImGui::DragScalar(
        "##number", ImGuiDataType_Double, &value, static_cast<float>(numberStep(field)),
        limited ? &range.min : nullptr, limited ? &range.max : nullptr, text.c_str(),
        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
    ImGui::PopStyleColor();
    drawUnit(ui, text.c_str(), shownUnit(field.unit));
    ui.widgets.mark(path, mixed ? std::string{kMixed} : shortestText(now));
    // The drag of one number may end and that of another start in the same frame.
    if (ImGui::IsItemDeactivated() && held) {
        path_.clear();
        ui.workspace.undo.endGesture();
    }
    if (ImGui::IsItemActivated()) {
        path_ = path;
        dragged_ = start_ = now;
        ids_.assign(target.objects.begin(), target.objects.end());
        starts_.clear();
        for (const FieldValue& one : readFields(ui.workspace, target))
            starts_.push_back(numberAt(field, one, at));
    }
    if (path_ != path || !ImGui::IsItemActive()) return;
    drawn_ = ui.takesEscape = true;
    if (pressed(Key::Escape)) {
        value = start_;
        path_.clear();
        dropActiveItem();
    }
    if (value == dragged_) return;
    dragged_ = value;
    change(row, at);
    if (path_.empty()) ui.workspace.undo.endGesture();
}

/// Changes the numbers of all entities by the same amount as the dragged one.
void NumberEdit::change(const FieldRow& row, std::size_t at) {
    const auto& [type, field, objects] = row.target;
    const double grain = numberStep(field) * kFinest;
    const double by = std::round((dragged_ - start_) / grain) * grain;
    const FieldInfo& info = field;  // a structured binding cannot be captured
    std::size_t next = 0;           // index in `starts_`, which has only the entities with the component
    editFields(row.ui.workspace, {type, field, ids_}, [&](FieldValue& value, std::size_t) {
        const std::size_t i = next++;
        if (i < starts_.size()) setNumberAt(info, value, starts_[i] + by, at);
    });
}

void NumberEdit::endFrame(Ui& ui) {
    if (std::exchange(drawn_, false) || path_.empty()) return;
    path_.clear();  // the widget disappeared during a drag
    ui.workspace.undo.endGesture();
}

}  // namespace plumb::editor::ui
