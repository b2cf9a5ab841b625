#include "core/text.hpp"
#include "tests/accuracy/stability/report.hpp"

namespace plumb::stability {

namespace {

constexpr std::string_view kOpening = R"(# Where the physics holds

Made by `./plumb accuracy --stability --docs docs`, including every figure on this page. Each map runs one scene
with all combinations of two parameters: mostly [quality](../engine/physics/README.md) (rows; *auto* raises the
quality of hard islands automatically, from 2 on) and one that makes the scene harder (columns). A cell shows a
letter, a color and its largest error.

Errors are ratios: overlap to the smallest body's thickness, joint gaps to the length of a link, distance from the
exact position to the size of the scene along gravity (across it: to the smallest body), final speed to that of a
fall by the smallest body's size. Energy is kinetic plus potential energy above the lowest reachable position, its
maximum compared with the start; with motors or presses it is not evaluated, but no speed may exceed twice
the maximum expected speed. **Holds** is the range in which a row is soft or better without a gap: what you can rely on.

`--quick` runs quality 2 and automatic only; so does the test suite, in which no cell may get worse.

)";

std::string scoreTable(const Counts& counts) {
    std::string table =
        "![E exact, 1 within 1 %, S soft, W wrong but bounded, X blows up](stability/legend.svg)\n\n";
    table += "| sign | score | rule | cells |\n|---|---|---|---|\n";
    for (std::size_t i = counts.size(); i-- > 0;) {
        const ScoreInfo& info = infoOf(static_cast<Score>(i));
        table += format("| {} | {} | {} | {} |\n", info.sign, info.word, info.rule, counts[i]);
    }
    return table + "\n";
}

/// Lists the columns of a row whose cells have a given score.
std::string cellsOf(const PlayedMap& map, std::size_t row, Score score) {
    std::string cells;
    for (std::size_t column = 0; column < map.width(); ++column) {
        if (scoreOf(map.at(row, column)) != score) continue;
        if (!cells.empty()) cells += ", ";
        cells += map.columnLabel(column);
        if (score == Score::BlowsUp) cells += format(" ({})", reasonOf(map.at(row, column)));
    }
    return cells;
}

std::string badCells(std::span<const PlayedMap> maps) {
    std::string table =
        "## Bad cells\n\nAll cells that are wrong or blow up, by row.\n\n| map | row | wrong but "
        "bounded at | blows up at |\n|---|---|---|---|\n";
    for (const PlayedMap& map : maps) {
        for (std::size_t row = 0; row < map.rows.size(); ++row) {
            const std::string wrong = cellsOf(map, row, Score::Wrong),
                              blown = cellsOf(map, row, Score::BlowsUp);
            if (wrong.empty() && blown.empty()) continue;
            table += format("| {} | {} {} | {} | {} |\n", map.map->title, map.map->rows.name,
                            map.rowLabel(row), wrong, blown);
        }
    }
    return table;
}

std::string keptText(const PlayedMap& map) {
    std::string text = format("Holds ({}), by {}:", map.map->columns.name, map.map->rows.name);
    for (std::size_t row = 0; row < map.rows.size(); ++row)
        text += format("{} {}: {}", row > 0 ? ";" : "", map.rowLabel(row), map.holds(row, Score::Soft));
    return text + ".\n\n";
}

}  // namespace

std::string markdownOf(std::span<const PlayedMap> maps, std::string_view pictures) {
    std::string text{kOpening};
    text += scoreTable(countsOf(maps));
    for (const PlayedMap& map : maps) {
        text += format("## {}\n\n{}\n\n![{}, {} against {}]({}/{}.svg)\n\n", map.map->title, map.map->scene,
                       map.map->title, map.map->rows.name, map.map->columns.name, pictures, map.map->name);
        text += keptText(map);
    }
    return text + badCells(maps);
}

}  // namespace plumb::stability
