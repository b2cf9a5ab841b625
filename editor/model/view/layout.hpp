#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "math/rect.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb::editor {

/// The part of the window that a pane occupies. The bottom can be divided into two panes side by side.
enum class Dock : unsigned char { Left, Center, Right, Bottom, BottomRight };
inline constexpr std::size_t kDockCount = 5;

/// A panel and its default position.
struct PanelHome {
    std::string_view title;
    Dock dock = Dock::Bottom;
    bool tall = false;  ///< needs more height than other panels if docked at the bottom
};

/// A bar between two panes that can be dragged. The bottom has separate heights with and without tall panels.
enum class Edge : unsigned char { Left, Right, Bottom, TallBottom, Split };
inline constexpr std::size_t kEdgeCount = 5;

struct LayoutPreset;

/// The layout of the window: the open panels of each pane in order, the visible one of each pane, and the
/// sizes of the panes. The center pane always shows only the scene.
class PaneLayout {
public:
    struct Pane {
        std::vector<std::string> tabs;
        std::string front;  ///< title of the visible tab

        friend bool operator==(const Pane&, const Pane&) = default;
    };

    /// Updates the layout to the existing panels: adds new ones at their default positions, and removes
    /// unknown ones and duplicates.
    void complete(std::span<const PanelHome> panels);

    [[nodiscard]] const Pane& pane(Dock dock) const { return panes_[static_cast<std::size_t>(dock)]; }
    [[nodiscard]] bool isOpen(std::string_view panel) const;
    [[nodiscard]] Dock dockOf(std::string_view panel) const;  ///< dock, also the last one of a closed panel
    /// True if the panel is the front tab of its pane, and panels are not hidden.
    [[nodiscard]] bool isSeen(std::string_view panel) const;

    /// Opens a closed panel in its last dock, and brings it to the front.
    void show(std::string_view panel);
    void close(std::string_view panel);
    /// Moves a panel into a pane and brings it to the front. @param before  index of the tab that will follow
    /// it
    void move(std::string_view panel, Dock to, std::size_t before = ~std::size_t{0});

    /// Size of a pane as a ratio of the window's width or height; Split: ratio of the bottom's width.
    [[nodiscard]] float size(Edge edge) const { return sizes_[static_cast<std::size_t>(edge)]; }
    void resize(Edge edge, float part);  ///< sets the ratio that `size` returns

    bool hidden = false;  ///< hides all panels except the scene; not saved

    [[nodiscard]] Json toJson() const;
    /// Parses a layout; invalid parts keep their defaults and are added to `problems`.
    /// @return nothing if `json` is not an object
    static std::optional<PaneLayout> fromJson(const Json& json, const std::string& where,
                                              std::vector<Error>& problems);

    friend bool operator==(const PaneLayout&, const PaneLayout&) = default;
    friend std::vector<LayoutPreset> makePresets();

private:
    Pane& at(Dock dock) { return panes_[static_cast<std::size_t>(dock)]; }
    /// Removes a panel from its pane or from the closed ones.
    void take(std::string_view panel);

    struct Closed {
        std::string panel;
        Dock dock = Dock::Bottom;  ///< last dock of the panel

        friend bool operator==(const Closed&, const Closed&) = default;
    };

    std::array<Pane, kDockCount> panes_;
    std::vector<Closed> closed_;
    std::array<float, kEdgeCount> sizes_{0.18f, 0.24f, 0.22f, 0.38f, 0.5f};
};

/// A predefined layout for one kind of work. `PaneLayout::complete` must be called before it is used.
struct LayoutPreset {
    std::string_view name;
    std::string_view what;  ///< description for the tooltip
    PaneLayout layout;
};

/// The presets Paint, Logic and Play.
std::span<const LayoutPreset> layoutPresets();

/// Positions of the panes and of the bars between them.
struct PaneBoxes {
    struct Bar {
        Edge edge = Edge::Left;
        AABB box;
        bool upright = true;  ///< true: a vertical bar between a left and a right pane
    };
    std::array<AABB, kDockCount> panes;  ///< px; an empty box if the pane is not shown
    std::vector<Bar> bars;
};

/// Computes the positions of the panes.
/// @param size   px: of the area of all panes
/// @param gap    px: between two panes
/// @param least  px: minimum width of a pane, if the window is wide enough
PaneBoxes arrange(const PaneLayout& layout, std::span<const PanelHome> panels, Vec2 size, float gap,
                  float least);

/// The drop target of a dragged tab.
struct PaneDrop {
    Dock dock = Dock::Bottom;
    AABB box;  ///< px: area that the tab would occupy
};
/// Returns the drop target at a point: a pane, or an outer part of the scene where a new pane would be
/// opened.
/// @param at  px: position of the mouse
std::optional<PaneDrop> dropAt(const PaneLayout& layout, const PaneBoxes& boxes, Vec2 at);

}  // namespace plumb::editor
