#pragma once

#include <map>
#include <string>
#include <string_view>

#include "math/rect.hpp"

namespace plumb::editor::ui {

/// Position and value of each named widget of the last frame, so that tests and tour scripts can use paths
/// such as "Inspector/Transform/position.x" instead of coordinates.
class WidgetMap {
public:
    struct Widget {
        AABB box;  ///< bounds, in the units of mouse positions
        std::string value;
    };

    void beginFrame() { widgets_.clear(), focused_.clear(); }
    /// Stores the last ImGui item under a path.
    void mark(std::string_view path, std::string_view value = {});
    void mark(std::string_view path, const AABB& box, std::string_view value = {});

    [[nodiscard]] const Widget* find(std::string_view path) const;
    /// Path of the widget that has the keyboard focus; empty: none of the marked ones.
    [[nodiscard]] const std::string& focused() const { return focused_; }
    [[nodiscard]] const std::map<std::string, Widget, std::less<>>& all() const { return widgets_; }

private:
    std::map<std::string, Widget, std::less<>> widgets_;
    std::string focused_;
};

}  // namespace plumb::editor::ui
