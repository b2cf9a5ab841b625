#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

enum class LabelAlign : std::uint8_t { Left, Center, Right };

/// A line or more of text at the entity's Transform. {coins}, {deaths}, {time} and so on are filled in.
struct Label {
    TextId text;
    FontId font;        ///< empty for the engine's own
    float size = 8.0f;  ///< px, height of a line
    Color color;
    Color shadow{0, 0, 0, 0};   ///< one px below and right; invisible without opacity
    Color outline{0, 0, 0, 0};  ///< one px all around; invisible without opacity
    LabelAlign align = LabelAlign::Left;
    int layer = 100;      ///< order of drawing: higher is in front
    bool screen = false;  ///< stays on the screen: the Transform is px of the view from its top-left corner

    static void describe(TypeBuilder<Label>& type) {
        type.name("Label").doc("Text at the entity's Transform; {coins}, {deaths}, {time} are filled in.");
        type.field<&Label::text>("text").doc("Placeholders in braces are filled in by the game.");
        type.field<&Label::font>("font").doc("Empty for the engine's own.");
        type.field<&Label::size>("size").unit(Unit::Pixels).range(1.0f, 512.0f).doc("Height of a line.");
        type.field<&Label::color>("color");
        type.field<&Label::shadow>("shadow").doc("One pixel below and right; none without opacity.");
        type.field<&Label::outline>("outline").doc("One pixel all around; none without opacity.");
        type.field<&Label::align>("align").names({{"left", 0}, {"center", 1}, {"right", 2}});
        type.field<&Label::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
        type.field<&Label::screen>("screen").doc("Stays on the screen while the camera moves.");
    }
};

}  // namespace plumb
