// Part of kernels.inl: collides eight pairs of boxes in SIMD lanes, without branches on values.
//
// Source: separating axes of boxes after S. Gottschalk, M. Lin, D. Manocha, "OBBTree", 1996, 5; the incident
// edge is clipped after E. Catto, "Contact Manifolds", GDC 2007.

using BoxPair = BoxPairOf<Float8, Two8>;
using BoxTouch = BoxTouchOf<Float8, Two8>;

/// The axis of maximum separation, for eight pairs of boxes.
struct BoxAxis {
    Float8 gap;         // m: separation of the cores along the axis
    Mask8 ofB, alongY;  // true for an axis of B; true for the y axis of its box
};

inline Float8 oneIn(Mask8 mask) { return select(mask, all(1.0f), all(0.0f)); }

BoxAxis bestAxis(const BoxPair& p, Float8 qx, Float8 qy) {
    const Float8 c = abs(p.cosine);
    const Float8 s = abs(p.sine);
    const Float8 aX = abs(p.place.x) - p.halfA.x - (c * p.halfB.x + s * p.halfB.y);
    const Float8 aY = abs(p.place.y) - p.halfA.y - (s * p.halfB.x + c * p.halfB.y);
    const Float8 bX = abs(qx) - p.halfB.x - (c * p.halfA.x + s * p.halfA.y);
    const Float8 bY = abs(qy) - p.halfB.y - (s * p.halfA.x + c * p.halfA.y);
    // Like faceTieOf() for the smallest half size.
    const Float8 tie =
        min(all(kMaxFaceTie), all(kFaceTie) * min(min(p.halfA.x, p.halfA.y), min(p.halfB.x, p.halfB.y)));
    const auto aIsY = aY > aX + tie;
    const auto bIsY = bY > bX + tie;
    const Float8 a = select(aIsY, aY, aX);
    const Float8 b = select(bIsY, bY, bX);
    const auto isB = b > a + tie;
    return {select(isB, b, a), isB, select(isB, oneIn(bIsY), oneIn(aIsY)) > all(0.0f)};
}

/// The boxes in coordinates of the reference face: n along its normal to the other box, t along the face.
struct BoxView {
    Float8 n, t;                 // centre of the other box
    Float8 half, halfAlong;      // half sizes of the reference box
    Float8 flip;                 // -1 if n is a negative axis of the reference box, else 1
    Float8 endN[2], endT[2];     // ends of the incident edge: low and high, in the order of t
    Float8 slope, midN, midT;    // slope and middle of the incident edge
    Float8 corner[2], other[2];  // corners of the reference box and of the other box at low and high
};

BoxView viewFrom(const BoxPair& p, const BoxAxis& axis, Float8 qx, Float8 qy) {
    const Float8 zero = all(0.0f);
    const Float8 one = all(1.0f);
    const Float8 two = all(2.0f);
    const auto& [gap, ofB, alongY] = axis;
    const Float8 sine = select(ofB, -p.sine, p.sine);
    const Float8 x = select(ofB, -qx, p.place.x);
    const Float8 y = select(ofB, -qy, p.place.y);
    const Float8 halfX = select(ofB, p.halfB.x, p.halfA.x);
    const Float8 halfY = select(ofB, p.halfB.y, p.halfA.y);
    const Float8 otherX = select(ofB, p.halfA.x, p.halfB.x);
    const Float8 otherY = select(ofB, p.halfA.y, p.halfB.y);

    BoxView v;
    const Float8 towards = select(alongY, y, x);
    v.flip = select(towards < zero, -one, one);
    v.n = abs(towards);
    v.t = select(alongY, x, y);
    v.half = select(alongY, halfY, halfX);
    v.halfAlong = select(alongY, halfX, halfY);

    // Components of the other box's axes x and y along n and t.
    const Float8 xN = v.flip * select(alongY, sine, p.cosine);
    const Float8 xT = select(alongY, p.cosine, sine);
    const Float8 yN = v.flip * select(alongY, p.cosine, -sine);
    const Float8 yT = select(alongY, -sine, p.cosine);
    const auto byX = abs(xN) > abs(yN);  // true if the incident face is perpendicular to x
    const Float8 faceN = select(byX, xN, yN);
    const Float8 faceT = select(byX, xT, yT);
    const Float8 sideN = select(byX, yN, xN);
    const Float8 sideT = select(byX, yT, xT);
    const Float8 halfFace = select(byX, otherX, otherY);
    const Float8 halfSide = select(byX, otherY, otherX);
    const auto backwards = faceN > zero;  // true if it is on the negative side of its axis
    const auto sideBackwards = sideT < zero;
    v.midN = v.n - abs(faceN) * halfFace;
    v.midT = v.t + select(backwards, -faceT, faceT) * halfFace;
    const Float8 alongN = select(sideBackwards, -sideN, sideN);
    const Float8 alongT = abs(sideT);  // at least the square root of 1/2
    v.slope = alongN / alongT;
    v.endN[0] = v.midN - alongN * halfSide;
    v.endT[0] = v.midT - alongT * halfSide;
    v.endN[1] = v.midN + alongN * halfSide;
    v.endT[1] = v.midT + alongT * halfSide;

    const Float8 positive = oneIn(v.flip > zero);
    v.corner[0] = select(alongY, positive * two, positive);
    v.corner[1] = v.corner[0] + select(alongY, one, two);
    const Float8 face = select(backwards, zero, one);
    const Float8 low = oneIn(sideBackwards);
    v.other[0] = select(byX, face + low * two, face * two + low);
    v.other[1] = select(byX, face + (one - low) * two, face * two + (one - low));
    return v;
}

