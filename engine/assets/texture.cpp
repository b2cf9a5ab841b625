#include "assets/texture.hpp"

namespace plumb {
namespace {

constexpr int kSide = 32;  // px
constexpr int kCell = 8;   // px

Image makeChecker() {
    Image image{kSide, kSide, {}};
    image.rgba.reserve(std::size_t{4} * kSide * kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const std::uint8_t light = (x / kCell + y / kCell) % 2 == 0 ? 255 : 0;
            image.rgba.insert(image.rgba.end(), {light, 0, light, 255});
        }
    }
    return image;
}

}  // namespace

const Image& placeholderImage() {
    static const Image checker = makeChecker();
    return checker;
}

}  // namespace plumb
