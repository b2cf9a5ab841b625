#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

namespace {

constexpr SceneText kNothing{};

struct Textbook {
    std::string_view integrator;
    double order;
};
constexpr Textbook kTextbook[] = {
    {"explicit Euler", 1.0}, {"semi-implicit Euler", 1.0}, {"Verlet", 2.0}, {"Runge-Kutta 4", 4.0}};

}  // namespace

const SceneText& textOf(std::string_view scene) {
    for (const std::span<const SceneText> texts : {exactTexts(), hardTexts()}) {
        for (const SceneText& text : texts) {
            if (text.name == scene) return text;
        }
    }
    return kNothing;
}

double textbookOrder(std::string_view integrator) {
    for (const Textbook& row : kTextbook) {
        if (row.integrator == integrator) return row.order;
    }
    return 0.0;
}

}  // namespace plumb::accuracy
