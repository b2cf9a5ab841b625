#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/result.hpp"
#include "math/tile_grid.hpp"
#include "physics/terrain/grid_point.hpp"

namespace plumb::physics {

/// The outline of a cell. "Up" and "Down" are seen from left to right; Low and High are the two halves of a
/// slope that takes two cells. What a palette adds comes after `Count`.
enum class TileForm : std::uint16_t {
    Empty,
    Full,
    OneWay,
    SlopeUp,
    SlopeDown,
    SlopeUpLow,
    SlopeUpHigh,
    SlopeDownHigh,
    SlopeDownLow,
    HalfTop,
    HalfBottom,
    HalfLeft,
    HalfRight,
    Count
};

/// The side that a one-way form stops bodies on; they pass from all others.
enum class OneWay : std::uint8_t { No, Up, Right, Down, Left };

/// Out of the side that stops: a ShapeDefinition::oneWayDirection. {0, 0} for No.
constexpr GridPoint directionOf(OneWay side) {
    constexpr GridPoint kDirections[] = {{0, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    return kDirections[static_cast<int>(side)];
}

/// What the surface of cells is like.
struct TileMaterial {
    float friction = 0.6f;      ///< Coulomb coefficient, 0..100
    float bounciness = 0.0f;    ///< ratio of speed kept by a bounce, 0..1
    float surfaceSpeed = 0.0f;  ///< m/s along the surface, in the direction of its segments
    std::uint32_t user = 0;     ///< the owner's own number, e.g. of a sound

    friend constexpr bool operator==(const TileMaterial&, const TileMaterial&) = default;
};

/// Whom cells meet, as in a ShapeDefinition.
struct TileLayers {
    std::uint32_t layers = 1;          ///< bits: what they are
    std::uint32_t mask = 0xffffffffu;  ///< bits: what they meet

    friend constexpr bool operator==(const TileLayers&, const TileLayers&) = default;
};

/// The part of a side of a cell that a solid form fills (units, from left to right or from top to bottom).
/// Empty where a corner only touches the side, and where nothing does: then at a corner of the cell.
struct SideSpan {
    std::int32_t from = 0;
    std::int32_t to = 0;

    [[nodiscard]] constexpr bool empty() const { return from >= to; }
    friend constexpr bool operator==(SideSpan, SideSpan) = default;
};

/// The sides of a cell, clockwise on screen as its outline runs.
enum Side : std::int8_t { kTop, kRight, kBottom, kLeft, kInside = -1 };

/// A form in numbers: convex corners, clockwise on screen, within the cell.
struct TileOutline {
    static constexpr int kMaxCorners = 8;

    std::array<GridPoint, kMaxCorners> corners{};
    std::array<Side, kMaxCorners> sides{};  ///< on which the edge from each corner lies
    std::array<SideSpan, 4> spans{};        ///< what it fills of each side; nothing where it is one-way
    std::uint8_t count = 0;
    std::uint8_t stops = 0;  ///< bits of the edges that stop bodies: all, but for a one-way form
    OneWay oneWay = OneWay::No;

    [[nodiscard]] bool isSolid() const { return count > 0 && oneWay == OneWay::No; }
    [[nodiscard]] GridPoint corner(int i) const { return corners[static_cast<std::size_t>(i)]; }
    [[nodiscard]] GridPoint cornerAfter(int i) const { return corner(i + 1 < count ? i + 1 : 0); }
    /// Twice its area (units^2).
    [[nodiscard]] std::int64_t doubleArea() const;

    friend bool operator==(const TileOutline&, const TileOutline&) = default;
};

/// What the cells of a terrain can be: forms, materials and layers by number. Number 0 is the empty form, the
/// default material and the default layers. It only grows, so numbers stay valid; what it has already is
/// found, not added again.
class TilePalette {
public:
    static constexpr std::size_t kMaxForms = 16384;
    static constexpr std::size_t kMaxMaterials = 256;
    static constexpr std::size_t kMaxLayers = 255;

    TilePalette();

    /// A form of a set's own, in parts of a cell (0..1 from its top-left corner), in either order. Corners
    /// within 1/256 of a border are on it: so carelessly drawn tiles close their seams.
    /// @error not a convex polygon of 3 to 8 corners inside the cell, or too many forms
    Result<TileForm> addPolygon(std::span<const Vec2> points, OneWay oneWay = OneWay::No);

    /// The form flipped as a cell of a TileGrid is. One-way forms stay solid from the same side.
    /// @param flips  bits of kTileFlips
    /// @error too many forms
    Result<TileForm> flipped(TileForm form, TileCell flips);

    /// The form, solid from one side only, or (No) from all.
    /// @error too many forms
    Result<TileForm> withOneWay(TileForm form, OneWay oneWay);

    /// @error a number is out of its range, or too many materials
    Result<std::uint8_t> addMaterial(const TileMaterial& material);
    /// @error too many layers
    Result<std::uint8_t> addLayers(const TileLayers& layers);

    [[nodiscard]] const TileOutline& outline(TileForm form) const {
        return forms_[static_cast<std::size_t>(form)];
    }
    [[nodiscard]] const TileMaterial& material(std::uint8_t number) const { return materials_[number]; }
    [[nodiscard]] const TileLayers& layers(std::uint8_t number) const { return layers_[number]; }

    [[nodiscard]] bool hasForm(TileForm form) const { return static_cast<std::size_t>(form) < forms_.size(); }
    [[nodiscard]] bool hasMaterial(std::uint8_t number) const { return number < materials_.size(); }
    [[nodiscard]] bool hasLayers(std::uint8_t number) const { return number < layers_.size(); }

    /// Whoever meets `covered` meets `cover` too.
    [[nodiscard]] bool covers(std::uint8_t cover, std::uint8_t covered) const;

private:
    Result<TileForm> add(const TileOutline& outline);

    std::vector<TileOutline> forms_;
    std::vector<TileMaterial> materials_;
    std::vector<TileLayers> layers_;
};

}  // namespace plumb::physics
