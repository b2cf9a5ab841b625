#include <algorithm>

#include "physics/islands/sleeping.hpp"
#include "physics/soft/soft_contacts.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

SoftBox merged(const SoftBox& a, const SoftBox& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

SoftBox boxOf(const SoftParticle& p, float dt) {
    const WorldPosition there = p.place + dt * p.velocity;
    return merged({p.place, p.place}, {there, there});
}

SoftBox grown(const SoftBox& box, double by) {
    return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}};
}

bool overlap(const SoftBox& a, const SoftBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

WorldPosition middleOf(const SoftBox& box) {
    return {0.5 * (box.min.x + box.max.x), 0.5 * (box.min.y + box.max.y)};
}

bool mayCollide(const SoftBody& a, const SoftBody& b) {
    return (a.mask & b.layers) != 0 && (b.mask & a.layers) != 0;
}

/// Finds the edge through which a point leaves a closed outline (SoftBody::ring): the nearest, or the first
/// along `axis`. @return the index of the edge; the number of edges if the point is not inside
std::size_t wayOut(const SoftBody& body, WorldPosition from, Vec2 axis, bool alongAxis) {
    const std::vector<std::uint32_t>& ring = body.ring;
    const auto seen = [&](std::size_t i) {
        const Vec2 to = body.particles[ring[i % ring.size()]].place - from;
        return Vec2{dot(axis, to), cross(axis, to)};
    };
    bool inside = false;
    float shortest = 0.0f;
    std::size_t found = ring.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = seen(i), b = seen(i + 1), edge = b - a;
        const bool crosses = (a.y > 0.0f) != (b.y > 0.0f) && (cross(a, b) > 0.0f) == (b.y > a.y);
        if (crosses) inside = !inside;
        if (alongAxis && !crosses) continue;
        const float square = lengthSquared(edge);
        const float t = square > 0.0f ? std::clamp(-dot(a, edge) / square, 0.0f, 1.0f) : 0.0f;
        const float distance = alongAxis ? cross(a, b) / edge.y : lengthSquared(a + t * edge);
        if (found < ring.size() && !(distance < shortest)) continue;
        shortest = distance;
        found = i;
    }
    return inside ? found : ring.size();
}

/// Finds the potential contacts of a soft body's particles with the edges of another.
class Finder {
public:
    Finder(const World& world, float dt, std::uint32_t body, std::uint32_t other, SoftSoftContacts& meetings)
        : dt_{dt},
          own_{world.softBodies.all[body]},
          other_{world.softBodies.all[other]},
          reach_{double{own_.radius + other_.radius + kSoftSlack}},
          ids_{.body = body, .other = other},
          meetings_{meetings} {}

    void run() {
        takeEdges(meetings_.boxes[ids_.body]);
        findAxis();
        for (std::uint32_t i = 0; i < own_.particles.size(); ++i) {
            const SoftParticle& p = own_.particles[i];
            const SoftBox box = grown(boxOf(p, dt_), reach_);
            if (overlap(box, meetings_.boxes[ids_.other]) && !findWayOut(p, i)) findEdges(p, i, box);
        }
    }

private:
    void takeEdges(const SoftBox& near) {
        meetings_.edges.clear();
        widest_ = 0.0;
        for (const SoftLink& link : other_.links) {
            if (!link.isEdge) continue;
            const SoftBox box =
                merged(boxOf(other_.particles[link.a], dt_), boxOf(other_.particles[link.b], dt_));
            if (!overlap(grown(box, reach_), near)) continue;
            meetings_.edges.push_back({box, static_cast<std::uint32_t>(&link - other_.links.data())});
            widest_ = std::max(widest_, box.max.x - box.min.x);
        }
        std::sort(meetings_.edges.begin(), meetings_.edges.end(), [](const SoftEdge& a, const SoftEdge& b) {
            return a.box.min.x != b.box.min.x ? a.box.min.x < b.box.min.x : a.link < b.link;
        });
    }

