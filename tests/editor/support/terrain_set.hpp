#pragma once

#include "assets/tileset.hpp"

namespace plumb::editor {

/// A tileset with `terrains` terrains, numbered from 1; their tiles are numbered in the order of rising
/// neighbour masks.
inline Tileset terrainSet(TerrainMode mode, int terrains) {
    Tileset set;
    set.tileWidth = set.tileHeight = 16;
    set.columns = 10;
    set.count = 200;
    int next = 0;
    for (int id = 1; id <= terrains; ++id) {
        Terrain terrain;
        terrain.id = id;
        terrain.name = "terrain";
        terrain.mode = mode;
        for (const std::uint8_t mask : masksOf(mode)) terrain.tiles.push_back({next++, mask});
        set.terrains.push_back(std::move(terrain));
    }
    return set;
}

}  // namespace plumb::editor
