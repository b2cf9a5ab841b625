#include "tests/accuracy/report/guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "tests/accuracy/report/chart.hpp"
#include "tests/accuracy/report/orders.hpp"

namespace plumb::accuracy {

namespace {

constexpr auto kPlots = std::to_array<std::string_view>(
    {"stack20", "heavy1000", "chain1000", "pendulum", "spring2", "spring10", "orbit", "bullet"});

/// Names of the scenes in the table of goals, in its order.
constexpr auto kMarks =
    std::to_array<std::string_view>({"stack20", "heavy100", "heavy1000", "chain100", "chain1000", "pendulum",
                                     "pyramid465", "bounces", "incline", "freefall"});

constexpr std::string_view kStart = R"(# What accuracy costs

Every simulation has errors. Plumb measures them and the cost of smaller ones, so that you can choose. All figures on this
page come from `./plumb accuracy --docs docs`, which also writes `accuracy.html` with every scene, and tables for
spreadsheets. `./plumb accuracy --quick` takes less than a minute; `--scene NAME` runs one. `./plumb accuracy --web FOLDER` writes a page
for any web server on which each reader moves the slider of the substeps and sees error, time and picture, computed by the engine in the browser.

)";

constexpr auto kAdvice = std::to_array<Advice>({
    {"Leave it at the default",
     "(quality 2: four substeps in each step of 1/60 s) until something looks wrong. It is the "
     "circled point in the plots."},
    {"Something sags, stretches or sinks in?",
     "Raise the quality of that body or joint, not of the whole world: each level doubles the "
     "substeps, makes such errors three to four times smaller and costs that island 1.3 to 2 times "
     "the time."},
    {"Chains, ropes, bridges, pendulums:", "leave direct joints on. They hold any load, even at quality 0."},
    {"Springs and orbits",
     "depend on the integrator. Runge-Kutta 4 is the most accurate if a period has 24 substeps or "
     "more (5 Hz at quality 1, 10 Hz at quality 2). With fewer it loses energy; Verlet conserves it. "
     "Explicit Euler is for teaching."},
    {"More iterations",
     "are rarely worth their time: most of the remaining error is compliance, which only more "
     "substeps reduce. The solver's contacts and joints are stiff, overdamped springs (soft "
     "constraints): the shorter the substep, the stiffer."},
});

constexpr std::string_view kReading = R"(## How to read the plots

Further left is faster, further down is more accurate; both axes are logarithmic. A line is a method; its points are labeled with the number
of substeps, and hollow points have more iterations instead. The yellow band connects the best choices: no other point is both faster and more
accurate. Green is the goal; a dark diamond is another engine with its defaults. A cross is a run that misses another goal of the scene, such
as a tower that fell: its error has no meaning.

)";

std::string cellOf(const Row* row) {
    if (row == nullptr) return "-";
    if (!std::isfinite(row->error)) return "fails";
    return format("{} {} @ {} µs", figureText(row->error), row->unit, figureText(row->metrics.microsPerStep));
}

/// Returns the default solver's result with the fewest substeps that reaches
/// the error goal, whatever its time; nullptr if none does.
const Row* fewestThatMeet(const std::vector<Row>& rows, std::string_view scene) {
    const Row* best = nullptr;
    for (const Row& row : rows) {
        Method method = row.method;
        method.quality = Method{}.quality;
        if (row.scene != scene || !row.main || !row.met() || row.fails || row.automatic() ||
            !isDefault(method))
            continue;
        if (best == nullptr || row.substeps < best->substeps) best = &row;
    }
    return best;
}

std::string howMet(const Row* best) {
    if (best == nullptr) return "none";
    return format("{}: {}{}", best->substeps, cellOf(best), best->fast() ? "" : ", too slow");
}

std::string ratioTo(const Row* own, const Row* peer) {
    if (own == nullptr || peer == nullptr) return "-";
    const std::string time = figureText(own->metrics.microsPerStep / peer->metrics.microsPerStep);
    if (!std::isfinite(peer->error)) return format("it fails / {}", time);
    if (peer->error == 0.0) return format("both 0 / {}", time);
    return format("{} / {}", figureText(own->error / peer->error), time);
}

std::string choicesText() {
    std::string text = "## What to choose\n\n";
    for (std::size_t i = 0; i < kAdvice.size(); ++i)
        text += format("{}. **{}** {}\n", i + 1, kAdvice[i].lead, kAdvice[i].text);
    return text + "\n";
}

std::string marksText(const std::vector<Row>& rows) {
    std::string text = format(
        "## Goals\n\n{}\n\n| scene | goal | default | minimum substeps that reach the goal | Box2D "
        "2.4.1 | default over Box2D: error / time |\n|---|---|---|---|---|---|\n",
        marksWords());
    for (const Mark& mark : marksOf(rows))
        text += format("| {} | {} | {} | {} | {} | {} |\n", mark.title, mark.goal, mark.own, mark.fewest,
                       mark.peer, mark.ratio);
    return text + "\n";
}

