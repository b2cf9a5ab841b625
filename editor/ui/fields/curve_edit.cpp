#include "editor/ui/fields/curve_edit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "editor/model/document/field_number.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr int kSegments = 64;     // number of segments of the drawn polyline
constexpr float kWidth = 340.0f;  // px at scale 1: width of the popup's canvas
constexpr float kGrab = 8.0f;     // px at scale 1: hit distance of a key
constexpr std::size_t kNoKey = Curve::kKeys;

/// A predefined curve with values from 0 to 1.
struct Preset {
    const char* name;
    Curve curve;
};
const std::array kPresets{
    Preset{"Constant", Curve::constant(1.0f)},
    Preset{"Up", Curve::line(0.0f, 1.0f)},
    Preset{"Down", Curve::line(1.0f, 0.0f)},
    Preset{"Hump", Curve::hump(0.0f, 1.0f)},
    Preset{"Ease",
           {{CurveKey{0.0f, 0.0f}, CurveKey{0.25f, 0.1f}, CurveKey{0.75f, 0.9f}, CurveKey{1.0f, 1.0f}}, 4}},
};

/// The area on screen in which a curve is drawn, and its range of values.
struct Canvas {
    ImVec2 from;
    ImVec2 to;
    float bottom = 0.0f;  ///< value at the lower edge
    float top = 1.0f;     ///< value at the upper edge

    [[nodiscard]] ImVec2 at(CurveKey key) const {
        const float part = (key.value - bottom) / (top - bottom);
        return {from.x + key.at * (to.x - from.x), to.y - part * (to.y - from.y)};
    }
    [[nodiscard]] CurveKey keyAt(ImVec2 place) const {
        const float at = (place.x - from.x) / std::max(to.x - from.x, 1.0f);
        const float part = (to.y - place.y) / std::max(to.y - from.y, 1.0f);
        return {std::clamp(at, 0.0f, 1.0f), bottom + part * (top - bottom)};
    }
};

/// Returns the value at the upper edge: the smallest round number not below any key, limited to the field's
/// maximum.
float topOf(const FieldInfo& field, const Curve& curve) {
    float highest = 0.0f;
    for (std::size_t i = 0; i < curve.size(); ++i) highest = std::max(highest, curve.keys[i].value);
    for (const float top : {1.0f, 2.0f, 5.0f, 10.0f, 100.0f}) {
        if (top >= field.max) return field.max;
        if (top >= highest) return top;
    }
    return highest;
}

float bottomOf(const Curve& curve) {
    float lowest = 0.0f;
    for (std::size_t i = 0; i < curve.size(); ++i) lowest = std::min(lowest, curve.keys[i].value);
    return lowest;
}

void drawLine(ImDrawList& list, const Canvas& canvas, const Curve& curve, ImU32 color, float thickness) {
    std::array<ImVec2, kSegments + 1> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float at = static_cast<float>(i) / static_cast<float>(kSegments);
        points[i] = canvas.at({at, curve.valueAt(at)});
    }
    polyline(list, points.data(), static_cast<int>(points.size()), color, false, thickness);
}

void drawGrid(const Ui& ui, ImDrawList& list, const Canvas& canvas) {
    for (int i = 1; i < 4; ++i) {
        const float part = static_cast<float>(i) * 0.25f;
        const float x = std::floor(canvas.from.x + part * (canvas.to.x - canvas.from.x));
        const float y = std::floor(canvas.from.y + part * (canvas.to.y - canvas.from.y));
        list.AddLine({x, canvas.from.y}, {x, canvas.to.y}, palette::kTick);
        list.AddLine({canvas.from.x, y}, {canvas.to.x, y}, palette::kTick);
    }
    list.AddText({canvas.from.x + ui.px(10.0f), canvas.from.y + ui.px(2.0f)}, palette::kTextDim,
                 numberText(double{canvas.top}).c_str());
    list.AddText({canvas.from.x + ui.px(10.0f), canvas.to.y - ImGui::GetTextLineHeight() - ui.px(2.0f)},
                 palette::kTextDim, numberText(double{canvas.bottom}).c_str());
}

