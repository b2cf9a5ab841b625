#include "editor/ui/icons.hpp"

#include <array>

#include "editor/ui/theme.hpp"
#include "editor/ui/ui_compat.hpp"
#include "reflect/type_registry.hpp"

namespace plumb::editor::ui {
namespace {

/// Draws shapes with coordinates from -1 to 1 into the square of an icon.
struct Pen {
    ImDrawList& list;
    ImVec2 center;
    float half;
    ImU32 color;
    float width;

    [[nodiscard]] ImVec2 at(float x, float y) const { return {center.x + x * half, center.y + y * half}; }
    void line(float x0, float y0, float x1, float y1) const {
        list.AddLine(at(x0, y0), at(x1, y1), color, width);
    }
    void box(float x0, float y0, float x1, float y1, float round = 0.0f) const {
        outline(list, at(x0, y0), at(x1, y1), color, round * half, width);
    }
    void fill(float x0, float y0, float x1, float y1, float round = 0.0f) const {
        list.AddRectFilled(at(x0, y0), at(x1, y1), color, round * half);
    }
    void triangle(float x0, float y0, float x1, float y1, float x2, float y2) const {
        list.AddTriangleFilled(at(x0, y0), at(x1, y1), at(x2, y2), color);
    }
    void dot(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), radius * half, color); }
    void ring(float x, float y, float radius) const {
        list.AddCircle(at(x, y), radius * half, color, 0, width);
    }
    void arc(float x, float y, float radius, float from, float to) const {
        list.PathArcTo(at(x, y), radius * half, from, to);
        for (int i = 1; i < list._Path.Size; ++i) {
            list.AddLine(list._Path[i - 1], list._Path[i], color, width);
        }
        list.PathClear();
    }
};

