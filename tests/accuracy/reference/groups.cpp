#include "tests/accuracy/reference/groups.hpp"

#include <algorithm>
#include <numeric>

namespace plumb::reference {

namespace {

struct Bounds {
    double left = kEndless, right = -kEndless, top = kEndless, bottom = -kEndless;
    std::uint32_t outline = 0;
};

Bounds boundsOf(const Scene& scene, std::uint32_t index, Triple pose, double margin) {
    const Outline& outline = scene.outlines[index];
    Bounds bounds;
    bounds.outline = index;
    const Turn turn{pose.turn};
    for (const Point local : outline.corners) {
        const Point corner = placeOf(pose) + rotate(turn, local);
        bounds.left = std::min(bounds.left, corner.x);
        bounds.right = std::max(bounds.right, corner.x);
        bounds.top = std::min(bounds.top, corner.y);
        bounds.bottom = std::max(bounds.bottom, corner.y);
    }
    const double more = outline.radius + margin;
    bounds.left -= more, bounds.right += more, bounds.top -= more, bounds.bottom += more;
    return bounds;
}

/// Returns an upper limit of a body's displacement in a step, m: twice
/// that of the fastest body, as impacts can accelerate any other body.
double marginOf(const Scene& scene, const RunState& state, double h) {
    double fastest = 0.0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (!body.id) continue;
        const double speed =
            length(placeOf(state.velocities[i])) + std::fabs(state.velocities[i].turn) * body.reach;
        fastest = std::max(fastest, speed + h * length(body.acceleration));
    }
    return 2.0 * fastest * h + 2.0 * kNear;
}

/// Finds pairs of outlines whose bounds overlap, by sort and sweep along x.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, 7.5.
std::vector<std::pair<std::uint32_t, std::uint32_t>> pairsOf(const Scene& scene, const RunState& state,
                                                             double h) {
    const double margin = marginOf(scene, state, h);
    std::vector<Bounds> all;
    for (std::uint32_t i = 0; i < scene.outlines.size(); ++i)
        all.push_back(boundsOf(scene, i, state.poses[scene.outlines[i].body], margin));
    std::sort(all.begin(), all.end(), [](const Bounds& a, const Bounds& b) {
        return a.left != b.left ? a.left < b.left : a.outline < b.outline;
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<Bounds> open;
    for (const Bounds& next : all) {
        std::erase_if(open, [&](const Bounds& bounds) { return bounds.right < next.left; });
        for (const Bounds& other : open) {
            if (other.top > next.bottom || next.top > other.bottom) continue;
            const auto [a, b] = std::minmax(other.outline, next.outline);
            if (mayCollide(scene, a, b)) pairs.emplace_back(a, b);
        }
        open.push_back(next);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// Union-find structure: sets of connected bodies.
class Forest {
public:
    explicit Forest(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t rootOf(std::uint32_t body) {
        while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
        return body;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t rootA = rootOf(a), rootB = rootOf(b);
        parent_[std::max(rootA, rootB)] = std::min(rootA, rootB);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<Group> findGroups(const Scene& scene, const RunState& state, double h) {
    const auto pairs = pairsOf(scene, state, h);
    const auto isPushed = [&](std::uint32_t body) { return scene.bodies[body].isPushed; };
    Forest forest{scene.bodies.size()};
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        if (isPushed(a) && isPushed(b)) forest.join(a, b);
    };
    for (const auto& [a, b] : pairs) join(scene.outlines[a].body, scene.outlines[b].body);
    for (const Law& law : scene.laws) join(law.a, law.b);

    std::vector<Group> groups;
    std::vector<std::uint32_t> groupOf(scene.bodies.size(), kNoGroup);
    for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
        if (!isPushed(i)) continue;
        const std::uint32_t root = forest.rootOf(i);
        if (groupOf[root] == kNoGroup) {
            groupOf[root] = static_cast<std::uint32_t>(groups.size());
            groups.emplace_back();
        }
        groupOf[i] = groupOf[root];
        groups[groupOf[i]].bodies.push_back(i);
    }
    for (Group& group : groups) group.pushed = group.bodies.size();
    const auto groupFor = [&](std::uint32_t a, std::uint32_t b) -> Group& {
        Group& group = groups[groupOf[isPushed(a) ? a : b]];
        for (const std::uint32_t body : {a, b}) {
            if (!isPushed(body)) group.bodies.push_back(body);
        }
        return group;
    };
    for (const auto& [a, b] : pairs)
        groupFor(scene.outlines[a].body, scene.outlines[b].body).pairs.emplace_back(a, b);
    for (std::uint32_t i = 0; i < scene.laws.size(); ++i)
        groupFor(scene.laws[i].a, scene.laws[i].b).laws.push_back(i);
    for (Group& group : groups) {
        const auto fixed = group.bodies.begin() + static_cast<std::ptrdiff_t>(group.pushed);
        std::sort(fixed, group.bodies.end());
        group.bodies.erase(std::unique(fixed, group.bodies.end()), group.bodies.end());
    }
    return groups;
}

}  // namespace plumb::reference