std::size_t keyUnder(const Ui& ui, const Canvas& canvas, const Curve& curve, ImVec2 mouse) {
    std::size_t nearest = kNoKey;
    float closest = ui.px(kGrab);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const ImVec2 at = canvas.at(curve.keys[i]);
        const float away = std::hypot(at.x - mouse.x, at.y - mouse.y);
        if (away < closest) closest = away, nearest = i;
    }
    return nearest;
}

std::string keyText(CurveKey key) {
    return format("{} : {}", fixedText(double{key.at}, 2), fixedText(double{key.value}, 2));
}

}  // namespace

std::string curveText(const Curve& curve) {
    std::string text = curve.shape == CurveShape::Smooth ? "smooth" : "linear";
    for (std::size_t i = 0; i < curve.size(); ++i)
        text += format(" {}:{}", shortestText(curve.keys[i].at), shortestText(curve.keys[i].value));
    return text;
}

void CurveEdit::draw(const FieldRow& row) {
    const Ui& ui = row.ui;
    const auto curve = row.value<Curve>();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 8.0f), ImGui::GetFrameHeight() * 1.7f};
    const bool clicked = ImGui::InvisibleButton("##curve", size);
    row.ui.widgets.mark(row.path, row.mixed() ? kMixed : curveText(curve));
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    list.AddRectFilled(from, to, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       ImGui::GetStyle().FrameRounding);
    const float margin = ui.px(5.0f);
    const Canvas canvas{{from.x + margin, from.y + margin},
                        {to.x - margin, to.y - margin},
                        bottomOf(curve),
                        topOf(row.target.field, curve)};
    drawLine(list, canvas, curve, row.mixed() ? palette::kTextDim : palette::kAccent, ui.px(1.5f));
    if (row.mixed()) {
        const ImVec2 dash = ImGui::CalcTextSize(kMixed);
        list.AddText({(from.x + to.x - dash.x) * 0.5f, (from.y + to.y - dash.y) * 0.5f}, palette::kText,
                     kMixed);
    }
    tooltip(row.mixed() ? "The entities have different curves. A change here applies to all of them."
                        : "Click to edit the curve");
    if (clicked) ImGui::OpenPopup("curve");
    if (!ImGui::BeginPopup("curve")) return;
    drawPopup(row, curve);
    ImGui::EndPopup();
}

void CurveEdit::drawPopup(const FieldRow& row, const Curve& curve) {
    const Ui& ui = row.ui;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(std::string{row.target.field.name}.c_str());
    const float width =
        ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize("Smooth").x;
    ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + ui.px(kWidth) - width);
    bool smooth = curve.shape == CurveShape::Smooth;
    const bool changed = checkbox("Smooth", smooth, false);
    ui.widgets.mark(row.path + "/Smooth", smooth ? "true" : "false");
    tooltip("On: smooth between the keys, without overshoot. Off: straight lines.");
    drawCanvas(row, curve);
    drawButtons(row);
    if (!changed) return;
    Curve shaped = curve;
    shaped.shape = smooth ? CurveShape::Smooth : CurveShape::Linear;
    row.set(FieldValue::of(shaped));
}

