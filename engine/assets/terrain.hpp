#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/color.hpp"

namespace plumb {

/// The neighbours of a cell as bits, clockwise from above. A tile's mask has those that are of its terrain.
struct Neighbour {
    static constexpr std::uint8_t kUp = 1, kUpRight = 2, kRight = 4, kDownRight = 8;
    static constexpr std::uint8_t kDown = 16, kDownLeft = 32, kLeft = 64, kUpLeft = 128;
    static constexpr std::uint8_t kEdges = kUp | kRight | kDown | kLeft;
    static constexpr std::uint8_t kCorners = kUpRight | kDownRight | kDownLeft | kUpLeft;
    static constexpr std::uint8_t kAll = kEdges | kCorners;
};

/// Which neighbours count. Edges: the four beside a cell, 16 masks. Blob: also those across a corner, where
/// both beside it are there: 47 masks. Corners: not cells but the places where four cells meet are of a
/// terrain: 16.
enum class TerrainMode : std::uint8_t { Edges, Blob, Corners };
std::span<const std::string_view> terrainModeNames();

/// The mask with the neighbours only that count in this mode.
std::uint8_t countedMask(TerrainMode mode, std::uint8_t mask);
/// All masks that the mode tells apart, in rising order.
std::vector<std::uint8_t> masksOf(TerrainMode mode);

struct TerrainTile {
    int tile = 0;
    std::uint8_t mask = 0;

    friend bool operator==(const TerrainTile&, const TerrainTile&) = default;
};

/// A material that is painted as such; each of its cells takes the tile whose mask fits its neighbours.
struct Terrain {
    int id = 1;  ///< what cells of a layer's terrain hold: 1 .. 255
    std::string name;
    TerrainMode mode = TerrainMode::Blob;
    Color color{120, 200, 90, 255};  ///< of the editor's marks
    std::vector<TerrainTile> tiles;  ///< several of one mask are variants

    friend bool operator==(const Terrain&, const Terrain&) = default;
};

}  // namespace plumb
