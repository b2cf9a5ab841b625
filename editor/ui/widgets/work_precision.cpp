#include "editor/ui/widgets/work_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/text.hpp"
#include "editor/model/cost/cost_words.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kLeastError = 1.0e-5f;  // m, smaller errors are drawn at the lower edge
constexpr float kDot = 4.5f;            // px at scale 1, radius

/// A logarithmic axis with limits computed from the data.
struct Axis {
    float least = 1.0f;
    float most = 10.0f;

    void take(float value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    /// Adds a margin, and makes the axis span at least a factor of 20, so that similar values look similar.
    void widen() {
        constexpr float kRoom = 1.6f;   // factor of the margin at each end
        constexpr float kSpan = 20.0f;  // minimum ratio of the axis limits
        const float more = std::sqrt(std::max(kSpan * least / most, 1.0f));
        least /= kRoom * more;
        most *= kRoom * more;
    }
    [[nodiscard]] float at(float value) const {
        return std::log(std::clamp(value, least, most) / least) / std::log(most / least);
    }
};

std::string tickWords(float value) {
    const int digits = value < 0.000995f  ? 4
                       : value < 0.00995f ? 3
                       : value < 0.0995f  ? 2
                       : value < 0.995f   ? 1
                                          : 0;
    return fixedText(static_cast<double>(value), digits);
}

/// Returns tick values 1, 2, 5 times powers of ten; on a long axis the powers of ten only.
std::vector<float> ticksOf(const Axis& axis, float unit) {
    const bool many = axis.most / axis.least > 80.0f;
    std::vector<float> ticks;
    for (float power = 1.0e-4f; power < 1.0e6f; power *= 10.0f) {
        for (const float step : {1.0f, 2.0f, 5.0f}) {
            const float value = power * step * unit;
            if ((step == 1.0f || !many) && value > axis.least && value < axis.most) ticks.push_back(value);
        }
    }
    return ticks;
}

float shownError(const WhatIfPoint& point) { return std::max(point.error(), kLeastError); }

bool alike(const WhatIfPoint& a, const WhatIfPoint& b) {
    constexpr float kAlike = 1.2f;  // maximum ratio of values that count as similar
    const auto near = [](float x, float y) { return std::max(x, y) < kAlike * std::min(x, y); };
    return near(a.microseconds, b.microseconds) && near(shownError(a), shownError(b));
}

/// Draw list, rectangle and axes of the plot.
struct Plot {
    Ui& ui;
    const WhatIfResult& result;
    ImDrawList& list;
    ImVec2 from;
    ImVec2 to;
    Axis cost;   // µs
    Axis error;  // m

    [[nodiscard]] ImVec2 place(float microseconds, float metres) const {
        return {from.x + cost.at(microseconds) * (to.x - from.x), to.y - error.at(metres) * (to.y - from.y)};
    }
};

void drawAxes(const Plot& plot) {
    ImDrawList& list = plot.list;
    const float line = ImGui::GetTextLineHeight();
    list.AddRectFilled(plot.from, plot.to, palette::kField, plot.ui.px(3.0f));
    const float seen = kSeenPixels * plot.result.scale.metres;
    if (seen > plot.error.least) {
        const float y = plot.place(plot.cost.least, seen).y;
        list.AddRectFilled({plot.from.x, y}, plot.to, palette::kPast, plot.ui.px(3.0f));
        if (plot.to.y - y > line * 1.3f)
            list.AddText({plot.from.x + plot.ui.px(6.0f), plot.to.y - line - plot.ui.px(3.0f)},
                         palette::kText, "invisible");
    }
    float last = 1.0e9f;
    for (const float metres : ticksOf(plot.error, 1.0e-3f)) {
        const float y = plot.place(plot.cost.least, metres).y;
        list.AddLine({plot.from.x, y}, {plot.to.x, y}, palette::kCellLine);
        if (last - y < line) continue;
        const std::string words = format("{} mm", tickWords(metres * 1000.0f));
        const float width = ImGui::CalcTextSize(words.c_str()).x;
        list.AddText({plot.from.x - width - plot.ui.px(5.0f), y - line * 0.5f}, palette::kTextDim,
                     words.c_str());
        last = y;
    }
    float right = plot.from.x - plot.ui.px(30.0f);
    for (const float microseconds : ticksOf(plot.cost, 1000.0f)) {
        const float x = plot.place(microseconds, plot.error.least).x;
        list.AddLine({x, plot.from.y}, {x, plot.to.y}, palette::kCellLine);
        const std::string words = microseconds < 9.95f ? format("{} µs", tickWords(microseconds))
                                                       : format("{} ms", tickWords(microseconds * 0.001f));
        const float half = ImGui::CalcTextSize(words.c_str()).x * 0.5f;
        if (x - half < right + plot.ui.px(6.0f) || x + half > plot.to.x) continue;
        list.AddText({x - half, plot.to.y + plot.ui.px(3.0f)}, palette::kTextDim, words.c_str());
        right = x + half;
    }
}

/// Draws a point with its label. @return true if it is under the mouse
bool drawPoint(const Plot& plot, const WhatIfPoint& point, bool isPresent, const std::string& label) {
    const ImVec2 at = plot.place(point.microseconds, shownError(point));
    const float radius = plot.ui.px(kDot);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool hovered = std::hypot(mouse.x - at.x, mouse.y - at.y) < radius * 2.0f;
    const ImU32 color = point.kind == WhatIfKind::Automatic ? palette::kViolet : palette::kAccent;
    plot.list.AddCircleFilled(at, hovered ? radius * 1.4f : radius, color);
    if (isPresent) plot.list.AddCircle(at, radius * 2.0f, palette::kText, 0, plot.ui.px(1.5f));
    const ImVec2 size = ImGui::CalcTextSize(label.c_str());
    // The label of automatic quality is placed at the lower left, which is free at a falling curve.
    const bool automatic = point.kind == WhatIfKind::Automatic;
    const bool fits = at.x + radius * 2.4f + size.x < plot.to.x && !automatic;
    const float x = fits ? at.x + radius * 2.4f : at.x - radius * 2.4f - size.x;
    const float y = automatic ? at.y : std::max(at.y - size.y, plot.from.y);
    plot.list.AddText({x, y}, isPresent ? palette::kText : palette::kTextSoft, label.c_str());
    plot.ui.widgets.mark(point.kind == WhatIfKind::Automatic ? std::string{"Cost/curve/automatic"}
                                                             : format("Cost/curve/{}", point.quality),
                         AABB{{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}},
                         isPresent ? "present" : "");
    return hovered;
}

}  // namespace

