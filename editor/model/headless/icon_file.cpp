#include "editor/model/headless/icon_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "platform/image_file.hpp"

namespace plumb::editor {
namespace {

constexpr std::array kSides{16, 24, 32, 48, 64, 256};  // px
constexpr std::size_t kHeadBytes = 6;
constexpr std::size_t kEntryBytes = 16;

void append(std::string& bytes, std::size_t number, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

/// The mean of the pixels in a rectangle whose sides may lie within pixels.
std::array<std::uint8_t, 4> meanOf(const Image& image, double left, double top, double side) {
    std::array<double, 4> sum{};
    double area = 0.0;
    const auto shareOf = [](int at, double from, double length) {
        return std::min(at + 1.0, from + length) - std::max<double>(at, from);
    };
    for (int y = static_cast<int>(top); y < image.height && y < top + side; ++y) {
        for (int x = static_cast<int>(left); x < image.width && x < left + side; ++x) {
            const double share = shareOf(x, left, side) * shareOf(y, top, side);
            const std::uint8_t* pixel =
                &image.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x)) *
                            4];
            for (std::size_t i = 0; i < 3; ++i) sum[i] += share * pixel[3] * pixel[i];
            sum[3] += share * pixel[3];
            area += share;
        }
    }
    std::array<std::uint8_t, 4> mean{};
    if (sum[3] <= 0.0) return mean;
    for (std::size_t i = 0; i < 3; ++i) mean[i] = static_cast<std::uint8_t>(std::lround(sum[i] / sum[3]));
    mean[3] = static_cast<std::uint8_t>(std::lround(sum[3] / area));
    return mean;
}

}  // namespace

Image shrunk(const Image& image, int side) {
    Image small{side, side, {}};
    const double step = static_cast<double>(image.width) / side;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto mean = meanOf(image, x * step, y * step, step);
            small.rgba.insert(small.rgba.end(), mean.begin(), mean.end());
        }
    }
    return small;
}

Result<std::string> iconFile(const Image& picture, std::string_view where) {
    if (picture.width != picture.height || picture.width < kSides.front())
        return Error{std::string{where},
                     format("expected an icon that is square and has at least {} px a side, found {}x{} px",
                            kSides.front(), picture.width, picture.height),
                     "change the picture; 256x256 px serves every use"};
    std::vector<std::pair<int, std::string>> pictures;
    for (const int side : kSides) {
        if (side > picture.width) break;
        Result<std::string> png = encodePng(shrunk(picture, side));
        if (!png) return png.error();
        pictures.emplace_back(side, std::move(*png));
    }
    std::string head, content;
    append(head, 0, 2);
    append(head, 1, 2);  // an icon, not a cursor
    append(head, pictures.size(), 2);
    const std::size_t start = kHeadBytes + kEntryBytes * pictures.size();
    for (const auto& [side, png] : pictures) {
        for (int i = 0; i < 2; ++i) append(head, static_cast<std::size_t>(side), 1);  // 256 px: 0
        append(head, 0, 2);                                                           // no palette
        append(head, 1, 2);                                                           // planes
        append(head, 32, 2);                                                          // bits of a pixel
        append(head, png.size(), 4);
        append(head, start + content.size(), 4);
        content += png;
    }
    return head + content;
}

}  // namespace plumb::editor
