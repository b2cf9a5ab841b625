#include "tests/accuracy/tuning/report.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"

namespace plumb::tuning {

namespace {

using accuracy::escaped;

std::string percent(int part, int all) { return fixedText(100.0 * part / std::max(all, 1), 0); }

std::string textOf(const Move& move) {
    if (move.isMap)
        return format("{} map: {} of {} cells hold, not {}", move.scene, move.reached, move.members,
                      move.base);
    return format(
        "{} {} to {} %{}", move.scene, percent(move.base, move.members), percent(move.reached, move.members),
        move.isChance() ? format(" (chance: {} worse, {} better)", move.worse, move.better) : std::string{});
}

/// Returns a table cell with the large changes of a trial.
std::string cellOf(const Trial& trial) {
    if (!trial.differs()) return "no bit";
    std::string text;
    for (const Move& move : trial.moves)
        if (move.isLarge()) text += format("{}{}", text.empty() ? "" : "; ", textOf(move));
    return text.empty() ? "nothing" : text;
}

const Trial* trialOf(const std::vector<Trial>& trials, const Constant& constant, double factor) {
    const auto found = std::find_if(trials.begin(), trials.end(), [&](const Trial& trial) {
        return trial.constant == &constant && trial.factor == factor;
    });
    return found == trials.end() ? nullptr : &*found;
}

/// Returns a row of the table: the constant, and the effects of halving and doubling it.
std::vector<std::string> cellsOf(const std::vector<Trial>& trials, const Constant& constant) {
    std::vector<std::string> cells{constant.name, shortestText(static_cast<float>(constant.value)),
                                   constant.unit, constant.derivation};
    for (const double factor : {0.5, 2.0}) {
        const Trial* trial = trialOf(trials, constant, factor);
        cells.push_back(trial == nullptr ? "not run" : cellOf(*trial));
    }
    cells.emplace_back(reasonOf(constant.name));
    return cells;
}

constexpr std::string_view kTitles[] = {"constant", "value",     "unit", "meaning and derivation",
                                        "at half",  "at double", "why"};

constexpr std::string_view kWhat =
    "Every chosen constant of the physics (engine/physics/tuning.hpp), and what changes when it is halved "
    "or doubled: families whose share of members that reach their goals changes by more than 2 % "
    "(docs/families.md), and maps of the stability report in which a different number of cells holds "
    "(docs/stability.md). 'Nothing': bodies move differently, but no share changes. 'No bit': nothing "
    "there depends on it; characters, casts and Settings::tolerance are tested by tests/physics. Chance: "
    "where motion is chaotic, as many members of a family get worse as get better.";

}  // namespace

bool needsReason(const std::vector<Trial>& trials, const Constant& constant) {
    return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
        return trial.constant == &constant &&
               std::any_of(trial.moves.begin(), trial.moves.end(), [](const Move& move) {
                   return !move.isMap && move.isLarge() && !move.isChance();
               });
    });
}

std::string textOf(const Trial& trial) {
    return format("{} x {}: {}\n", trial.constant->name, trial.factor, cellOf(trial));
}

std::string csvOf(const std::vector<Trial>& trials) {
    std::string text = "constant,value,factor,scene,map,members,base,reached,worse,better,differs\n";
    for (const Trial& trial : trials) {
        for (const Move& move : trial.moves)
            text += format("{},{},{},{},{},{},{},{},{},{},{}\n", trial.constant->name, trial.constant->value,
                           trial.factor, move.scene, move.isMap ? 1 : 0, move.members, move.base,
                           move.reached, move.worse, move.better, move.differs ? 1 : 0);
    }
    return text;
}

std::string htmlOf(const std::vector<Trial>& trials, const std::string& how) {
    std::string text = format("<p>{}</p><p>{}</p><table><tr>", escaped(kWhat), escaped(how));
    for (const std::string_view title : kTitles) text += format("<th>{}</th>", title);
    text += "</tr>";
    for (const Constant* constant : allConstants()) {
        text += "<tr>";
        for (const std::string& cell : cellsOf(trials, *constant))
            text += format("<td>{}</td>", escaped(cell));
        text += "</tr>";
    }
    return accuracy::tablePage("Constants", text + "</table>");
}

std::string markdownOf(const std::vector<Trial>& trials, const std::string& how) {
    std::string text = format("# Constants\n\n{}\n\nMade by `{}`.\n\n|", kWhat, how);
    for (const std::string_view title : kTitles) text += format(" {} |", title);
    text += "\n|---|---|---|---|---|---|---|\n";
    for (const Constant* constant : allConstants()) {
        text += "|";
        for (const std::string& cell : cellsOf(trials, *constant)) text += format(" {} |", cell);
        text += "\n";
    }
    return text;
}

}  // namespace plumb::tuning
