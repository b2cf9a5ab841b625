#include "tests/accuracy/families/report.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"

namespace plumb::families {

namespace {

using accuracy::escaped;

std::string percent(int part, int all) {
    return all == 0 ? "-" : format("{} %", fixedText(100.0 * part / all, part == all || part == 0 ? 0 : 1));
}

std::string numberText(double value) {
    if (value == 0.0) return "0";
    return fixedText(value, value >= 100.0 ? 0 : value >= 1.0 ? 2 : value >= 0.001 ? 4 : 7);
}

bool comparesShares(Rule rule) { return rule == Rule::SameOutcome || rule == Rule::NotFewer; }

/// Returns the table cell with the result of a relation in a family.
std::string cellOf(const Verdict& verdict) {
    if (comparesShares(verdict.relation->rule)) {
        std::string text = format("{} to {}", percent(verdict.baseReached, verdict.members),
                                  percent(verdict.variedReached, verdict.members));
        if (verdict.differing > 0) text += format(", {} elsewhere", verdict.differing);
        return text;
    }
    if (verdict.relation->rule == Rule::Bound)
        return format("{}{}", numberText(verdict.largest),
                      verdict.differing > 0 ? format(", {} above", verdict.differing) : std::string{});
    return verdict.differing > 0 ? format("{} differ", verdict.differing) : "same";
}

std::string engineText(const EngineShare& share) {
    if (share.members == 0) return format("{}: lacks {}", share.engine, share.missing);
    return format("{}: {} of {}, {} us a step, overlap {} m, joints {} m", share.engine,
                  percent(share.reached, share.members), share.members, numberText(share.micros),
                  numberText(share.maxOverlap), numberText(share.maxJointError));
}

}  // namespace

std::string textOf(const FamilyResult& result) {
    std::string text = format("{}\n", result.family->name);
    for (const EngineShare& share : result.engines) text += format("    {}\n", engineText(share));
    if (!result.missedSeeds.empty()) {
        text += "    missed by seeds";
        for (const std::uint64_t seed : result.missedSeeds) text += format(" {}", seed);
        text += format(" ({})\n", result.firstMiss);
    }
    for (const Verdict& verdict : result.verdicts) {
        const std::string name{verdict.relation->name};
        text += format("    {}{}{} {}{}\n", verdict.holds() ? "      " : "FAILS ", name,
                       std::string(20 - std::min<std::size_t>(name.size(), 19), ' '), cellOf(verdict),
                       verdict.holds() ? std::string{} : format(" (seed {})", verdict.seed));
    }
    return text;
}

std::string csvOf(const std::vector<FamilyResult>& results) {
    std::string text =
        "family,relation,holds,members,base_reached,varied_reached,worse,better,differing,largest,seed\n";
    for (const FamilyResult& result : results) {
        for (const Verdict& verdict : result.verdicts)
            text +=
                format("{},{},{},{},{},{},{},{},{},{},{}\n", result.family->name, verdict.relation->name,
                       verdict.holds() ? 1 : 0, verdict.members, verdict.baseReached, verdict.variedReached,
                       verdict.worse, verdict.better, verdict.differing, verdict.largest, verdict.seed);
    }
    text += "\nfamily,engine,members,reached,us_per_step,max_overlap_m,max_joint_error_m\n";
    for (const FamilyResult& result : results) {
        for (const EngineShare& share : result.engines)
            text += format("{},{},{},{},{},{},{}\n", result.family->name, share.engine, share.members,
                           share.reached, share.micros, share.maxOverlap, share.maxJointError);
    }
    return text;
}

std::string htmlOf(const std::vector<FamilyResult>& results, const std::string& how) {
    std::string text = format("<p>{}</p><table><tr><th>family</th><th>engines</th></tr>", escaped(how));
    for (const FamilyResult& result : results) {
        text += format("<tr><td><b>{}</b><br>{}</td><td>", result.family->name, escaped(result.family->what));
        for (const EngineShare& share : result.engines) text += format("{}<br>", escaped(engineText(share)));
        text += "</td></tr>";
    }
    text += "</table><table><tr><th>relation</th>";
    for (const FamilyResult& result : results) text += format("<th>{}</th>", result.family->name);
    text += "</tr>";
    const std::size_t rows = results.empty() ? 0 : results[0].verdicts.size();
    for (std::size_t row = 0; row < rows; ++row) {
        const Relation& relation = *results[0].verdicts[row].relation;
        text += format("<tr><th title=\"{}\">{}</th>", escaped(relation.bound), relation.name);
        for (const FamilyResult& result : results) {
            const Verdict& verdict = result.verdicts[row];
            text += format("<td class=\"{}\" title=\"seed {}\">{}</td>", verdict.holds() ? "good" : "bad",
                           verdict.seed, escaped(cellOf(verdict)));
        }
        text += "</tr>";
    }
    return accuracy::tablePage("Families and relations", text + "</table>");
}

std::string markdownOf(const std::vector<FamilyResult>& results, const std::string& how) {
    std::string text =
        "# Families and relations\n\nRandom scenes of the kinds that games contain, and relations that "
        "must hold in all of them even where the exact result is unknown. A cell in bold does not "
        "hold.\n\n";
    text += format("Made by `{}`.\n\n## Families\n\n| family | parameters and goals |\n|---|---|\n", how);
    for (const FamilyResult& result : results)
        text += format("| {} | {} |\n", result.family->name, result.family->what);
    text +=
        "\n## Engines, at their defaults\n\n| family | engine | members that reach their goals | us a step | "
        "largest overlap, m | widest joint, m |\n|---|---|---|---|---|---|\n";
    for (const FamilyResult& result : results) {
        for (const EngineShare& share : result.engines) {
            if (share.members == 0) {
                text += format("| {} | {} | lacks {} | | | |\n", result.family->name, share.engine,
                               share.missing);
                continue;
            }
            text += format("| {} | {} | {} of {} | {} | {} | {} |\n", result.family->name, share.engine,
                           percent(share.reached, share.members), share.members, numberText(share.micros),
                           numberText(share.maxOverlap), numberText(share.maxJointError));
        }
    }
    text += "\n## Relations\n\n| relation | property | bound |\n|---|---|---|\n";
    const std::size_t rows = results.empty() ? 0 : results[0].verdicts.size();
    for (std::size_t row = 0; row < rows; ++row) {
        const Relation& relation = *results[0].verdicts[row].relation;
        text += format("| {} | {} | {} |\n", relation.name, relation.what, relation.bound);
    }
    text += "\n## Results\n\n| family |";
    for (std::size_t row = 0; row < rows; ++row)
        text += format(" {} |", results[0].verdicts[row].relation->name);
    text += "\n|---|";
    for (std::size_t row = 0; row < rows; ++row) text += "---|";
    text += "\n";
    for (const FamilyResult& result : results) {
        text += format("| {} |", result.family->name);
        for (const Verdict& verdict : result.verdicts) {
            const std::string cell = cellOf(verdict);
            text +=
                verdict.holds() ? format(" {} |", cell) : format(" **{}** (seed {}) |", cell, verdict.seed);
        }
        text += "\n";
    }
    return text;
}

}  // namespace plumb::families
