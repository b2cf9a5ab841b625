#pragma once

#include <optional>
#include <vector>

namespace plumb {

/// Packs rectangles into a square: each is placed at the smallest possible y, then at the smallest x.
/// Source: J. Jylanki, "A Thousand Ways to Pack the Bin", 2010, section 2.6, skyline bottom-left.
class Skyline {
public:
    struct Place {
        int x = 0;  ///< px
        int y = 0;  ///< px
    };

    explicit Skyline(int side) : side_{side}, steps_{{0, 0, side}} {}

    /// Places a rectangle. @return its position; no value if there is no room
    std::optional<Place> add(int width, int height);

private:
    /// A horizontal segment of the skyline: at smaller y the square is occupied.
    struct Step {
        int x = 0;
        int y = 0;
        int width = 0;
    };

    [[nodiscard]] std::optional<int> heightAt(std::size_t index, int width) const;
    void raise(std::size_t index, const Step& top);

    int side_;  ///< side length of the square, px
    std::vector<Step> steps_;
};

}  // namespace plumb
