#include "scene/drawing/plot_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "math/logarithm.hpp"
#include "math/portable.hpp"
#include "scene/components/bodies/ghost.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/name.hpp"
#include "scene/drawing/label_drawing.hpp"
#include "scene/lab.hpp"

namespace plumb {

namespace {

constexpr float kPlotTextSize = 14.0f;  // px
constexpr float kLine = 18.0f;          // px, line height
constexpr float kPlotGap = 10.0f;       // px, margin
constexpr float kScaleRoom = 64.0f;     // px left of the curves, for the labels of the scale
constexpr float kMostLegend = 150.0f;   // px, maximum width of the legend: fits "velocity Verlet"
constexpr float kTicksPerSecond = 60.0f;

/// Range of the vertical axis: values, or exponents of ten on a logarithmic scale.
struct Span {
    float low = 0.0f;
    float high = 1.0f;

    [[nodiscard]] float partOf(float value) const {
        return std::clamp((value - low) / (high - low), 0.0f, 1.0f);
    }
};

float shownOf(const Plot& plot, float value) {
    if (!plot.powers) return value;
    return std::isfinite(value) ? logarithm10(value) : 38.0f;
}

/// Returns the range of the plot; if it defines none, one that fits the curves.
Span spanOf(const Plot& plot, const PlotPast& past, EntityId entity) {
    if (plot.max > plot.min) return {plot.min, plot.max};
    Span span{plot.powers ? 1.0f : 1e30f, plot.powers ? -1.0f : -1e30f};
    for (const PlotPast::Curve& curve : past.curves) {
        if (curve.plot != entity) continue;
        for (const float value : curve.values) {
            if (!std::isfinite(value)) continue;
            span.low = std::min(span.low, shownOf(plot, value));
            span.high = std::max(span.high, shownOf(plot, value));
        }
    }
    if (span.low > span.high) return {};
    const float least = std::max(1e-3f, 1e-3f * std::fabs(span.high));
    const float room = std::max((span.high - span.low) * 0.1f, least);
    return {span.low - room, span.high + room};
}

struct Legend {
    std::string_view name;
    Color color;
};

/// Adds a plot to a draw list.
class PlotPicture {
public:
    PlotPicture(const World& world, const Plot& plot, Vec2 corner, LabelDrawing& labels, DrawList& list)
        : world_{world}, plot_{plot}, corner_{corner}, labels_{labels}, list_{list} {}

    void draw(EntityId entity, const PlotPast& past) {
        const Vec2 size{plot_.width, plot_.height};
        list_.filledRect({corner_, corner_ + size}, plot_.background, plot_.layer);
        write(world_.texts().find(plot_.text), {kPlotGap, kPlotGap * 0.6f}, plot_.color, TextAlign::Left);
        curves_ = {corner_ + Vec2{kPlotGap + kScaleRoom, kPlotGap + kLine * 1.4f},
                   corner_ + size - Vec2{kPlotGap + legendWidth(), kPlotGap}};
        const Span span = spanOf(plot_, past, entity);
        drawScale(span);
        int row = 0;
        for (const PlotPast::Curve& curve : past.curves) {
            if (curve.plot != entity || world_.has<Hidden>(curve.source)) continue;
            const Legend legend = legendOf(curve);
            drawCurve(curve, span, legend.color);
            drawLegend(curve, legend, row++);
        }
    }

private:
    [[nodiscard]] float legendWidth() const { return std::min(plot_.width * 0.34f, kMostLegend); }

    void write(std::string_view text, Vec2 at, Color color, TextAlign align) {
        TextStyle style;
        style.shape.size = kPlotTextSize;
        style.shape.align = align;
        style.color = color;
        style.layer = plot_.layer;
        labels_.write(text, corner_ + at, style, list_);
    }

    [[nodiscard]] Legend legendOf(const PlotPast::Curve& curve) const {
        const auto* ghost = world_.find<Ghost>(curve.source);
        if (ghost == nullptr) return {world_.texts().find(plot_.name), plot_.color};
        const auto* name = world_.find<Name>(curve.source);
        return {name != nullptr ? world_.texts().find(name->text) : "ghost", ghost->color};
    }

    void drawScale(const Span& span) {
        Color faint = plot_.color;
        faint.a = 60;
        const ShapeStyle line{faint, 1.0f, plot_.layer};
        const float way = span.high - span.low;
        // A logarithmic scale has lines at whole exponents only.
        const float step = plot_.powers ? std::max(1.0f, std::ceil(way / 6.0f)) : way / 4.0f;
        const float first = plot_.powers ? std::ceil(span.low) : span.low;
        for (float value = first; value <= span.high + way * 0.01f; value += step) {
            const float y = curves_.max.y - span.partOf(value) * (curves_.max.y - curves_.min.y);
            list_.line({curves_.min.x, y}, {curves_.max.x, y}, line);
            const float shown = plot_.powers ? exponential(value * 2.302585093f) : value;
            write(roughNumber(shown),
                  Vec2{curves_.min.x - kPlotGap * 0.6f, y - kPlotTextSize * 0.62f} - corner_, plot_.color,
                  TextAlign::Right);
        }
    }

    void drawCurve(const PlotPast::Curve& curve, const Span& span, Color color) {
        const ShapeStyle line{color, 2.0f, plot_.layer};
        const float perTick =
            (curves_.max.x - curves_.min.x) / (std::max(plot_.seconds, 1.0f) * kTicksPerSecond);
        Vec2 before{};
        for (std::size_t i = 0; i < curve.values.size(); ++i) {
            const float part = span.partOf(shownOf(plot_, curve.values[i]));
            const Vec2 here{curves_.min.x + perTick * static_cast<float>(i),
                            curves_.max.y - part * (curves_.max.y - curves_.min.y)};
            if (i > 0) list_.line(before, here, line);
            before = here;
        }
    }

    void drawLegend(const PlotPast::Curve& curve, const Legend& legend, int row) {
        const float x = curves_.max.x - corner_.x + kPlotGap;
        const float y = curves_.min.y - corner_.y + kLine * 2.0f * static_cast<float>(row);
        write(legend.name, {x, y}, legend.color, TextAlign::Left);
        const std::string value = curve.same             ? "bit-identical"
                                  : curve.values.empty() ? std::string{}
                                                         : roughNumber(curve.values.back());
        write(value, {x + kPlotGap, y + kLine * 0.9f}, legend.color, TextAlign::Left);
    }

    const World& world_;
    const Plot& plot_;
    Vec2 corner_;
    LabelDrawing& labels_;
    DrawList& list_;
    AABB curves_;  // px, area of the curves
};

}  // namespace

std::string roughNumber(float value) {
    const float size = std::fabs(value);
    if (size == 0.0f) return "0";
    if (!std::isfinite(value)) return value > 0.0f ? "infinite" : "not a number";
    const int exponent = static_cast<int>(std::floor(logarithm10(size) + 1e-4f));
    const bool plain = exponent >= -3 && exponent < 6;
    const float digits = plain ? value : value / exponential(static_cast<float>(exponent) * 2.302585093f);
    std::string text = fixedText(static_cast<double>(digits), plain ? std::clamp(2 - exponent, 0, 5) : 1);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return plain ? text : format("{}e{}", text, exponent);
}

void drawPlot(const World& world, EntityId entity, const Plot& plot, Vec2 corner, LabelDrawing& labels,
              DrawList& list) {
    const PlotPast nothing;
    const auto* past = world.findResource<PlotPast>();
    PlotPicture{world, plot, corner, labels, list}.draw(entity, past != nullptr ? *past : nothing);
}

}  // namespace plumb
