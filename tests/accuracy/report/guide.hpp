#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/options.hpp"
#include "tests/accuracy/report/row.hpp"
#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

/// Returns a description of the run: options, size and duration.
std::string howItRan(const Options& options, const std::vector<Row>& rows, double seconds);

/// Names of the scenes whose diagrams (accuracy/NAME.svg) are in docs/accuracy.md.
std::span<const std::string_view> guideScenes();

/// A recommendation: a bold beginning, and the rest of the text.
struct Advice {
    std::string_view lead;
    std::string_view text;
};
std::span<const Advice> allAdvice();  ///< recommendations in the section "What to choose"

/// A row of the table of goals: the goal of a scene, and results as text.
struct Mark {
    std::string_view scene;
    std::string_view title;
    std::string goal;
    std::string own;     ///< result of the default settings
    std::string fewest;  ///< smallest number of substeps that reaches the goal, with its result
    std::string peer;    ///< result of Box2D 2.4.1
    std::string ratio;   ///< ratios "error / time" of the default settings to Box2D
};
std::vector<Mark> marksOf(const std::vector<Row>& rows);
/// Explanation of the columns of the table of goals.
std::string_view marksWords();

/// Returns the text of docs/accuracy.md.
std::string guideOf(const std::vector<Row>& rows, std::string_view how);

}  // namespace plumb::accuracy
