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

/// Something of the physics that can be shown over the scene: a row of physicsLayers().
struct PhysicsLayer {
    std::string_view name;  ///< in options
    std::string_view label;
    std::string_view doc;
    unsigned bit;    ///< of a set of layers
    Key key;         ///< with Ctrl: shows or hides it in the player
    bool withShift;  ///< with Ctrl and Shift
    bool atFirst;    ///< shown until the user chooses
    bool ofBodies;   ///< can be shown of some bodies alone
};
std::span<const PhysicsLayer> physicsLayers();

/// Layers of numbers, which no picture has; the others are those of physics::DebugPart.
inline constexpr unsigned kPhysicsTimes = 1u << 30;
inline constexpr unsigned kPhysicsCounts = 1u << 31;

/// A set of layers from their names, e.g. "shapes,contacts", or "all".
/// @error a name that there is not; the remedy names the closest one
Result<unsigned> physicsLayersNamed(std::string_view names);

/// Whose a layer shows.
enum class PhysicsReach : std::uint8_t { Off, Selected, All };

/// What is drawn of the physics in a frame.
struct PhysicsShown {
    unsigned layers = 0;      ///< bits of PhysicsLayer: of all bodies
    unsigned ofSelected = 0;  ///< of those alone:
    std::span<const EntityId> selected{};
    const PhysicsTimes* times = nullptr;

    [[nodiscard]] unsigned any() const { return layers | ofSelected; }
};

/// What the player and the editor show of the physics.
struct PhysicsView {
    PhysicsView();

    bool on = false;
    unsigned layers;          ///< bits of PhysicsLayer that are shown while it is on
    unsigned ofSelected = 0;  ///< those that are shown of what is selected

    [[nodiscard]] PhysicsShown shown() const {
        return on ? PhysicsShown{layers, ofSelected} : PhysicsShown{};
    }
    [[nodiscard]] PhysicsReach reachOf(const PhysicsLayer& layer) const;
    void setReach(const PhysicsLayer& layer, PhysicsReach reach);
    /// Shows a layer of all bodies, and the view with it, or hides it.
    void toggle(const PhysicsLayer& layer);
    /// F3 shows or hides all; while it is shown, Ctrl and a digit its layers, Ctrl+Shift and a digit the
    /// rest.
    /// @return  whether it was F3
    bool handle(const Event& event);
};

/// A line of the legend: what a colour stands for.
struct PhysicsColor {
    std::string_view label;
    Color color;
    unsigned layer;  ///< bit of the layer that draws it
};

}  // namespace plumb
