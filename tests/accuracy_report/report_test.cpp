#include <algorithm>
#include <cctype>
#include <set>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "tests/accuracy/report/chart.hpp"
#include "tests/accuracy/report/guide.hpp"
#include "tests/accuracy/report/options.hpp"
#include "tests/accuracy/report/orders.hpp"
#include "tests/accuracy/report/page.hpp"
#include "tests/accuracy/report/scene_texts.hpp"
#include "tests/accuracy/report/sweep.hpp"
#include "tests/accuracy/report/tables.hpp"

namespace plumb::accuracy {
namespace {

/// True if all XML elements are closed in the correct order, and every & and < is part of an entity or tag.
bool isWellFormed(std::string_view xml) {
    static constexpr std::string_view kVoid[] = {"meta", "!DOCTYPE"};
    std::vector<std::string> open;
    for (std::size_t i = 0; i < xml.size(); ++i) {
        if (xml[i] == '&') {
            const std::size_t end = xml.find(';', i);
            if (end == std::string_view::npos || end - i > 6 || end - i < 3) return false;
        }
        if (xml[i] != '<') continue;
        const std::size_t end = xml.find('>', i);
        if (end == std::string_view::npos) return false;
        const std::string_view tag = xml.substr(i + 1, end - i - 1);
        const bool closes = startsWith(tag, "/");
        const std::string name{tag.substr(closes ? 1 : 0, tag.find_first_of(" >/", 1) - (closes ? 1 : 0))};
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0 || tag.find('<') != std::string_view::npos)
            return false;
        if (closes) {
            if (open.empty() || open.back() != name) return false;
            open.pop_back();
        } else if (!endsWith(tag, "/") &&
                   std::find(std::begin(kVoid), std::end(kVoid), name) == std::end(kVoid)) {
            open.push_back(name);
        }
        i = end;
    }
    return open.empty();
}

/// Splits a line of CSV into cells.
std::vector<std::string> cellsIn(std::string_view line) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += line[++i];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += line[i];
        }
    }
    return cells;
}

/// Checks that a text is a single JSON value of objects, arrays, strings, numbers and null.
class JsonReader {
public:
    explicit JsonReader(std::string_view text) : rest_{text} {}
    bool all() { return value() && (skip(), rest_.empty()); }

private:
    void skip() {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0)
            rest_.remove_prefix(1);
    }
    bool eat(std::string_view word) {
        skip();
        if (!startsWith(rest_, word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    bool string() {
        if (!eat("\"")) return false;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            if (rest_[i] == '\\') {
                ++i;
            } else if (rest_[i] == '"') {
                rest_.remove_prefix(i + 1);
                return true;
            }
        }
        return false;
    }
    bool list(std::string_view end, bool named) {
        if (eat(end)) return true;
        do {
            if (named && !(string() && eat(":"))) return false;
            if (!value()) return false;
        } while (eat(","));
        return eat(end);
    }
    bool value() {
        if (eat("[")) return list("]", false);
        if (eat("{")) return list("}", true);
        if (eat("null")) return true;
        skip();
        if (startsWith(rest_, "\"")) return string();
        const std::size_t size = std::min(rest_.find_first_of(",]} \n"), rest_.size());
        const bool number = size > 0 && rest_.find_first_not_of("+-.0123456789eE") >= size;
        rest_.remove_prefix(number ? size : 0);
        return number;
    }
    std::string_view rest_;
};

Row rowOf(std::string scene, int quality, double error, double micros) {
    Row row{.scene = std::move(scene),
            .main = true,
            .method = {.quality = static_cast<physics::Quality>(quality)},
            .solver = "soft step",
            .integrator = "semi-implicit Euler",
            .substeps = 1 << quality,
            .error = error,
            .unit = "mm",
            .target = 1.0};
    row.metrics.microsPerStep = micros;
    return row;
}

/// Rows that include special characters of HTML, CSV and JSON, and a diverged simulation.
std::vector<Row> nastyRows() {
    std::vector<Row> rows;
    for (int quality = 0; quality <= 6; ++quality)
        rows.push_back(rowOf("stack20", quality, 8.0 / (1 << 2 * quality), 3.0 * (1 + quality)));
    rows.push_back(rowOf("a <b> & \"c\", 'd'\\", 2, INFINITY, 1.0));
    rows.back().figure = "x < y & \"z\"";
    rows.push_back(rowOf("a <b> & \"c\", 'd'\\", 3, 0.0, 2.0));
    return rows;
}

TEST(Report, csvHasALinePerRowAndACellPerColumn) {
    const std::vector<Row> rows = nastyRows();
    const std::string csv = csvOf(rows);
    std::vector<std::string_view> lines = split(csv, '\n');
    ASSERT_EQ(lines.size(), rows.size() + 2);  // plus header and the empty text after the last line break
    EXPECT_EQ(lines.back(), "");
    const std::vector<std::string> names = cellsIn(lines[0]);
    EXPECT_EQ(names[0], "scene");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::vector<std::string> cells = cellsIn(lines[i + 1]);
        ASSERT_EQ(cells.size(), names.size()) << lines[i + 1];
        EXPECT_EQ(cells[0], rows[i].scene);
        EXPECT_EQ(cells[1], rows[i].figure);
    }
    EXPECT_EQ(cellsIn(lines[1])[static_cast<std::size_t>(std::find(names.begin(), names.end(), "error") -
                                                         names.begin())],
              "8");
}

