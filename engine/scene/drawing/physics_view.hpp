#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/result.hpp"
#include "math/color.hpp"
#include "platform/events.hpp"
#include "reflect/entity_id.hpp"

namespace plumb {

class PhysicsTimes;

/// One kind of physics data that can be shown over the scene; an element of physicsLayers().
struct PhysicsLayer {
    std::string_view name;   ///< name in command line options
    std::string_view label;  ///< name in menus
    std::string_view doc;    ///< description, for tooltips
    unsigned bit;            ///< bit in a set of layers
    Key key;                 ///< shortcut in the player, with Ctrl: shows or hides the layer
    bool withShift;          ///< the shortcut needs Shift too
    bool atFirst;            ///< shown by default
    bool ofBodies;           ///< can be limited to the selected entities
};
std::span<const PhysicsLayer> physicsLayers();

// Layers that are tables of numbers; the bits of the other layers are those of physics::DebugPart.
inline constexpr unsigned kPhysicsTimes = 1u << 30;
inline constexpr unsigned kPhysicsCounts = 1u << 31;

/// Returns the set of layers with these names, e.g. "shapes,contacts", or "all".
/// @error an unknown name; the remedy suggests the closest one
Result<unsigned> physicsLayersNamed(std::string_view names);

/// The entities for which a layer is shown.
enum class PhysicsReach : std::uint8_t { Off, Selected, All };

/// The physics data that is drawn in a frame.
struct PhysicsShown {
    unsigned layers = 0;      ///< set of PhysicsLayer::bit: layers shown for all bodies
    unsigned ofSelected = 0;  ///< set of PhysicsLayer::bit: layers shown for `selected` only
    std::span<const EntityId> selected{};
    const PhysicsTimes* times = nullptr;  ///< for the table of times; null: not measured

    [[nodiscard]] unsigned any() const { return layers | ofSelected; }
};

/// Settings of the physics debug view in the player and the editor.
struct PhysicsView {
    PhysicsView();

    bool on = false;
    unsigned layers;          ///< set of PhysicsLayer::bit: layers shown for all bodies while the view is on
    unsigned ofSelected = 0;  ///< set of PhysicsLayer::bit: layers shown for selected entities only

    [[nodiscard]] PhysicsShown shown() const {
        return on ? PhysicsShown{layers, ofSelected} : PhysicsShown{};
    }
    [[nodiscard]] PhysicsReach reachOf(const PhysicsLayer& layer) const;
    void setReach(const PhysicsLayer& layer, PhysicsReach reach);
    /// Hides the layer if it is shown for all bodies; otherwise
    /// shows it for all bodies and turns the view on.
    void toggle(const PhysicsLayer& layer);
    /// Handles shortcuts: F3 turns the view on or off; while it
    /// is on, Ctrl+digit and Ctrl+Shift+digit toggle layers.
    /// @return  true if the key was F3
    bool handle(const Event& event);
};

/// A row of the legend: a colour and its meaning.
struct PhysicsColor {
    std::string_view label;
    Color color;
    unsigned layer;  ///< bit of the layer that draws it
};

}  // namespace plumb
