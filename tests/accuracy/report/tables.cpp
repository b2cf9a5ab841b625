#include "tests/accuracy/report/tables.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kMillimetres = 1000.0;

/// A cell: the name of its column, and its value as text or number.
struct Cell {
    std::string_view name;
    std::string words;
    std::optional<double> number;  ///< the value if `isNumber`
    bool isNumber = false;
};

Cell words(std::string_view name, std::string value) { return {name, std::move(value), std::nullopt, false}; }

Cell number(std::string_view name, std::optional<double> value) { return {name, {}, value, true}; }

std::optional<double> unlessNone(double value) {
    return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::array<Cell, 18> cellsOf(const Row& row) {
    return {words("scene", row.scene),
            words("figure", row.figure),
            words("solver", row.solver),
            words("integrator", row.integrator),
            number("substeps", row.substeps > 0 ? std::optional<double>{row.substeps} : std::nullopt),
            number("iterations",
                   row.method.peer == nullptr ? std::optional<double>{row.method.iterations} : std::nullopt),
            number("error", row.error),
            words("unit", row.unit),
            number("usPerStep", row.metrics.microsPerStep),
            number("target", unlessNone(row.target)),
            number("usTarget", row.usTarget > 0.0 ? std::optional{row.usTarget} : std::nullopt),
            words("met", !std::isfinite(row.target) ? ""
                         : row.met()                ? "yes"
                                                    : "no"),
            number("maxPenetrationMm", row.metrics.maxPenetration * kMillimetres),
            number("meanPenetrationMm", row.metrics.meanPenetration * kMillimetres),
            number("jointSeparationMm", row.metrics.jointSeparation * kMillimetres),
            number("restTimeS", row.metrics.restTime),
            number("allocationsPerStep", row.metrics.allocationsPerStep),
            words("default", isDefault(row.method) ? "yes" : "no")};
}

std::string quotedForCsv(const std::string& value) {
    if (value.find_first_of(",\"\n") == std::string::npos) return value;
    std::string result = "\"";
    for (const char c : value) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + "\"";
}

}  // namespace

std::string csvOf(std::span<const Row> rows) {
    std::string text;
    for (const Cell& cell : cellsOf(Row{})) text += format("{}{}", text.empty() ? "" : ",", cell.name);
    text += '\n';
    for (const Row& row : rows) {
        std::string line;
        bool first = true;
        for (const Cell& cell : cellsOf(row)) {
            if (!first) line += ',';
            first = false;
            if (!cell.isNumber) {
                line += quotedForCsv(cell.words);
            } else if (cell.number) {
                line += std::isfinite(*cell.number) ? shortestText(*cell.number) : "inf";
            }
        }
        text += line + '\n';
    }
    return text;
}

std::string jsonOf(std::span<const Row> rows) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::string object;
        for (const Cell& cell : cellsOf(rows[i])) {
            const bool finite = cell.number && std::isfinite(*cell.number);
            object += format("{}\"{}\": {}", object.empty() ? "" : ", ", cell.name,
                             !cell.isNumber ? quotedForJson(cell.words)
                             : finite       ? shortestText(*cell.number)
                                            : std::string{"null"});
        }
        text += format("  {{}}{}\n", object, i + 1 < rows.size() ? "," : "");
    }
    return text + "]\n";
}

}  // namespace plumb::accuracy