    void findEdges(const SoftParticle& p, std::uint32_t particle, const SoftBox& box) {
        const auto first =
            std::lower_bound(meetings_.edges.begin(), meetings_.edges.end(), box.min.x - widest_,
                             [](const SoftEdge& edge, double left) { return edge.box.min.x < left; });
        for (auto edge = first; edge != meetings_.edges.end() && edge->box.min.x <= box.max.x; ++edge) {
            if (!overlap(edge->box, box)) continue;
            const SoftLink& link = other_.links[edge->link];
            const WorldPosition a = other_.particles[link.a].place;
            const bool left = cross(other_.particles[link.b].place - a, p.place - a) >= 0.0f;
            meet(particle, link.a, link.b, left ? 1.0f : -1.0f, false);
        }
    }

    /// Adds the contact of a particle inside the other body's ring. @return false if it is not inside
    bool findWayOut(const SoftParticle& p, std::uint32_t particle) {
        const std::vector<std::uint32_t>& ring = other_.ring;
        const std::size_t edge = wayOut(other_, p.place, axis_, deep_);
        if (edge == ring.size()) return false;
        // The interior is to the left of the edges if the area is positive.
        meet(particle, ring[edge], ring[(edge + 1) % ring.size()], other_.area > 0.0f ? -1.0f : 1.0f, true);
        return true;
    }

    /// If two bodies are half inside each other, their nearest edges could push one through the other. Then
    /// they are separated along the line between their centres.
    void findAxis() {
        if (own_.ring.empty() || other_.ring.empty()) return;
        const WorldPosition own = middleOf(meetings_.boxes[ids_.body]);
        const WorldPosition other = middleOf(meetings_.boxes[ids_.other]);
        deep_ = wayOut(other_, own, axis_, false) < other_.ring.size() ||
                wayOut(own_, other, axis_, false) < own_.ring.size();
        if (deep_)
            axis_ = own == other ? Vec2{ids_.body < ids_.other ? -1.0f : 1.0f} : normalized(own - other);
    }

    void meet(std::uint32_t particle, std::uint32_t a, std::uint32_t b, float side, bool inside) {
        meetings_.all.push_back({ids_.body, particle, ids_.other, a, b, side, inside});
    }

    float dt_;
    const SoftBody& own_;
    const SoftBody& other_;
    double reach_;  // m
    SoftSoftContact ids_;
    SoftSoftContacts& meetings_;
    double widest_ = 0.0;  // m: maximum width of the edges
    Vec2 axis_{1.0f, 0.0f};
    bool deep_ = false;
};

/// A particle, the closest point of an edge, and the direction in which they separate.
struct Meeting {
    SoftParticle& p;
    SoftParticle& a;
    SoftParticle& b;
    float t = 0.0f;  // position on the edge, from a to b
    Vec2 normal{};

    [[nodiscard]] Vec2 between(WorldPosition SoftParticle::*when) const {
        return (p.*when - a.*when) - t * (b.*when - a.*when);
    }
    [[nodiscard]] float weight() const {
        return p.inverseMass + ((1.0f - t) * (1.0f - t) * a.inverseMass + t * t * b.inverseMass);
    }
    void push(Vec2 impulse) {
        p.place = p.place + p.inverseMass * impulse;
        a.place = a.place + -(1.0f - t) * a.inverseMass * impulse;
        b.place = b.place + -t * b.inverseMass * impulse;
    }
};

/// Sets `meeting.t` to the point of the edge closest to the particle, and `meeting.normal` to the direction
/// in which the two are separated. @return false if that direction is undefined
bool aim(const SoftSoftContact& which, Meeting& meeting) {
    const Vec2 edge = meeting.b.place - meeting.a.place;
    const float square = lengthSquared(edge);
    if (!(square > 0.0f)) return false;
    meeting.t = std::clamp(dot(meeting.p.place - meeting.a.place, edge) / square, 0.0f, 1.0f);
    meeting.normal = (which.side / std::sqrt(square)) * perpendicular(edge);
    if (which.inside || (meeting.t > 0.0f && meeting.t < 1.0f)) return true;
    // At an end of the edge the normal depends on the position.
    const Vec2 displacement = meeting.between(&SoftParticle::place);
    const float size = length(displacement);
    if (!(size > 0.0f)) return false;
    meeting.normal = displacement / size;
    return true;
}

}  // namespace

