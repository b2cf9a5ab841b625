#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/accuracy/stability/score.hpp"

namespace plumb::stability {

/// Format of the labels of an axis: number, quality or "auto", time step, multiple, percentage.
enum class Label : std::uint8_t { Plain, Quality, Step, Times, Percent };

/// The values along one axis of a map.
struct Axis {
    std::string_view name;  ///< name with unit
    Label label = Label::Plain;
    std::span<const double> values;
};

std::string labelOf(Label label, double value);  ///< formats an axis label

/// A grid of cells: one scene simulated with all combinations of two parameters.
struct Map {
    std::string_view name;  ///< identifier in files and tables
    std::string_view title;
    std::string_view scene;  ///< description: scene, duration and exact result
    Axis rows;
    Axis columns;
    std::size_t home = 0;  ///< index of the easiest column; the range that a row supports includes it
    Figures (*run)(double row, double column) = nullptr;  ///< simulates a cell, given the axes' values
    std::uint32_t quickRows = 0;  ///< bit set of the rows used by --quick and the tests
};

/// All maps, in the order of the report.
std::span<const Map> allMaps();

// Map::run functions for scenes with bodies at rest: resting_cells.cpp.
Figures heavyOnTop(double quality, double ratio);
Figures heavyOnStack(double count, double ratio);
Figures stackOf(double quality, double count);
Figures stackAtStep(double quality, double step);
Figures tallAtStep(double step, double count);
Figures stackInGravity(double quality, double times);
Figures sizesAtDensity(double quality, double size);
Figures sizesAtMass(double quality, double size);
Figures stackAtScale(double quality, double size);
Figures stackFarAway(double quality, double distance);
Figures thinPlates(double quality, double thickness);
Figures slivers(double quality, double thickness);

// Map::run functions for scenes with hanging bodies: hanging_cells.cpp.
Figures chainOf(double quality, double count);
Figures ballOnChain(double quality, double ratio);
Figures ballOnChainOf(double count, double ratio);
Figures chainAtStep(double quality, double step);
Figures swingingChain(double quality, double count);
Figures loadedBridge(double quality, double ratio);
Figures pendulumAtStep(double quality, double step);
Figures motorAtLimit(double quality, double torque);

// Map::run functions for scenes with moving bodies: moving_cells.cpp.
Figures bounce(double quality, double bounciness);
Figures bounceAtStep(double step, double bounciness);
Figures slope(double quality, double friction);
Figures spinOnFloor(double quality, double spin);
Figures spinAmongCrates(double quality, double spin);
Figures spawnedInOnePlace(double quality, double count);
Figures crushed(double quality, double left);
Figures crushedFast(double quality, double speed);

}  // namespace plumb::stability
