#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/options.hpp"
#include "tests/accuracy/report/row.hpp"
#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

/// Description of the run: options, size and duration.
std::string howItRan(const Options& options, const std::vector<Row>& rows, double seconds);

/// The scenes whose plots are in docs/accuracy.md, as accuracy/NAME.svg.
std::span<const std::string_view> guideScenes();

/// Recommendations: a bold lead, and the rest of the text.
struct Advice {
    std::string_view lead;
    std::string_view text;
};
std::span<const Advice> allAdvice();

/// A goal and the results, as text.
struct Mark {
    std::string_view scene;
    std::string_view title;
    std::string goal;
    std::string own;     ///< of the default
    std::string fewest;  ///< minimum substeps that reach the goal
    std::string peer;    ///< of Box2D 2.4.1
    std::string ratio;   ///< default over Box2D: error / time
};
std::vector<Mark> marksOf(const std::vector<Row>& rows);
/// Explanation of the columns.
std::string_view marksWords();

/// docs/accuracy.md.
std::string guideOf(const std::vector<Row>& rows, std::string_view how);

}  // namespace plumb::accuracy
