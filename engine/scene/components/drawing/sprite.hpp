#pragma once

#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// An image, or one cell of a sheet of equal cells, drawn at the entity's Transform.
struct Sprite {
    TextureId texture;
    int width = 32;   ///< px, width of the drawn cell; `source` is scaled to this size
    int height = 32;  ///< px, height of the drawn cell
    int frameX = 0;   ///< column of the cell in the sheet, from 0
    int frameY = 0;   ///< row of the cell in the sheet, from 0
    Rect source;      ///< px: the part of the texture to draw; empty: the cell (frameX, frameY)
    int layer = 0;    ///< drawing layer; higher numbers are in front
    Color tint;
    bool flipX = false;
    bool flipY = false;
    Vec2 pivot;  ///< point placed at the Transform, ratio of the size; {0, 0}: top left, {0.5, 0.5}: center

    Sprite() = default;
    Sprite(TextureId picture, int cellWidth, int cellHeight)
        : texture{picture}, width{cellWidth}, height{cellHeight} {}

    static void describe(TypeBuilder<Sprite>& type) {
        type.name("Sprite").doc("An image, or one cell of a sheet, drawn at the entity's Transform.");
        type.field<&Sprite::texture>("texture").doc("Image file to draw.");
        type.field<&Sprite::width>("width").unit(Unit::Pixels).range(0.0f, 16384.0f);
        type.field<&Sprite::height>("height").unit(Unit::Pixels).range(0.0f, 16384.0f);
        type.field<&Sprite::frameX>("frameX")
            .range(0.0f, 16384.0f)
            .doc("Column of the cell in the sheet, from 0.");
        type.field<&Sprite::frameY>("frameY")
            .range(0.0f, 16384.0f)
            .doc("Row of the cell in the sheet, from 0.");
        type.field<&Sprite::source>("source")
            .unit(Unit::Pixels)
            .doc("Rectangle of the texture to draw, px; empty for the cell (frameX, frameY).");
        type.field<&Sprite::layer>("layer")
            .range(-1000.0f, 1000.0f)
            .doc("Drawing layer; higher numbers are in front.");
        type.field<&Sprite::tint>("tint").doc("Color multiplied with the texture's colors.");
        type.field<&Sprite::flipX>("flipX").doc("Mirrors the image left and right.");
        type.field<&Sprite::flipY>("flipY").doc("Mirrors the image top and bottom.");
        type.field<&Sprite::pivot>("pivot")
            .unit(Unit::Ratio)
            .doc(
                "Point placed at the Transform, as a ratio of the size: 0, 0 is the top-left corner, 0.5, "
                "0.5 the center.");
    }
};

}  // namespace plumb