int drawWorkPrecision(Ui& ui, const WhatIfResult& result, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    ImGui::InvisibleButton("curve", size);
    ui.widgets.mark("Cost/curve");
    const bool pressed = ImGui::IsItemClicked();
    const bool over = ImGui::IsItemHovered();
    std::vector<const WhatIfPoint*> shown;
    for (const WhatIfPoint& point : result.points) {
        if (point.kind == WhatIfKind::Quality || point.kind == WhatIfKind::Automatic) shown.push_back(&point);
    }
    if (shown.empty()) return -1;
    Plot plot{ui,
              result,
              *ImGui::GetWindowDrawList(),
              {corner.x + ui.px(58.0f), corner.y + line + ui.px(4.0f)},
              {corner.x + size.x - ui.px(4.0f), corner.y + size.y - line * 1.0f - ui.px(6.0f)},
              {shown.front()->microseconds, shown.front()->microseconds},
              {shownError(*shown.front()), shownError(*shown.front())}};
    for (const WhatIfPoint* point : shown) {
        plot.cost.take(std::max(point->microseconds, 0.1f));
        plot.error.take(shownError(*point));
    }
    plot.cost.widen(), plot.error.widen();
    plot.list.AddText(corner, palette::kTextDim, "largest error over the physics time of a tick");
    drawAxes(plot);
    std::vector<ImVec2> curve;
    for (const WhatIfPoint* point : shown) {
        if (point->kind == WhatIfKind::Quality)
            curve.push_back(plot.place(point->microseconds, shownError(*point)));
    }
    polyline(plot.list, curve.data(), static_cast<int>(curve.size()), palette::kAccent, false, ui.px(1.5f));
    int clicked = -1;
    const WhatIfPoint* present = result.present();
    for (const WhatIfPoint* point : shown) {
        const bool isPresent = point == present;
        const bool automatic = point->kind == WhatIfKind::Automatic;
        // Automatic quality is omitted where it coincides with the quality it starts from.
        const WhatIfPoint* plain = result.find(WhatIfKind::Quality, point->quality);
        if (automatic && !isPresent && plain != nullptr && alike(*point, *plain)) continue;
        const std::string name = automatic ? std::string{"auto"} : format("{}", point->quality);
        const bool hovered = drawPoint(plot, *point, isPresent, isPresent ? name + " now" : name);
        if (!hovered || !over) continue;
        tooltip(format("{}{}: {} per tick, largest error {}, momentary peak {}",
                       automatic ? "Automatic, from quality " : "Quality ", point->quality,
                       costWords(point->microseconds), lengthWords(point->error(), result.scale),
                       lengthWords(point->peak, result.scale)));
        if (pressed && !automatic) clicked = point->quality;
    }
    return clicked;
}

}  // namespace plumb::editor::ui
