#pragma once

#include <limits>
#include <span>
#include <string_view>

namespace plumb::accuracy {

/// Description of a scene in the report.
struct SceneText {
    std::string_view name;  ///< Experiment::name
    int number = 0;         ///< number in the table of scenes with exact results; 0: none
    std::string_view title;
    std::string_view answer;  ///< expected result
    std::string_view shows;   ///< description of the diagram
    std::string_view choose;  ///< recommendation
    double order = kNoOrder;  ///< theoretical p of error ~ 1 / substeps^p, default solver; kNoOrder: none
    std::string_view why;     ///< reason for a different measured order; empty: as expected

    static constexpr double kNoOrder = -1.0;
};

std::span<const SceneText> exactTexts();  ///< texts of scenes with exact results (texts_exact.cpp)
std::span<const SceneText> hardTexts();   ///< texts of all other scenes (texts_hard.cpp)
/// Returns the text of a scene; an empty text if there is none.
const SceneText& textOf(std::string_view scene);

/// Returns the theoretical order of the position error of an integrator, given its name.
double textbookOrder(std::string_view integrator);

}  // namespace plumb::accuracy
