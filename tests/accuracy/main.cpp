// plumb-accuracy, run by ./plumb accuracy: runs experiments with known results and compares the error and
// time of each method with the goals.

#include <cstdio>
#include <unistd.h>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/command/progress_line.hpp"
#include "tests/accuracy/families/families.hpp"
#include "tests/accuracy/report/chart.hpp"
#include "tests/accuracy/report/guide.hpp"
#include "tests/accuracy/report/options.hpp"
#include "tests/accuracy/report/orders.hpp"
#include "tests/accuracy/report/page.hpp"
#include "tests/accuracy/report/sweep.hpp"
#include "tests/accuracy/report/tables.hpp"
#include "tests/accuracy/stability/stability.hpp"
#include "tests/accuracy/tuning/tuning.hpp"
#include "tests/bench/physics/peers/peers.hpp"
#include "tests/support/allocations.hpp"

namespace {

using namespace plumb;
using namespace plumb::accuracy;

/// Prints the progress: the current run, the number of runs and the estimated remaining time.
class ProgressPrinter {
public:
    explicit ProgressPrinter(bool loud) : loud_{loud} {}

    void show(const Progress& progress) {
        if (!loud_) return;
        const double now = wallSeconds();
        const std::string left = timeLeft(now - start_, progress.part);
        const std::string what = format("{} of {}{}: {}, {}", progress.number, progress.all, left,
                                        progress.experiment->name, progress.method);
        if (isatty(STDERR_FILENO) != 0) {
            std::fprintf(stderr, "\r\033[K%s", what.c_str());
        } else if (now - shown_ > kPause) {
            std::fprintf(stderr, "%s\n", what.c_str());
            shown_ = now;
        }
        std::fflush(stderr);
    }
    void clear() const {
        if (loud_ && isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\r\033[K");
    }

private:
    static constexpr double kPause = 10.0;  // s between two lines if the output is a file
    double start_ = wallSeconds();
    double shown_ = start_;
    bool loud_;
};

void printHeader() {
    std::printf("%-14s %-9s %-27s %9s %12s %-8s %9s   %9s %8s\n", "scene", "figure", "solver", "substeps",
                "error", "unit", "target", "us/step", "target");
}

/// True if a row is printed in the terminal: the default method at each
/// quality, and other engines. The output files contain all rows.
bool isPrinted(const Row& row) {
    return row.method.peer != nullptr || (row.method.iterations == 1 && row.method.jointTrees &&
                                          row.method.integrator == Method{}.integrator);
}

void print(std::span<const Row> rows) {
    for (const Row& row : rows) {
        if (!isPrinted(row)) continue;
        const bool goal = row.target != kNoTarget;
        const std::string substeps = row.method.peer != nullptr ? "its own"
                                     : row.automatic()          ? "auto"
                                                                : format("{}", row.substeps);
        std::printf("%-14s %-9s %-27s %9s %12s %-8s %9s   %9.2f %8s   %s\n", row.scene.c_str(),
                    row.figure.c_str(), peerTitle(row.solver).c_str(), substeps.c_str(),
                    figureText(row.error).c_str(), row.unit.c_str(),
                    goal ? figureText(row.target).c_str() : "-", row.metrics.microsPerStep,
                    row.usTarget > 0.0 ? figureText(row.usTarget).c_str() : "-",
                    !goal        ? ""
                    : !row.met() ? "MISSED"
                    : row.fast() ? "met"
                                 : "met, but slow");
    }
    std::fflush(stdout);
}

void printOrders(const std::vector<Row>& rows) {
    std::printf("\n%-14s %-27s %14s %9s %9s   %s\n", "scene", "method", "order", "expected", "substeps",
                "floor");
    for (const OrderRow& row : ordersOf(rows)) {
        std::printf("%-14s %-27s %14s %9s %9s   %s\n", row.scene.c_str(), row.method.c_str(),
                    powerText(row.order).c_str(), row.expected ? figureText(*row.expected).c_str() : "-",
                    rangeText(row.order).c_str(), floorText(row).c_str());
    }
}

bool writeAll(const Options& options, const std::vector<Row>& rows, double seconds) {
    const std::string how = howItRan(options, rows, seconds);
    bool good = write(options.out / "results.csv", csvOf(rows)) &&
                write(options.out / "results.json", jsonOf(rows)) &&
                write(options.out / "accuracy.html", pageOf(rows, how));
    if (good) std::printf("\nwrote %s\n", (options.out / "accuracy.html").c_str());
    if (!good || options.docs.empty()) return good;
    good = write(options.docs / "accuracy.md", guideOf(rows, how));
    for (const std::string_view scene : guideScenes()) {
        const std::vector<Row> own = rowsOf(rows, scene);
        const std::string svg = svgOf(chartOf(textOf(scene).title, own));
        if (good && !own.empty()) good = write(options.docs / "accuracy" / format("{}.svg", scene), svg);
    }
    if (good) std::printf("wrote %s\n", (options.docs / "accuracy.md").c_str());
    return good;
}

/// Returns the installed other engines.
std::vector<scenes::Engine> comparedPeers() {
    std::vector<scenes::Engine> peers;
    for (const scenes::Engine& engine : scenes::peerEngines()) {
        if (engine.name != "box2d-2.4-unswept")
            peers.push_back(engine);  // a variant without sweeps would only repeat box2d-2.4
    }
    return peers;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string_view> words(argv + 1, argv + argc);
    const auto read = readOptions(words);
    if (!read) {
        std::fprintf(stderr, "%s\n", read.error().text().c_str());
        return 2;
    }
    const Options& options = *read;
    if (options.help || options.list) {
        std::printf("%s", (options.help ? helpText() : sceneList()).c_str());
        return 0;
    }
    if (options.stability) return stability::runStability(options.otherWords);
    if (options.tuning) return tuning::runTuningCommand(options.otherWords, options.out);
    if (options.families) return families::runFamilyCommand(options.otherWords, comparedPeers(), options.out);

    const std::vector<scenes::Engine> peers = options.peers ? comparedPeers() : std::vector<scenes::Engine>{};

    SweepOptions sweepOptions = options.sweep;
    sweepOptions.peers = peers;
    sweepOptions.count = [] { return test::allocations().made; };
    ProgressPrinter printer{true};
    const double start = wallSeconds();
    printHeader();
    const std::vector<Row> rows = sweep(
        sweepOptions, [&](const Progress& progress) { printer.show(progress); },
        [&](std::span<const Row> done) {
            printer.clear();
            print(done);
        });
    printer.clear();
    printOrders(rows);
    return writeAll(options, rows, wallSeconds() - start) ? 0 : 1;
}
