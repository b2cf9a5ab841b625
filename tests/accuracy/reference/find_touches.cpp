#include "tests/accuracy/reference/find_touches.hpp"

#include <algorithm>

namespace plumb::reference {

namespace {

// Tests all separating axes and all pairs of corners, which is simple, and fast enough for outlines of few
// corners. Source: C. Ericson, Real-Time Collision Detection, 2005, 4.4, 5.1, 5.2.

constexpr double kMin = 1.0e-9;  // tolerance of comparisons, m or ratio; smaller than kClosed (group.hpp)

struct Placed {  // an outline at a pose
    const Outline* outline = nullptr;
    Triple pose;
    std::vector<Point> corners, normals;  // world coordinates

    [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == corners.size() ? 0 : i + 1; }
};

Placed placed(const Outline& outline, Triple pose) {
    Placed result{&outline, pose, {}, {}};
    const Turn turn{pose.turn};
    for (const Point corner : outline.corners) result.corners.push_back(placeOf(pose) + rotate(turn, corner));
    for (const Point normal : outline.normals) result.normals.push_back(rotate(turn, normal));
    return result;
}

/// A side of one outline, and the distance of the other outline in front of it.
struct Side {
    double apart = -kEndless;
    std::size_t index = 0;
};

/// True if a direction (world coordinates) from a chain segment belongs to this segment, not to a neighbour.
bool isOwnDirection(const Placed& chain, Point direction) {
    const Turn turn{chain.pose.turn};
    const Point own = chain.normals[0];
    const double side = cross(own, direction);
    if (dot(own, direction) < 0.0) return false;
    if (std::fabs(side) < kMin) return true;
    const Point along = chain.corners[1] - chain.corners[0];
    const bool toEnd = dot(along, direction) > 0.0;
    const Point last = rotate(turn, toEnd ? chain.outline->after : chain.outline->before);
    // True between the normals of the segment and its neighbour, at a convex corner.
    return cross(own, last) * side > 0.0 && std::fabs(cross(own, last)) >= std::fabs(side) - kMin &&
           dot(last, along) * (toEnd ? 1.0 : -1.0) > 0.0;
}

double nearestBefore(const Placed& side, std::size_t index, const Placed& other) {
    double nearest = kEndless;
    for (const Point corner : other.corners)
        nearest =
            std::min(nearest, dot(side.normals[index], corner - side.corners[index % side.corners.size()]));
    return nearest;
}

Side bestSide(const Placed& mine, const Placed& other) {
    Side best;
    for (std::size_t i = 0; i < mine.normals.size(); ++i) {
        const double apart = nearestBefore(mine, i, other);
        if (apart > best.apart) best = {apart, i};
    }
    return best;
}

/// A corner of one outline and the nearest point on the border of the other outline.
struct Nearest {
    double distance = kEndless;
    std::size_t corner = 0;
    std::size_t side = 0;  // index of the side of the other outline
    std::size_t otherCorner = 0;
    bool isCorner = true;
};

void tryNearest(const Placed& mine, const Placed& other, Nearest& best) {
    const std::size_t sides = other.corners.size() == 2 ? 1 : other.corners.size();
    for (std::size_t c = 0; c < mine.corners.size(); ++c) {
        for (std::size_t s = 0; s < sides; ++s) {
            const Point start = other.corners[s], way = other.corners[other.next(s)] - start;
            const double size = dot(way, way);
            const double part = size > 0.0 ? dot(mine.corners[c] - start, way) / size : 0.0;
            const double clamped = std::clamp(part, 0.0, 1.0);
            const double distance = length(mine.corners[c] - (start + clamped * way));
            const bool isCorner = clamped != part || size == 0.0;
            // At equal distance the inside of a side is preferred to its end.
            if (distance < best.distance || (distance == best.distance && best.isCorner && !isCorner))
                best = {distance, c, s, clamped < 0.5 ? s : other.next(s), isCorner};
        }
    }
}

class Finder {
public:
    Finder(const Scene& scene, std::uint32_t a, Triple poseA, std::uint32_t b, Triple poseB, double margin,
           std::vector<Touch>& touches)
        : a_{placed(scene.outlines[a], poseA)},
          b_{placed(scene.outlines[b], poseB)},
          margin_{margin},
          touches_{touches} {
        const Outline& one = scene.outlines[a];
        const Outline& two = scene.outlines[b];
        usual_.key = (std::uint64_t{a} << 44) | (std::uint64_t{b} << 24);
        usual_.outlineA = a;
        usual_.outlineB = b;
        usual_.bodyA = one.body;
        usual_.bodyB = two.body;
        usual_.radiusA = one.radius;
        usual_.radiusB = two.radius;
        usual_.friction = std::sqrt(one.friction * two.friction);
        usual_.bounciness = std::max(one.bounciness, two.bounciness);
        usual_.surfaceSpeed = one.surfaceSpeed + two.surfaceSpeed;
        round_ = one.radius + two.radius;
    }

