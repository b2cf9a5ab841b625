#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "physics/debug_draw.hpp"
#include "physics/workspace.hpp"
#include "scene/drawing/physics_drawing.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/physics_times.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {
namespace {

constexpr float kLinesOfPicture = 1080.0f;  // px: the panel scales with whole multiples of this screen height
constexpr float kFewLines = 540.0f;         // px: below this screen height the panel is scaled down
constexpr float kPanelTextSize = 13.0f;     // px
constexpr float kRow = 17.0f;               // px, height of a row
constexpr float kSwatch = 9.0f;             // px, side of a colour square in the legend
constexpr float kPanelGap = 8.0f;           // px, margin
constexpr float kLegendWidth = 120.0f;      // px, width of a column of the legend
constexpr float kNumbersWidth = 236.0f;     // px, width of a column of the tables of numbers
constexpr Color kBack{16, 18, 22, 205};
constexpr Color kText{232, 234, 238, 255};
constexpr Color kDim{150, 156, 168, 255};
constexpr int kBackLayer = 0;
constexpr int kTextLayer = 1;

/// Returns the scale of the panel: screen px per panel px.
float unitOf(Vec2 screen) {
    if (screen.y < kFewLines) return std::max(0.6f, screen.y / kFewLines);
    return std::max(1.0f, std::floor(screen.y / kLinesOfPicture));
}

/// A table of text rows in one or more columns.
class Panel {
public:
    void color(std::string_view label, Color color) { add({Kind::Color, label, color}); }
    void heading(std::string_view words) {
        if (count_ > 0) add({});
        add({Kind::Heading, words});
    }
    void number(std::string_view label, std::size_t value) {
        Row row{Kind::Number, label};
        row.end = std::to_chars(row.value.data(), row.value.data() + row.value.size(), value).ptr -
                  row.value.data();
        add(row);
    }
    /// @param value  time, ms
    void time(std::string_view label, float value) {
        Row row{Kind::Number, label};
        row.end = std::to_chars(row.value.data(), row.value.data() + row.value.size(), value,
                                std::chars_format::fixed, 3)
                      .ptr -
                  row.value.data();
        add(row);
    }

    /// Placement at the bottom of the screen, as games often show texts at the top.
    struct Stand {
        float width = 0.0f;  ///< px, width of a column
        bool right = false;  ///< right side, as few columns as possible; else left side, as many as fit
        float free = 0.0f;   ///< panel px at the side that are left free for other panels
    };
    void draw(LabelDrawing& labels, DrawList& list, const Stand& stand) const;
    /// Returns the width of the panel, panel px.
    [[nodiscard]] float widthOn(Vec2 screen, const Stand& stand) const {
        return stand.width * static_cast<float>(shapeOn(screen, stand).columns);
    }

private:
    enum class Kind : std::uint8_t { Color, Heading, Number };
    struct Row {
        Kind kind = Kind::Heading;
        std::string_view label;
        Color swatch;
        std::array<char, 24> value{};
        std::ptrdiff_t end = 0;
    };

    struct Shape {
        std::size_t columns = 0;
        std::size_t high = 1;  ///< rows per column
    };
    [[nodiscard]] Shape shapeOn(Vec2 screen, const Stand& stand) const;
    void add(const Row& row) {
        if (count_ < rows_.size()) rows_[count_++] = row;
    }

