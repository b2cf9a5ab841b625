#include "assets/terrain.hpp"

#include <array>

namespace plumb {

std::span<const std::string_view> terrainModeNames() {
    static constexpr std::array<std::string_view, 3> kNames{"edges", "blob", "corners"};
    return kNames;
}

std::uint8_t countedMask(TerrainMode mode, std::uint8_t mask) {
    using N = Neighbour;
    if (mode == TerrainMode::Edges) return mask & N::kEdges;
    if (mode == TerrainMode::Corners) return mask & N::kCorners;
    struct Corner {
        std::uint8_t bit;
        std::uint8_t sides;
    };
    static constexpr std::array kCorners{
        Corner{N::kUpRight, N::kUp | N::kRight}, Corner{N::kDownRight, N::kDown | N::kRight},
        Corner{N::kDownLeft, N::kDown | N::kLeft}, Corner{N::kUpLeft, N::kUp | N::kLeft}};
    for (const Corner& corner : kCorners) {
        if ((mask & corner.sides) != corner.sides) mask = static_cast<std::uint8_t>(mask & ~corner.bit);
    }
    return mask;
}

std::vector<std::uint8_t> masksOf(TerrainMode mode) {
    std::vector<std::uint8_t> masks;
    for (unsigned mask = 0; mask <= Neighbour::kAll; ++mask) {
        const auto byte = static_cast<std::uint8_t>(mask);
        if (countedMask(mode, byte) == byte) masks.push_back(byte);
    }
    return masks;
}

}  // namespace plumb