    double find() {
        const Side sideA = bestSide(a_, b_), sideB = bestSide(b_, a_);
        const double apart = std::max(sideA.apart, sideB.apart);
        if (apart - round_ > margin_) return kEndless;
        // Rounded outlines, capsules and segments may be nearest at a corner.
        const bool hasEnds = a_.corners.size() < 3 || b_.corners.size() < 3;
        if ((apart > 0.0 || apart == -kEndless) && (round_ > 0.0 || hasEnds)) return findNearest(apart);
        const bool isOfA = sideA.apart >= sideB.apart - kMin;
        return findAtSides(sideA, sideB, isOfA);
    }

private:
    double findNearest(double apart) {
        Nearest ofA, ofB;
        tryNearest(a_, b_, ofA);
        tryNearest(b_, a_, ofB);
        const bool cornerOfA = ofA.distance < ofB.distance || (ofA.distance == ofB.distance && !ofA.isCorner);
        const Nearest& best = cornerOfA ? ofA : ofB;
        if (best.distance - round_ > margin_) return kEndless;
        if (best.isCorner && round_ > 0.0) {
            const std::size_t a = cornerOfA ? best.corner : best.otherCorner;
            const std::size_t b = cornerOfA ? best.otherCorner : best.corner;
            const Point way = normalized(b_.corners[b] - a_.corners[a]);
            if (a_.outline->isChain && !isOwnDirection(a_, way)) return kEndless;
            if (b_.outline->isChain && !isOwnDirection(b_, -way)) return kEndless;
            addCorners(a, b);
            return best.distance - round_;
        }
        if (best.isCorner) {
            const Side sideA = bestSide(a_, b_), sideB = bestSide(b_, a_);
            if (apart > margin_) return kEndless;
            return findAtSides(sideA, sideB, sideA.apart >= sideB.apart);
        }
        const Placed& owner = cornerOfA ? b_ : a_;
        const Point corner = (cornerOfA ? a_ : b_).corners[best.corner];
        std::size_t side = best.side;
        if (owner.corners.size() == 2 && dot(owner.normals[0], corner - owner.corners[0]) < 0.0) {
            if (owner.outline->isChain) return kEndless;
            side = 1;
        }
        const Placed& other = cornerOfA ? a_ : b_;
        if (other.outline->isChain && !isOwnDirection(other, -owner.normals[side])) return kEndless;
        addSide(!cornerOfA, side);
        return best.distance - round_;
    }

    double findAtSides(const Side& sideA, const Side& sideB, bool isOfA) {
        for (const bool chainIsA : {true, false}) {
            const Placed& chain = chainIsA ? a_ : b_;
            if (!chain.outline->isChain) continue;
            const Placed& other = chainIsA ? b_ : a_;
            const Side& own = chainIsA ? sideA : sideB;
            const Side& theirs = chainIsA ? sideB : sideA;
            if (dot(chain.normals[0], placeOf(other.pose) - chain.corners[0]) < 0.0) return kEndless;
            if (isOfA == chainIsA) continue;
            if (isOwnDirection(chain, -other.normals[theirs.index])) continue;
            if (theirs.apart > kMin) return kEndless;
            isOfA = chainIsA;
            addSide(isOfA, own.index);
            return own.apart - round_;
        }
        const Side& best = isOfA ? sideA : sideB;
        addSide(isOfA, best.index);
        return best.apart - round_;
    }

