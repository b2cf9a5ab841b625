#pragma once

#include <limits>
#include <span>
#include <string_view>

namespace plumb::accuracy {

/// The description of a scene for readers of the report.
struct SceneText {
    std::string_view name;
    int number = 0;  ///< in the table of scenes with exact answers; 0 for others
    std::string_view title;
    std::string_view answer;  ///< the expected result
    std::string_view shows;   ///< what the plot shows
    std::string_view choose;  ///< the recommendation
    double order = kNoOrder;  ///< theoretical p of error ~ 1 / substeps^p for the default; kNoOrder: none
    std::string_view why;     ///< why the measured order differs; empty if it does not

    static constexpr double kNoOrder = -1.0;
};

std::span<const SceneText> exactTexts();  ///< of scenes with exact answers: texts_exact.cpp
std::span<const SceneText> hardTexts();   ///< of all others: texts_hard.cpp
/// The text of a scene; an empty one if it has none.
const SceneText& textOf(std::string_view scene);

/// The theoretical order of an integrator's position error.
double textbookOrder(std::string_view integrator);

}  // namespace plumb::accuracy
