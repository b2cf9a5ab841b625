#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "math/color.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

enum class LabelAlign : std::uint8_t { Left, Center, Right };

/// Text of one or more lines at the entity's Transform. Words like {coins}, {deaths}, {time}, and those of
/// showText(), are replaced by their values.
struct Label {
    TextId text;
    FontId font;        ///< font file; empty: the engine's default font
    float size = 8.0f;  ///< px, height of a line
    Color color;
    Color shadow{0, 0, 0, 0};   ///< color of the shadow, 1 px below and right; transparent for none
    Color outline{0, 0, 0, 0};  ///< color of the 1 px outline; transparent for none
    LabelAlign align = LabelAlign::Left;
    int layer = 100;      ///< drawing layer; higher numbers are in front
    bool screen = false;  ///< fixed on the screen: the Transform is in px from the view's top-left corner

    static void describe(TypeBuilder<Label>& type) {
        type.name("Label").doc(
            "Text at the entity's Transform; {coins}, {deaths}, {time} are replaced by their values.");
        type.field<&Label::text>("text").doc(
            "Text to show; the game replaces placeholders in braces by their values.");
        type.field<&Label::font>("font").doc("Font file; empty for the engine's default font.");
        type.field<&Label::size>("size").unit(Unit::Pixels).range(1.0f, 512.0f).doc("Height of a line, px.");
        type.field<&Label::color>("color");
        type.field<&Label::shadow>("shadow").doc(
            "Color of the shadow, 1 px below and right; transparent for none.");
        type.field<&Label::outline>("outline").doc("Color of the 1 px outline; transparent for none.");
        type.field<&Label::align>("align").names({{"left", 0}, {"center", 1}, {"right", 2}});
        type.field<&Label::layer>("layer")
            .range(-1000.0f, 1000.0f)
            .doc("Drawing layer; higher numbers are in front.");
        type.field<&Label::screen>("screen").doc(
            "The label stays fixed on the screen while the camera moves.");
    }
};

}  // namespace plumb
