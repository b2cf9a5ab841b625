#include "app/options/options_view.hpp"

#include <algorithm>
#include <array>

namespace plumb {
namespace {

constexpr Vec2 kLeast{640.0f, 360.0f};  // px of the menu
constexpr float kNarrow = 430.0f;       // px, width of the menu in a small window
constexpr float kSmallest = 0.75f;      // px of the window for one of the menu: below, texts are hard to read
constexpr Color kShade{6, 8, 12, 176};
constexpr Color kBack{22, 25, 33, 244};
constexpr Color kBorder{66, 73, 92, 255};
constexpr Color kText{226, 229, 236, 255};
constexpr Color kDim{148, 155, 172, 255};
constexpr Color kAccent{255, 204, 92, 255};
constexpr Color kMark{255, 204, 92, 30};
constexpr Color kTrack{58, 64, 80, 255};
constexpr float kTitleSize = 18.0f;  // px
constexpr float kTextSize = 13.0f;   // px
constexpr float kHintSize = 11.0f;   // px
constexpr float kPad = 8.0f;         // px, between a row's sides and its texts
constexpr int kShadeLayer = 0, kPanelLayer = 1, kMarkLayer = 2, kTextLayer = 3;

class Painter {
public:
    Painter(LabelDrawing& labels, DrawList& list) : labels_{labels}, list_{list} {}

    /// @param middle  y of the middle of the line
    void text(std::string_view words, Vec2 middle, float size, Color color,
              TextAlign align = TextAlign::Left) {
        TextStyle style;
        style.shape.size = size;
        style.shape.align = align;
        style.color = color;
        style.layer = kTextLayer;
        labels_.write(words, {middle.x, middle.y - size * kLine * 0.5f}, style, list_);
    }
    void box(const AABB& box, Color color, int layer) { list_.filledRect(box, color, layer); }
    void frame(const AABB& box, Color color) {
        this->box({box.min, {box.max.x, box.min.y + 1.0f}}, color, kMarkLayer);
        this->box({{box.min.x, box.max.y - 1.0f}, box.max}, color, kMarkLayer);
        this->box({box.min, {box.min.x + 1.0f, box.max.y}}, color, kMarkLayer);
        this->box({{box.max.x - 1.0f, box.min.y}, box.max}, color, kMarkLayer);
    }
    /// A triangle that points to the left or to the right. @param direction  -1 or 1
    void arrow(Vec2 middle, float direction, Color color) {
        const std::array corners{Vec2{middle.x + 3.0f * direction, middle.y},
                                 Vec2{middle.x - 2.0f * direction, middle.y - 4.0f},
                                 Vec2{middle.x - 2.0f * direction, middle.y + 4.0f}};
        list_.filledPolygon(corners, color, kTextLayer);
    }
    void knob(Vec2 middle, Color color) { list_.filledCircle(middle, 5.0f, color, kTextLayer); }

private:
    static constexpr float kLine = 1.27f;  // height of a line of the engine's font, ratio to its size

