#include <array>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "tests/accuracy/stability/report.hpp"

namespace plumb::stability {

namespace {

using Column = std::pair<std::string_view, double Figures::*>;
constexpr std::array<Column, 6> kFigures{{{"penetration", &Figures::penetration},
                                          {"joints", &Figures::joints},
                                          {"off", &Figures::off},
                                          {"residual", &Figures::residual},
                                          {"energyGain", &Figures::energyGain},
                                          {"speeding", &Figures::speeding}}};

/// Formats a number for JSON, which has no infinity and NaN: they become null.
std::string numberOf(double value) { return std::isfinite(value) ? format("{}", value) : "null"; }

std::string jsonCell(const PlayedMap& map, std::size_t row, std::size_t column) {
    const Figures& figures = map.at(row, column);
    std::string text = format("    {\"row\": {}, \"column\": {}, \"score\": \"{}\", \"error\": {}",
                              map.map->rows.values[map.rows[row]], map.map->columns.values[column],
                              infoOf(scoreOf(figures)).word, numberOf(errorOf(figures)));
    for (const auto& [name, member] : kFigures)
        text += format(", \"{}\": {}", name, numberOf(figures.*member));
    return text + format(", \"finite\": {}, \"reason\": \"{}\"}", figures.finite, reasonOf(figures));
}

std::string jsonMap(const PlayedMap& map) {
    std::string text = format(
        "  {\"map\": \"{}\", \"title\": \"{}\", \"scene\": \"{}\", \"rows\": \"{}\", \"columns\": \"{}\", "
        "\"cells\": [\n",
        map.map->name, map.map->title, map.map->scene, map.map->rows.name, map.map->columns.name);
    for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
        text += jsonCell(map, cell / map.width(), cell % map.width());
        text += cell + 1 < map.cells.size() ? ",\n" : "\n";
    }
    return text + "  ]}";
}

}  // namespace

std::string csvOf(std::span<const PlayedMap> maps) {
    std::string text = "map,row_name,row,column_name,column,sign,score,error";
    for (const auto& [name, member] : kFigures) text += format(",{}", name);
    text += ",finite\n";
    for (const PlayedMap& map : maps) {
        for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
            const std::size_t row = cell / map.width(), column = cell % map.width();
            const Figures& figures = map.at(row, column);
            const ScoreInfo& info = infoOf(scoreOf(figures));
            text += format("{},\"{}\",{},\"{}\",{},{},{},{}", map.map->name, map.map->rows.name,
                           map.map->rows.values[map.rows[row]], map.map->columns.name,
                           map.map->columns.values[column], info.sign, info.word, errorOf(figures));
            for (const auto& [name, member] : kFigures) text += format(",{}", figures.*member);
            text += format(",{}\n", figures.finite);
        }
    }
    return text;
}

std::string jsonOf(std::span<const PlayedMap> maps) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < maps.size(); ++i)
        text += jsonMap(maps[i]) + (i + 1 < maps.size() ? ",\n" : "\n");
    return text + "]\n";
}

}  // namespace plumb::stability
