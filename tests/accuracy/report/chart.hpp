#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// One way to simulate a scene, at several qualities.
struct ChartLine {
    std::string name;
    int colour = 0;          ///< 0..4
    std::vector<Row> rows;   ///< by growing substeps
    std::vector<Row> extra;  ///< the same with more iterations: small hollow points
};

/// A work-precision plot: error over time, both by powers of ten. Further down and further left is better.
struct Chart {
    std::string title;
    std::string unit;
    double target = 0.0;    ///< infinite where there is none
    double usTarget = 0.0;  ///< 0 where there is none
    std::vector<ChartLine> lines;
    std::vector<Row> peers;
};

/// What is plotted of a scene: its main figure.
/// @param rows  of the scene
Chart chartOf(std::string_view title, std::span<const Row> rows);

/// The name of another engine as its owner writes it.
std::string peerTitle(std::string_view engine);

/// Complete in itself; dark where the reader's desktop is.
std::string svgOf(const Chart& chart);
/// Rules for a page that has such plots in it, and nothing that only a plot of its own needs.
std::string_view chartStyle();

}  // namespace plumb::accuracy
