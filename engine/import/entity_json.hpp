#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "import/tiled_map.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Drawing order and offset that a map layer adds to each entity made from it.
struct LayerPlacement {
    int order = 0;       ///< drawing order: index of the layer in the map, the lowest first
    Vec2 offset;         ///< px, added to positions; includes the correction for parallax
    bool moves = false;  ///< the layer's parallax factor is not 1
};

/// Computes entity ids from names instead of random numbers, so repeated imports produce the same ids.
class EntityIds {
public:
    std::string next(std::string_view key);  ///< id for a key; a different one if the key is repeated

private:
    std::set<std::uint64_t> taken_;
};

Json transformJson(Vec2 position, float rotation, Vec2 scale);
Json parallaxJson(const tiled::Layer& layer);
Json colorOf(const tiled::Layer& layer, double opacity);  ///< the layer's tint, with both opacities

}  // namespace plumb
