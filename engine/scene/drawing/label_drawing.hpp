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

/// Gives the text that a label shows: placeholders like {coins} filled in.
using LabelText = void (*)(const World& world, std::string_view text, std::string& out);

/// Draws the labels of a world; keeps their fonts.
class LabelDrawing {
public:
    LabelDrawing(RenderDevice& device, AssetStore& assets) : assets_{assets}, painter_{device} {}

    /// @param pixelScale  window px for each px of the picture
    void setPixelScale(float pixelScale) { painter_.setPixelScale(pixelScale); }
    void draw(const World& world, const Label& label, const Pose& pose, LabelText labelText, DrawList& list);
    /// A text of the engine itself, with digits of one width. @return  px: its size
    Vec2 write(std::string_view text, Vec2 position, const TextStyle& style, DrawList& list);
    /// The size that draw would give (px), e.g. for selecting it.
    Vec2 measure(const World& world, const Label& label, LabelText labelText);

private:
    struct Face {
        FontId id;
        std::uint32_t revision = 0;
        std::uint64_t content = 0;   ///< hash of the file
        std::unique_ptr<Font> font;  ///< null when the file is no font
    };

    FontId ownFont(std::string_view path, bool& held);
    const Font* fontOf(FontId id);
    void fill(const World& world, const Label& label, LabelText labelText);

    AssetStore& assets_;
    TextPainter painter_;
    std::vector<Face> faces_;
    bool holdsDefault_ = false;
    bool holdsPlain_ = false;
    std::string text_;  // reused, so that a steady frame allocates nothing
};

}  // namespace plumb