std::string plotsOf(const std::vector<Row>& rows) {
    std::string text = "## Representative scenes\n\n";
    for (const std::string_view scene : kPlots) {
        if (defaultRow(rows, scene) == nullptr) continue;
        const SceneText& words = textOf(scene);
        text += format("### {}\n\n{} {} {}\n\n![{}](accuracy/{}.svg)\n\n", words.title, words.answer,
                       words.shows, words.choose, words.title, scene);
    }
    return text;
}

std::string energiesOf(const std::vector<Row>& rows) {
    std::string text =
        "## Integrators alone\n\nA spring for 10 s with one substep of 1/60 s: the largest error of its "
        "energy, in percent.\n\n"
        "| integrator | 0.5 Hz | 2 Hz | 5 Hz | 10 Hz |\n|---|---|---|---|---|\n";
    bool any = false;
    for (int kind = 0; kind < static_cast<int>(physics::IntegratorKind::Count); ++kind) {
        const std::string_view name = integratorName(static_cast<physics::IntegratorKind>(kind));
        std::string line = format("| {} |", name);
        for (const std::string_view scene : {"spring05", "spring2", "spring5", "spring10"}) {
            const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
                return r.scene == scene && r.figure == "energy" && r.integrator == name && r.substeps == 1;
            });
            any = any || row != rows.end();
            line += format(" {} |", row != rows.end() ? figureText(row->error) : std::string{"-"});
        }
        text += line + "\n";
    }
    return any ? text + "\n" : std::string{};
}

std::string orderTable(const std::vector<Row>& rows) {
    std::string text =
        "## How fast errors fall\n\nThe exponent p of error ~ 1 / substeps^p, fitted where the points "
        "are on a line; 2 means that twice the substeps leave\na quarter of the error. The floor is the "
        "error that more substeps do not reduce: mostly rounding of single precision, in\nwhich "
        "everything except positions is stored. Where errors are rounding alone p has no meaning; below "
        "0 more substeps round more often.\n\n| scene | method | p | expected | substeps | floor "
        "|\n|---|---|---|---|---|---|\n";
    std::set<std::string> explained;
    std::string reasons;
    for (const OrderRow& row : ordersOf(rows)) {
        text += format("| {} | {} | {} | {} | {} | {} |\n", row.scene, row.method, powerText(row.order),
                       row.expected ? figureText(*row.expected) : std::string{"-"}, rangeText(row.order),
                       floorText(row));
        if (!row.why.empty() && explained.insert(row.scene).second)
            reasons += format("* **{}**: {}\n", row.scene, row.why);
    }
    return format("{}\nWhere the exponent is not as expected:\n\n{}\n", text, reasons);
}

}  // namespace

std::string howItRan(const Options& options, const std::vector<Row>& rows, double seconds) {
    return format("{} figures of {} scenes in {} min, {}best of {} run{}; steps of 1/60 s, one thread.",
                  rows.size(), chosen(options.sweep).size(), fixedText(seconds / 60.0, 1),
                  options.sweep.quick ? "quick, " : "", options.sweep.runs,
                  options.sweep.runs == 1 ? "" : "s");
}

std::span<const std::string_view> guideScenes() { return kPlots; }

std::span<const Advice> allAdvice() { return kAdvice; }

std::string_view marksWords() {
    return "The error and the time of a step of the whole world. The last column is the default's error and "
           "time over "
           "those of Box2D 2.4.1 in the same run, with its usual 8 velocity and 3 position iterations: below "
           "1 is "
           "better.";
}

std::vector<Mark> marksOf(const std::vector<Row>& rows) {
    std::vector<Mark> marks;
    for (const std::string_view scene : kMarks) {
        const Row* const own = defaultRow(rows, scene);
        if (own == nullptr) continue;
        const Row* const peer = peerRow(rows, scene, "box2d-2.4");
        const std::string within =
            own->usTarget > 0.0 ? format(" @ ≤ {} µs", figureText(own->usTarget)) : std::string{};
        marks.push_back({scene, textOf(scene).title,
                         format("≤ {} {}{}", figureText(own->target), own->unit, within), cellOf(own),
                         howMet(fewestThatMeet(rows, scene)), cellOf(peer), ratioTo(own, peer)});
    }
    return marks;
}

std::string guideOf(const std::vector<Row>& rows, std::string_view how) {
    return format("{}{}{}{}{}{}{}## This run\n\n{}\n", kStart, choicesText(), kReading, marksText(rows),
                  plotsOf(rows), energiesOf(rows), orderTable(rows), how);
}

}  // namespace plumb::accuracy
