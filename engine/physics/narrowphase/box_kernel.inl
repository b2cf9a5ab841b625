// Two boxes, as a template over the number type: one float, or eight in lanes. It is written once, so that
// both give the same bits, and without branches on values, so that it works on lanes. Included in a namespace
// that has all(), abs(), min(), max(), sqrt(), select() and any() for the number type and its mask.
//
// Source: separating axes of boxes after S. Gottschalk, M. Lin, D. Manocha, "OBBTree", 1996, 5; the incident
// edge is clipped after E. Catto, "Contact Manifolds", GDC 2007.

/// Two boxes in a frame with A's centre and axes.
template <class F>
struct BoxPair {
    F halfAx, halfAy, halfBx, halfBy;  // m
    F x, y;                            // m: B's centre
    F cosine, sine;                    // B's rotation
    F radiusA, radiusB;                // m
    F speculative;                     // m
};

template <class F>
struct BoxTouch {
    F normalX, normalY;  // from A to B
    F pointX[2], pointY[2], separation[2];
    F id[2];  // corner of A * 256 + corner of B; corners are 0 (-,-), 1 (+,-), 2 (-,+), 3 (+,+)
    F count;
    F roundA, roundB;
};

/// The axis of maximum separation.
template <class F>
struct BoxAxis {
    F gap;          // m: separation of the cores along it
    F ofB, alongY;  // 1 or 0: an axis of B; the y axis of that box
};

template <class F>
BoxAxis<F> bestAxis(const BoxPair<F>& p, F qx, F qy) {
    const F c = abs(p.cosine);
    const F s = abs(p.sine);
    const F aX = abs(p.x) - p.halfAx - (c * p.halfBx + s * p.halfBy);
    const F aY = abs(p.y) - p.halfAy - (s * p.halfBx + c * p.halfBy);
    const F bX = abs(qx) - p.halfBx - (c * p.halfAx + s * p.halfAy);
    const F bY = abs(qy) - p.halfBy - (s * p.halfAx + c * p.halfAy);
    // As faceTieOf() of the smallest half size.
    const F tie =
        min(all<F>(kMaxFaceTie), all<F>(kFaceTie) * min(min(p.halfAx, p.halfAy), min(p.halfBx, p.halfBy)));
    const F zero = all<F>(0.0f);
    const F one = all<F>(1.0f);
    const auto aIsY = aY > aX + tie;
    const auto bIsY = bY > bX + tie;
    const F a = select(aIsY, aY, aX);
    const F b = select(bIsY, bY, bX);
    const auto isB = b > a + tie;
    const F yOfA = select(aIsY, one, zero);
    const F yOfB = select(bIsY, one, zero);
    return {select(isB, b, a), select(isB, one, zero), select(isB, yOfB, yOfA)};
}

/// The boxes seen from the reference face: n is its outward normal, towards the other box, t the direction
/// along it.
template <class F>
struct BoxView {
    F n, t;             // centre of the other box
    F half, halfAlong;  // of the reference box
    F flip;             // -1 if n is a negative axis of the reference box, else 1
    F lowN, lowT;       // ends of the incident edge; t increases from low to high
    F highN, highT;
    F slope, midN, midT;      // of the incident edge
    F cornerLow, cornerHigh;  // of the reference box
    F otherLow, otherHigh;    // of the other
};

template <class F>
BoxView<F> viewFrom(const BoxPair<F>& p, const BoxAxis<F>& axis, F qx, F qy) {
    const F zero = all<F>(0.0f);
    const F one = all<F>(1.0f);
    const F two = all<F>(2.0f);
    const auto ofB = axis.ofB > zero;
    const auto alongY = axis.alongY > zero;
    const F sine = select(ofB, -p.sine, p.sine);
    const F x = select(ofB, -qx, p.x);
    const F y = select(ofB, -qy, p.y);
    const F halfX = select(ofB, p.halfBx, p.halfAx);
    const F halfY = select(ofB, p.halfBy, p.halfAy);
    const F otherX = select(ofB, p.halfAx, p.halfBx);
    const F otherY = select(ofB, p.halfAy, p.halfBy);

    BoxView<F> v;
    const F towards = select(alongY, y, x);
    v.flip = select(towards < zero, -one, one);
    v.n = abs(towards);
    v.t = select(alongY, x, y);
    v.half = select(alongY, halfY, halfX);
    v.halfAlong = select(alongY, halfX, halfY);

    // The other box's axes x and y: their components along n and t.
    const F xN = v.flip * select(alongY, sine, p.cosine);
    const F xT = select(alongY, p.cosine, sine);
    const F yN = v.flip * select(alongY, p.cosine, -sine);
    const F yT = select(alongY, -sine, p.cosine);
    const auto byX = abs(xN) > abs(yN);  // the incident face is perpendicular to x, not to y
    const F faceN = select(byX, xN, yN);
    const F faceT = select(byX, xT, yT);
    const F sideN = select(byX, yN, xN);
    const F sideT = select(byX, yT, xT);
    const F halfFace = select(byX, otherX, otherY);
    const F halfSide = select(byX, otherY, otherX);
    const auto backwards = faceN > zero;  // the incident face is on the negative side of its axis
    const auto sideBackwards = sideT < zero;
    v.midN = v.n - abs(faceN) * halfFace;
    v.midT = v.t + select(backwards, -faceT, faceT) * halfFace;
    const F alongN = select(sideBackwards, -sideN, sideN);
    const F alongT = abs(sideT);  // at least the square root of 1/2
    v.slope = alongN / alongT;
    v.lowN = v.midN - alongN * halfSide;
    v.lowT = v.midT - alongT * halfSide;
    v.highN = v.midN + alongN * halfSide;
    v.highT = v.midT + alongT * halfSide;

    const F positive = select(v.flip > zero, one, zero);
    v.cornerLow = select(alongY, positive * two, positive);
    v.cornerHigh = v.cornerLow + select(alongY, one, two);
    const F face = select(backwards, zero, one);
    const F low = select(sideBackwards, one, zero);
    v.otherLow = select(byX, face + low * two, face * two + low);
    v.otherHigh = select(byX, face + (one - low) * two, face * two + (one - low));
    return v;
}