TEST(Report, jsonIsValidAndNonFiniteNumbersAreNull) {
    const std::string json = jsonOf(nastyRows());
    EXPECT_TRUE(JsonReader{json}.all()) << json;
    for (const std::string_view name :
         {"scene", "solver", "integrator", "substeps", "iterations", "error", "unit", "usPerStep"})
        EXPECT_NE(json.find(format("\"{}\": ", name)), std::string::npos) << name;
    EXPECT_NE(json.find("\"error\": null"), std::string::npos);
    EXPECT_EQ(json.find("inf"), std::string::npos);
    EXPECT_FALSE(JsonReader{"[{\"a\": 1,}]"}.all());  // checks that JsonReader rejects invalid JSON
    EXPECT_FALSE(JsonReader{"[1, inf]"}.all());
}

TEST(Report, thePageIsWellFormedEscapedAndSelfContained) {
    const std::string page = pageOf(nastyRows(), "now & then");
    EXPECT_TRUE(isWellFormed(page));
    EXPECT_NE(page.find("a &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_EQ(page.find("<b>"), std::string::npos);
    EXPECT_NE(page.find("now &amp; then"), std::string::npos);
    for (const std::string_view foreign : {"<link", "<script", "src=", "@import", "url("})
        EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
    EXPECT_FALSE(isWellFormed("<p>a<b></p>"));
    EXPECT_FALSE(isWellFormed("<p>a & b</p>"));
}

TEST(Report, aPlotShowsEveryPointTheDefaultTheGoalAndTheFront) {
    const std::vector<Row> rows = rowsOf(nastyRows(), "stack20");
    const std::string svg = svgOf(chartOf("Stack", rows));
    EXPECT_TRUE(isWellFormed(svg));
    std::size_t points = 0;
    for (std::size_t at = svg.find("r=\"3.8\""); at != std::string::npos; at = svg.find("r=\"3.8\"", at + 1))
        ++points;
    EXPECT_EQ(points, rows.size());
    EXPECT_NE(svg.find("4: default"), std::string::npos);
    EXPECT_NE(svg.find("goal: 1 mm"), std::string::npos);
    EXPECT_NE(svg.find("c-front\""), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

// The error of a stack is its overlap; that of a fallen tower is 0, so the run would seem the best choice.
TEST(Report, aRunThatMissesAnotherGoalIsACrossAndNotABestBuy) {
    std::vector<Row> rows = rowsOf(nastyRows(), "stack20");
    const std::string whole = svgOf(chartOf("Stack", rows));
    EXPECT_EQ(whole.find("crosses miss"), std::string::npos);
    const auto bandOf = [](const std::string& svg) {
        const std::size_t end = svg.find("class=\"c-front\" fill=\"none\"");
        return end == std::string::npos ? std::string{} : svg.substr(svg.rfind("points=", end), end);
    };
    rows.front().fails = true;
    const std::string svg = svgOf(chartOf("Stack", rows));
    EXPECT_TRUE(isWellFormed(svg));
    EXPECT_NE(svg.find("crosses miss another goal"), std::string::npos);
    EXPECT_NE(svg.find("l8 8m0 -8l-8 8"), std::string::npos);
    EXPECT_NE(bandOf(svg), bandOf(whole)) << "the band of best choices must not contain the failed run";
    for (Row& row : rows) row.fails = true;
    EXPECT_EQ(svgOf(chartOf("Stack", rows)).find("best buys"), std::string::npos);
}

TEST(Report, labelsOfPointsAtEqualPositionsDoNotOverlap) {
    std::vector<Row> rows;
    for (int quality = 0; quality <= 3; ++quality) rows.push_back(rowOf("stack20", quality, 1.0, 5.0));
    const std::string svg = svgOf(chartOf("Stack", rows));
    std::set<std::string> places;
    for (const std::string_view words : {">1<", ">2<", ">4: default<", ">8<"}) {
        const std::size_t end = svg.find(words);
        ASSERT_NE(end, std::string::npos) << words;
        const std::size_t begin = svg.rfind("<text", end);
        places.insert(svg.substr(begin, svg.find(" class", begin) - begin));
    }
    EXPECT_EQ(places.size(), 4u);
}

TEST(Report, theListOfScenesContainsExactlyTheScenes) {
    const std::string_view words[] = {"--list"};
    const auto options = readOptions(words);
    ASSERT_TRUE(options.ok());
    EXPECT_TRUE(options->list);
    EXPECT_FALSE(options->help);
    const std::string list = sceneList();
    EXPECT_EQ(static_cast<std::size_t>(std::count(list.begin(), list.end(), '\n')), allExperiments().size());
    EXPECT_TRUE(list.find("stack20 ") != std::string::npos);
}

TEST(Report, aPlotOfFailedRunsOnlyIsValid) {
    std::vector<Row> rows{rowOf("x", 0, INFINITY, 1.0), rowOf("x", 1, INFINITY, 2.0)};
    const std::string svg = svgOf(chartOf("x", rows));
    EXPECT_TRUE(isWellFormed(svg));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Report, ordersAreComputedFromTheRows) {
    const std::vector<OrderRow> orders = ordersOf(nastyRows());
    ASSERT_EQ(orders.size(), 2u);
    EXPECT_EQ(orders[0].scene, "stack20");
    EXPECT_NEAR(orders[0].order.power, 2.0, 1e-9);
    EXPECT_EQ(orders[1].order.points, 0);
}

TEST(Report, theGuideContainsTheGoalsAndTheOrders) {
    const std::string guide = guideOf(nastyRows(), "here");
    EXPECT_NE(guide.find("0.5 mm @ 9 µs"), std::string::npos) << guide;  // result of the default
    EXPECT_NE(guide.find("| 4: 0.5 mm @ 9 µs |"), std::string::npos);    // fewest substeps within 1 mm
    EXPECT_NE(guide.find("| stack20 | soft step | 2.00 | 2 | 1 to 64 | not met |"), std::string::npos);
}

TEST(SceneTexts, everySceneHasATextAndEveryNumberAScene) {
    std::set<int> numbers;
    for (const std::span<const SceneText> texts : {exactTexts(), hardTexts()}) {
        for (const SceneText& text : texts) {
            EXPECT_NE(findExperiment(text.name), nullptr) << text.name;
            numbers.insert(text.number);
        }
    }
    for (const Experiment& experiment : allExperiments()) {
        const SceneText& text = textOf(experiment.name);
        EXPECT_FALSE(text.title.empty() || text.answer.empty() || text.shows.empty() || text.choose.empty())
            << experiment.name;
    }
    for (int number = 1; number <= 24; ++number) EXPECT_EQ(numbers.count(number), 1u) << number;
}

TEST(Figures, areShortAndKeepThreeDigits) {
    EXPECT_EQ(figureText(0.0), "0");
    EXPECT_EQ(figureText(1.0), "1");
    EXPECT_EQ(figureText(0.050), "0.05");
    EXPECT_EQ(figureText(12.345), "12.3");
    EXPECT_EQ(figureText(1234.6), "1235");
    EXPECT_EQ(figureText(1.2e-7), "1.2e-07");
    EXPECT_EQ(figureText(INFINITY), "fails");
}

SweepOptions quickly() {
    SweepOptions options;
    options.quick = true;
    options.runs = 1;
    return options;
}

TEST(Sweep, methodsDependOnTheTraitsOfTheScene) {
    const auto hasTrees = [](const Method& method) { return method.jointTrees; };
    const std::vector<Method> joints = methodsOf(*findExperiment("chain100"), {});
    EXPECT_FALSE(std::all_of(joints.begin(), joints.end(), hasTrees));
    const std::vector<Method> boxes = methodsOf(*findExperiment("stack20"), {});
    EXPECT_TRUE(std::all_of(boxes.begin(), boxes.end(), hasTrees));
    const std::vector<Method> spring = methodsOf(*findExperiment("spring2"), {});
    EXPECT_EQ(spring.size(), 4u * 7u);
    for (const auto& methods : {joints, boxes, spring}) {
        EXPECT_EQ(std::count_if(methods.begin(), methods.end(), isDefault), 1);
    }
}

TEST(Sweep, returnsARowPerFigureAndOneMainRow) {
    SweepOptions options = quickly();
    options.scene = "freefall";
    std::size_t reported = 0;
    const std::vector<Row> rows = sweep(
        options,
        [&](const Progress& progress) {
            ++reported;
            EXPECT_EQ(progress.number, reported);
            EXPECT_LT(progress.part, 1.0);
        },
        [](std::span<const Row>) {});
    EXPECT_EQ(reported, methodsOf(*findExperiment("freefall"), options).size());
    ASSERT_EQ(rows.size(), reported);
    for (const Row& row : rows) {
        EXPECT_TRUE(row.main);
        EXPECT_TRUE(row.met()) << row.error;
        EXPECT_GT(row.metrics.microsPerStep, 0.0);
    }
    EXPECT_NE(defaultRow(rows, "freefall"), nullptr);
}

Result<Options> read(std::vector<std::string_view> words) { return readOptions(words); }

TEST(Options, areParsedAndErrorsListTheAllowedValues) {
    const auto good = read({"--quick", "--scene", "bullet", "--out", "x"});
    ASSERT_TRUE(good.ok());
    EXPECT_TRUE(good->sweep.quick);
    EXPECT_EQ(good->sweep.scene, "bullet");
    EXPECT_EQ(good->out, "x");
    const auto word = read({"--quik"});
    ASSERT_FALSE(word.ok());
    EXPECT_NE(word.error().text().find("--quick"), std::string::npos);
    const auto scene = read({"--scene", "bulet"});
    ASSERT_FALSE(scene.ok());
    EXPECT_NE(scene.error().text().find("did you mean 'bullet'"), std::string::npos);
    EXPECT_NE(scene.error().text().find("stack20"), std::string::npos);
    EXPECT_FALSE(read({"--out"}).ok());
    EXPECT_FALSE(read({"--quality", "7"}).ok());
    EXPECT_FALSE(read({"--runs", "0"}).ok());
}

TEST(Options, passRemainingArgumentsToTheStabilityMap) {
    const auto options = read({"--stability", "--cells", "7"});
    ASSERT_TRUE(options.ok());
    EXPECT_TRUE(options->stability);
    EXPECT_EQ(options->otherWords, (std::vector<std::string_view>{"--cells", "7"}));
}

}  // namespace
}  // namespace plumb::accuracy
