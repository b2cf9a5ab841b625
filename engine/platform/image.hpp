#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumb {

/// An image in memory: rows from the top, each pixel red, green, blue, opacity, not premultiplied.
struct Image {
    int width = 0;                   ///< px
    int height = 0;                  ///< px
    std::vector<std::uint8_t> rgba;  ///< width * height * 4 bytes

    [[nodiscard]] bool empty() const { return rgba.empty(); }
    friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace plumb
