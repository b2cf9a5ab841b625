#include <cmath>

#include "core/text.hpp"
#include "tests/accuracy/stability/report.hpp"

namespace plumb::stability {

namespace {

constexpr int kCellWide = 66, kCellHigh = 40;  // size of a cell, px
constexpr int kLeft = 96, kTop = 52;           // upper left corner of the cells, px; leaves room for labels
constexpr int kReachWide = 112;                // width of the column "Holds" (range of good scores), px
constexpr int kPad = 8;

std::string text(int x, int y, std::string_view anchor, int size, std::string_view fill,
                 std::string_view words, std::string_view more = "") {
    return format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n", x,
                  y, anchor, size, fill, more, words);
}

std::string opening(int width, int height) {
    return format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" "
        "font-family=\"system-ui, 'DejaVu Sans', sans-serif\">\n<rect width=\"{}\" height=\"{}\" "
        "fill=\"#ffffff\"/>\n",
        width, height, width, height, width, height);
}

/// Returns the text below the sign: the error, or the figure that blew up.
std::string shortReason(const Figures& figures) {
    if (!figures.finite || !std::isfinite(errorOf(figures))) return "numbers";
    if (!(figures.energyGain <= kMaxEnergyGain)) return "energy";
    if (!(figures.speeding <= kMaxSpeeding)) return "speed";
    const double percent = errorOf(figures) * 100.0;
    if (percent < 0.001) return "0 %";
    if (percent > 999.5) return "> 999 %";
    return fixedText(percent, percent < 0.01 ? 3 : percent < 1.0 ? 2 : percent < 10.0 ? 1 : 0) + " %";
}

std::string cellPicture(const PlayedMap& map, std::size_t row, std::size_t column) {
    const Figures& figures = map.at(row, column);
    const ScoreInfo& info = infoOf(scoreOf(figures));
    const int x = kLeft + kCellWide * static_cast<int>(column), y = kTop + kCellHigh * static_cast<int>(row);
    const int middle = x + kCellWide / 2;
    std::string picture = format("<g><title>{}: {}</title>", info.word, reasonOf(figures));
    picture += format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"3\" fill=\"{}\"/>\n", x + 1,
                      y + 1, kCellWide - 2, kCellHigh - 2, info.fill);
    picture +=
        text(middle, y + 19, "middle", 15, info.ink, std::string(1, info.sign), " font-weight=\"700\"");
    picture += text(middle, y + 33, "middle", 10, info.ink, shortReason(figures));
    return picture + "</g>\n";
}

}  // namespace

Counts countsOf(std::span<const PlayedMap> maps) {
    Counts counts{};
    for (const PlayedMap& map : maps) {
        for (const Figures& figures : map.cells) ++counts[static_cast<std::size_t>(scoreOf(figures))];
    }
    return counts;
}

std::string pictureOf(const PlayedMap& map) {
    const int columns = static_cast<int>(map.width()), rows = static_cast<int>(map.rows.size());
    const int right = kLeft + kCellWide * columns;
    std::string picture = opening(right + 2 * kReachWide + kPad, kTop + kCellHigh * rows + kPad);
    picture += text(kLeft, 18, "start", 12, "#52606d", format("{} →", map.map->columns.name));
    picture += text(kLeft - 10, 42, "end", 12, "#52606d", format("{} ↓", map.map->rows.name));
    picture += text(right + 14, 42, "start", 12, "#52606d", "holds");
    picture += text(right + 14 + kReachWide, 42, "start", 12, "#52606d", "within 1 %");
    for (std::size_t column = 0; column < map.width(); ++column) {
        const int x = kLeft + kCellWide * static_cast<int>(column) + kCellWide / 2;
        picture += text(x, 42, "middle", 12, "#1f2933", map.columnLabel(column), " font-weight=\"600\"");
    }
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
        const int y = kTop + kCellHigh * static_cast<int>(row) + 25;
        picture += text(kLeft - 10, y, "end", 13, "#1f2933", map.rowLabel(row), " font-weight=\"600\"");
        for (std::size_t column = 0; column < map.width(); ++column) picture += cellPicture(map, row, column);
        picture += text(right + 14, y, "start", 13, "#1f2933", map.holds(row, Score::Soft));
        picture += text(right + 14 + kReachWide, y, "start", 13, "#1f2933", map.holds(row, Score::Close));
    }
    return picture + "</svg>\n";
}

std::string shareBar(const Counts& counts, int width) {
    constexpr int kHigh = 16;
    std::size_t all = 0;
    for (const std::size_t count : counts) all += count;
    std::string bar = opening(width, kHigh);
    double x = 0.0;
    for (std::size_t i = counts.size(); i-- > 0;) {
        const double share = all > 0 ? static_cast<double>(counts[i] * static_cast<std::size_t>(width)) /
                                           static_cast<double>(all)
                                     : 0.0;
        const ScoreInfo& info = infoOf(static_cast<Score>(i));
        bar += format("<rect x=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"><title>{}: {}</title></rect>\n",
                      fixedText(x, 1), fixedText(share, 1), kHigh, info.fill, info.word, counts[i]);
        x += share;
    }
    return bar + "</svg>\n";
}

std::string legendPicture() {
    constexpr int kSide = 26, kGap = 8, kLetter = 8, kBetween = 22;
    int x = kPad;
    std::string marks;
    for (auto i = static_cast<std::size_t>(Score::Count); i-- > 0;) {
        const ScoreInfo& info = infoOf(static_cast<Score>(i));
        marks += format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"3\" fill=\"{}\"/>\n", x,
                        kPad, kSide, kSide, info.fill);
        marks += text(x + kSide / 2, kPad + 18, "middle", 15, info.ink, std::string(1, info.sign),
                      " font-weight=\"700\"");
        marks += text(x + kSide + kGap, kPad + 18, "start", 13, "#1f2933", info.word);
        x += kSide + kGap + kLetter * static_cast<int>(info.word.size()) + kBetween;
    }
    return opening(x, kSide + 2 * kPad) + marks + "</svg>\n";
}

}  // namespace plumb::stability