void CurveEdit::drawCanvas(const FieldRow& row, const Curve& curve) {
    Ui& ui = row.ui;
    const ImVec2 size{ui.px(kWidth), ui.px(170.0f)};
    ImGui::InvisibleButton("##canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    ui.widgets.mark(row.path + "/canvas");
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    const float margin = ui.px(kGrab);
    const bool held = path_ == row.path;
    const Canvas canvas{{from.x + margin, from.y + margin},
                        {to.x - margin, to.y - margin},
                        bottomOf(held ? start_ : curve),
                        held ? top_ : topOf(row.target.field, curve)};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const std::size_t under = held                     ? key_
                              : ImGui::IsItemHovered() ? keyUnder(ui, canvas, curve, mouse)
                                                       : kNoKey;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, palette::kField, ImGui::GetStyle().FrameRounding);
    drawGrid(ui, list, canvas);
    list.PushClipRect(from, to, true);
    drawLine(list, canvas, curve, palette::kAccent, ui.px(2.0f));
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const ImVec2 at = canvas.at(curve.keys[i]);
        list.AddCircleFilled(at, ui.px(i == under ? 6.0f : 4.5f),
                             i == under ? palette::kText : palette::kAccent);
        ui.widgets.mark(format("{}/key{}", row.path, i),
                        {{at.x - 1.0f, at.y - 1.0f}, {at.x + 1.0f, at.y + 1.0f}}, keyText(curve.keys[i]));
    }
    list.PopClipRect();
    if (under != kNoKey) {
        const std::string text = keyText(curve.keys[under]);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        list.AddText({to.x - width - ui.px(6.0f), from.y + ui.px(4.0f)}, palette::kText, text.c_str());
    }

    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && under != kNoKey) {
        Curve fewer = curve;
        fewer.remove(under);
        return row.set(FieldValue::of(fewer));
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && under == kNoKey) {
        Curve more = curve;
        CurveKey key = canvas.keyAt(mouse);
        key.value = std::clamp(key.value, row.target.field.min, row.target.field.max);
        if (more.insert(key) != kNoKey) return row.set(FieldValue::of(more));
        ui.workspace.notice = format("A curve can have at most {} keys", Curve::kKeys);
        return;
    }
    if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && under != kNoKey) {
        path_ = row.path;
        ids_.assign(row.target.objects.begin(), row.target.objects.end());
        key_ = under;
        start_ = curve;
        top_ = canvas.top;
        const CurveKey at = canvas.keyAt(mouse);
        grab_ = {curve.keys[under].at - at.at, curve.keys[under].value - at.value};
    }
    const CurveKey at = canvas.keyAt(mouse);
    if (path_ == row.path) drag(row, curve, {at.at + grab_.at, at.value + grab_.value});
}

void CurveEdit::drag(const FieldRow& row, const Curve& curve, CurveKey to) {
    Ui& ui = row.ui;
    const bool ends = !ImGui::IsItemActive();
    drawn_ = ui.takesEscape = true;
    Curve next = start_;
    if (!ends && pressed(Key::Escape)) {
        path_.clear();
        dropActiveItem();
    } else if (ends) {
        next = curve;
    } else {
        to.value = std::clamp(to.value, row.target.field.min, row.target.field.max);
        next.move(key_, to);
    }
    if (next != curve) {
        const FieldValue value = FieldValue::of(next);
        editFields(ui.workspace, {row.target.type, row.target.field, ids_},
                   [&](FieldValue& one, std::size_t) { one = value; });
    }
    if (ends) path_.clear();
    if (path_.empty()) ui.workspace.undo.endGesture();
}

void CurveEdit::drawButtons(const FieldRow& row) {
    const Ui& ui = row.ui;
    for (const Preset& preset : kPresets) {
        if (&preset != &kPresets.front()) ImGui::SameLine(0.0f, ui.px(4.0f));
        if (ImGui::Button(preset.name)) {
            Curve chosen = preset.curve;
            chosen.shape = row.value<Curve>().shape;
            row.set(FieldValue::of(chosen));
        }
        ui.widgets.mark(format("{}/{}", row.path, preset.name));
    }
    ImGui::TextDisabled("Drag keys. Double-click adds a key, right-click removes it.");
}

void CurveEdit::endFrame(Ui& ui) {
    if (std::exchange(drawn_, false) || path_.empty()) return;
    path_.clear();
    ui.workspace.undo.endGesture();
}

}  // namespace plumb::editor::ui
