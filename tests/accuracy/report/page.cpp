#include "tests/accuracy/report/page.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/report/chart.hpp"
#include "tests/accuracy/report/guide.hpp"
#include "tests/accuracy/report/orders.hpp"
#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

namespace {

constexpr std::string_view kStyle =
    R"(:root{color-scheme:light dark;--back:#f4f6f9;--card:#fff;--ink:#1c2330;--soft:#5c6675;
--line:#dfe4ec;--link:#2463c8;--good:#1d7a4c;--bad:#b3401c}
@media (prefers-color-scheme:dark){:root{--back:#0f1217;--card:#171b22;--ink:#e6eaf1;--soft:#9aa5b5;--line:#2a313c;
--link:#6ea8ff;--good:#7fd3a6;--bad:#f79256}}
*{box-sizing:border-box}body{margin:0;background:var(--back);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Helvetica,Arial,sans-serif}
main{max-width:860px;margin:0 auto;padding:32px 20px 80px}h1{font-size:30px;line-height:1.2;margin:0 0 8px}
h2{font-size:21px;margin:0 0 12px}h3{font-size:18px;margin:0 0 4px}p{margin:8px 0}a{color:var(--link)}
.soft{color:var(--soft)}.card{background:var(--card);border:1px solid var(--line);border-radius:10px;
padding:20px 22px;margin:18px 0;overflow-x:auto}.card svg{width:100%;min-width:600px;height:auto;display:block;margin:10px 0}
nav{columns:4 170px;font-size:14px;line-height:1.75}nav a{text-decoration:none;display:block}
nav a:hover{text-decoration:underline}table{border-collapse:collapse;font-size:14px;width:100%}
th,td{padding:4px 10px 4px 0;text-align:left;border-bottom:1px solid var(--line);vertical-align:top}
th{font-weight:600}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}.wide{overflow-x:auto}
.yes{color:var(--good)}.no{color:var(--bad)}summary{cursor:pointer;color:var(--link);font-size:14px;margin-top:8px}
)";

std::string linkTo(std::string_view scene) {
    const SceneText& text = textOf(scene);
    return format("<a href=\"#{}\">{}</a>", escaped(scene), escaped(text.title.empty() ? scene : text.title));
}

std::string cell(std::string_view content, bool number = false) {
    return format("<td{}>{}</td>", number ? " class=\"n\"" : "", content);
}

std::string verdict(const Row& row) {
    if (!std::isfinite(row.target)) return "";
    if (!row.met()) return "<span class=\"no\">missed</span>";
    return row.fast() ? "<span class=\"yes\">met</span>" : "<span class=\"yes\">met</span>, but slow";
}

std::string substepsText(const Row& row) {
    return row.method.peer != nullptr ? "its own"
           : row.automatic()          ? "automatic"
                                      : format("{}", row.substeps);
}

std::string tableOf(std::span<const Row> rows) {
    std::string html =
        "<details><summary>All figures</summary><div class=\"wide\"><table><tr><th>figure</th><th>solver</th>"
        "<th>integrator</th><th class=\"n\">substeps</th><th class=\"n\">iterations</th>"
        "<th class=\"n\">error</th><th class=\"n\">goal</th><th></th><th class=\"n\">µs a step</th></tr>\n";
    for (const Row& row : rows) {
        const bool goal = std::isfinite(row.target);
        html += "<tr>";
        html +=
            cell(escaped(row.figure.empty() ? "error" : row.figure)) + cell(escaped(peerTitle(row.solver)));
        html += cell(escaped(row.integrator)) + cell(substepsText(row), true);
        html += cell(row.method.peer != nullptr ? "" : format("{}", row.method.iterations), true);
        html += cell(format("{} {}", figureText(row.error), escaped(row.unit)), true);
        html += cell(goal ? format("{} {}", figureText(row.target), escaped(row.unit)) : std::string{}, true);
        html += cell(verdict(row)) + cell(figureText(row.metrics.microsPerStep), true);
        html += "</tr>\n";
    }
    return html + "</table></div></details>\n";
}

std::string orderSentence(const std::vector<OrderRow>& orders, std::string_view scene) {
    std::string html;
    for (const OrderRow& row : orders) {
        if (row.scene != scene || row.order.points < 2) continue;
        html += format("{}{}: {}", html.empty() ? "" : "; ", escaped(row.method), powerText(row.order));
        if (row.expected) html += format(" (expected {})", figureText(*row.expected));
        html += format(", {} substeps", rangeText(row.order));
        if (row.order.floorFrom > 0.0) html += format(", down to {}", floorText(row));
    }
    if (html.empty()) return {};
    return format("<p class=\"soft\">Order, the p of error ~ 1 / substeps<sup>p</sup>. {}.</p>\n", html);
}

std::string sectionOf(const std::vector<Row>& rows, const std::vector<OrderRow>& orders,
                      std::string_view scene) {
    const SceneText& text = textOf(scene);
    const std::vector<Row> own = rowsOf(rows, scene);
    const std::string title{text.title.empty() ? scene : text.title};
    std::string html =
        format("<section class=\"card\" id=\"{}\">\n<h3>{}</h3>\n", escaped(scene), escaped(title));
    html +=
        format("<p class=\"soft\">{} <code>--scene {}</code></p>\n", escaped(text.answer), escaped(scene));
    html += svgOf(chartOf(title, own));
    html += format("<p>{} <strong>{}</strong></p>\n", escaped(text.shows), escaped(text.choose));
    html += orderSentence(orders, scene);
    if (!text.why.empty()) html += format("<p class=\"soft\">{}</p>\n", escaped(text.why));
    return html + tableOf(own) + "</section>\n";
}

std::string choices() {
    std::string html = "<section class=\"card\"><h2>What to choose</h2>\n<ol>\n";
    for (const Advice& advice : allAdvice())
        html += format("<li><strong>{}</strong> {}</li>\n", escaped(advice.lead), escaped(advice.text));
    return html + "</ol></section>\n";
}

std::string marks(const std::vector<Row>& rows) {
    const std::vector<Mark> all = marksOf(rows);
    if (all.empty()) return {};
    std::string html = format(
        "<section class=\"card\"><h2>Goals</h2>\n<p class=\"soft\">{}</p>\n<div "
        "class=\"wide\"><table><tr><th>scene</th><th>goal</th><th>default</th><th>minimum substeps that "
        "reach the goal</th><th>Box2D 2.4.1</th><th>default over Box2D: error / time</th></tr>\n",
        escaped(marksWords()));
    for (const Mark& mark : all) {
        html += "<tr>" + cell(linkTo(mark.scene));
        for (const std::string& words : {mark.goal, mark.own, mark.fewest, mark.peer, mark.ratio})
            html += cell(escaped(words));
        html += "</tr>\n";
    }
    return html + "</table></div></section>\n";
}

std::vector<std::string> scenesIn(const std::vector<Row>& rows) {
    std::vector<std::string> scenes;
    for (const Row& row : rows) {
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
    }
    return scenes;
}

}  // namespace

