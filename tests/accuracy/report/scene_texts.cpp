#include "tests/accuracy/report/scene_texts.hpp"

#include <algorithm>
#include <array>

namespace plumb::accuracy {

namespace {

constexpr auto kTexts = std::to_array<SceneText>({
    {.name = "freefall", .number = 1, .title = "Free fall", .answer = "½ g t² after 2 s."},
});

constexpr SceneText kNothing{};

struct Textbook {
    std::string_view integrator;
    double order;
};
constexpr Textbook kTextbook[] = {
    {"explicit Euler", 1.0}, {"semi-implicit Euler", 1.0}, {"Verlet", 2.0}, {"Runge-Kutta 4", 4.0}};

}  // namespace

std::span<const SceneText> allSceneTexts() { return kTexts; }

const SceneText& textOf(std::string_view scene) {
    const auto found = std::find_if(kTexts.begin(), kTexts.end(),
                                    [scene](const SceneText& text) { return text.name == scene; });
    return found != kTexts.end() ? *found : kNothing;
}

double textbookOrder(std::string_view integrator) {
    for (const Textbook& row : kTextbook) {
        if (row.integrator == integrator) return row.order;
    }
    return 0.0;
}

}  // namespace plumb::accuracy
