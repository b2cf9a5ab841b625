#pragma once

#include <map>
#include <string>
#include <string_view>

#include "math/rect.hpp"

namespace plumb::editor::ui {

/// Where each named widget of the last frame was and what it showed, so that a test (or a guide that points
/// at things) says "Inspector/Transform/position.x" instead of pixels.
class WidgetMap {
public:
    struct Widget {
        AABB box;  ///< in the units of mouse positions
        std::string value;
    };

    void beginFrame() { widgets_.clear(); }
    /// Remembers the ImGui item just drawn.
    void mark(std::string_view path, std::string_view value = {});
    void mark(std::string_view path, const AABB& box, std::string_view value = {});

    [[nodiscard]] const Widget* find(std::string_view path) const;
    [[nodiscard]] const std::map<std::string, Widget, std::less<>>& all() const { return widgets_; }

private:
    std::map<std::string, Widget, std::less<>> widgets_;
};

}  // namespace plumb::editor::ui
