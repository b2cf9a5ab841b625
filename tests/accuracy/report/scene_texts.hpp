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
    std::string_view answer;  ///< what should come out
    std::string_view shows;   ///< what the plot shows
    std::string_view choose;  ///< what to choose
    double order = kNoOrder;  ///< p of error ~ 1 / substeps^p that theory says of the default; kNoOrder: none
    std::string_view why;     ///< why the measured order is another one; empty where it is as expected

    static constexpr double kNoOrder = -1.0;
};

std::span<const SceneText> exactTexts();  ///< of scenes with exact answers: texts_exact.cpp
std::span<const SceneText> hardTexts();   ///< of all others: texts_hard.cpp
/// That of a scene; one without words for a scene that has none.
const SceneText& textOf(std::string_view scene);

/// What textbooks say of an integrator's error in place.
double textbookOrder(std::string_view integrator);

}  // namespace plumb::accuracy
