#include "core/text.hpp"
#include "tests/accuracy/stability/report.hpp"

namespace plumb::stability {

namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1f2933; --soft: #52606d; --line: #d9e0e6; --paper: #f4f6f8; --card: #fff;
        --link: #1d5f91; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6eaf1; --soft: #9aa5b5; --line: #2a313c; --paper: #0f1217;
        --card: #171b22; --link: #6ea8ff; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); line-height: 1.5;
       font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 32px 20px 80px; }
h1 { font-size: 28px; margin: 0 0 6px; }
h2 { font-size: 20px; margin: 0 0 4px; }
p { margin: 0 0 12px; max-width: 76ch; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 18px 20px; margin: 0 0 18px;
        overflow-x: auto; }
.card p { color: var(--soft); }
table { border-collapse: collapse; width: 100%; }
td, th { text-align: left; padding: 5px 10px 5px 0; border-bottom: 1px solid var(--line); vertical-align: middle; }
th { color: var(--soft); font-weight: 600; font-size: 13px; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
.sign { display: inline-block; width: 26px; height: 26px; border-radius: 3px; text-align: center; font-weight: 700;
        line-height: 26px; }
.verdict { font-weight: 700; }
svg { display: block; }
svg text[fill="#1f2933"] { fill: var(--ink); } svg text[fill="#52606d"] { fill: var(--soft); }
svg rect[fill="#ffffff"] { fill: var(--card); }
)";

std::string signOf(const ScoreInfo& info) {
    return format("<span class=\"sign\" style=\"background:{};color:{}\">{}</span>", info.fill, info.ink,
                  info.sign);
}

std::string legendCard(const Counts& counts) {
    std::string card =
        "<section class=\"card\"><h2>How to read it</h2>\n<p>Each map runs one scene with all "
        "combinations of two parameters: mostly quality (rows; auto raises the quality of hard islands "
        "automatically, from 2 on) and one that makes the scene harder (columns). A cell shows its "
        "score and its largest error, or what blew up; its tooltip names the error. Errors are ratios: "
        "overlap to the smallest body's thickness, gaps in joints to the length of a link, distance "
        "from the exact position to the size of the scene along gravity (across it: to the smallest "
        "body), final speed to that of a fall by the smallest body's size. <b>Holds</b> is the range in "
        "which a row is soft or better without a gap: what you can rely "
        "on.</p>\n<table><tr><th></th><th>score</th><th>rule</th><th>cells</th></tr>\n";
    for (std::size_t i = counts.size(); i-- > 0;) {
        const ScoreInfo& info = infoOf(static_cast<Score>(i));
        card += format("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n", signOf(info),
                       info.word, info.rule, counts[i]);
    }
    return card + "</table></section>\n";
}

std::string contentsCard(std::span<const PlayedMap> maps) {
    std::string card =
        "<section class=\"card\"><h2>All "
        "maps</h2>\n<table><tr><th>map</th><th>against</th><th>scores</th></tr>\n";
    for (const PlayedMap& map : maps) {
        card += format("<tr><td><a href=\"#{}\">{}</a></td><td>{}</td><td>{}</td></tr>\n", map.map->name,
                       map.map->title, map.map->columns.name, shareBar(countsOf({&map, 1}), 300));
    }
    return card + "</table></section>\n";
}

std::string verdict(const Counts& counts) {
    std::size_t all = 0;
    for (const std::size_t count : counts) all += count;
    const std::size_t bad = counts[static_cast<std::size_t>(Score::BlowsUp)];
    if (bad == 0) return format("<p class=\"verdict\">No cell of {} blows up.</p>\n", all);
    return format("<p class=\"verdict\">{} of {} cells blow up.</p>\n", bad, all);
}

std::string blownCard(std::span<const PlayedMap> maps) {
    std::string rows;
    for (const PlayedMap& map : maps) {
        for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
            if (scoreOf(map.cells[cell]) != Score::BlowsUp) continue;
            rows +=
                format("<tr><td><a href=\"#{}\">{}</a></td><td>{} {}</td><td>{} {}</td><td>{}</td></tr>\n",
                       map.map->name, map.map->title, map.map->rows.name, map.rowLabel(cell / map.width()),
                       map.map->columns.name, map.columnLabel(cell % map.width()), reasonOf(map.cells[cell]));
        }
    }
    if (rows.empty()) return "";
    return format("<section class=\"card\"><h2>What blows up</h2>\n<table>{}</table></section>\n", rows);
}

}  // namespace

std::string pageOf(std::span<const PlayedMap> maps) {
    const Counts counts = countsOf(maps);
    std::string page = format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>Plumb: stability "
        "map</title>\n<style>{}</style></head><body><main>\n",
        kStyle);
    page += "<h1>Stability map</h1>\n<p>Where the physics holds, where it is soft, and where it fails.</p>\n";
    page += verdict(counts) + legendCard(counts) + contentsCard(maps) + blownCard(maps);
    for (const PlayedMap& map : maps) {
        page += format("<section class=\"card\" id=\"{}\"><h2>{}</h2>\n<p>{}</p>\n{}</section>\n",
                       map.map->name, map.map->title, map.map->scene, pictureOf(map));
    }
    return page + "</main></body></html>\n";
}

}  // namespace plumb::stability
