#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "editor/model/tiles/tileset_edit.hpp"
#include "editor/ui/panels/tileset_panel.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/tile_picture.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::array<const char*, 11> kShapeWords{"No collision",
                                                  "Solid",
                                                  "Solid from above only",
                                                  "Slope up to the right",
                                                  "Slope down to the right",
                                                  "Lower half of a two-tile slope up",
                                                  "Upper half of a two-tile slope up",
                                                  "Upper half of a two-tile slope down",
                                                  "Lower half of a two-tile slope down",
                                                  "Upper half solid",
                                                  "Lower half solid"};

const Tile& firstOf(const Tileset& tileset, std::span<const int> chosen) {
    static const Tile plain;
    const Tile* known = chosen.empty() ? nullptr : tileset.find(chosen.front());
    return known == nullptr ? plain : *known;
}

/// True if the selected tiles differ in a property.
template <class Get>
bool isMixed(const Tileset& tileset, std::span<const int> chosen, Get get) {
    return std::any_of(chosen.begin(), chosen.end(), [&](int tile) {
        const std::array one{tile};
        return !(get(firstOf(tileset, one)) == get(firstOf(tileset, chosen)));
    });
}

/// Changes all selected tiles in one undo step.
template <class Change>
void changeTiles(Ui& ui, const char* label, std::span<const int> chosen, Change change) {
    const std::vector<int> tiles{chosen.begin(), chosen.end()};
    changeTileset(ui.workspace, label, [&](Tileset& set) {
        for (const int tile : tiles) change(tileIn(set, tile));
    });
    ui.workspace.undo.endGesture();
}

bool shapeButton(Ui& ui, TileShape shape, bool on) {
    const float side = ui.px(26.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string_view name = tileShapeNames()[static_cast<std::size_t>(shape)];
    const std::string path = "Tileset/collision/" + std::string{name};
    const bool clicked = ImGui::InvisibleButton(path.c_str(), {side, side});
    ui.widgets.mark(path, on ? "on" : "");
    tooltip(kShapeWords[static_cast<std::size_t>(shape)]);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + side, at.y + side}, palette::kField, ui.px(3.0f));
    outline(list, at, {at.x + side, at.y + side}, palette::kBorder, ui.px(3.0f));
    const float inset = ui.px(5.0f);
    const float room = side - 2.0f * inset;
    Tile tile;
    tile.shape = shape;
    std::vector<ImVec2> corners;
    for (const std::vector<Vec2>& points : outlinesOf(tile, {room, room})) {
        for (const Vec2 point : points) corners.push_back({at.x + inset + point.x, at.y + inset + point.y});
    }
    const ImU32 color = on ? palette::kAccent : palette::kTextDim;
    if (shape == TileShape::OneWay) {
        list.AddLine({at.x + inset, at.y + inset + 1.0f}, {at.x + side - inset, at.y + inset + 1.0f}, color,
                     2.0f);
        list.AddTriangleFilled({at.x + side * 0.5f, at.y + side * 0.45f},
                               {at.x + side * 0.32f, at.y + side * 0.75f},
                               {at.x + side * 0.68f, at.y + side * 0.75f}, color);
    } else if (corners.size() >= 3) {
        list.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), color);
    } else {
        list.AddLine({at.x + inset, at.y + side - inset}, {at.x + side - inset, at.y + inset}, color, 1.5f);
    }
    if (on || ImGui::IsItemHovered())
        outline(list, at, {at.x + side, at.y + side}, on ? palette::kAccent : palette::kTextDim, ui.px(3.0f),
                1.5f);
    return clicked;
}

void drawShapes(Ui& ui, const Tileset& tileset, std::span<const int> chosen) {
    ImGui::TextDisabled("Collision");
    const bool mixed = isMixed(tileset, chosen, [](const Tile& tile) { return tile.shape; });
    const TileShape now = firstOf(tileset, chosen).shape;
    for (std::size_t i = 0; i < kShapeWords.size(); ++i) {
        const auto shape = static_cast<TileShape>(i);
        if (i > 0) ImGui::SameLine(0.0f, ui.px(2.0f));
        if (!shapeButton(ui, shape, !mixed && now == shape)) continue;
        const std::vector<int> tiles{chosen.begin(), chosen.end()};
        changeTileset(ui.workspace, "set collision", [&](Tileset& set) { setShape(set, tiles, shape); });
        ui.workspace.undo.endGesture();
    }
}