/// A manifold in the coordinates of the reference face, before its transformation to A's frame.
template <class F>
struct BoxPlaces {
    F normalN, normalT;
    F n[2], t[2], separation[2];
    F corner[2], other[2];
    F keep[2];  // 1 for a point, 0 for none
    F roundOther, roundReference;
};

template <class F>
BoxPlaces<F> touchFaces(const BoxView<F>& v, F radius, F otherRadius, F speculative) {
    const F zero = all<F>(0.0f);
    const F one = all<F>(1.0f);
    const auto cutLow = v.lowT < -v.halfAlong;
    const auto cutHigh = v.highT > v.halfAlong;
    BoxPlaces<F> w;
    w.normalN = one;
    w.normalT = zero;
    w.t[0] = select(cutLow, -v.halfAlong, v.lowT);
    w.t[1] = select(cutHigh, v.halfAlong, v.highT);
    const F low = select(cutLow, v.midN + v.slope * (w.t[0] - v.midT), v.lowN);
    const F high = select(cutHigh, v.midN + v.slope * (w.t[1] - v.midT), v.highN);
    const F surface = v.half + radius;
    const F half = all<F>(0.5f);
    w.separation[0] = low - otherRadius - surface;
    w.separation[1] = high - otherRadius - surface;
    w.n[0] = surface + half * w.separation[0];
    w.n[1] = surface + half * w.separation[1];
    w.corner[0] = v.cornerLow;
    w.corner[1] = v.cornerHigh;
    w.other[0] = v.otherLow;
    w.other[1] = v.otherHigh;
    const F beside = select(w.t[0] > w.t[1], zero, one);
    w.keep[0] = select(w.separation[0] > speculative, zero, beside);
    w.keep[1] = select(w.separation[1] > speculative, zero, beside);
    // A single point is at a rounded corner, unless clipping moved it.
    const F roundLow = select(cutLow, zero, otherRadius);
    const F roundHigh = select(cutHigh, zero, otherRadius);
    const F alone = select(w.keep[0] > zero, roundLow, roundHigh);
    w.roundOther = select(w.keep[0] + w.keep[1] > one, zero, alone);
    w.roundReference = zero;
    return w;
}

/// Replaces the points by a single one between two corners where the cores are separated and a corner of each
/// is nearest.
template <class F>
void touchCorners(BoxPlaces<F>& w, const BoxView<F>& v, F gap, F radius, F otherRadius, F speculative) {
    const F zero = all<F>(0.0f);
    const F one = all<F>(1.0f);
    const F lowBeyond = max(abs(v.lowT) - v.halfAlong, zero);
    const F highBeyond = max(abs(v.highT) - v.halfAlong, zero);
    const F lowOver = v.lowN - v.half;
    const F highOver = v.highN - v.half;
    const auto isHigh =
        highBeyond * highBeyond + highOver * highOver < lowBeyond * lowBeyond + lowOver * lowOver;
    const F nearT = select(isHigh, v.highT, v.lowT);
    const F nearN = select(isHigh, highOver, lowOver);
    const F farT = select(isHigh, v.lowT, v.highT);
    const F farN = select(isHigh, lowOver, highOver);
    const auto atLow = nearT < zero;
    const F cornerT = select(atLow, -v.halfAlong, v.halfAlong);
    const F displacementT = nearT - cornerT;
    // The incident edge may pass in front of the corner: then the edge touches, unless it ends before.
    const F passes = -(nearN * (farN - nearN) + displacementT * (farT - nearT));
    const auto apart = (v.lowT > v.halfAlong) | (-v.halfAlong > v.highT);
    const F square = nearN * nearN + displacementT * displacementT;
    const F blur = all<F>(kBlur * kBlur) * (v.n * v.n + v.t * v.t);
    const F beyond = select(isHigh, highBeyond, lowBeyond);
    // A corner that extends only slightly beyond the end of a nearly parallel face stays with the face, so
    // that stacked boxes of equal size keep both points. This costs 0.01 % of the distance.
    const F rise = (farN - nearN) * beyond;
    const F minimum = all<F>(kParallel * kParallel) * nearN * abs(farT - nearT);
    const auto past = (beyond > all<F>(kParallel) * nearN) | (rise > minimum);
    const auto isCorner =
        (gap > zero) & (beyond > zero) & (((zero > passes) & past) | apart) & (square > blur);

    const F distance = sqrt(square);
    const F safe = select(isCorner, distance, one);
    const F n = nearN / safe;
    const F t = displacementT / safe;
    const F separation = distance - otherRadius - radius;
    const F middle = radius + all<F>(0.5f) * separation;
    w.normalN = select(isCorner, n, w.normalN);
    w.normalT = select(isCorner, t, w.normalT);
    w.n[0] = select(isCorner, v.half + n * middle, w.n[0]);
    w.t[0] = select(isCorner, cornerT + t * middle, w.t[0]);
    w.separation[0] = select(isCorner, separation, w.separation[0]);
    w.corner[0] = select(isCorner, select(atLow, v.cornerLow, v.cornerHigh), w.corner[0]);
    w.other[0] = select(isCorner, select(isHigh, v.otherHigh, v.otherLow), w.other[0]);
    w.keep[0] = select(isCorner, select(separation > speculative, zero, one), w.keep[0]);
    w.keep[1] = select(isCorner, zero, w.keep[1]);
    w.roundOther = select(isCorner, otherRadius, w.roundOther);
    w.roundReference = select(isCorner, radius, w.roundReference);
}

