#include "tests/bench/physics/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"

namespace plumb::scenes {

namespace {

constexpr int kMinSize = 100;  // bodies; in smaller worlds the fixed cost of a step dominates
constexpr double kMillimetres = 1e3;

std::string number(double value, int digits) { return value == 0.0 ? "-" : fixedText(value, digits); }

const Measurement& referenceOf(const Measurement& row, std::span<const Measurement> rows) {
    for (const Measurement& other : rows) {
        if (other.threads == row.threads && other.missing.empty() && other.error.holds()) return other;
    }
    return row;
}

void printStages(const Measurement& row) {
    double sum = 0.0;
    for (const Profile::Zone& zone : row.stages) sum += zone.seconds;
    if (sum <= 0.0) return;
    std::printf("   ");
    for (const Profile::Zone& zone : row.stages) {
        const double share = 100.0 * zone.seconds / sum;
        if (share >= 0.5)
            std::printf(" %.*s %.0f %%,", static_cast<int>(zone.name.size()), zone.name.data(), share);
    }
    std::printf(" of %s ms\n", fixedText(sum, sum < 0.1 ? 4 : 2).c_str());
}

/// Prints the sequential time, the time of each thread in the parallel part, and the maximum speedup for more
/// threads by Amdahl's law. Source: G. Amdahl, "Validity of the single processor approach", 1967.
void printThreads(const Measurement& row) {
    double alone = 0.0, shared = 0.0;
    std::vector<double> busy(static_cast<std::size_t>(row.threads));
    for (const Profile::Zone& zone : row.stages) {
        alone += zone.seconds - zone.rounds;
        shared += zone.rounds;
        for (std::size_t i = 0; i < std::min(busy.size(), zone.busy.size()); ++i) busy[i] += zone.busy[i];
    }
    if (shared <= 0.0) return;
    std::printf("    sequential %.3f ms, parallel %.3f ms, threads busy", alone, shared);
    for (const double thread : busy) std::printf(" %.0f %%", 100.0 * thread / shared);
    const double all = alone + std::accumulate(busy.begin(), busy.end(), 0.0);
    std::printf("; maximum speedup for threads");
    for (const int threads : {2, 8, 16})
        std::printf(" %d: %.1f", threads, all / (alone + (all - alone) / threads));
    std::printf("\n");
}

void printRow(const Measurement& row, std::span<const Measurement> rows) {
    std::printf("%-24s %-18s %2d ", row.scene.c_str(), row.engine.c_str(), row.threads);
    if (!row.missing.empty()) return static_cast<void>(std::printf("- (no %s)\n", row.missing.c_str()));
    const int digits = row.msPerStep < 0.1 ? 5 : 3;
    const SceneError& error = row.error;
    const std::string verdict = error.holds() ? ""
                                : row.lostAfter > 0
                                    ? format("  EXPLODED, aborted after {} steps", row.lostAfter)
                                : error.finite ? "  JOINTS BROKE"
                                               : "  EXPLODED";
    std::printf("%9s %9s %9s %7zu %8.0f %8s %8s %8s %8s %6s%s\n", fixedText(row.msPerStep, digits).c_str(),
                fixedText(row.quietMs, digits).c_str(), fixedText(row.medianMs, digits).c_str(), row.bodies,
                row.contacts, number(error.maxPenetration * kMillimetres, 2).c_str(),
                number(error.meanPenetration * kMillimetres, 3).c_str(),
                number(error.maxJointError * kMillimetres, 2).c_str(),
                number(error.meanJointError * kMillimetres, 3).c_str(),
                error.holds() ? fixedText(row.quietMs / referenceOf(row, rows).quietMs, 2).c_str() : "-",
                verdict.c_str());
}

std::string familyOf(const std::string& scene) { return scene.substr(0, scene.rfind('_')); }

bool isScaling(const Measurement& row) {
    const Scene* scene = findScene(row.scene);
    return scene != nullptr && scene->group == SceneGroup::Scaling && row.missing.empty();
}

bool sameLine(const Measurement& a, const Measurement& b) {
    return familyOf(a.scene) == familyOf(b.scene) && a.engine == b.engine && a.threads == b.threads;
}

std::string jsonOf(const Measurement& row) {
    const SceneError& error = row.error;
    std::string stages;
    for (const Profile::Zone& zone : row.stages)
        stages += format("{}\"{}\": {}", stages.empty() ? "" : ", ", zone.name, zone.seconds);
    return format(
        "  {\"scene\": \"{}\", \"engine\": \"{}\", \"threads\": {}, \"size\": {}, \"steps\": {}, "
        "\"missing\": \"{}\", \"msPerStep\": {}, \"quietMs\": {}, \"medianMs\": {}, \"firstMs\": {}, "
        "\"bodies\": {}, \"contacts\": {}, \"lastContacts\": {}, \"maxPenetration\": {}, "
        "\"meanPenetration\": {}, \"overlaps\": {}, \"maxJointError\": {}, \"jointError\": {}, "
        "\"finite\": {}, \"holds\": {}, \"stages\": {{}}}",
        row.scene, row.engine, row.threads, row.size, row.steps, row.missing, row.msPerStep, row.quietMs,
        row.medianMs, row.firstMs, row.bodies, row.contacts, row.lastContacts, error.maxPenetration,
        error.meanPenetration, error.overlaps, error.maxJointError, error.meanJointError, error.finite,
        error.holds(), stages);
}

}  // namespace

void printMeasurementHeader() {
    std::printf("%-24s %-18s %2s %9s %9s %9s %7s %8s %8s %8s %8s %8s %6s\n", "", "", "", "ms/step", "quiet",
                "median", "", "", "overlap", "mean", "joints", "mean", "time");
    std::printf("%-24s %-18s %2s %9s %9s %9s %7s %8s %8s %8s %8s %8s %6s\n", "scene", "engine", "th", "", "",
                "step", "bodies", "contacts", "mm", "mm", "mm", "mm", "ratio");
}

void printMeasurements(std::span<const Measurement> rows) {
    for (const Measurement& row : rows) {
        printRow(row, rows);
        printStages(row);
        printThreads(row);
    }
    std::fflush(stdout);
}

double exponentOf(std::span<const Measurement> rows) {
    double n = 0.0;
    double sumX = 0.0;
    double sumY = 0.0;
    double sumXx = 0.0;
    double sumXy = 0.0;
    for (const Measurement& row : rows) {
        const double x = std::log(static_cast<double>(row.size));
        const double y = std::log(row.quietMs);
        n += 1.0;
        sumX += x;
        sumY += y;
        sumXx += x * x;
        sumXy += x * y;
    }
    return (n * sumXy - sumX * sumY) / (n * sumXx - sumX * sumX);
}

void printExponents(std::span<const Measurement> rows) {
    std::vector<Measurement> done;
    for (const Measurement& first : rows) {
        if (!isScaling(first)) continue;
        if (std::any_of(done.begin(), done.end(), [&](const auto& row) { return sameLine(row, first); }))
            continue;
        done.push_back(first);
        std::vector<Measurement> line;
        for (const Measurement& row : rows) {
            if (isScaling(row) && sameLine(row, first) && row.size >= kMinSize) line.push_back(row);
        }
        if (line.size() < 2) continue;
        std::printf("%s, %s, %d thread(s): cost grows as n^%s from %d to %d bodies\n",
                    familyOf(first.scene).c_str(), first.engine.c_str(), first.threads,
                    fixedText(exponentOf(line), 2).c_str(), line.front().size, line.back().size);
    }
}

bool writeMeasurements(const std::string& path, std::span<const Measurement> rows) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
        text += jsonOf(rows[i]) + (i + 1 < rows.size() ? ",\n" : "\n");
    const auto written = writeFile(path, text + "]\n");
    if (!written) std::fprintf(stderr, "%s\n", written.error().text().c_str());
    return written.ok();
}

}  // namespace plumb::scenes
