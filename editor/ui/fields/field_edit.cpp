#include "editor/ui/fields/field_edit.hpp"

#include <cstring>

#include "core/text.hpp"
#include "editor/model/document/field_number.hpp"
#include "editor/model/field_text.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/fields/choices.hpp"
#include "editor/ui/ui_compat.hpp"
#include "reflect/curve_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kGap = 4.0f;  // px at scale 1: between widgets side by side

/// Returns the last part of the widget path of a number with this label letter.
std::string nameOf(char letter) {
    return letter == 'w' ? "width" : letter == 'h' ? "height" : std::string(1, letter);
}

/// Draws a text that looks like an input field. @param lines  multi-line @return true if it was clicked
bool wordButton(const Ui& ui, const std::string& text, float width, bool lines, bool dim) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float height = lines ? ImGui::GetTextLineHeight() * 4.5f : ImGui::GetFrameHeight();
    const bool clicked = ImGui::InvisibleButton("##word", {std::max(width, 1.0f), height});
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(
        from, to, ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
        style.FrameRounding);
    if (style.FrameBorderSize > 0.0f) outline(list, from, to, palette::kBorder, style.FrameRounding);
    list.PushClipRect({from.x + ui.px(2.0f), from.y}, {to.x - ui.px(2.0f), to.y}, true);
    list.AddText({from.x + style.FramePadding.x, from.y + style.FramePadding.y},
                 dim ? palette::kTextDim : palette::kText, text.c_str());
    list.PopClipRect();
    return clicked;
}

}  // namespace

/// Draws several numbers, two per row, each with its label letter.
void FieldEdit::drawNumbers(const FieldRow& row, const char* letters, std::size_t from) {
    const auto count = static_cast<int>(std::strlen(letters));
    const float spacing = row.ui.px(kGap);
    const float letterWidth = row.ui.px(13.0f);
    const float start = ImGui::GetCursorPosX();
    const float width = (ImGui::GetContentRegionAvail().x - spacing) * 0.5f - letterWidth;
    for (int i = 0; i < count; ++i) {
        if (i % 2 != 0) ImGui::SameLine(0.0f, spacing);
        if (i > 0 && i % 2 == 0) ImGui::SetCursorPosX(start);
        ImGui::PushID(i);
        ImGui::AlignTextToFramePadding();
        const float left = ImGui::GetCursorPosX();
        ImGui::TextDisabled("%c", letters[i]);
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::SetCursorPosX(left + letterWidth);
        const std::size_t at = from + static_cast<std::size_t>(i) * sizeof(float);
        numbers_.draw(row, format("{}.{}", row.path, nameOf(letters[i])), at, width);
        ImGui::PopID();
    }
}

void FieldEdit::drawList(const FieldRow& row) {
    const FieldInfo& field = row.target.field;
    std::vector<std::byte> list = row.shared.value.bytes;
    const std::uint32_t count = field.countOf(list.data());
    if (!hasNumbers(field) || row.shared.mixed.lengths()) {
        ImGui::AlignTextToFramePadding();
        if (row.shared.mixed.lengths()) {
            ImGui::TextDisabled("%s  different lengths", kMixed);
        } else {
            ImGui::TextDisabled("%u of %u entries", count, static_cast<unsigned>(field.capacity));
        }
        row.ui.widgets.mark(row.path, row.mixed() ? kMixed : format("{}", count));
        return;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string path = format("{}.{}", row.path, i);
        const std::size_t at = i * field.elementSize;
        if (field.element == FieldKind::Vec2) {
            drawNumbers({row.ui, path, row.target, row.shared}, "xy", at);
        } else {
            numbers_.draw(row, path, at, -1.0f);
        }
        ImGui::PopID();
    }
    chooseLength(row, count);
}

void FieldEdit::drawWord(const FieldRow& row, const std::string& path, const std::string& text,
                         Result<FieldValue> (*take)(Workspace&, std::string_view)) {
    const float width = ImGui::GetContentRegionAvail().x;
    const bool reached = typing_.reached(path);
    ImGui::SetNextItemWidth(width);
    if (typing_.on(path)) return typing_.draw(row.ui);
    const bool lines = text.find('\n') != std::string::npos;
    const bool clicked = wordButton(row.ui, row.mixed() ? kMixed : text, width, lines, row.mixed());
    row.ui.widgets.mark(path, row.mixed() ? kMixed : text);
    if (!clicked && !reached) return;
    // The ids are stored, because other entities may be selected when the text is applied.
    const auto& [type, field, objects] = row.target;
    typing_.begin(
        row.ui, path,
        {.before = row.mixed() ? std::string{} : text,
         .take = [take, type = &type, field = &field,
                  ids = std::vector<ObjectId>(objects.begin(), objects.end())](
                     Workspace& workspace, std::string_view typed) -> Result<Done> {
             const Result<FieldValue> value = take(workspace, typed);
             if (!value) return value.error();
             editFields(workspace, {*type, *field, ids}, [&](FieldValue& one, std::size_t) { one = *value; });
             return Done{};
         },
         .lines = lines});
}

void FieldEdit::drawText(const FieldRow& row) {
    const std::string text{row.ui.workspace.shownWorld().texts().find(row.value<TextId>())};
    drawWord(row, row.path, text, [](Workspace& workspace, std::string_view typed) -> Result<FieldValue> {
        return FieldValue::of(workspace.shownWorld().texts().add(typed));
    });
}

void FieldEdit::drawColor(const FieldRow& row) {
    chooseColor(row);
    ImGui::SameLine(0.0f, row.ui.px(kGap));
    drawWord(row, row.path + ".hex", colorText(row.shared.value),
             [](Workspace&, std::string_view typed) { return colorFromText(typed); });
}

void FieldEdit::draw(const FieldRow& row) {
    switch (row.target.field.kind) {
        case FieldKind::Bool: return chooseBool(row);
        case FieldKind::Int:
            return row.target.field.layerBits ? chooseLayers(row) : numbers_.draw(row, row.path, 0, -1.0f);
        case FieldKind::Float: return numbers_.draw(row, row.path, 0, -1.0f);
        case FieldKind::Vec2: return drawNumbers(row, "xy", 0);
        case FieldKind::Rect: return drawNumbers(row, "xywh", 0);
        case FieldKind::Color: return drawColor(row);
        case FieldKind::Text: return drawText(row);
        case FieldKind::Enum: return chooseEnum(row);
        case FieldKind::Entity: return entities_.draw(row);
        case FieldKind::Asset: return assets_.draw(row);
        case FieldKind::Tiles: return chooseTiles(row);
        case FieldKind::List: return isCurve(row.target.field) ? curves_.draw(row) : drawList(row);
    }
}

}  // namespace plumb::editor::ui
