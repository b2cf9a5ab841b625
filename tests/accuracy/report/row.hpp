#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/trial.hpp"

namespace plumb::accuracy {

/// One figure of one scene with one method: a line of results.csv.
struct Row {
    std::string scene;
    std::string figure;  ///< empty if the scene has one figure
    bool main = false;   ///< the first figure of its scene: the plotted one
    Method method;
    std::string solver;      ///< in plain words; for another engine its name
    std::string integrator;  ///< in plain words
    int substeps = 0;        ///< 0: adaptive, or as another engine has it
    double error = 0.0;      ///< infinite if the scene fell apart
    std::string unit;
    double target = 0.0;    ///< infinite if there is none
    double usTarget = 0.0;  ///< µs per step; 0 if there is none
    Metrics metrics;
    bool fails = false;  ///< another figure of the same run misses its goal

    [[nodiscard]] bool automatic() const {
        return method.peer == nullptr && method.quality == physics::kQualityOfWorld;
    }
    [[nodiscard]] bool met() const { return error <= target; }
    [[nodiscard]] bool fast() const { return usTarget <= 0.0 || metrics.microsPerStep <= usTarget; }
};

/// Whether a row uses the default settings.
inline bool isDefault(const Method& method) { return method == Method{}; }

std::string_view integratorName(physics::IntegratorKind kind);
/// @param joints whether the scene has any: without joints trees make no difference
std::string solverName(const Method& method, bool joints);

/// The rows of a scene, in order.
std::vector<Row> rowsOf(const std::vector<Row>& rows, std::string_view scene);
/// The row of a scene's main figure with the default method; nullptr if it was not run.
const Row* defaultRow(const std::vector<Row>& rows, std::string_view scene);
/// The main figure of a scene with another engine.
const Row* peerRow(const std::vector<Row>& rows, std::string_view scene, std::string_view engine);

/// For readers: three significant digits, 1.2e-07 if that is shorter.
std::string figureText(double value);

}  // namespace plumb::accuracy
