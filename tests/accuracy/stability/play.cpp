#include "tests/accuracy/stability/play.hpp"

#include "core/text.hpp"

namespace plumb::stability {

namespace {

struct Place {
    std::size_t map = 0;
    std::size_t cell = 0;
};

std::vector<PlayedMap> chosen(const Choice& choice) {
    std::vector<PlayedMap> maps;
    for (const Map& map : allMaps()) {
        if (!choice.map.empty() && choice.map != map.name) continue;
        PlayedMap& played = maps.emplace_back();
        played.map = &map;
        for (std::size_t row = 0; row < map.rows.values.size(); ++row) {
            if (!choice.quick || (map.quickRows >> row & 1u) != 0) played.rows.push_back(row);
        }
        played.cells.resize(played.rows.size() * played.width());
    }
    return maps;
}

void playCell(PlayedMap& played, std::size_t cell) {
    const Map& map = *played.map;
    const double row = map.rows.values[played.rows[cell / played.width()]];
    played.cells[cell] = map.run(row, map.columns.values[cell % played.width()]);
}

}  // namespace

std::vector<Score> PlayedMap::scoresOf(std::size_t row) const {
    std::vector<Score> scores;
    for (std::size_t column = 0; column < width(); ++column) scores.push_back(scoreOf(at(row, column)));
    return scores;
}

std::string PlayedMap::rowLabel(std::size_t row) const {
    return labelOf(map->rows.label, map->rows.values[rows[row]]);
}

std::string PlayedMap::columnLabel(std::size_t column) const {
    return labelOf(map->columns.label, map->columns.values[column]);
}

std::string PlayedMap::holds(std::size_t row, Score floor) const {
    const std::vector<Score> scores = scoresOf(row);
    const Reach reach = reachOf(scores, map->home, floor);
    if (reach.none()) return "none";
    if (reach.first == 0 && reach.end == scores.size()) return "all";
    const std::string last = columnLabel(reach.end - 1);
    if (reach.first == 0 && map->home == 0) return format("to {}", last);
    return format("{} to {}", columnLabel(reach.first), last);
}

std::vector<PlayedMap> play(const Choice& choice, const accuracy::ShowDone& show) {
    std::vector<PlayedMap> maps = chosen(choice);
    std::vector<Place> places;
    for (std::size_t map = 0; map < maps.size(); ++map) {
        for (std::size_t cell = 0; cell < maps[map].cells.size(); ++cell) places.push_back({map, cell});
    }
    const auto playOne = [&](std::size_t i) { playCell(maps[places[i].map], places[i].cell); };
    accuracy::onThreads(choice.threads, places.size(), playOne, show);
    return maps;
}

}  // namespace plumb::stability
