#pragma once

#include <span>
#include <vector>

#include "physics/soft_obstacles.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// How soft bodies keep out of each other: particles of one off the edges of another, both ways. An edge is a
// link of SoftBody::edges with the widths of both.

/// Where something may be within a step, m.
struct SoftBox {
    Place min;
    Place max;
};

/// A particle that an edge of another soft body may come near to in this step.
struct SoftMeeting {
    std::uint32_t body = 0;  ///< in SoftBodies::all: whose particle
    std::uint32_t particle = 0;
    std::uint32_t other = 0;  ///< whose edge
    std::uint32_t a = 0;      ///< particles of that: its ends
    std::uint32_t b = 0;
    float side = 1.0f;    ///< of the edge on which the particle belongs: 1 or -1
    bool inside = false;  ///< it is in the other one's ring, and this is the shortest way out
};

struct SoftEdge {
    SoftBox box;
    std::uint32_t link = 0;
};

/// Of a step, in Workspace.
struct SoftMeetings {
    std::vector<SoftBox> boxes;  ///< by index of the soft body
    std::vector<std::uint32_t>
        leaders;                       ///< by index: the first of those that it may meet, through others too
    std::vector<std::uint32_t> order;  ///< living ones, those with one leader together
    std::vector<SoftEdge> edges;       ///< of one soft body near another, from left to right
    std::vector<SoftMeeting> all;      ///< of one group
};

/// Puts those that may meet within a step of dt seconds, or push one body, beside each other in `order`.
void groupSoftBodies(const World& world, float dt, std::span<const SoftNeighbour> neighbours,
                     SoftMeetings& meetings);
/// Finds all meetings within a group of `order`.
void findMeetings(const World& world, float dt, std::span<const std::uint32_t> group, SoftMeetings& meetings);
/// Pushes those apart who are too near at the end of a substep of h seconds. Keeps momentum.
void keepSoftApart(World& world, float h, std::span<const SoftMeeting> meetings);

}  // namespace plumb::physics