std::string pageOf(const std::vector<Row>& rows, std::string_view how) {
    const std::vector<OrderRow> orders = ordersOf(rows);
    const std::vector<std::string> scenes = scenesIn(rows);
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Plumb: what accuracy costs</title>\n";
    html += format("<style>{}{}</style>\n</head>\n<body>\n<main>\n", kStyle, chartStyle());
    html += "<h1>What accuracy costs</h1>\n";
    html += format("<p class=\"soft\">{}</p>\n", escaped(how));
    html +=
        "<p>Each plot is one scene whose outcome is known. Further left is faster, further down is more "
        "accurate; both axes are logarithmic. A line is a method; its points are labeled with the "
        "number of substeps. Hollow points have more iterations instead. The yellow band connects the "
        "best choices: no other point is both faster and more accurate. The ring marks the default, "
        "green is the goal, and a dark diamond is another engine with its defaults. A cross misses "
        "another goal of the scene, such as a tower that fell; a triangle at the upper edge is an error "
        "beyond the plot.</p>\n";
    html += choices() + marks(rows) + "<nav>\n";
    for (const std::string& scene : scenes) html += linkTo(scene) + "\n";
    html += "</nav>\n";
    for (const std::string& scene : scenes) html += sectionOf(rows, orders, scene);
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace plumb::accuracy
