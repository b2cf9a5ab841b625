#include "tests/accuracy/reference/gradient.hpp"

namespace plumb::reference {

namespace {

/// Returns the gradient of dot(direction, point of B - point of A); the
/// points are at offsets `a` and `b` from the centres of mass.
Gradient alongDirection(Point direction, Point a, Point b) {
    return {{-direction.x, -direction.y, -cross(a, direction)},
            {direction.x, direction.y, cross(b, direction)}};
}

Gradient lengthOf(const Measure& measure, Triple poseA, Triple poseB, Point armA, Point armB) {
    const Point way = (placeOf(poseB) + armB) - (placeOf(poseA) + armA);
    Gradient gradient = alongDirection(normalized(way), armA, armB);
    gradient.value = length(way) - measure.rest;
    return gradient;
}

Gradient pulleyOf(const Measure& measure, Triple poseA, Triple poseB, Point armA, Point armB) {
    const Point ropeA = (placeOf(poseA) + armA) - measure.groundA;
    const Point ropeB = (placeOf(poseB) + armB) - measure.groundB;
    const Point a = normalized(ropeA), b = measure.ratio * normalized(ropeB);
    return {{a.x, a.y, cross(armA, a)},
            {b.x, b.y, cross(armB, b)},
            length(ropeA) + measure.ratio * length(ropeB) - measure.rest};
}

}  // namespace

Gradient gradientOf(const Measure& measure, Triple poseA, Triple poseB) {
    if (measure.kind == MeasureKind::Angle)
        return {{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, poseB.turn - poseA.turn - measure.rest};
    const Turn rotationA{poseA.turn};
    const Point armA = rotate(rotationA, measure.anchorA), armB = rotate(Turn{poseB.turn}, measure.anchorB);
    if (measure.kind == MeasureKind::Length) return lengthOf(measure, poseA, poseB, armA, armB);
    if (measure.kind == MeasureKind::Pulley) return pulleyOf(measure, poseA, poseB, armA, armB);
    const Point way = (placeOf(poseB) + armB) - (placeOf(poseA) + armA);
    const bool slides = measure.kind == MeasureKind::Across || measure.kind == MeasureKind::Along;
    Point direction = slides ? rotate(rotationA, measure.axis) : measure.axis;
    if (measure.kind == MeasureKind::Across || measure.kind == MeasureKind::AnchorY)
        direction = perpendicular(direction);
    // If the direction rotates with A, the arm of A extends to B's anchor.
    Gradient gradient = alongDirection(direction, slides ? armA + way : armA, armB);
    gradient.value = dot(direction, way) - measure.rest;
    return gradient;
}

TouchView viewOf(const Touch& touch, Triple poseA, Triple poseB) {
    const Point a = apply(poseA, touch.a), b = apply(poseB, touch.b);
    const double round = touch.radiusA + touch.radiusB;
    TouchView view;
    if (touch.hasSide) {
        const Point outward = rotate(Turn{touch.sideOfA ? poseA.turn : poseB.turn}, touch.normal);
        view.normal = touch.sideOfA ? outward : -outward;
    } else {
        view.normal = normalized(b - a);
    }
    const double apart = dot(view.normal, b - a);
    view.gap = apart - round;
    // The contact point is midway between the two surfaces, on the normal through the corner.
    const bool fromA = touch.hasSide && !touch.sideOfA;
    view.point = fromA ? a + (touch.radiusA + 0.5 * view.gap) * view.normal
                       : b - (touch.radiusB + 0.5 * view.gap) * view.normal;
    return view;
}

Gradient normalGradient(const TouchView& view, Triple poseA, Triple poseB) {
    Gradient gradient = alongDirection(view.normal, view.point - placeOf(poseA), view.point - placeOf(poseB));
    gradient.value = view.gap;
    return gradient;
}

Gradient tangentGradient(const TouchView& view, Triple poseA, Triple poseB) {
    return alongDirection(perpendicular(view.normal), view.point - placeOf(poseA),
                          view.point - placeOf(poseB));
}

}  // namespace plumb::reference