/// A manifold in (n, t) coordinates of the reference face.
struct BoxPlaces {
    Float8 normalN, normalT;
    Float8 n[2], t[2], separation[2];
    Float8 corner[2], other[2];
    Float8 keep[2];  // 1 if the point exists, else 0
    Float8 roundOther, roundReference;
};

BoxPlaces touchFaces(const BoxView& v, Float8 radius, Float8 otherRadius, Float8 speculative) {
    const Float8 zero = all(0.0f);
    const Float8 one = all(1.0f);
    const Float8 surface = v.half + radius;
    const Float8 border[2] = {-v.halfAlong, v.halfAlong};
    const Mask8 cutLow = v.endT[0] < border[0], cutHigh = v.endT[1] > border[1];
    const Mask8 cut[2] = {cutLow, cutHigh};
    Float8 round[2];  // a single point is at a rounded corner, unless clipping moved it
    BoxPlaces w;
    w.normalN = one;
    w.normalT = zero;
    for (int i = 0; i < 2; ++i) {
        w.t[i] = select(cut[i], border[i], v.endT[i]);
        const Float8 height = select(cut[i], v.midN + v.slope * (w.t[i] - v.midT), v.endN[i]);
        w.separation[i] = height - otherRadius - surface;
        w.n[i] = surface + all(0.5f) * w.separation[i];
        w.corner[i] = v.corner[i];
        w.other[i] = v.other[i];
        round[i] = select(cut[i], zero, otherRadius);
    }
    const Float8 beside = select(w.t[0] > w.t[1], zero, one);
    for (int i = 0; i < 2; ++i) w.keep[i] = select(w.separation[i] > speculative, zero, beside);
    const Float8 alone = select(w.keep[0] > zero, round[0], round[1]);
    w.roundOther = select(w.keep[0] + w.keep[1] > one, zero, alone);
    w.roundReference = zero;
    return w;
}

/// In lanes in which separated cores are nearest at two corners, replaces the points by a single point.
void touchCorners(BoxPlaces& w, const BoxView& v, Float8 gap, Float8 radius, Float8 otherRadius,
                  Float8 speculative) {
    const Float8 zero = all(0.0f);
    const Float8 one = all(1.0f);
    const Float8 lowBeyond = max(abs(v.endT[0]) - v.halfAlong, zero);
    const Float8 highBeyond = max(abs(v.endT[1]) - v.halfAlong, zero);
    const Float8 lowOver = v.endN[0] - v.half;
    const Float8 highOver = v.endN[1] - v.half;
    const auto isHigh =
        highBeyond * highBeyond + highOver * highOver < lowBeyond * lowBeyond + lowOver * lowOver;
    const Float8 nearT = select(isHigh, v.endT[1], v.endT[0]);
    const Float8 nearN = select(isHigh, highOver, lowOver);
    const Float8 farT = select(isHigh, v.endT[0], v.endT[1]);
    const Float8 farN = select(isHigh, lowOver, highOver);
    const auto atLow = nearT < zero;
    const Float8 cornerT = select(atLow, -v.halfAlong, v.halfAlong);
    const Float8 displacementT = nearT - cornerT;
    // If the incident edge passes in front of the corner, the edge touches, not its end.
    const Float8 passes = -(nearN * (farN - nearN) + displacementT * (farT - nearT));
    const auto apart = (v.endT[0] > v.halfAlong) | (-v.halfAlong > v.endT[1]);
    const Float8 square = nearN * nearN + displacementT * displacementT;
    const Float8 blur = all(kBlur * kBlur) * (v.n * v.n + v.t * v.t);
    const Float8 beyond = select(isHigh, highBeyond, lowBeyond);
    // A corner that extends only slightly beyond the end of a nearly parallel face counts as in front of it,
    // so that stacked boxes of equal size keep both points. The error is 0.01 % of the distance.
    const Float8 rise = (farN - nearN) * beyond;
    const Float8 minimum = all(kParallel * kParallel) * nearN * abs(farT - nearT);
    const auto past = (beyond > all(kParallel) * nearN) | (rise > minimum);
    const auto isCorner =
        (gap > zero) & (beyond > zero) & (((zero > passes) & past) | apart) & (square > blur);

    const Float8 distance = sqrt(square);
    const Float8 safe = select(isCorner, distance, one);
    const Float8 n = nearN / safe;
    const Float8 t = displacementT / safe;
    const Float8 separation = distance - otherRadius - radius;
    const Float8 middle = radius + all(0.5f) * separation;
    w.normalN = select(isCorner, n, w.normalN);
    w.normalT = select(isCorner, t, w.normalT);
    w.n[0] = select(isCorner, v.half + n * middle, w.n[0]);
    w.t[0] = select(isCorner, cornerT + t * middle, w.t[0]);
    w.separation[0] = select(isCorner, separation, w.separation[0]);
    w.corner[0] = select(isCorner, select(atLow, v.corner[0], v.corner[1]), w.corner[0]);
    w.other[0] = select(isCorner, select(isHigh, v.other[1], v.other[0]), w.other[0]);
    w.keep[0] = select(isCorner, select(separation > speculative, zero, one), w.keep[0]);
    w.keep[1] = select(isCorner, zero, w.keep[1]);
    w.roundOther = select(isCorner, otherRadius, w.roundOther);
    w.roundReference = select(isCorner, radius, w.roundReference);
}

