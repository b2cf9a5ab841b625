#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/broadphase/line_sweep.hpp"
#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

/// Boxes in a list, to be compared with eight neighbours of it at a time. The far sides are negated, as in
/// TreeBoxes. Places that nobody has overlap nothing; so do the eight behind the last.
struct BoxRows {
    static constexpr std::uint8_t kFree = 0;
    static constexpr std::uint8_t kThere = 1;
    static constexpr std::uint8_t kAwake = 3;  ///< ProxyMotion::Awake

    std::array<std::vector<float>, 4> low;  ///< m: left, top, -right, -bottom
    std::vector<Filter> filters;
    std::vector<std::uint32_t> ids;
    std::vector<std::uint8_t> states;  ///< kFree, kThere or kAwake
    std::uint32_t count = 0;           ///< places, with free ones
    std::uint32_t free = 0;
    std::uint32_t layers = 0;  ///< of all that have been here; see overruledBy()
    std::uint32_t masks = 0;

    BoxRows() { reset(0); }
    /// Makes free places; forgets what there was.
    void reset(std::uint32_t places);
    /// Makes a free place behind the others.
    std::uint32_t addPlace();
    /// Takes the last place away, which is free.
    void dropPlace();
    /// @param box  what usable() makes of its bounds
    void write(const Proxies& proxies, std::uint32_t place, std::uint32_t id, const AABB& box);
    void erase(std::uint32_t place);
    [[nodiscard]] std::uint32_t size() const { return count - free; }
    [[nodiscard]] bool isFree(std::uint32_t place) const { return states[place] == kFree; }
    /// Whether somebody here may meet one with this filter.
    [[nodiscard]] bool mayMeet(const Filter& filter) const {
        const std::uint32_t overruled = overruledBy(filter.group);
        return ((filter.layers | overruled) & masks) != 0 && ((filter.mask | overruled) & layers) != 0;
    }
    [[nodiscard]] AABB boxAt(std::uint32_t place) const {
        return {{low[0][place], low[1][place]}, {-low[2][place], -low[3][place]}};
    }
};

/// Some places, one behind the other.
struct Stretch {
    std::uint32_t begin;
    std::uint32_t end;
};

/// Some that are near each other look for partners.
struct RowSearch {
    static constexpr std::uint32_t kMostLookers = 8;

    const BoxRows* own = nullptr;
    const BoxRows* others = nullptr;  ///< may be the same
    bool ownMayBeAwake = false;
    bool allCanPair = false;                   ///< the moving and the sleeping; else one has to be awake
    bool onlyLater = false;                    ///< everybody looks, so each looks only behind itself
    const std::uint8_t* isMoved = nullptr;     ///< by proxy: nonzero for all that look
    std::uint32_t lookers[kMostLookers] = {};  ///< places, rising
    std::uint32_t count = 0;
};

/// The sides of a box in cells of a grid.
using BoxCells = std::array<std::int32_t, 4>;

/// The searches through rows as compiled for one kind of processor.
struct RowSearches {
    void (*findPairs)(const RowSearch& search, std::span<const Stretch> stretches,
                      std::vector<PairKey>& pairs);
    /// Appends the ids of those from `begin` to `end` that the box overlaps and, unless that is null, the
    /// sweep may meet.
    void (*findInBox)(const BoxRows& rows, Stretch part, const AABB& box, const LineSweep* sweep,
                      std::uint32_t mask, std::vector<std::uint32_t>& found);
    /// Of each box left, top, right and bottom in cells, rounded down and at most 2^30 away. Boxes are an
    /// even number.
    void (*findCells)(std::span<const AABB> boxes, float perMetre, std::span<BoxCells> cells);
};

}  // namespace plumb::physics
