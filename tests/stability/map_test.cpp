#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/text.hpp"
#include "tests/accuracy/stability/play.hpp"
#include "tests/accuracy/stability/report.hpp"
#include "tests/accuracy/stability/stability.hpp"
#include "tests/support/places.hpp"

namespace plumb::stability {
namespace {

const std::vector<PlayedMap>& quickMaps() {
    static const std::vector<PlayedMap> maps = play({.quick = true, .threads = 1});
    return maps;
}

/// Minimum scores of the cells of a row of a map, as the signs of ScoreInfo::sign (score.hpp).
struct Floor {
    std::string map;
    std::string row;
    std::string signs;
};

/// Returns a label without its unit, as in floors.txt.
std::string wordOf(const std::string& label) { return label.substr(0, label.find(' ')); }

std::vector<Floor> readFloors() {
    std::vector<Floor> floors;
    std::ifstream file{test::sourceFolder() / "tests/stability/floors.txt"};
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words{line};
        Floor& floor = floors.emplace_back();
        words >> floor.map >> floor.row >> floor.signs;
    }
    return floors;
}

const Floor* findFloor(const std::vector<Floor>& floors, std::string_view map, const std::string& row) {
    for (const Floor& floor : floors) {
        if (floor.map == map && floor.row == wordOf(row)) return &floor;
    }
    return nullptr;
}

/// Returns invented results of a map with two rows and three columns.
PlayedMap madeUp() {
    static constexpr std::array<double, 3> kRows{0, 2, -1}, kColumns{1, 1e3, 1e6};
    static const Map map{.name = "made_up",
                         .title = "Made up",
                         .scene = "No scene is built.",
                         .rows = {"quality", Label::Quality, kRows},
                         .columns = {"load", Label::Plain, kColumns}};
    PlayedMap played{&map, {1, 2}, {}};
    played.cells = {{}, {.off = 0.005}, {.energyGain = 0.5}, {}, {.joints = 0.05}, {.penetration = 0.5}};
    return played;
}

std::size_t countOf(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(StabilityMap, noCellIsWorseThanItsFloor) {
    const std::vector<Floor> floors = readFloors();
    std::size_t rows = 0;
    for (const PlayedMap& map : quickMaps()) {
        for (std::size_t row = 0; row < map.rows.size(); ++row, ++rows) {
            const Floor* floor = findFloor(floors, map.map->name, map.rowLabel(row));
            ASSERT_NE(floor, nullptr) << map.map->name << " " << map.rowLabel(row) << " is not in floors.txt";
            ASSERT_EQ(floor->signs.size(), map.width()) << map.map->name;
            for (std::size_t column = 0; column < map.width(); ++column) {
                EXPECT_GE(scoreOf(map.at(row, column)), scoreOf(floor->signs[column]))
                    << map.map->name << ", " << map.rowLabel(row) << ", " << map.columnLabel(column) << ": "
                    << reasonOf(map.at(row, column));
            }
        }
    }
    EXPECT_EQ(rows, floors.size()) << "floors.txt contains a row that does not exist";
}

// Runs all 1,140 cells of all maps, not only the quick rows. Allows wrong results, but no blow-ups.
TEST(StabilityMap, noCellBlowsUp) {
    std::size_t cells = 0;
    for (const PlayedMap& map : play({.threads = 2})) {
        for (std::size_t row = 0; row < map.rows.size(); ++row) {
            for (std::size_t column = 0; column < map.width(); ++column, ++cells) {
                EXPECT_NE(scoreOf(map.at(row, column)), Score::BlowsUp)
                    << map.map->name << ", " << map.rowLabel(row) << ", " << map.columnLabel(column) << ": "
                    << reasonOf(map.at(row, column));
            }
        }
    }
    EXPECT_GT(cells, 1000u);
}

TEST(StabilityMap, mapsHaveUniqueNamesAndAnEasiestColumn) {
    std::set<std::string_view> names;
    for (const Map& map : allMaps()) {
        EXPECT_TRUE(names.insert(map.name).second) << map.name;
        EXPECT_LT(map.home, map.columns.values.size()) << map.name;
        EXPECT_TRUE(std::is_sorted(map.columns.values.begin(), map.columns.values.end()) ||
                    std::is_sorted(map.columns.values.rbegin(), map.columns.values.rend()))
            << map.name;
        EXPECT_NE(map.quickRows, 0u) << map.name << " is not in the quick part";
        EXPECT_EQ(map.quickRows >> map.rows.values.size(), 0u) << map.name;
    }
}

TEST(StabilityMap, resultsDoNotDependOnTheNumberOfThreads) {
    const auto one = play({.quick = true, .map = "stack_step", .threads = 1});
    const auto three = play({.quick = true, .map = "stack_step", .threads = 3});
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].cells, three[0].cells);
}

