#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/trial.hpp"

namespace plumb::accuracy {

/// Result of one figure (measured error) of a scene with one method; a line of results.csv.
struct Row {
    std::string scene;
    std::string figure;  ///< name of the figure; empty if the scene has only one
    bool main = false;   ///< true for the first figure of a scene, which is plotted
    Method method;
    std::string solver;      ///< description of the solver, or name of another engine
    std::string integrator;  ///< name of the integrator
    int substeps = 0;        ///< substeps per step; 0: automatic, or another engine
    double error = 0.0;      ///< infinite if the simulation diverged
    std::string unit;        ///< unit of the error
    double target = 0.0;     ///< goal of the error; infinite: none
    double usTarget = 0.0;   ///< goal of the time of a step, µs; 0: none
    Metrics metrics;
    bool fails = false;  ///< true if another figure of the same run misses its goal

    [[nodiscard]] bool automatic() const {  ///< true for automatic quality
        return method.peer == nullptr && method.quality == physics::kQualityOfWorld;
    }
    [[nodiscard]] bool met() const { return error <= target; }  ///< reaches the error goal
    [[nodiscard]] bool fast() const { return usTarget <= 0.0 || metrics.microsPerStep <= usTarget; }
};

/// True for the default settings.
inline bool isDefault(const Method& method) { return method == Method{}; }

std::string_view integratorName(physics::IntegratorKind kind);
/// Returns a description of the solver.
/// @param joints  true if the scene has joints; otherwise Method::jointTrees is not mentioned
std::string solverName(const Method& method, bool joints);

/// Returns those rows that belong to a scene, in the same order.
std::vector<Row> rowsOf(const std::vector<Row>& rows, std::string_view scene);
/// Returns the result of a scene's main figure with default settings; nullptr if that was not measured.
const Row* defaultRow(const std::vector<Row>& rows, std::string_view scene);
/// Returns the result of a scene's main figure with another engine; nullptr if that was not measured.
const Row* peerRow(const std::vector<Row>& rows, std::string_view scene, std::string_view engine);

/// Formats a number with three significant digits, or as 1.2e-07 if that is shorter.
std::string figureText(double value);

}  // namespace plumb::accuracy
