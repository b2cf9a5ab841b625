#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "render/text_painter.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

/// Function that writes a label's text to `out` with placeholders like {coins} replaced by their values.
using LabelText = void (*)(const World& world, std::string_view text, std::string& out);

/// Draws the labels of a world; caches their fonts.
class LabelDrawing {
public:
    LabelDrawing(RenderDevice& device, AssetStore& assets) : assets_{assets}, painter_{device} {}

    /// @param pixelScale  window px per px of the game image
    void setPixelScale(float pixelScale) { painter_.setPixelScale(pixelScale); }
    void draw(const World& world, const Label& label, const Pose& pose, LabelText labelText, DrawList& list);
    /// Draws a text in the engine's own font, whose digits have the same width. @return  size of the text, px
    Vec2 write(std::string_view text, Vec2 position, const TextStyle& style, DrawList& list);
    /// Returns the size that draw() would give the label (px), e.g. for selecting it.
    Vec2 measure(const World& world, const Label& label, LabelText labelText);

private:
    struct Face {
        FontId id;
        std::uint32_t revision = 0;
        std::uint64_t content = 0;   ///< hash of the font file
        std::unique_ptr<Font> font;  ///< null if the file is not a font
    };

    FontId ownFont(std::string_view path, bool& held);
    const Font* fontOf(FontId id);
    void fill(const World& world, const Label& label, LabelText labelText);

    AssetStore& assets_;
    TextPainter painter_;
    std::vector<Face> faces_;
    bool holdsDefault_ = false;  ///< the font of labels without their own is acquired from `assets_`
    bool holdsPlain_ = false;    ///< the font of write() is acquired from `assets_`
    std::string text_;           // a member, so that its memory is reused in every frame
};

}  // namespace plumb
