#pragma once

#include "import/tiled_map.hpp"

namespace plumb {

/// The plane of an isometric map, in which its objects have their coordinates. On both axes its unit, as in
/// Tiled, is the height of a cell.
class IsometricPlane {
public:
    /// @param width, height  cell as seen on the screen, px
    /// @param originX        px: where the plane's origin is on the screen; half a cell for each row of the
    /// map
    IsometricPlane(int width, int height, double originX)
        : width_{static_cast<double>(width)}, height_{static_cast<double>(height)}, originX_{originX} {}
    [[nodiscard]] static IsometricPlane of(const tiled::Map& map);

    [[nodiscard]] Vec2 onScreen(double x, double y) const;   ///< of a point
    [[nodiscard]] Vec2 direction(double x, double y) const;  ///< of the difference of two points

    /// Moves an object to where Tiled draws it. Areas become polygons; what has no area keeps its shape.
    void project(tiled::Object& object) const;

private:
    double width_;
    double height_;
    double originX_;
};

}  // namespace plumb