TEST(StabilityMap, progressCountsUpToAllCells) {
    std::size_t calls = 0, last = 0, of = 0;
    const auto maps =
        play({.quick = true, .map = "far", .threads = 2}, [&](std::size_t done, std::size_t all) {
            ++calls;
            last = done, of = all;
        });
    EXPECT_EQ(calls, maps[0].cells.size());
    EXPECT_EQ(last, of);
    EXPECT_EQ(of, maps[0].cells.size());
}

TEST(StabilityReport, givesTheRangeInWhichARowHolds) {
    const PlayedMap map = madeUp();
    EXPECT_EQ(map.holds(0, Score::Soft), "to 1000");
    EXPECT_EQ(map.holds(0, Score::Exact), "to 1");
    EXPECT_EQ(map.holds(1, Score::Wrong), "all");
    EXPECT_EQ(map.rowLabel(0), "2");
    EXPECT_EQ(map.rowLabel(1), "auto");
    EXPECT_EQ(map.columnLabel(2), "10⁶");
}

TEST(StabilityReport, labelsContainTheirUnits) {
    EXPECT_EQ(labelOf(Label::Step, 1.0 / 240.0), "1/240 s");
    EXPECT_EQ(labelOf(Label::Times, 0.1), "×0.1");
    EXPECT_EQ(labelOf(Label::Percent, 0.05), "5 %");
    EXPECT_EQ(labelOf(Label::Plain, 1.0e4), "10⁴");
    EXPECT_EQ(labelOf(Label::Quality, -1.0), "auto");
}

TEST(StabilityReport, everyFormatContainsEveryCell) {
    const std::vector<PlayedMap> maps{madeUp()};
    EXPECT_EQ(countOf(csvOf(maps), "\n"), 7u);
    EXPECT_EQ(countOf(csvOf(maps), "made_up,"), 6u);
    EXPECT_EQ(countOf(jsonOf(maps), "\"score\""), 6u);
    const std::string picture = pictureOf(maps[0]);
    EXPECT_EQ(countOf(picture, "<title>"), 6u);
    EXPECT_EQ(countOf(picture, ">E</text>"), 2u);
    EXPECT_EQ(countOf(picture, ">X</text>"), 1u);
    EXPECT_NE(picture.find("energy grew by 50 %"), std::string::npos);
    EXPECT_EQ(countsOf(maps), (Counts{1, 1, 1, 1, 2}));
}

TEST(StabilityReport, thePageIsSelfContained) {
    const std::string page = pageOf({{madeUp()}});
    EXPECT_EQ(countOf(page, "http"), countOf(page, "http://www.w3.org/2000/svg"));
    EXPECT_EQ(countOf(page, "src="), 0u);
    EXPECT_EQ(countOf(page, "<svg"), countOf(page, "</svg>"));
    EXPECT_NE(page.find("1 of 6 cells blow up"), std::string::npos);
}

TEST(StabilityReport, badCellsAreListed) {
    const std::string text = markdownOf({{madeUp()}}, "stability");
    EXPECT_NE(text.find("| Made up | quality 2 |  | 10⁶ (energy grew by 50 %) |"), std::string::npos) << text;
    EXPECT_NE(text.find("| Made up | quality auto | 10⁶ |  |"), std::string::npos) << text;
    EXPECT_NE(text.find("(stability/made_up.svg)"), std::string::npos);
}

TEST(StabilityCommand, writesItsFilesAndRejectsInvalidArguments) {
    const std::string out = (std::filesystem::temp_directory_path() / "plumb_stability_test").string();
    std::filesystem::remove_all(out);
    const std::vector<std::string_view> words{"--quick", "--map", "chain", "--out", out, "--docs", out};
    EXPECT_EQ(runStability(words), 0);
    for (const char* name : {"stability.csv", "stability.json", "stability.html", "stability.md",
                             "stability/chain.svg", "stability/legend.svg"})
        EXPECT_TRUE(std::filesystem::exists(Path{out} / name)) << name;
    std::filesystem::remove_all(out);
    for (const std::vector<std::string_view>& bad :
         std::vector<std::vector<std::string_view>>{{"--mpa", "chain"},
                                                    {"--map", "chains"},
                                                    {"--map"},
                                                    {"--random", "0"},
                                                    {"--random", "many"},
                                                    {"--threads", "-1"},
                                                    {"chain"}})
        EXPECT_EQ(runStability(bad), 2) << bad[0];
}

}  // namespace
}  // namespace plumb::stability