void drawSelect(const Pen& pen) {
    const std::array points{pen.at(-0.5f, -0.85f), pen.at(0.7f, 0.2f), pen.at(0.1f, 0.27f),
                            pen.at(-0.5f, 0.75f)};
    pen.list.AddTriangleFilled(points[0], points[1], points[2], pen.color);
    pen.list.AddTriangleFilled(points[0], points[2], points[3], pen.color);
}
void drawMove(const Pen& pen) {
    pen.line(-0.6f, 0.0f, 0.6f, 0.0f);
    pen.line(0.0f, -0.6f, 0.0f, 0.6f);
    pen.triangle(0.95f, 0.0f, 0.5f, -0.32f, 0.5f, 0.32f);
    pen.triangle(-0.95f, 0.0f, -0.5f, 0.32f, -0.5f, -0.32f);
    pen.triangle(0.0f, -0.95f, -0.32f, -0.5f, 0.32f, -0.5f);
    pen.triangle(0.0f, 0.95f, 0.32f, 0.5f, -0.32f, 0.5f);
}
void drawRotate(const Pen& pen) {
    pen.arc(0.0f, 0.0f, 0.65f, -0.4f, 4.4f);
    pen.triangle(0.95f, -0.1f, 0.2f, -0.15f, 0.72f, -0.8f);
}
void drawScale(const Pen& pen) {
    pen.box(-0.85f, 0.1f, -0.1f, 0.85f);
    pen.line(-0.05f, 0.05f, 0.55f, -0.55f);
    pen.triangle(0.9f, -0.9f, 0.15f, -0.75f, 0.75f, -0.15f);
}
/// Draws a polygon with marked corners.
void drawShape(const Pen& pen) {
    pen.line(-0.6f, 0.6f, -0.45f, -0.6f);
    pen.line(-0.45f, -0.6f, 0.65f, -0.3f);
    pen.line(0.65f, -0.3f, 0.35f, 0.65f);
    pen.line(0.35f, 0.65f, -0.6f, 0.6f);
    for (const auto& [x, y] : {std::pair{-0.6f, 0.6f}, std::pair{-0.45f, -0.6f}, std::pair{0.65f, -0.3f},
                               std::pair{0.35f, 0.65f}}) {
        pen.fill(x - 0.25f, y - 0.25f, x + 0.25f, y + 0.25f);
    }
}
/// Draws ground with a step and a line of grass above it.
void drawTerrain(const Pen& pen) {
    pen.line(-0.9f, -0.2f, -0.3f, -0.2f);
    pen.line(-0.3f, -0.2f, -0.3f, -0.75f);
    pen.line(-0.3f, -0.75f, 0.9f, -0.75f);
    pen.fill(-0.9f, 0.05f, 0.9f, 0.85f);
    pen.fill(-0.02f, -0.48f, 0.9f, 0.1f);
}
/// Draws cells in a dashed border.
void drawMoveTiles(const Pen& pen) {
    for (const float side : {-0.85f, 0.85f}) {
        for (const float from : {-0.85f, -0.2f, 0.45f}) {
            pen.line(from, side, from + 0.4f, side);
            pen.line(side, from, side, from + 0.4f);
        }
    }
    pen.fill(-0.4f, -0.4f, 0.4f, 0.4f);
}
void drawSameTile(const Pen& pen) {
    pen.fill(-0.85f, -0.85f, -0.15f, -0.15f);
    pen.fill(0.15f, 0.15f, 0.85f, 0.85f);
    pen.box(0.15f, -0.85f, 0.85f, -0.15f);
    pen.box(-0.85f, 0.15f, -0.15f, 0.85f);
}
void drawEye(const Pen& pen) {
    pen.arc(0.0f, 0.75f, 1.15f, -2.45f, -0.69f);
    pen.arc(0.0f, -0.75f, 1.15f, 0.69f, 2.45f);
}
/// Draws a padlock. @param lift  y of the ends of the shackle; higher up (more negative) when unlocked
void drawLock(const Pen& pen, float lift) {
    pen.fill(-0.6f, 0.0f, 0.6f, 0.8f, 0.12f);
    pen.arc(0.0f, lift, 0.4f, 3.14159f, 6.28318f);
    pen.line(-0.4f, lift, -0.4f, 0.1f);
}
void drawPick(const Pen& pen) {
    pen.line(-0.8f, 0.8f, 0.25f, -0.25f);
    pen.line(-0.05f, -0.55f, 0.55f, 0.05f);
    pen.dot(0.5f, -0.5f, 0.34f);
}
void drawBrush(const Pen& pen) {
    pen.line(0.8f, -0.8f, 0.0f, 0.05f);
    pen.dot(-0.3f, 0.35f, 0.38f);
    pen.triangle(-0.85f, 0.85f, -0.62f, 0.2f, -0.1f, 0.7f);
}
void drawErase(const Pen& pen) {
    const std::array points{pen.at(-0.85f, 0.2f), pen.at(0.1f, -0.75f), pen.at(0.8f, -0.05f),
                            pen.at(-0.15f, 0.75f)};
    polyline(pen.list, points.data(), 4, pen.color, true, pen.width);
    pen.line(-0.4f, -0.25f, 0.35f, 0.35f);
    pen.line(-0.2f, 0.85f, 0.85f, 0.85f);
}
void drawFill(const Pen& pen) {
    const std::array points{pen.at(-0.75f, 0.1f), pen.at(0.0f, -0.7f), pen.at(0.65f, 0.0f),
                            pen.at(-0.1f, 0.75f)};
    polyline(pen.list, points.data(), 4, pen.color, true, pen.width);
    pen.triangle(-0.75f, 0.1f, 0.65f, 0.1f, -0.1f, 0.75f);
    pen.dot(0.8f, 0.55f, 0.18f);
}
void drawUndo(const Pen& pen) {
    pen.arc(0.0f, 0.15f, 0.6f, -2.6f, 1.9f);
    pen.triangle(-0.95f, -0.1f, -0.25f, -0.2f, -0.65f, -0.75f);
}
void drawRedo(const Pen& pen) {
    pen.arc(0.0f, 0.15f, 0.6f, 1.24f, 5.74f);
    pen.triangle(0.95f, -0.1f, 0.25f, -0.2f, 0.65f, -0.75f);
}
void drawSave(const Pen& pen) {
    pen.box(-0.75f, -0.75f, 0.75f, 0.75f, 0.15f);
    pen.fill(-0.4f, -0.75f, 0.4f, -0.2f);
    pen.box(-0.4f, 0.15f, 0.4f, 0.75f);
}
void drawSnap(const Pen& pen) {
    pen.arc(0.0f, 0.0f, 0.55f, 0.0f, 3.1416f);
    pen.line(-0.55f, 0.0f, -0.55f, -0.75f);
    pen.line(0.55f, 0.0f, 0.55f, -0.75f);
    pen.fill(-0.75f, -0.85f, -0.35f, -0.5f);
    pen.fill(0.35f, -0.85f, 0.75f, -0.5f);
}
void drawPicture(const Pen& pen) {
    pen.box(-0.85f, -0.7f, 0.85f, 0.7f, 0.15f);
    pen.triangle(-0.65f, 0.5f, -0.1f, -0.2f, 0.35f, 0.5f);
    pen.dot(0.4f, -0.25f, 0.18f);
}
void drawTiles(const Pen& pen) {
    for (const float x : {-0.8f, 0.1f}) {
        for (const float y : {-0.8f, 0.1f}) {
            pen.fill(x, y, x + 0.7f, y + 0.7f, 0.1f);
        }
    }
}
void drawText(const Pen& pen) {
    pen.fill(-0.7f, -0.75f, 0.7f, -0.45f);
    pen.fill(-0.15f, -0.75f, 0.15f, 0.8f);
}
void drawCamera(const Pen& pen) {
    pen.fill(-0.9f, -0.5f, 0.3f, 0.5f, 0.2f);
    pen.triangle(0.4f, 0.0f, 0.9f, -0.45f, 0.9f, 0.45f);
}
void drawLayers(const Pen& pen) {
    for (const float y : {-0.3f, 0.05f, 0.4f}) {
        const std::array points{pen.at(-0.85f, y), pen.at(0.0f, y - 0.45f), pen.at(0.85f, y),
                                pen.at(0.0f, y + 0.45f)};
        polyline(pen.list, points.data(), 4, pen.color, true, pen.width);
    }
}
void drawPerson(const Pen& pen) {
    pen.dot(0.0f, -0.5f, 0.38f);
    pen.fill(-0.55f, 0.05f, 0.55f, 0.85f, 0.4f);
}
void drawStar(const Pen& pen) {
    pen.triangle(0.0f, -0.9f, 0.7f, 0.5f, -0.7f, 0.5f);
    pen.triangle(0.0f, 0.9f, 0.7f, -0.5f, -0.7f, -0.5f);
}