/// Transforms from the reference face's (n, t) to A's frame.
template <class F>
BoxTouch<F> placed(const BoxPlaces<F>& w, const BoxView<F>& v, const BoxPair<F>& p, const BoxAxis<F>& axis) {
    const F zero = all<F>(0.0f);
    const F one = all<F>(1.0f);
    const auto ofB = axis.ofB > zero;
    const auto alongY = axis.alongY > zero;
    const F cosine = select(ofB, p.cosine, one);
    const F sine = select(ofB, p.sine, zero);
    const F originX = select(ofB, p.x, zero);
    const F originY = select(ofB, p.y, zero);
    BoxTouch<F> touch;
    const F normalN = select(ofB, -v.flip, v.flip) * w.normalN;
    const F normalT = select(ofB, -w.normalT, w.normalT);
    const F normalX = select(alongY, normalT, normalN);
    const F normalY = select(alongY, normalN, normalT);
    touch.normalX = cosine * normalX - sine * normalY;
    touch.normalY = sine * normalX + cosine * normalY;
    F pointX[2], pointY[2], id[2];
    const F shift = all<F>(256.0f);
    for (int i = 0; i < 2; ++i) {
        const F n = v.flip * w.n[i];
        const F x = select(alongY, w.t[i], n);
        const F y = select(alongY, n, w.t[i]);
        pointX[i] = originX + (cosine * x - sine * y);
        pointY[i] = originY + (sine * x + cosine * y);
        id[i] = select(ofB, w.other[i] * shift + w.corner[i], w.corner[i] * shift + w.other[i]);
    }
    const auto first = w.keep[0] > zero;  // otherwise the second point becomes the first
    touch.pointX[0] = select(first, pointX[0], pointX[1]);
    touch.pointY[0] = select(first, pointY[0], pointY[1]);
    touch.separation[0] = select(first, w.separation[0], w.separation[1]);
    touch.id[0] = select(first, id[0], id[1]);
    touch.pointX[1] = pointX[1];
    touch.pointY[1] = pointY[1];
    touch.separation[1] = w.separation[1];
    touch.id[1] = id[1];
    touch.count = w.keep[0] + w.keep[1];
    touch.roundA = select(ofB, w.roundOther, w.roundReference);
    touch.roundB = select(ofB, w.roundReference, w.roundOther);
    return touch;
}

/// @return  count 0 if the boxes are further apart than `speculative`
template <class F>
BoxTouch<F> touchBoxes(const BoxPair<F>& p) {
    const F zero = all<F>(0.0f);
    const F qx = p.cosine * p.x + p.sine * p.y;  // B's centre along B's axes
    const F qy = p.cosine * p.y - p.sine * p.x;
    const BoxAxis<F> axis = bestAxis(p, qx, qy);
    const auto near = p.speculative + (p.radiusA + p.radiusB) > axis.gap;
    BoxTouch<F> touch;
    touch.count = zero;
    if (!any(near)) return touch;

    const BoxView<F> view = viewFrom(p, axis, qx, qy);
    const auto ofB = axis.ofB > zero;
    const F radius = select(ofB, p.radiusB, p.radiusA);
    const F otherRadius = select(ofB, p.radiusA, p.radiusB);
    BoxPlaces<F> places = touchFaces(view, radius, otherRadius, p.speculative);
    if (any((axis.gap > zero) & near))
        touchCorners(places, view, axis.gap, radius, otherRadius, p.speculative);
    touch = placed(places, view, p, axis);
    touch.count = select(near, touch.count, zero);
    return touch;
}