    std::array<Row, 64> rows_;
    std::size_t count_ = 0;
};

Panel::Shape Panel::shapeOn(Vec2 screen, const Stand& stand) const {
    const float unit = unitOf(screen);
    const auto room = [](float size, float part) {
        return static_cast<std::size_t>(std::max(1.0f, size / part));
    };
    const std::size_t most = room(screen.y / unit - 4.0f * kPanelGap, kRow);
    const std::size_t broadest = room(screen.x / unit - stand.free - 2.0f * kPanelGap, stand.width);
    const std::size_t fewest = std::max<std::size_t>(1, (count_ + most - 1) / most);
    const std::size_t wanted = stand.right ? fewest : std::max(fewest, broadest);
    const std::size_t high = std::max<std::size_t>(1, (count_ + wanted - 1) / wanted);
    return {(count_ + high - 1) / high, high};
}

void Panel::draw(LabelDrawing& labels, DrawList& list, const Stand& stand) const {
    if (count_ == 0) return;
    const Vec2 screen = list.view().size;
    const float unit = unitOf(screen);
    const float width = stand.width;
    const auto [columns, high] = shapeOn(screen, stand);
    const Vec2 size =
        Vec2{width * static_cast<float>(columns), kRow * static_cast<float>(high) + 2.0f * kPanelGap} * unit;
    const float margin = kPanelGap * unit;
    const Vec2 corner{stand.right ? screen.x - size.x - margin : margin, screen.y - size.y - margin};
    list.filledRect({corner, corner + size}, kBack, kBackLayer);
    labels.setPixelScale(1.0f);
    TextStyle style;
    style.shape.size = kPanelTextSize * unit;
    style.layer = kTextLayer;
    for (std::size_t i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        const Vec2 at = corner + Vec2{width * static_cast<float>(i / high),
                                      kPanelGap + kRow * static_cast<float>(i % high)} *
                                     unit;
        const auto write = [&](std::string_view words, float x, TextAlign align) {
            style.shape.align = align;
            style.color = row.kind == Kind::Heading ? kDim : kText;
            labels.write(words, at + Vec2{x * unit, 0.0f}, style, list);
        };
        float left = kPanelGap;
        if (row.kind == Kind::Color) {
            const Vec2 swatch = at + Vec2{kPanelGap, (kRow - kSwatch) * 0.5f} * unit;
            list.filledRect({swatch, swatch + Vec2{kSwatch, kSwatch} * unit}, row.swatch, kTextLayer);
            left += kSwatch + kPanelGap;
        }
        write(row.label, left, TextAlign::Left);
        if (row.end > 0)
            write({row.value.data(), static_cast<std::size_t>(row.end)}, width - kPanelGap, TextAlign::Right);
    }
}

void writeTimes(const PhysicsTimes* times, Panel& panel) {
    const bool known = times != nullptr && !times->rows().empty();
    panel.heading(known ? "ms per tick" : "times: only while playing");
    if (!known) return;
    float all = 0.0f;
    for (const PhysicsTimes::Row& row : times->rows()) {
        all += row.milliseconds;
        panel.time(row.stage, row.milliseconds);
    }
    panel.time("all", all);
}

struct BodyCounts {
    std::size_t awake = 0;
    std::size_t asleep = 0;
    std::size_t driven = 0;
    std::size_t fixed = 0;
    std::size_t islands = 0;  // number of awake islands
};

BodyCounts countBodies(const physics::World& world) {
    BodyCounts counts;
    for (std::uint32_t body = 0; body < world.bodies.size(); ++body) {
        const physics::BodyInfo& info = world.bodies.info[body];
        if (info.kind == physics::BodyKind::Static) ++counts.fixed;
        if (info.kind == physics::BodyKind::Kinematic) ++counts.driven;
        if (info.kind != physics::BodyKind::Dynamic) continue;
        const bool asleep = world.sleepers.islandOf[body] != physics::kNone;
        ++(asleep ? counts.asleep : counts.awake);
        if (!asleep && info.island == body) ++counts.islands;
    }
    return counts;
}

void writePairs(const physics::DetectionCounts& counts, Panel& panel) {
    panel.heading("pairs per tick");
    panel.number("bounds overlap", counts.pairs);
    panel.number("apart by circles", counts.apartByCircles);
    panel.number("apart by boxes", counts.apartByBounds);
    panel.number("apart by axes", counts.apartByAxes);
    panel.number("points reused", counts.recycled);
    panel.number("touching", counts.touching);
}

/// @param last  workspace of the last step; null if it is no longer known
void writeCounts(const physics::World& world, const physics::Workspace* last, Panel& panel) {
    const BodyCounts bodies = countBodies(world);
    panel.heading("bodies");
    panel.number("awake", bodies.awake);
    panel.number("asleep", bodies.asleep);
    panel.number("kinematic", bodies.driven);
    panel.number("static", bodies.fixed);
    panel.number("shapes", world.shapes.size() - world.shapes.free.size());
    panel.number("contacts awake", world.contacts.size());
    panel.number("joints", world.joints.size() - world.joints.free.size());
    panel.number("islands awake", bodies.islands);
    panel.number("islands asleep", world.sleepers.islands.size() - world.sleepers.freeIslands.size());
    // A sleeping world is not stepped, so its workspace is that of the last tick with an awake body.
    const physics::Workspace* work = world.awake.empty() ? nullptr : last;
    writePairs(work != nullptr ? work->counts : physics::DetectionCounts{}, panel);
}

}  // namespace

void drawPhysicsPanel(const World& world, const PhysicsShown& shown, LabelDrawing& labels, DrawList& list) {
    if (shown.any() == 0) return;
    Panel legend, numbers;
    for (const PhysicsColor& row : physicsColors()) {
        if ((row.layer & shown.any()) != 0) legend.color(row.label, row.color);
    }
    if ((shown.any() & kPhysicsTimes) != 0) writeTimes(shown.times, numbers);
    auto* running = world.findResource<PhysicsState>();
    const PhysicsState* state = lowestPhysics(world);
    if ((shown.any() & kPhysicsCounts) != 0 && state != nullptr)
        writeCounts(state->world, state == running ? physics::lastStepOf(running->world) : nullptr, numbers);
    const Panel::Stand right{kNumbersWidth, true, 0.0f};
    const float taken = numbers.widthOn(list.view().size, right) + 2.0f * kPanelGap;
    legend.draw(labels, list, {kLegendWidth, false, taken});
    numbers.draw(labels, list, right);
}

}  // namespace plumb
