#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/color.hpp"

namespace plumb {

/// The eight neighbours of a cell as bits, clockwise from above. A tile's mask contains those neighbours that
/// must have the tile's terrain.
struct Neighbour {
    static constexpr std::uint8_t kUp = 1, kUpRight = 2, kRight = 4, kDownRight = 8;
    static constexpr std::uint8_t kDown = 16, kDownLeft = 32, kLeft = 64, kUpLeft = 128;
    static constexpr std::uint8_t kEdges = kUp | kRight | kDown | kLeft;
    static constexpr std::uint8_t kCorners = kUpRight | kDownRight | kDownLeft | kUpLeft;
    static constexpr std::uint8_t kAll = kEdges | kCorners;
};

/// Neighbours that determine a tile. Edges: the four cells at the edges, 16 masks. Blob: also a diagonal cell
/// if both edge cells next to it have the terrain, 47 masks. Corners: terrain belongs to the corners of cells
/// instead of to cells, 16 masks.
enum class TerrainMode : std::uint8_t { Edges, Blob, Corners };
std::span<const std::string_view> terrainModeNames();

/// Removes the neighbours that do not count in a mode from a mask.
std::uint8_t countedMask(TerrainMode mode, std::uint8_t mask);
/// Returns all distinct masks of a mode in ascending order.
std::vector<std::uint8_t> masksOf(TerrainMode mode);

struct TerrainTile {
    int tile = 0;
    std::uint8_t mask = 0;

    friend bool operator==(const TerrainTile&, const TerrainTile&) = default;
};

/// A terrain to paint with: each of its cells gets the tile whose mask matches the cell's neighbours.
struct Terrain {
    int id = 1;  ///< value in the cells of a layer's terrain, 1..255
    std::string name;
    TerrainMode mode = TerrainMode::Blob;
    Color color{120, 200, 90, 255};  ///< used by the editor to mark the terrain
    std::vector<TerrainTile> tiles;  ///< several tiles with the same mask are variants

    friend bool operator==(const Terrain&, const Terrain&) = default;
};

}  // namespace plumb
