#include "tests/accuracy/report/chart.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/report/chart_scale.hpp"
#include "tests/accuracy/report/order.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kWide = 760.0, kHigh = 430.0;  // size of the diagram, px
constexpr double kLeft = 68.0, kRight = 736.0, kTop = 66.0, kBottom = 372.0;
constexpr double kDecades = 11.0;  // maximum powers of ten on the error axis; larger errors are at its top

/// Line colors on a light background; kStyle defines those on a dark background.
constexpr std::string_view kColours[] = {"#2463c8", "#d8611c", "#12876a", "#8a4fc9", "#a8871a"};

constexpr std::string_view kStyle = R"(.c-back{fill:#fff}.c-ink{fill:#1c2330}.c-soft{fill:#5c6675}
.c-grid{stroke:#e3e7ee}.c-axis{stroke:#aab3c0}.c-front{stroke:#f3cf6b}.c-goal{fill:#d9f0e3}.c-goalink{fill:#1d7a4c}
.c-goalline{stroke:#58a97f}.c-peer{fill:#1c2330}.c-s0{stroke:#2463c8}.c-f0{fill:#2463c8}.c-s1{stroke:#d8611c}
.c-f1{fill:#d8611c}.c-s2{stroke:#12876a}.c-f2{fill:#12876a}.c-s3{stroke:#8a4fc9}.c-f3{fill:#8a4fc9}
.c-s4{stroke:#a8871a}.c-f4{fill:#a8871a}.c-halo{stroke:#fff;stroke-width:3px;paint-order:stroke}
.c-peerline{stroke:#1c2330}
@media (prefers-color-scheme:dark){.c-back{fill:#171b22}.c-ink{fill:#e6eaf1}.c-soft{fill:#9aa5b5}
.c-grid{stroke:#2a313c}.c-axis{stroke:#596577}.c-front{stroke:#6f5c22}.c-goal{fill:#16352a}.c-goalink{fill:#7fd3a6}
.c-goalline{stroke:#3d8562}.c-peer{fill:#e6eaf1}.c-s0{stroke:#6ea8ff}.c-f0{fill:#6ea8ff}.c-s1{stroke:#f79256}
.c-f1{fill:#f79256}.c-s2{stroke:#43c99f}.c-f2{fill:#43c99f}.c-s3{stroke:#c195f5}.c-f3{fill:#c195f5}
.c-s4{stroke:#dcb945}.c-f4{fill:#dcb945}.c-halo{stroke:#171b22}.c-peerline{stroke:#e6eaf1}}
)";

std::string px(double value) { return fixedText(value, 1); }

std::string text(double x, double y, std::string_view content, std::string_view look,
                 std::string_view anchor = "start", int size = 12) {
    const std::string_view fill = startsWith(look, "c-ink")       ? "#1c2330"
                                  : startsWith(look, "c-goalink") ? "#1d7a4c"
                                                                  : "#5c6675";
    return format(
        "<text x=\"{}\" y=\"{}\" class=\"{}\" fill=\"{}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n",
        px(x), px(y), look, fill, anchor, size, escaped(content));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view look, std::string_view colour,
                 double width, std::string_view more = "") {
    return format(
        "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" class=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
        px(x1), px(y1), px(x2), px(y2), look, colour, px(width), more);
}

std::vector<Row> allRows(const Chart& chart) {
    std::vector<Row> rows;
    for (const ChartLine& part : chart.lines) {
        rows.insert(rows.end(), part.rows.begin(), part.rows.end());
        rows.insert(rows.end(), part.extra.begin(), part.extra.end());
    }
    return rows;
}

/// Scales of both axes, and the position of errors of 0, which a logarithmic axis cannot show.
struct Frame {
    LogScale x, y;
    double zero;    ///< value at which errors of 0 are drawn
    bool hasZeros;  ///< true if there are errors of 0

    [[nodiscard]] double px(const Row& row) const { return x.at(row.metrics.microsPerStep); }
    [[nodiscard]] double py(const Row& row) const { return y.at(row.error > 0.0 ? row.error : zero); }
    [[nodiscard]] bool above(const Row& row) const { return !(row.error <= y.high()); }
};

double powerBelow(double value) { return std::pow(10.0, std::floor(std::log10(value))); }
double powerAbove(double value) { return std::pow(10.0, std::ceil(std::log10(value))); }

/// Rounds down to 1, 2 or 5 times a power of ten.
double roundDown(double value) {
    const double power = powerBelow(value);
    return value >= 5.0 * power ? 5.0 * power : value >= 2.0 * power ? 2.0 * power : power;
}
double roundUp(double value) {
    const double power = powerBelow(value);
    return value <= 2.0 * power ? 2.0 * power : value <= 5.0 * power ? 5.0 * power : 10.0 * power;
}

Frame frameOf(const Chart& chart) {
    std::vector<Row> rows = allRows(chart);
    rows.insert(rows.end(), chart.peers.begin(), chart.peers.end());
    double fast = 1.0e9, slow = 1.0e-9, small = 1.0e300, large = 0.0;
    bool zeros = false;
    const auto take = [&](double error) {
        if (error > 0.0 && std::isfinite(error))
            small = std::min(small, error), large = std::max(large, error);
    };
    for (const Row& row : rows) {
        fast = std::min(fast, row.metrics.microsPerStep);
        slow = std::max(slow, row.metrics.microsPerStep);
        take(row.error);
        zeros = zeros || row.error == 0.0;
    }
    take(chart.target);
    if (chart.usTarget > 0.0) slow = std::max(slow, chart.usTarget), fast = std::min(fast, chart.usTarget);
    if (large == 0.0) small = 1.0, large = 10.0;
    const double least = powerBelow(0.7 * small);
    const double high = std::min(powerAbove(1.3 * large), least * std::pow(10.0, kDecades));
    const double low = zeros ? 0.1 * least : least;
    return {LogScale{roundDown(std::max(0.9 * fast, 1.0e-3)), roundUp(std::max(1.1 * slow, 2.0e-3)), kLeft,
                     kRight},
            LogScale{low, high, kBottom, kTop}, low, zeros};
}

std::string grid(const Chart& chart, const Frame& frame) {
    std::string svg;
    for (const LogScale::Tick& tick : frame.x.ticks()) {
        const double x = frame.x.at(tick.value);
        svg += line(x, kTop, x, kBottom, "c-grid", "#e3e7ee", 1.0);
        if (tick.named) svg += text(x, kBottom + 18.0, tickText(tick.value), "c-soft", "middle");
    }
    for (const LogScale::Tick& tick : frame.y.ticks()) {
        const double y = frame.y.at(tick.value);
        svg += line(kLeft, y, kRight, y, "c-grid", "#e3e7ee", 1.0);
        const bool isZero = frame.hasZeros && tick.value < 1.5 * frame.zero;
        if (isZero || tick.named)
            svg +=
                text(kLeft - 8.0, y + 4.0, isZero ? std::string{"0"} : tickText(tick.value), "c-soft", "end");
    }
    svg += line(kLeft, kBottom, kRight, kBottom, "c-axis", "#aab3c0", 1.0);
    svg += text(kRight, kBottom + 38.0, "time of a step (µs), less to the left", "c-soft", "end");
    const std::vector<Row> rows = allRows(chart);
    if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.fails; }) ||
        std::any_of(chart.peers.begin(), chart.peers.end(), [](const Row& row) { return row.fails; }))
        svg += text(kLeft - 8.0, kBottom + 38.0, "crosses miss another goal of the scene", "c-soft");
    svg += text(kLeft - 8.0, kTop - 12.0, format("error ({})", chart.unit), "c-soft", "start");
    return svg;
}

std::string goal(const Chart& chart, const Frame& frame) {
    if (!std::isfinite(chart.target) || chart.target <= 0.0) return {};
    const double y = frame.y.at(chart.target), x = chart.usTarget > 0.0 ? frame.x.at(chart.usTarget) : kRight;
    std::string svg =
        format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"c-goal\" fill=\"#d9f0e3\"/>\n",
               px(kLeft), px(y), px(x - kLeft), px(kBottom - y));
    svg += line(kLeft, y, x, y, "c-goalline", "#58a97f", 1.0, " stroke-dasharray=\"4 3\"");
    if (chart.usTarget > 0.0)
        svg += line(x, y, x, kBottom, "c-goalline", "#58a97f", 1.0, " stroke-dasharray=\"4 3\"");
    const std::string words =
        chart.usTarget > 0.0
            ? format("goal: {} {} in {} µs", figureText(chart.target), chart.unit, figureText(chart.usTarget))
            : format("goal: {} {}", figureText(chart.target), chart.unit);
    return svg + text(kLeft + 8.0, kBottom - 8.0, words, "c-goalink c-halo", "start", 11);
}

std::string front(const Chart& chart, const Frame& frame) {
    std::vector<Row> rows = allRows(chart);
    std::vector<Sample> samples;
    std::erase_if(rows, [&](const Row& row) { return row.fails || frame.above(row); });
    for (const Row& row : rows) samples.push_back({row.metrics.microsPerStep, row.error});
    std::string points;
    const std::vector<std::size_t> best = paretoFront(samples);
    for (const std::size_t i : best) points += format("{},{} ", px(frame.px(rows[i])), px(frame.py(rows[i])));
    if (best.size() < 2) return {};  // a band needs two points
    return format(
        "<polyline points=\"{}\" class=\"c-front\" fill=\"none\" stroke=\"#f3cf6b\" stroke-width=\"9\" "
        "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
        trimmed(points));
}

std::string hint(const Row& row) {
    const std::string how = row.method.peer != nullptr ? peerTitle(row.solver)
                            : row.automatic()          ? format("{}, automatic substeps", row.solver)
                                              : format("{}, {}, {} substeps, {} iterations", row.solver,
                                                       row.integrator, row.substeps, row.method.iterations);
    return format("<title>{}: {} {} in {} µs a step</title>", escaped(how), figureText(row.error),
                  escaped(row.unit), figureText(row.metrics.microsPerStep));
}

std::string dot(const Frame& frame, const Row& row, int colour, double radius, bool hollow) {
    const double x = frame.px(row), y = frame.py(row);
    const std::string_view fill = kColours[colour];
    if (frame.above(row)) {  // outside of the diagram: drawn as an arrow at the edge
        return format("<path d=\"M{} {}l5 8h-10z\" class=\"c-f{}\" fill=\"{}\">{}</path>\n", px(x),
                      px(y - 4.0), colour, fill, hint(row));
    }
    if (row.fails) {
        return format(
            "<path d=\"M{} {}l8 8m0 -8l-8 8\" class=\"c-s{}\" fill=\"none\" stroke=\"{}\" "
            "stroke-width=\"2\">{}</path>\n",
            px(x - 4.0), px(y - 4.0), colour, fill, hint(row));
    }
    if (hollow) {
        return format(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"c-s{}\" fill=\"none\" stroke=\"{}\" "
            "stroke-width=\"1.2\">{}</circle>\n",
            px(x), px(y), px(radius), colour, fill, hint(row));
    }
    return format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"c-f{}\" fill=\"{}\">{}</circle>\n", px(x),
                  px(y), px(radius), colour, fill, hint(row));
}

std::string path(const Frame& frame, const ChartLine& part) {
    std::string points;
    for (const Row& row : part.rows) points += format("{},{} ", px(frame.px(row)), px(frame.py(row)));
    std::string svg = format(
        "<polyline points=\"{}\" class=\"c-s{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" "
        "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
        trimmed(points), part.colour, kColours[part.colour]);
    for (const Row& row : part.extra) svg += dot(frame, row, part.colour, 2.6, true);
    for (const Row& row : part.rows) svg += dot(frame, row, part.colour, 3.8, false);
    return svg;
}

/// Places labels beside points without overlaps: right, left, above or below.
class Labels {
public:
    /// @param wide  distance from the point, px
    std::string beside(double x, double y, std::string_view words, double wide = 9.0) {
        const double length = kLetter * static_cast<double>(words.size());
        for (const auto& [right, lower] : kPlaces) {
            const Box box{right ? x + wide : x - wide - length, y + lower - kLine, length};
            if (box.left < kLeft || box.left + length > kWide || !isFree(box)) continue;
            taken_.push_back(box);
            return text(right ? x + wide : x - wide, y + lower, words, "c-ink c-halo",
                        right ? "start" : "end", 11);
        }
        taken_.push_back({x + wide, y - 7.0 - kLine, length});
        return text(x + wide, y - 7.0, words, "c-ink c-halo", "start", 11);
    }

private:
    struct Box {
        double left, top, wide;  // px; the height is kLine
    };
    struct Place {
        bool right;
        double lower;  // vertical distance from the point to the baseline, px
    };
    static constexpr double kLetter = 6.0, kLine = 11.0;  // letter width and line height of the font, px
    static constexpr Place kPlaces[] = {{true, -7.0},  {false, 15.0}, {true, 15.0}, {false, -7.0},
                                        {true, -19.0}, {false, 27.0}, {true, 27.0}, {false, -19.0}};

    [[nodiscard]] bool isFree(const Box& box) const {
        return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
            return box.left < other.left + other.wide && other.left < box.left + box.wide &&
                   std::fabs(box.top - other.top) < kLine;
        });
    }
    std::vector<Box> taken_;
};

/// Labels each point of a line with its number of substeps. The default's point is first, and has a ring.
std::string numbers(const Frame& frame, const ChartLine& part, Labels& labels) {
    std::string svg;
    for (const bool isDefaults : {true, false}) {
        for (const Row& row : part.rows) {
            if (isDefault(row.method) != isDefaults) continue;
            const double x = frame.px(row), y = frame.py(row);
            if (isDefaults) {
                svg += format(
                    "<circle cx=\"{}\" cy=\"{}\" r=\"8\" class=\"c-s0\" fill=\"none\" stroke=\"#2463c8\" "
                    "stroke-width=\"2\"/>\n",
                    px(x), px(y));
            }
            const std::string count = format("{}", row.substeps);
            svg += labels.beside(x, y, isDefaults ? count + ": default" : count);
        }
    }
    return svg;
}

std::string peerMarks(const Chart& chart, const Frame& frame, Labels& labels) {
    std::string svg;
    for (const Row& row : chart.peers) {
        const double x = frame.px(row), y = frame.py(row);
        svg +=
            row.fails && !frame.above(row)
                ? format(
                      "<path d=\"M{} {}l10 10m0 -10l-10 10\" class=\"c-peerline\" fill=\"none\" "
                      "stroke=\"#1c2330\" stroke-width=\"2.5\">{}</path>\n",
                      px(x - 5.0), px(y - 5.0), hint(row))
                : format("<path d=\"M{} {}l6 6l-6 6l-6 -6z\" class=\"c-peer\" fill=\"#1c2330\">{}</path>\n",
                         px(x), px(y - 6.0), hint(row));
        const std::string words =
            frame.above(row) ? format("{} fails", peerTitle(row.solver)) : peerTitle(row.solver);
        svg += labels.beside(x, y, words, 10.0);
    }
    return svg;
}

std::string legend(const Chart& chart, bool hasFront) {
    double x = kLeft - 8.0;
    std::string svg;
    for (const ChartLine& part : chart.lines) {
        svg += line(x, 33.0, x + 18.0, 33.0, format("c-s{}", part.colour), kColours[part.colour], 3.0);
        svg += text(x + 24.0, 37.0, part.name, "c-soft");
        x += 46.0 + 6.3 * static_cast<double>(part.name.size());
    }
    if (hasFront) {
        svg += line(x, 33.0, x + 18.0, 33.0, "c-front", "#f3cf6b", 8.0, " stroke-linecap=\"round\"");
        svg += text(x + 28.0, 37.0, "best buys", "c-soft");
    }
    return svg;
}

}  // namespace

std::string peerTitle(std::string_view engine) {
    if (engine == "box2d-2.4") return "Box2D 2.4.1";
    if (engine == "chipmunk-7") return "Chipmunk 7";
    return std::string{engine};
}

Chart chartOf(std::string_view title, std::span<const Row> rows) {
    Chart chart{.title = std::string{title}, .unit = {}, .target = kNoTarget};
    const bool smooth = std::any_of(rows.begin(), rows.end(), [](const Row& row) {
        return row.method.integrator != physics::IntegratorKind::SemiImplicitEuler;
    });
    for (const Row& row : rows) {
        if (!row.main) continue;
        chart.unit = row.unit;
        chart.target = row.target;
        chart.usTarget = row.usTarget;
        if (row.method.peer != nullptr) {
            chart.peers.push_back(row);
            continue;
        }
        if (row.automatic()) continue;  // automatic quality uses one of the other qualities per island
        const std::string& name = smooth ? row.integrator : row.solver;
        auto part = std::find_if(chart.lines.begin(), chart.lines.end(),
                                 [&](const ChartLine& known) { return known.name == name; });
        if (part == chart.lines.end()) {
            chart.lines.push_back(
                {name, static_cast<int>(std::min(chart.lines.size(), std::size(kColours) - 1)), {}, {}});
            part = chart.lines.end() - 1;
        }
        (row.method.iterations == 1 ? part->rows : part->extra).push_back(row);
    }
    return chart;
}

std::string svgOf(const Chart& chart) {
    const Frame frame = frameOf(chart);
    std::string svg = format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" "
        "font-family=\"system-ui, -apple-system, Segoe UI, Helvetica, Arial, "
        "sans-serif\">\n<style>{}</style>\n",
        static_cast<int>(kWide), static_cast<int>(kHigh), escaped(chart.title), kStyle);
    svg += format("<rect width=\"{}\" height=\"{}\" class=\"c-back\" fill=\"#ffffff\"/>\n",
                  static_cast<int>(kWide), static_cast<int>(kHigh));
    svg += text(kLeft - 8.0, 18.0, chart.title, "c-ink", "start", 14);
    const std::string band = front(chart, frame);
    svg += legend(chart, !band.empty()) + goal(chart, frame) + grid(chart, frame) + band;
    for (auto part = chart.lines.rbegin(); part != chart.lines.rend(); ++part) svg += path(frame, *part);
    Labels labels;
    if (!chart.lines.empty()) svg += numbers(frame, chart.lines.front(), labels);
    return svg + peerMarks(chart, frame, labels) + "</svg>\n";
}

std::string_view chartStyle() { return kStyle; }

}  // namespace plumb::accuracy