/// Transforms a manifold from (n, t) coordinates to A's frame.
BoxTouch placed(const BoxPlaces& w, const BoxView& v, const BoxPair& p, const BoxAxis& axis) {
    const Float8 zero = all(0.0f);
    const Float8 one = all(1.0f);
    const Mask8 ofB = axis.ofB;
    const Float8 cosine = select(ofB, p.cosine, one);
    const Float8 sine = select(ofB, p.sine, zero);
    const Two8 origin{select(ofB, p.place.x, zero), select(ofB, p.place.y, zero)};
    BoxTouch touch;
    const Float8 normalN = select(ofB, -v.flip, v.flip) * w.normalN;
    const Float8 normalT = select(ofB, -w.normalT, w.normalT);
    const auto inA = [&](Float8 n, Float8 t) {
        return turned(cosine, sine, select(axis.alongY, t, n), select(axis.alongY, n, t));
    };
    touch.normal = inA(normalN, normalT);
    const Float8 shift = all(256.0f);
    for (int i = 0; i < 2; ++i) {
        touch.point[i] = origin + inA(v.flip * w.n[i], w.t[i]);
        touch.separation[i] = w.separation[i];
        touch.id[i] = select(ofB, w.other[i] * shift + w.corner[i], w.corner[i] * shift + w.other[i]);
    }
    const auto first = w.keep[0] > zero;  // if false, the second point becomes the first
    touch.point[0] = {select(first, touch.point[0].x, touch.point[1].x),
                      select(first, touch.point[0].y, touch.point[1].y)};
    touch.separation[0] = select(first, w.separation[0], w.separation[1]);
    touch.id[0] = select(first, touch.id[0], touch.id[1]);
    touch.count = w.keep[0] + w.keep[1];
    touch.roundA = select(ofB, w.roundOther, w.roundReference);
    touch.roundB = select(ofB, w.roundReference, w.roundOther);
    return touch;
}

/// @return manifolds; count is 0 if the boxes are further apart than `speculative`
BoxTouch touchBoxes(const BoxPair& p, Float8 speculative) {
    const Float8 zero = all(0.0f);
    const Float8 qx = p.cosine * p.place.x + p.sine * p.place.y;  // B's centre along B's axes
    const Float8 qy = p.cosine * p.place.y - p.sine * p.place.x;
    const BoxAxis axis = bestAxis(p, qx, qy);
    const auto near = speculative + (p.radiusA + p.radiusB) > axis.gap;
    BoxTouch touch;
    touch.count = zero;
    if (!any(near)) return touch;

    const BoxView view = viewFrom(p, axis, qx, qy);
    const Float8 radius = select(axis.ofB, p.radiusB, p.radiusA);
    const Float8 otherRadius = select(axis.ofB, p.radiusA, p.radiusB);
    BoxPlaces places = touchFaces(view, radius, otherRadius, speculative);
    if (any((axis.gap > zero) & near)) touchCorners(places, view, axis.gap, radius, otherRadius, speculative);
    touch = placed(places, view, p, axis);
    touch.count = select(near, touch.count, zero);
    return touch;
}
