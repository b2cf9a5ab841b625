#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// One method for a scene, at several qualities.
struct ChartLine {
    std::string name;
    int colour = 0;          ///< 0..4
    std::vector<Row> rows;   ///< by increasing substeps
    std::vector<Row> extra;  ///< the same with more iterations: small hollow points
};

/// A work-precision plot: error over time, both logarithmic. Further down and further left is better.
struct Chart {
    std::string title;
    std::string unit;
    double target = 0.0;    ///< infinite if there is none
    double usTarget = 0.0;  ///< 0 if there is none
    std::vector<ChartLine> lines;
    std::vector<Row> peers;
};

/// The data of a scene's plot: its main figure.
/// @param rows of the scene
Chart chartOf(std::string_view title, std::span<const Row> rows);

/// The display name of another engine.
std::string peerTitle(std::string_view engine);

/// Self-contained; dark if the reader's desktop is.
std::string svgOf(const Chart& chart);
/// CSS rules for a page with such plots, without those that only a single plot needs.
std::string_view chartStyle();

}  // namespace plumb::accuracy
