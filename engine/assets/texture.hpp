#pragma once

#include "platform/image.hpp"

namespace plumb {

/// A texture of the project. Its size is always known; its pixels are decoded by AssetStore::image().
struct Texture {
    int width = 0;        ///< px
    int height = 0;       ///< px
    Image image;          ///< empty until AssetStore::image() decodes it
    bool wanted = false;  ///< the pixels were requested before, so a changed file is decoded immediately

    /// Guesses the number of square frames side by side, for the log: 1 unless the width is a multiple of the
    /// height and the height a multiple of 8 px.
    [[nodiscard]] int frameCount() const {
        return height > 0 && height % 8 == 0 && width % height == 0 ? width / height : 1;
    }
};

/// Returns the placeholder for a missing image: a conspicuous checkerboard of magenta and black.
const Image& placeholderImage();

}  // namespace plumb
