#include "scene/drawing/label_drawing.hpp"

#include <algorithm>

#include "core/hash.hpp"
#include "core/log.hpp"

namespace plumb {
namespace {

constexpr std::string_view kPlainFont = "engine:fonts/b612.otf";              // font of write()
constexpr std::string_view kDefaultFont = "engine:fonts/press_start_2p.ttf";  // of labels without a font

TextShape shapeOf(const Label& label, float scale) {
    TextShape shape;
    shape.size = label.size * scale;
    shape.align = static_cast<TextAlign>(label.align);
    return shape;
}

}  // namespace

void LabelDrawing::draw(const World& world, const Label& label, const Pose& pose, LabelText labelText,
                        DrawList& list) {
    const Font* font = fontOf(label.font);
    if (font == nullptr || label.text.empty()) return;
    fill(world, label, labelText);
    TextStyle style;
    style.shape = shapeOf(label, pose.scale.y);
    style.color = label.color;
    style.shadow = label.shadow;
    style.outline = label.outline;
    style.layer = label.layer;
    painter_.draw(list, *font, text_, pose.position, style);
}

Vec2 LabelDrawing::write(std::string_view text, Vec2 position, const TextStyle& style, DrawList& list) {
    const Font* font = fontOf(ownFont(kPlainFont, holdsPlain_));
    return font != nullptr ? painter_.draw(list, *font, text, position, style) : Vec2{};
}

Vec2 LabelDrawing::measure(const World& world, const Label& label, LabelText labelText) {
    const Font* font = fontOf(label.font);
    if (font == nullptr) return {};
    fill(world, label, labelText);
    return painter_.measure(*font, text_, shapeOf(label, 1.0f));
}

FontId LabelDrawing::ownFont(std::string_view path, bool& held) {
    const FontId id{textId(path)};
    if (!held) {  // acquire the font, as no entity references it and keeps it loaded
        assets_.loadFont(path);
        assets_.acquire(AssetKind::Font, id.path);
        held = true;
    }
    return id;
}

const Font* LabelDrawing::fontOf(FontId id) {
    if (id.empty()) id = ownFont(kDefaultFont, holdsDefault_);
    for (const Face& face : faces_) {
        if (face.id == id && face.revision == assets_.revisionOf(AssetKind::Font, id.path))
            return face.font.get();
    }
    const FileBytes* file = assets_.find(id);
    if (file == nullptr || file->bytes.empty()) return nullptr;
    const auto known = std::find_if(faces_.begin(), faces_.end(), [id](const Face& f) { return f.id == id; });
    Face& face = known != faces_.end() ? *known : faces_.emplace_back();
    face.id = id;
    face.revision = assets_.revisionOf(AssetKind::Font, id.path);
    // Keep the rasterized glyphs if the reloaded file is unchanged.
    const std::uint64_t content = hashText(file->bytes);
    if (face.content == content) return face.font.get();
    face.content = content;
    face.font.reset();
    Result<Font> font = Font::fromBytes(file->bytes, std::string{assets_.pathOf(id)});
    if (font) {
        face.font = std::make_unique<Font>(std::move(*font));
    } else {
        logWarning("Assets", font.error());
    }
    return face.font.get();
}

void LabelDrawing::fill(const World& world, const Label& label, LabelText labelText) {
    const std::string_view written = world.texts().find(label.text);
    if (labelText != nullptr) {
        labelText(world, written, text_);
    } else {
        text_ = written;
    }
}

}  // namespace plumb
