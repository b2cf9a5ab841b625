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

/// Where a panel stands in the window. The bottom has two places beside each other.
enum class Dock : unsigned char { Left, Center, Right, Bottom, BottomRight };
inline constexpr std::size_t kDockCount = 5;

/// A panel that there is, and where it stands until the user moves it.
struct PanelHome {
    std::string_view title;
    Dock dock = Dock::Bottom;
    bool tall = false;  ///< at the bottom it needs more height than others
};

/// What can be dragged between two panes. The bottom has a height for tall panels and one for the others.
enum class Edge : unsigned char { Left, Right, Bottom, TallBottom, Split };
inline constexpr std::size_t kEdgeCount = 5;

struct LayoutPreset;

/// Which panels are open, in which pane, in which order, which of each pane is seen, and how large the panes
/// are. The scene itself always stands in the middle, alone.
class PaneLayout {
public:
    struct Pane {
        std::vector<std::string> tabs;
        std::string front;  ///< the one that is seen

        friend bool operator==(const Pane&, const Pane&) = default;
    };

    /// Brings the layout in line with the panels that there are: new ones go to their homes, those that are
    /// no more are left out, each stands in one place.
    void complete(std::span<const PanelHome> panels);

    [[nodiscard]] const Pane& pane(Dock dock) const { return panes_[static_cast<std::size_t>(dock)]; }
    [[nodiscard]] bool isOpen(std::string_view panel) const;
    [[nodiscard]] Dock dockOf(std::string_view panel) const;  ///< where it is, or was when it was closed
    /// Whether it is open and in front of the others of its pane, and panels are not hidden.
    [[nodiscard]] bool isSeen(std::string_view panel) const;

    /// Opens it where it was, if it is closed, and brings it to the front.
    void show(std::string_view panel);
    void close(std::string_view panel);
    /// Puts it into another pane, before the tab of that number, and to the front.
    void move(std::string_view panel, Dock to, std::size_t before = ~std::size_t{0});

    /// A part of the window's width or height; Split: of the bottom's width.
    [[nodiscard]] float size(Edge edge) const { return sizes_[static_cast<std::size_t>(edge)]; }
    void resize(Edge edge, float part);

    bool hidden = false;  ///< only the scene is seen; not saved

    [[nodiscard]] Json toJson() const;
    /// @return nothing when it is no layout; what is wrong is added to `problems`
    static std::optional<PaneLayout> fromJson(const Json& json, const std::string& where,
                                              std::vector<Error>& problems);

    friend bool operator==(const PaneLayout&, const PaneLayout&) = default;
    friend std::vector<LayoutPreset> makePresets();

private:
    Pane& at(Dock dock) { return panes_[static_cast<std::size_t>(dock)]; }
    /// Out of wherever it is.
    void take(std::string_view panel);

    struct Closed {
        std::string panel;
        Dock dock = Dock::Bottom;  ///< where it was

        friend bool operator==(const Closed&, const Closed&) = default;
    };

    std::array<Pane, kDockCount> panes_;
    std::vector<Closed> closed_;
    std::array<float, kEdgeCount> sizes_{0.18f, 0.24f, 0.22f, 0.38f, 0.5f};
};

/// A layout for one kind of work. To be completed before it is used.
struct LayoutPreset {
    std::string_view name;
    std::string_view what;  ///< for the tooltip
    PaneLayout layout;
};

/// Paint, Logic and Play.
std::span<const LayoutPreset> layoutPresets();

/// Where panes and the bars between them lie in a window of that size.
struct PaneBoxes {
    struct Bar {
        Edge edge = Edge::Left;
        AABB box;
        bool upright = true;  ///< divides left from right
    };
    std::array<AABB, kDockCount> panes;  ///< px; without size: not there
    std::vector<Bar> bars;
};

/// @param size  px of all panes together
/// @param gap   px between two panes
/// @param least px that a pane should have
PaneBoxes arrange(const PaneLayout& layout, std::span<const PanelHome> panels, Vec2 size, float gap,
                  float least);

/// Where a tab that is dragged would come to stand.
struct PaneDrop {
    Dock dock = Dock::Bottom;
    AABB box;  ///< px; the area that the dropped tab would take
};
/// @param at  px; the mouse. Over the scene the parts of it count where a pane is not there yet
std::optional<PaneDrop> dropAt(const PaneLayout& layout, const PaneBoxes& boxes, Vec2 at);

}  // namespace plumb::editor
