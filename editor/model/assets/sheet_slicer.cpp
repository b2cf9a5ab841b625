#include "editor/model/assets/sheet_slicer.hpp"

#include <algorithm>
#include <cstddef>

namespace plumb::editor {
namespace {

constexpr std::uint8_t kMaxEmptyAlpha = 8;  // maximum alpha (0 to 255) of a pixel that counts as empty
constexpr int kSmallestCell = 4;            // px

bool isSolid(const Image& image, int x, int y) {
    const auto at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return image.rgba[at * 4 + 3] > kMaxEmptyAlpha;
}

/// Finds connected shapes by flood fill, without recursion.
class ShapeFinder {
public:
    explicit ShapeFinder(const Image& image)
        : image_{image},
          seen_(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {}

    std::vector<Rect> find(int smallest) {
        std::vector<Rect> shapes;
        for (int y = 0; y < image_.height; ++y) {
            for (int x = 0; x < image_.width; ++x) {
                if (!take(x, y)) continue;
                const Rect box = fillFrom(x, y);
                const auto least = static_cast<float>(smallest);
                if (box.width >= least && box.height >= least) shapes.push_back(box);
            }
        }
        return shapes;
    }

private:
    bool take(int x, int y) {
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || !isSolid(image_, x, y)) return false;
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                        static_cast<std::size_t>(x);
        if (seen_[at]) return false;
        seen_[at] = true;
        open_.push_back({x, y});
        return true;
    }

    Rect fillFrom(int x, int y) {
        int left = x, right = x, top = y, bottom = y;
        while (!open_.empty()) {
            const auto [atX, atY] = open_.back();
            open_.pop_back();
            left = std::min(left, atX), right = std::max(right, atX);
            top = std::min(top, atY), bottom = std::max(bottom, atY);
            for (int stepY = -1; stepY <= 1; ++stepY) {
                for (int stepX = -1; stepX <= 1; ++stepX) take(atX + stepX, atY + stepY);
            }
        }
        return {static_cast<float>(left), static_cast<float>(top), static_cast<float>(right - left + 1),
                static_cast<float>(bottom - top + 1)};
    }

    struct Place {
        int x;
        int y;
    };
    const Image& image_;
    std::vector<bool> seen_;
    std::vector<Place> open_;
};

/// Returns the smallest cell length that divides the side evenly and cuts through no shape; else the side.
int cellLength(int side, const std::vector<Rect>& shapes, bool along) {
    for (int length = kSmallestCell; length < side; ++length) {
        if (side % length != 0) continue;
        const bool cuts = std::any_of(shapes.begin(), shapes.end(), [&](const Rect& shape) {
            const int from = static_cast<int>(along ? shape.x : shape.y);
            const int to = from + static_cast<int>(along ? shape.width : shape.height) - 1;
            return from / length != to / length;
        });
        if (!cuts) return length;
    }
    return side;
}

}  // namespace

std::vector<Rect> shapesIn(const Image& image, int smallest) {
    std::vector<Rect> shapes = image.empty() ? std::vector<Rect>{} : ShapeFinder{image}.find(smallest);
    std::stable_sort(shapes.begin(), shapes.end(), [](const Rect& a, const Rect& b) {
        if (a.y + a.height <= b.y || b.y + b.height <= a.y) return a.y < b.y;
        return a.x < b.x;
    });
    return shapes;
}

CellSize guessCells(const Image& image) {
    const std::vector<Rect> shapes = shapesIn(image, 1);
    if (shapes.empty()) return {};
    const CellSize cells{cellLength(image.width, shapes, true), cellLength(image.height, shapes, false)};
    return cells == CellSize{image.width, image.height} ? CellSize{} : cells;
}

bool hasContent(const Image& image, const Rect& cell) {
    const int right = std::min(static_cast<int>(cell.x + cell.width), image.width);
    const int bottom = std::min(static_cast<int>(cell.y + cell.height), image.height);
    for (int y = std::max(static_cast<int>(cell.y), 0); y < bottom; ++y) {
        for (int x = std::max(static_cast<int>(cell.x), 0); x < right; ++x) {
            if (isSolid(image, x, y)) return true;
        }
    }
    return false;
}

}  // namespace plumb::editor
