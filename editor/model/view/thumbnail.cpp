#include "editor/model/view/thumbnail.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb::editor {
namespace {

/// Returns the largest centered part of a box with this aspect ratio (width divided by height).
AABB middleOf(const AABB& box, float shape) {
    const Vec2 size = box.size();
    const Vec2 kept = size.x > size.y * shape ? Vec2{size.y * shape, size.y} : Vec2{size.x, size.x / shape};
    return {box.center() - kept * 0.5f, box.center() + kept * 0.5f};
}

}  // namespace

Image thumbnailOf(const Image& picture, const AABB& part, int width, int height) {
    const AABB all{{}, {static_cast<float>(picture.width), static_cast<float>(picture.height)}};
    const AABB inside{max(part.min, all.min), min(part.max, all.max)};
    if (picture.empty() || width < 1 || height < 1 || inside.size().x < 1.0f || inside.size().y < 1.0f)
        return {};
    const AABB box = middleOf(inside, static_cast<float>(width) / static_cast<float>(height));
    const auto edge = [](float from, float whole, int i, int count, int most) {
        const float at = from + whole * static_cast<float>(i) / static_cast<float>(count);
        return std::clamp(static_cast<int>(std::floor(at)), 0, most);
    };
    Image small{width, height, {}};
    small.rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (int y = 0; y < height; ++y) {
        const int y0 = edge(box.min.y, box.size().y, y, height, picture.height - 1);
        const int y1 = std::max(edge(box.min.y, box.size().y, y + 1, height, picture.height), y0 + 1);
        for (int x = 0; x < width; ++x) {
            const int x0 = edge(box.min.x, box.size().x, x, width, picture.width - 1);
            const int x1 = std::max(edge(box.min.x, box.size().x, x + 1, width, picture.width), x0 + 1);
            std::array<std::uint32_t, 4> sum{};
            for (int py = y0; py < y1; ++py) {
                for (int px = x0; px < x1; ++px) {
                    const auto at = static_cast<std::size_t>(py * picture.width + px) * 4;
                    for (std::size_t c = 0; c < 4; ++c) sum[c] += picture.rgba[at + c];
                }
            }
            const auto count = static_cast<std::uint32_t>((y1 - y0) * (x1 - x0));
            for (const std::uint32_t channel : sum)
                small.rgba.push_back(static_cast<std::uint8_t>(channel / count));
        }
    }
    return small;
}

}  // namespace plumb::editor
