#pragma once

#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A picture, or a cell of a sheet of equal cells, drawn at the entity's Transform.
struct Sprite {
    TextureId texture;
    int width = 32;   ///< px, of the cell that is drawn; `source` is scaled to it (see Game::wholePicture)
    int height = 32;  ///< px
    int frameX = 0;   ///< column of the cell in the sheet
    int frameY = 0;   ///< row of the cell
    Rect source;      ///< px in the texture; empty means the cell (frameX, frameY)
    int layer = 0;    ///< order of drawing: higher is in front
    Color tint;
    bool flipX = false;
    bool flipY = false;
    Vec2 pivot;  ///< ratio of the size; {0, 0} puts the top-left corner at the Transform, {0.5, 0.5} the
                 ///< middle

    Sprite() = default;
    Sprite(TextureId picture, int cellWidth, int cellHeight)
        : texture{picture}, width{cellWidth}, height{cellHeight} {}

    static void describe(TypeBuilder<Sprite>& type) {
        type.name("Sprite").doc("A picture, or a cell of a sheet, drawn at the entity's Transform.");
        type.field<&Sprite::texture>("texture").doc("The image file.");
        type.field<&Sprite::width>("width").unit(Unit::Pixels).range(0.0f, 16384.0f);
        type.field<&Sprite::height>("height").unit(Unit::Pixels).range(0.0f, 16384.0f);
        type.field<&Sprite::frameX>("frameX").range(0.0f, 16384.0f).doc("Column of the cell in the sheet.");
        type.field<&Sprite::frameY>("frameY").range(0.0f, 16384.0f).doc("Row of the cell in the sheet.");
        type.field<&Sprite::source>("source")
            .unit(Unit::Pixels)
            .doc("Part of the texture; empty for the cell (frameX, frameY).");
        type.field<&Sprite::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
        type.field<&Sprite::tint>("tint").doc("Multiplies the picture's colors.");
        type.field<&Sprite::flipX>("flipX").doc("Mirrors left and right.");
        type.field<&Sprite::flipY>("flipY").doc("Mirrors top and bottom.");
        type.field<&Sprite::pivot>("pivot")
            .unit(Unit::Ratio)
            .doc("The point that sits on the Transform: 0, 0 is the top-left corner, 0.5, 0.5 the middle.");
    }
};

}  // namespace plumb
