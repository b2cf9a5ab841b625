#include "render/skyline.hpp"

#include <algorithm>

namespace plumb {

/// Returns the smallest y of a rectangle with the left edge of a step; no value if it is too wide.
std::optional<int> Skyline::heightAt(std::size_t index, int width) const {
    if (steps_[index].x + width > side_) return std::nullopt;
    int top = 0;
    for (int left = width; left > 0; ++index) {
        top = std::max(top, steps_[index].y);
        left -= steps_[index].width;
    }
    return top;
}

std::optional<Skyline::Place> Skyline::add(int width, int height) {
    if (width <= 0 || height <= 0) return std::nullopt;
    std::optional<Place> best;
    std::size_t bestIndex = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::optional<int> top = heightAt(i, width);
        if (top && *top + height <= side_ && (!best || *top < best->y)) {
            best = Place{steps_[i].x, *top};
            bestIndex = i;
        }
    }
    if (best) raise(bestIndex, {best->x, best->y + height, width});
    return best;
}

/// Inserts a step before `index` and removes the covered parts of the following steps.
void Skyline::raise(std::size_t index, const Step& top) {
    steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(index), top);
    const int end = top.x + top.width;
    std::size_t next = index + 1;
    while (next < steps_.size() && steps_[next].x + steps_[next].width <= end) {
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(next));
    }
    if (next < steps_.size() && steps_[next].x < end) {
        steps_[next].width -= end - steps_[next].x;
        steps_[next].x = end;
    }
}

}  // namespace plumb
