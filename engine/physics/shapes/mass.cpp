#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

/// Area, first and second moment of area of all parts about one point.
struct Moments {
    double area = 0.0;
    Double2 first;
    double second = 0.0;

    void addTriangle(Double2 a, Double2 b) {  // its third corner is the origin
        const double part = 0.5 * cross(a, b);
        area += part;
        first = first + (a + b) * (part / 3.0);
        second += part / 6.0 * (dot(a, a) + dot(a, b) + dot(b, b));
    }
    void addStrip(Double2 start, Double2 end, Double2 normal, double width) {
        const Double2 displacement = end - start;
        const double part = std::sqrt(dot(displacement, displacement)) * width;
        const Double2 middle = (start + end) * 0.5 + normal * (0.5 * width);
        area += part;
        first = first + middle * part;
        second += part * ((dot(displacement, displacement) + width * width) / 12.0 + dot(middle, middle));
    }
    void addSector(Double2 corner, Double2 from, Double2 to, double angle, double radius) {
        const double part = 0.5 * angle * radius * radius;
        const double cube = radius * radius * radius / 3.0;
        const Double2 moment{cube * (to.y - from.y), cube * (from.x - to.x)};  // about the corner
        area += part;
        first = first + moment + corner * part;
        second += 0.5 * part * radius * radius + 2.0 * dot(corner, moment) + part * dot(corner, corner);
    }
};

/// Sums the moments of the core, of a strip along each face and of a sector at each corner.
Moments momentsOf(const Convex& convex) {
    const std::span<const Corner> corners = convex.corners();
    const Double2 origin = wide(corners[0].point);
    const auto radius = static_cast<double>(convex.radius);
    Moments sum;
    if (convex.count == 1) {
        sum.addSector({}, {}, {}, static_cast<double>(kTau), radius);
        return sum;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 before = corners[i > 0 ? i - 1 : corners.size() - 1].normal;
        const Corner& corner = corners[i];
        const Corner& after = corners[i + 1 < corners.size() ? i + 1 : 0];
        const Double2 here = wide(corner.point) - origin;
        const Double2 next = wide(after.point) - origin;
        sum.addTriangle(here, next);
        if (!(radius > 0.0)) continue;
        sum.addStrip(here, next, wide(corner.normal), radius);
        const float angle = arcTangent(std::fabs(cross(before, corner.normal)), dot(before, corner.normal));
        sum.addSector(here, wide(before), wide(corner.normal), double{angle}, radius);
    }
    return sum;
}

}  // namespace

MassProperties massProperties(const Geometry& geometry, std::span<const Corner> corners, float density) {
    const Convex convex = convexOf(geometry, corners);
    const Moments sum = momentsOf(convex);
    MassProperties mass{.centre = convex.centre};
    if (!(sum.area > 0.0)) return mass;
    const Double2 centre = sum.first * (1.0 / sum.area);
    const Vec2 origin = convex.corners()[0].point;
    mass.centre = {static_cast<float>(static_cast<double>(origin.x) + centre.x),
                   static_cast<float>(static_cast<double>(origin.y) + centre.y)};
    if (!(density > 0.0f)) return mass;
    const auto perArea = static_cast<double>(density);
    mass.mass = static_cast<float>(perArea * sum.area);
    mass.inertia = static_cast<float>(perArea * (sum.second - sum.area * dot(centre, centre)));
    return mass;
}

}  // namespace plumb::physics
