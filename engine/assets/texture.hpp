#pragma once

#include "platform/image.hpp"

namespace plumb {

/// A picture of the project. Its size is known at once; its pixels are in the store, decoded when asked for.
struct Texture {
    int width = 0;        ///< px
    int height = 0;       ///< px
    Image image;          ///< empty until the store was asked for it
    bool wanted = false;  ///< the pixels were asked for once: a changed file is decoded before it counts

    /// How many square cells of a sheet lie side by side; 1 for a single picture. Only a guess for the log,
    /// made where the height is a whole number of 8 px, as cells are drawn.
    [[nodiscard]] int frameCount() const {
        return height > 0 && height % 8 == 0 && width % height == 0 ? width / height : 1;
    }
};

/// What stands in for a picture that is missing: a checker of magenta and black that cannot be overlooked.
const Image& placeholderImage();

}  // namespace plumb