void drawSoft(const Pen& pen) {
    const std::array points{pen.at(-0.9f, 0.35f), pen.at(-0.65f, -0.4f), pen.at(-0.35f, -0.6f),
                            pen.at(-0.1f, -0.3f), pen.at(0.1f, 0.3f),    pen.at(0.35f, 0.6f),
                            pen.at(0.65f, 0.4f),  pen.at(0.9f, -0.35f)};
    polyline(pen.list, points.data(), 8, pen.color, false, pen.width);
}
void drawField(const Pen& pen) {
    for (const float y : {-0.45f, 0.45f}) {
        pen.line(-0.85f, y, 0.3f, y);
        pen.triangle(0.85f, y, 0.25f, y - 0.3f, 0.25f, y + 0.3f);
    }
}

struct MainIcon {
    std::string_view component;
    Icon icon;
};
constexpr std::array kMainIcons{
    MainIcon{"PlayerController", Icon::Person},
    MainIcon{"Camera", Icon::Camera},
    MainIcon{"TileLayer", Icon::Tiles},
    MainIcon{"Label", Icon::Text},
    MainIcon{"ParallaxLayer", Icon::Layers},
    MainIcon{"Collectible", Icon::Star},
    MainIcon{"Sprite", Icon::Picture},
    MainIcon{"RigidBody", Icon::Body},
    MainIcon{"ParticleEmitter", Icon::Star},
    MainIcon{"Rope", Icon::Soft},
    MainIcon{"Cloth", Icon::Soft},
    MainIcon{"Jelly", Icon::Soft},
    MainIcon{"WindField", Icon::Field},
    MainIcon{"GravityField", Icon::Field},
    MainIcon{"BuoyancyField", Icon::Field},
    MainIcon{"Attractor", Icon::Field},
    MainIcon{"BoxCollider", Icon::Body},
    MainIcon{"CircleCollider", Icon::Body},
    MainIcon{"CapsuleCollider", Icon::Body},
    MainIcon{"PolygonCollider", Icon::Body},
    MainIcon{"ChainCollider", Icon::Body},
};

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color) {
    const Pen pen{list, center, size * 0.5f, color, size > 18.0f ? 2.0f : 1.5f};
    switch (icon) {
        case Icon::Select: drawSelect(pen); break;
        case Icon::Move: drawMove(pen); break;
        case Icon::Rotate: drawRotate(pen); break;
        case Icon::Scale: drawScale(pen); break;
        case Icon::Shape: drawShape(pen); break;
        case Icon::Rectangle: pen.box(-0.8f, -0.6f, 0.8f, 0.6f), pen.fill(-0.5f, -0.3f, 0.5f, 0.3f); break;
        case Icon::Pick: drawPick(pen); break;
        case Icon::Brush: drawBrush(pen); break;
        case Icon::Erase: drawErase(pen); break;
        case Icon::Fill: drawFill(pen); break;
        case Icon::Play: pen.triangle(-0.6f, -0.8f, 0.85f, 0.0f, -0.6f, 0.8f); break;
        case Icon::Stop: pen.fill(-0.65f, -0.65f, 0.65f, 0.65f, 0.15f); break;
        case Icon::Pause: pen.fill(-0.6f, -0.7f, -0.15f, 0.7f), pen.fill(0.15f, -0.7f, 0.6f, 0.7f); break;
        case Icon::Step:
            pen.triangle(-0.7f, -0.7f, 0.4f, 0.0f, -0.7f, 0.7f), pen.fill(0.45f, -0.7f, 0.75f, 0.7f);
            break;
        case Icon::StepBack:
            pen.triangle(0.7f, -0.7f, 0.7f, 0.7f, -0.4f, 0.0f), pen.fill(-0.75f, -0.7f, -0.45f, 0.7f);
            break;
        case Icon::Watch:
            pen.triangle(-0.85f, -0.6f, 0.0f, 0.0f, -0.85f, 0.6f);
            pen.triangle(0.0f, -0.6f, 0.85f, 0.0f, 0.0f, 0.6f);
            break;
        case Icon::Undo: drawUndo(pen); break;
        case Icon::Redo: drawRedo(pen); break;
        case Icon::Save: drawSave(pen); break;
        case Icon::Snap: drawSnap(pen); break;
        case Icon::Entity: pen.ring(0.0f, 0.0f, 0.55f), pen.dot(0.0f, 0.0f, 0.2f); break;
        case Icon::Picture: drawPicture(pen); break;
        case Icon::Tiles: drawTiles(pen); break;
        case Icon::Text: drawText(pen); break;
        case Icon::Camera: drawCamera(pen); break;
        case Icon::Body: pen.box(-0.75f, -0.75f, 0.75f, 0.75f, 0.1f), pen.dot(0.0f, 0.0f, 0.22f); break;
        case Icon::Soft: drawSoft(pen); break;
        case Icon::Field: drawField(pen); break;
        case Icon::Layers: drawLayers(pen); break;
        case Icon::Person: drawPerson(pen); break;
        case Icon::Star: drawStar(pen); break;
        case Icon::Terrain: drawTerrain(pen); break;
        case Icon::Line:
            pen.line(-0.7f, 0.7f, 0.7f, -0.7f), pen.dot(-0.7f, 0.7f, 0.22f), pen.dot(0.7f, -0.7f, 0.22f);
            break;
        case Icon::Ellipse: pen.ring(0.0f, 0.0f, 0.8f); break;
        case Icon::MoveTiles: drawMoveTiles(pen); break;
        case Icon::SameTile: drawSameTile(pen); break;
        case Icon::Eye: drawEye(pen), pen.dot(0.0f, 0.0f, 0.3f); break;
        case Icon::EyeClosed: drawEye(pen), pen.line(-0.75f, 0.75f, 0.75f, -0.75f); break;
        case Icon::Lock: drawLock(pen, -0.05f); break;
        case Icon::Unlocked: drawLock(pen, -0.45f); break;
        case Icon::Solo: pen.ring(0.0f, 0.0f, 0.75f), pen.dot(0.0f, 0.0f, 0.32f); break;
        case Icon::Chevron: pen.triangle(-0.5f, -0.3f, 0.5f, -0.3f, 0.0f, 0.4f); break;
    }
}

