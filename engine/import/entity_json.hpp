#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "import/tiled_map.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Where something of a layer is drawn, after what the layer adds.
struct LayerPlace {
    int order = 0;       ///< the layer's place among all
    Vec2 offset;         ///< px, to be added to positions; parallax taken into account
    bool moves = false;  ///< has a parallax of its own
};

/// Gives every entity an id that is the same at every import: from the names, not by chance.
class EntityIds {
public:
    std::string next(std::string_view key);

private:
    std::set<std::uint64_t> taken_;
};

Json transformJson(Vec2 position, float rotation, Vec2 scale);
Json parallaxJson(const tiled::Layer& layer);
Json colorOf(const tiled::Layer& layer, double opacity);

}  // namespace plumb