/// Edits the collision polygons of the first selected tile: drag
/// moves a corner, double-click adds one, right-click removes one.
class PolygonEditor {
public:
    void draw(Ui& ui, const Tileset& tileset, std::span<const int> chosen) {
        const Vec2 size{static_cast<float>(tileset.tileWidth), static_cast<float>(tileset.tileHeight)};
        const float zoom = std::floor(ui.px(128.0f) / std::max(size.x, size.y));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        from_ = {at.x, at.y};
        zoom_ = zoom;
        const bool clicked = ImGui::InvisibleButton("polygon", {size.x * zoom, size.y * zoom});
        static_cast<void>(clicked);
        ui.widgets.mark("Tileset/polygon", format("{}", polygons_.empty() ? 0 : polygons_.front().size()));
        tooltip("Drag a corner to move it; double-click adds one, right-click removes one.");
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + size.x * zoom, at.y + size.y * zoom}, palette::kCanvas);
        drawTile(ui, list, tileset, cellOf(chosen.front()), {from_, from_ + size * zoom});
        if (!grabbed_) polygons_ = outlinesOf(firstOf(tileset, chosen), size);
        const bool changed = edit(size);
        drawPoints(list);
        if (!changed) return;
        const std::vector<int> tiles{chosen.begin(), chosen.end()};
        changeTileset(ui.workspace, "edit collision shape",
                      [&](Tileset& set) { setPolygons(set, tiles, polygons_); });
        ui.workspace.undo.endGesture();
    }

private:
    struct Corner {
        std::size_t polygon = 0;
        std::size_t index = 0;  // in the polygon
    };

    [[nodiscard]] Vec2 mouse(Vec2 size) const {
        const ImVec2 at = ImGui::GetIO().MousePos;
        const Vec2 point = (Vec2{at.x, at.y} - from_) / zoom_;
        return {std::clamp(std::round(point.x), 0.0f, size.x), std::clamp(std::round(point.y), 0.0f, size.y)};
    }
    /// Returns the corner at a point.
    [[nodiscard]] std::optional<Corner> nearest(Vec2 point) const {
        for (std::size_t p = 0; p < polygons_.size(); ++p) {
            for (std::size_t i = 0; i < polygons_[p].size(); ++i) {
                if (lengthSquared(polygons_[p][i] - point) <= 2.5f) return Corner{p, i};
            }
        }
        return std::nullopt;
    }
    /// Applies mouse input. @return true if a change of the shape is complete
    bool edit(Vec2 size) {
        const Vec2 point = mouse(size);
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && !nearest(point)) return insert(point);
        if (ImGui::IsItemActivated()) grabbed_ = nearest(point);
        if (const auto corner = nearest(point);
            corner && ImGui::IsItemHovered() && ImGui::IsMouseClicked(1)) {
            std::vector<Vec2>& points = polygons_[corner->polygon];
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(corner->index));
            grabbed_.reset();  // its index may be that of another corner now, or of none
            return true;
        }
        if (!grabbed_) return false;
        polygons_[grabbed_->polygon][grabbed_->index] = point;
        if (ImGui::IsItemActive()) return false;
        grabbed_.reset();
        return true;
    }
    /// Inserts a corner into the nearest side; without a shape, creates a triangle.
    bool insert(Vec2 point) {
        if (polygons_.empty()) {
            polygons_ = {{point, point + Vec2{6.0f, 0.0f}, point + Vec2{0.0f, 6.0f}}};
            return true;
        }
        Corner best;
        float least = 1e30f;
        for (std::size_t p = 0; p < polygons_.size(); ++p) {
            const std::vector<Vec2>& points = polygons_[p];
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vec2 along = points[(i + 1) % points.size()] - points[i];
                const float t = std::clamp(
                    dot(point - points[i], along) / std::max(lengthSquared(along), 1e-6f), 0.0f, 1.0f);
                const float away = lengthSquared(points[i] + along * t - point);
                if (away < least) least = away, best = {p, i};
            }
        }
        std::vector<Vec2>& points = polygons_[best.polygon];
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(best.index) + 1, point);
        return true;
    }
    void drawPoints(ImDrawList& list) const {
        const auto placed = [&](Vec2 corner) {
            const Vec2 point = from_ + corner * zoom_;
            return ImVec2{point.x, point.y};
        };
        for (const std::vector<Vec2>& points : polygons_) {
            for (std::size_t i = 0; i < points.size(); ++i)
                list.AddLine(placed(points[i]), placed(points[(i + 1) % points.size()]), palette::kPlay,
                             2.0f);
            for (const Vec2 point : points) list.AddCircleFilled(placed(point), 4.0f, palette::kText);
        }
    }

    std::vector<std::vector<Vec2>> polygons_;
    Vec2 from_;
    float zoom_ = 1.0f;
    std::optional<Corner> grabbed_;  // the corner that is dragged
};

void labelBefore(const Ui& ui, const char* label) {
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + ui.px(78.0f));
}

