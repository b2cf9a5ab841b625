#pragma once

#include <optional>
#include <vector>

namespace plumb {

/// Finds places for rectangles on a square sheet: each goes where it ends highest up, then furthest left.
/// Source: J. Jylanki, "A Thousand Ways to Pack the Bin", 2010, section 2.6, skyline bottom-left
class Skyline {
public:
    struct Place {
        int x = 0;  ///< px
        int y = 0;  ///< px
    };

    explicit Skyline(int side) : side_{side}, steps_{{0, 0, side}} {}

    /// @return where it lies now; nothing when there is no room
    std::optional<Place> add(int width, int height);

private:
    /// One horizontal piece of the line below which everything is taken.
    struct Step {
        int x = 0;
        int y = 0;
        int width = 0;
    };

    [[nodiscard]] std::optional<int> heightAt(std::size_t index, int width) const;
    void raise(std::size_t index, const Step& top);

    int side_;
    std::vector<Step> steps_;
};

}  // namespace plumb