    /// Adds the contact points in front of a side: the ends of the overlap with the other outline's side. If
    /// two corners coincide, the other outline's corner is used, so that a contact keeps its key.
    void addSide(bool ofA, std::size_t index) {
        const Placed& mine = ofA ? a_ : b_;
        const Placed& other = ofA ? b_ : a_;
        const Point normal = mine.normals[index];
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < other.corners.size(); ++i) {
            if (dot(normal, other.corners[i]) < dot(normal, other.corners[nearest])) nearest = i;
        }
        if (other.corners.size() == 1) return addCornerBefore(ofA, index, nearest);
        const std::size_t facing = facingSide(other, normal, nearest);
        const std::size_t first = index % mine.corners.size();
        const Point start = mine.corners[first], along = mine.corners[mine.next(first)] - start;
        const std::size_t ends[2] = {facing % other.corners.size(),
                                     other.next(facing % other.corners.size())};
        const double size = dot(along, along);
        double parts[2];
        for (int i = 0; i < 2; ++i) parts[i] = dot(other.corners[ends[i]] - start, along) / size;
        const int low = parts[0] <= parts[1] ? 0 : 1;
        const double begin = std::max(parts[low], 0.0), end = std::min(parts[1 - low], 1.0);
        if (end - begin < kMin) return addCornerBefore(ofA, index, nearest);
        if (parts[low] >= -kMin)
            addCornerBefore(ofA, index, ends[low]);
        else
            addCornerBefore(!ofA, facing, first);
        if (parts[1 - low] <= 1.0 + kMin)
            addCornerBefore(ofA, index, ends[1 - low]);
        else
            addCornerBefore(!ofA, facing, mine.next(first));
    }

    /// Returns the side at the nearest corner whose normal is most opposed to the given normal.
    static std::size_t facingSide(const Placed& other, Point normal, std::size_t nearest) {
        if (other.corners.size() == 2) {
            if (other.outline->isChain) return 0;
            return dot(other.normals[0], normal) <= dot(other.normals[1], normal) ? 0 : 1;
        }
        const std::size_t before = nearest == 0 ? other.corners.size() - 1 : nearest - 1;
        return dot(other.normals[before], normal) < dot(other.normals[nearest], normal) ? before : nearest;
    }

    void addCornerBefore(bool sideOfA, std::size_t side, std::size_t corner) {
        const Outline& owner = sideOfA ? *a_.outline : *b_.outline;
        const Outline& other = sideOfA ? *b_.outline : *a_.outline;
        Touch touch = usual_;
        touch.hasSide = true;
        touch.sideOfA = sideOfA;
        const Point onSide = owner.corners[side % owner.corners.size()];
        touch.a = sideOfA ? onSide : other.corners[corner];
        touch.b = sideOfA ? other.corners[corner] : onSide;
        touch.normal = owner.normals[side];
        touch.key |=
            (sideOfA ? 1u : 2u) << 20 | static_cast<unsigned>(side) << 8 | static_cast<unsigned>(corner);
        add(touch);
    }

    void addCorners(std::size_t a, std::size_t b) {
        Touch touch = usual_;
        touch.a = a_.outline->corners[a];
        touch.b = b_.outline->corners[b];
        touch.key |= static_cast<unsigned>(a) << 8 | static_cast<unsigned>(b);
        add(touch);
    }

    void add(const Touch& touch) {
        if (viewOf(touch, a_.pose, b_.pose).gap <= margin_) touches_.push_back(touch);
    }

    Placed a_, b_;
    double margin_;
    std::vector<Touch>& touches_;
    Touch usual_;
    double round_ = 0.0;
};

}  // namespace

double findTouches(const Scene& scene, std::uint32_t outlineA, Triple poseA, std::uint32_t outlineB,
                   Triple poseB, double margin, std::vector<Touch>& touches) {
    return Finder{scene, outlineA, poseA, outlineB, poseB, margin, touches}.find();
}

}  // namespace plumb::reference