    LabelDrawing& labels_;
    DrawList& list_;
};

void drawVolume(Painter& paint, const OptionsMenu::Row& row, bool isSelected) {
    const AABB value = OptionsMenu::valueBox(row);
    const float y = (row.box.min.y + row.box.max.y) * 0.5f;
    const float end = value.min.x + OptionsMenu::kSlider * row.ratio;
    const Color color = isSelected ? kAccent : kText, bar = isSelected ? kAccent : kDim;
    paint.box({{value.min.x, y - 2.0f}, {value.min.x + OptionsMenu::kSlider, y + 2.0f}}, kTrack, kMarkLayer);
    paint.box({{value.min.x, y - 2.0f}, {end, y + 2.0f}}, bar, kTextLayer);
    paint.knob({end, y}, bar);
    paint.text(row.value, {value.max.x, y}, kTextSize, color, TextAlign::Right);
}

void drawRow(Painter& paint, const OptionsMenu::Row& row, bool isSelected) {
    const float y = (row.box.min.y + row.box.max.y) * 0.5f;
    const AABB value = OptionsMenu::valueBox(row);
    const Color color = isSelected ? kAccent : kText;
    if (isSelected) {
        paint.box(row.box, kMark, kMarkLayer);
        paint.box({row.box.min, {row.box.min.x + 2.0f, row.box.max.y}}, kAccent, kMarkLayer);
    }
    paint.text(row.label, {row.box.min.x + kPad, y}, kTextSize, color);
    switch (row.kind) {
        case OptionsMenu::Kind::Volume: drawVolume(paint, row, isSelected); break;
        case OptionsMenu::Kind::Choice: {
            const float middle = (value.min.x + value.max.x) * 0.5f;
            paint.text(row.value, {middle, y}, kTextSize, color, TextAlign::Center);
            const Color arrows = isSelected ? kAccent : kBorder;
            paint.arrow({value.min.x + 4.0f, y}, -1.0f, arrows);
            paint.arrow({value.max.x - 4.0f, y}, 1.0f, arrows);
            break;
        }
        case OptionsMenu::Kind::Binding:
            paint.text(row.value, {value.max.x, y}, kTextSize, isSelected ? kAccent : kDim, TextAlign::Right);
            break;
        case OptionsMenu::Kind::Command: break;
    }
}

/// Shows which part of the rows is visible, if not all are.
void drawScrollBar(Painter& paint, const OptionsMenu& menu) {
    const std::size_t rows = menu.rows().size();
    if (menu.shownRows() >= rows) return;
    const AABB& panel = menu.panel();
    const float top = panel.min.y + OptionsMenu::kHead, bottom = panel.max.y - OptionsMenu::kFoot;
    const float part = (bottom - top) / static_cast<float>(rows);
    const float from = top + part * static_cast<float>(menu.firstShown());
    const float x = panel.max.x - 8.0f;
    paint.box({{x, top}, {x + 3.0f, bottom}}, kTrack, kMarkLayer);
    paint.box({{x, from}, {x + 3.0f, from + part * static_cast<float>(menu.shownRows())}}, kDim, kTextLayer);
}

}  // namespace

Vec2 optionsScreen(PixelSize window) {
    const float width = static_cast<float>(std::max(window.width, 1));
    const float height = static_cast<float>(std::max(window.height, 1));
    const float whole = std::min(width / kLeast.x, height / kLeast.y);
    const float unit = std::max(whole, std::min(kSmallest, width / kNarrow));
    return {width / unit, height / unit};
}

void drawOptions(const OptionsMenu& menu, LabelDrawing& labels, DrawList& list) {
    Painter paint{labels, list};
    const AABB& panel = menu.panel();
    paint.box({{0.0f, 0.0f}, list.view().size}, kShade, kShadeLayer);
    paint.box(panel, kBack, kPanelLayer);
    paint.frame(panel, kBorder);
    const float left = panel.min.x + OptionsMenu::kMargin + kPad;
    paint.text(menu.title(), {left, panel.min.y + OptionsMenu::kHead * 0.5f}, kTitleSize, kText);
    for (std::size_t i = menu.firstShown(); i < menu.firstShown() + menu.shownRows(); ++i)
        drawRow(paint, menu.rows()[i], i == menu.selected());
    drawScrollBar(paint, menu);
    paint.text(menu.hint(), {left, panel.max.y - OptionsMenu::kFoot * 0.5f}, kHintSize,
               menu.warns() ? kAccent : kDim);
}

void drawNotice(std::string_view text, LabelDrawing& labels, DrawList& list) {
    constexpr float kTextMargin = 6.0f;  // px, around the text
    const Vec2 screen = list.view().size;
    TextStyle style;
    style.shape.size = kTextSize;
    style.shape.align = TextAlign::Center;
    style.shape.wrapWidth = screen.x - 4.0f * kTextMargin;
    style.color = kAccent;
    style.layer = kTextLayer;
    const float height = labels.write(text, {screen.x * 0.5f, kTextMargin}, style, list).y;
    list.filledRect({{}, {screen.x, height + 2.0f * kTextMargin}}, kBack, kPanelLayer);
}

}  // namespace plumb
