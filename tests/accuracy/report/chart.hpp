#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// Results of one method for a scene at several qualities.
struct ChartLine {
    std::string name;
    int colour = 0;          ///< index of the color, 0..4
    std::vector<Row> rows;   ///< results sorted by number of substeps
    std::vector<Row> extra;  ///< results with more iterations, drawn as small hollow points
};

/// A work-precision diagram: error over time, both logarithmic. Further down and further left is better.
struct Chart {
    std::string title;
    std::string unit;       ///< unit of the error
    double target = 0.0;    ///< goal of the error; infinite: none
    double usTarget = 0.0;  ///< goal of the time of a step, µs; 0: none
    std::vector<ChartLine> lines;
    std::vector<Row> peers;  ///< results of other engines
};

/// Returns the diagram of the main figure of a scene.
/// @param rows  the results of the scene
Chart chartOf(std::string_view title, std::span<const Row> rows);

/// Returns the display name of another engine.
std::string peerTitle(std::string_view engine);

/// Draws a diagram as a self-contained SVG, with dark colors on a dark desktop.
std::string svgOf(const Chart& chart);
/// CSS rules for a page with several diagrams.
std::string_view chartStyle();

}  // namespace plumb::accuracy