Icon iconOf(const World& world, EntityId entity) {
    for (const MainIcon& main : kMainIcons) {
        const TypeInfo* type = world.types()->find(main.component);
        if (type != nullptr && world.has(*type, entity)) return main.icon;
    }
    return Icon::Entity;
}

ImU32 iconColor(Icon icon) {
    switch (icon) {
        case Icon::Person: return palette::kPlay;
        case Icon::Camera: return palette::kViolet;
        case Icon::Tiles: return palette::kOrange;
        case Icon::Picture: return palette::kAccent;
        case Icon::Star: return palette::kWarning;
        case Icon::Soft: return palette::kSand;
        case Icon::Field: return palette::kLime;
        case Icon::Layers: return palette::kTeal;
        case Icon::Text: return palette::kText;
        default: return palette::kTextDim;
    }
}

Icon iconOfAction(std::string_view action) {
    constexpr std::array kIcons{
        std::pair<std::string_view, Icon>{"tool.select", Icon::Select},
        std::pair<std::string_view, Icon>{"tool.move", Icon::Move},
        std::pair<std::string_view, Icon>{"tool.rotate", Icon::Rotate},
        std::pair<std::string_view, Icon>{"tool.scale", Icon::Scale},
        std::pair<std::string_view, Icon>{"tool.shape", Icon::Shape},
        std::pair<std::string_view, Icon>{"tool.rectangle", Icon::Rectangle},
        std::pair<std::string_view, Icon>{"tool.pick", Icon::Pick},
        std::pair<std::string_view, Icon>{"tool.brush", Icon::Brush},
        std::pair<std::string_view, Icon>{"tool.erase", Icon::Erase},
        std::pair<std::string_view, Icon>{"tool.fill", Icon::Fill},
        std::pair<std::string_view, Icon>{"tool.terrain", Icon::Terrain},
        std::pair<std::string_view, Icon>{"tool.line", Icon::Line},
        std::pair<std::string_view, Icon>{"tool.ellipse", Icon::Ellipse},
        std::pair<std::string_view, Icon>{"tool.moveTiles", Icon::MoveTiles},
        std::pair<std::string_view, Icon>{"tool.same", Icon::SameTile},
        std::pair<std::string_view, Icon>{"run.play", Icon::Play},
        std::pair<std::string_view, Icon>{"run.pause", Icon::Pause},
        std::pair<std::string_view, Icon>{"run.step", Icon::Step},
        std::pair<std::string_view, Icon>{"run.stepBack", Icon::StepBack},
        std::pair<std::string_view, Icon>{"run.watch", Icon::Watch},
        std::pair<std::string_view, Icon>{"edit.undo", Icon::Undo},
        std::pair<std::string_view, Icon>{"edit.redo", Icon::Redo},
        std::pair<std::string_view, Icon>{"file.save", Icon::Save},
        std::pair<std::string_view, Icon>{"view.snap", Icon::Snap},
    };
    for (const auto& [id, icon] : kIcons) {
        if (id == action) return icon;
    }
    return Icon::Entity;
}

}  // namespace plumb::editor::ui
