#pragma once

#include <cstddef>
#include <cstdint>

// All limits on external data. A file that exceeds one of them is refused with a message.
namespace plumb::limits {

inline constexpr std::size_t kFileBytes = std::size_t{256} << 20;   ///< of one file
inline constexpr int kJsonDepth = 64;                               ///< arrays and objects inside each other
inline constexpr std::size_t kJsonValues = std::size_t{1} << 24;    ///< of one file
inline constexpr int kXmlDepth = 64;                                ///< elements inside each other
inline constexpr std::size_t kXmlElements = std::size_t{1} << 20;   ///< of one file
inline constexpr std::size_t kTextBytes = std::size_t{1} << 20;     ///< of one string
inline constexpr std::size_t kEntities = std::size_t{1} << 20;      ///< of one scene file or imported map
inline constexpr int kImageSide = 16384;                            ///< px
inline constexpr std::size_t kImageBytes = std::size_t{512} << 20;  ///< decoded, RGBA
inline constexpr std::size_t kCompressionRatio = 1000;              ///< unpacked bytes per packed byte
inline constexpr int kTileSide = 16384;                             ///< tiles along one side of a grid
inline constexpr std::size_t kTiledCells = std::size_t{1} << 26;  ///< cells in all layers of one imported map
inline constexpr int kPrefabDepth = 16;                           ///< prefabs inside prefabs

}  // namespace plumb::limits