/// Draws a number of the selected tiles; it is saved when Enter is pressed or the field loses focus.
void drawNumber(Ui& ui, const Tileset& tileset, std::span<const int> chosen, const char* label,
                float Tile::*member, float least, const char* words) {
    const bool mixed = isMixed(tileset, chosen, [&](const Tile& tile) { return tile.*member; });
    float value = firstOf(tileset, chosen).*member;
    labelBefore(ui, label);
    ImGui::SetNextItemWidth(ui.px(84.0f));
    const char* shown = mixed ? "-" : value < 0.0f ? "as layer" : "%.2f";
    ImGui::InputFloat(format("##{}", label).c_str(), &value, 0.0f, 0.0f, shown);
    ui.widgets.mark(std::string{"Tileset/"} + label, mixed ? "-" : format("{}", value));
    tooltip(words);
    if (ImGui::IsItemDeactivatedAfterEdit() && std::isfinite(value))
        changeTiles(ui, "set tiles", chosen, [&](Tile& tile) { tile.*member = std::max(value, least); });
}

class TileMeaningPage final : public TilesetPage {
public:
    void draw(Ui& ui, const Tileset& tileset, std::span<const int> chosen) override {
        if (chosen.empty()) {
            ImGui::TextWrapped("Select tiles on the left: click, drag a box, or Shift+click to add.");
            return;
        }
        ImGui::TextUnformatted(chosen.size() == 1 ? format("Tile {}", chosen.front()).c_str()
                                                  : format("{} tiles", chosen.size()).c_str());
        ui.widgets.mark("Tileset/chosen", format("{}", chosen.size()));
        drawShapes(ui, tileset, chosen);
        polygon_.draw(ui, tileset, chosen);
        ImGui::SameLine(0.0f, ui.px(10.0f));
        ImGui::BeginGroup();
        bool oneWay = firstOf(tileset, chosen).oneWay;
        labelBefore(ui, "one-way");
        if (ImGui::Checkbox("##one-way", &oneWay))
            changeTiles(ui, "set one-way", chosen, [&](Tile& tile) { tile.oneWay = oneWay; });
        ui.widgets.mark("Tileset/oneWay", oneWay ? "on" : "off");
        tooltip("Makes the tile solid from above only; works with every collision shape.");
        drawNumber(ui, tileset, chosen, "friction", &Tile::friction, -1.0f,
                   "Friction coefficient; 0: no friction; -1: the value of the layer's TileCollider.");
        drawNumber(
            ui, tileset, chosen, "bounciness", &Tile::bounciness, -1.0f,
            "Restitution, 0 to 1: ratio of speeds after and before impact; -1: the TileCollider's value.");
        drawNumber(ui, tileset, chosen, "probability", &Tile::probability, 0.0f,
                   "Relative weight among terrain variants and in random painting; 0: never used.");
        ImGui::EndGroup();
        drawProperties(ui, tileset, chosen);
    }

private:
    void drawProperties(Ui& ui, const Tileset& tileset, std::span<const int> chosen) {
        ImGui::TextDisabled("Properties");
        const std::vector<int> tiles{chosen.begin(), chosen.end()};
        for (const TileProperty& property : firstOf(tileset, chosen).properties) {
            ImGui::PushID(property.name.c_str());
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted(format("{} = {}", property.name, property.json).c_str());
            ui.widgets.mark("Tileset/property/" + property.name, property.json);
            ImGui::SameLine();
            const bool removes = ImGui::SmallButton("x");
            ui.widgets.mark("Tileset/property/" + property.name + "/remove");
            ImGui::PopID();
            if (!removes) continue;
            const std::string removed = property.name;
            changeTileset(ui.workspace, "remove property",
                          [&](Tileset& set) { setProperty(set, tiles, removed, ""); });
            ui.workspace.undo.endGesture();
            return;
        }
        ImGui::SetNextItemWidth(ui.px(96.0f));
        ImGui::InputTextWithHint("##name", "name", name_.data(), name_.size());
        ui.widgets.mark("Tileset/newName");
        ImGui::SameLine(0.0f, ui.px(4.0f));
        ImGui::SetNextItemWidth(ui.px(96.0f));
        ImGui::InputTextWithHint("##value", "true", value_.data(), value_.size());
        ui.widgets.mark("Tileset/newValue");
        ImGui::SameLine(0.0f, ui.px(4.0f));
        const bool add = ImGui::Button("Add") && name_[0] != 0;
        ui.widgets.mark("Tileset/addProperty");
        if (!add) return;
        const std::string json = propertyJson(value_.data());
        changeTileset(ui.workspace, "add property",
                      [&](Tileset& set) { setProperty(set, tiles, name_.data(), json); });
        ui.workspace.undo.endGesture();
        name_[0] = value_[0] = 0;
    }

    PolygonEditor polygon_;
    std::array<char, 64> name_{};    // name of the new property
    std::array<char, 128> value_{};  // value of the new property
};

}  // namespace

std::unique_ptr<TilesetPage> makeTileMeaningPage() { return std::make_unique<TileMeaningPage>(); }

}  // namespace plumb::editor::ui