SoftBox boxOf(const SoftBody& body, float dt) {
    SoftBox box = boxOf(body.particles.front(), dt);
    for (const SoftParticle& p : body.particles) box = merged(box, boxOf(p, dt));
    return box;
}

void groupSoftBodies(const World& world, float dt, const SoftSurroundings& around,
                     SoftSoftContacts& meetings) {
    const std::vector<SoftBody>& all = world.softBodies.all;
    meetings.order.clear();
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (all[i].isAlive) meetings.order.push_back(i);
    }
    if (meetings.order.size() < 2) return;
    meetings.boxes.resize(all.size());
    meetings.leaders.resize(all.size());
    for (const std::uint32_t body : meetings.order) {
        meetings.boxes[body] = grown(boxOf(all[body], dt), double{all[body].radius + kSoftSlack});
        meetings.leaders[body] = body;
    }
    const auto leader = [&](std::uint32_t body) -> std::uint32_t& { return meetings.leaders[body]; };
    for (const std::uint32_t b : meetings.order) {
        for (const std::uint32_t a : meetings.order) {
            if (a == b) break;
            if (overlap(meetings.boxes[a], meetings.boxes[b]) && mayCollide(all[a], all[b]))
                joinTrees(leader, a, b);
        }
    }
    for (std::size_t i = 1; i < around.neighbours.size(); ++i) {
        const auto &a = around.neighbours[i - 1], &b = around.neighbours[i];
        if (a.first == b.first) joinTrees(leader, a.second, b.second);
    }
    for (const std::uint32_t body : meetings.order) leader(body) = rootOf(leader, body);
    std::sort(meetings.order.begin(), meetings.order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t first = meetings.leaders[a], second = meetings.leaders[b];
        return first != second ? first < second : a < b;
    });
}

void findMeetings(const World& world, float dt, std::span<const std::uint32_t> group,
                  SoftSoftContacts& meetings) {
    const std::vector<SoftBody>& all = world.softBodies.all;
    for (const std::uint32_t a : group) {
        for (const std::uint32_t b : group) {
            if (a != b && overlap(meetings.boxes[a], meetings.boxes[b]) && mayCollide(all[a], all[b]))
                Finder{world, dt, a, b, meetings}.run();
        }
    }
}

void keepSoftApart(World& world, float h, std::span<const SoftSoftContact> meetings) {
    for (const SoftSoftContact& which : meetings) {
        SoftBody& own = world.softBodies.all[which.body];
        SoftBody& other = world.softBodies.all[which.other];
        Meeting meeting{own.particles[which.particle], other.particles[which.a], other.particles[which.b]};
        if (!aim(which, meeting)) continue;
        // Overlap from before the substep is removed at a limited speed.
        const float before = dot(meeting.between(&SoftParticle::before), meeting.normal);
        const float apart = std::min(own.radius + other.radius, before + world.settings.pushSpeed * h);
        const float depth = apart - dot(meeting.between(&SoftParticle::place), meeting.normal);
        const float weight = meeting.weight();
        if (!(depth > 0.0f) || !(weight > 0.0f)) continue;
        meeting.push((depth / weight) * meeting.normal);
        const Vec2 along = perpendicular(meeting.normal);
        const Vec2 slid = meeting.between(&SoftParticle::place) - meeting.between(&SoftParticle::before);
        const float maximum = std::sqrt(own.friction * other.friction) * depth;
        meeting.push(-(std::clamp(dot(slid, along), -maximum, maximum) / weight) * along);
    }
}

}  // namespace plumb::physics
