#include "scene/drawing/physics_view.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "physics/debug_draw.hpp"

namespace plumb {
namespace {

constexpr std::array kLayers{
    // clang-format off
    PhysicsLayer{"shapes", "Shapes", "Outlines of colliders, colored by the state of their body", physics::kDrawShapes,
                 Key::Digit1, false, true, true},
    PhysicsLayer{"contacts", "Contacts", "Contact points of shapes, while playing", physics::kDrawContacts,
                 Key::Digit2, false, true, true},
    PhysicsLayer{"normals", "Normals", "Normal directions of contacts, while playing", physics::kDrawNormals,
                 Key::Digit3, false, false, true},
    PhysicsLayer{"impulses", "Impulses", "Normal impulses of contacts, relative to the lighter body, while playing",
                 physics::kDrawImpulses, Key::Digit4, false, false, true},
    PhysicsLayer{"friction", "Friction", "Friction impulses of contacts, while playing", physics::kDrawFriction,
                 Key::Digit5, false, false, true},
    PhysicsLayer{"joints", "Joints", "Anchors and limits of joints", physics::kDrawJoints,
                 Key::Digit6, false, true, true},
    PhysicsLayer{"jointForces", "Joint forces", "Forces of joints, relative to the lighter body, while playing",
                 physics::kDrawJointForces, Key::Digit7, false, false, true},
    PhysicsLayer{"velocities", "Velocities", "Velocities of bodies, as their displacement in 0.1 s", physics::kDrawVelocities,
                 Key::Digit8, false, false, true},
    PhysicsLayer{"centres", "Centres", "Centres of mass of dynamic bodies", physics::kDrawCentres,
                 Key::Digit9, false, false, true},
    PhysicsLayer{"islands", "Islands", "One colour per island: bodies connected by contacts or joints, which sleep together",
                 physics::kDrawIslands, Key::Digit0, false, false, true},
    PhysicsLayer{"triggers", "Triggers", "Outlines of triggers, and lines to the bodies inside", physics::kDrawTriggers,
                 Key::Digit1, true, true, true},
    PhysicsLayer{"fields", "Fields", "Regions of wind, fluids, gravity fields and attractors", physics::kDrawFields,
                 Key::Digit2, true, true, true},
    PhysicsLayer{"sleep", "Sleep", "Bodies at rest, filled by how close they are to falling asleep, while playing", physics::kDrawRest,
                 Key::Digit3, true, false, true},
    PhysicsLayer{"sweeps", "Sweeps", "Paths of fast bodies in the last tick, and their points of impact",
                 physics::kDrawSweeps, Key::Digit4, true, false, true},
    PhysicsLayer{"bounds", "Bounds", "Bounding box of each shape", physics::kDrawBounds,
                 Key::Digit5, true, false, true},
    PhysicsLayer{"broadPhase", "Broad phase", "Enlarged bounding boxes of the broad phase, and its tree or grid",
                 physics::kDrawBroadPhase, Key::Digit6, true, false, true},
    PhysicsLayer{"paths", "Paths", "Predicted paths of bodies in the next second, without obstacles", physics::kDrawPaths,
                 Key::Digit9, true, false, true},
    PhysicsLayer{"times", "Times", "Time of each stage of a tick", kPhysicsTimes,
                 Key::Digit7, true, false, false},
    PhysicsLayer{"counts", "Counts", "Numbers of bodies, contacts and islands", kPhysicsCounts,
                 Key::Digit8, true, false, false},
    // clang-format on
};

unsigned allLayers() {
    unsigned all = 0;
    for (const PhysicsLayer& layer : kLayers) all |= layer.bit;
    return all;
}

Error unknownLayer(std::string_view name) {
    std::vector<std::string_view> known{"all"};
    for (const PhysicsLayer& layer : kLayers) known.push_back(layer.name);
    const std::string_view near = closestName(name, known);
    std::string all;
    for (const std::string_view one : known) all += (all.empty() ? "" : ", ") + std::string{one};
    return Error{"physics view", format("there is no layer \"{}\"", name),
                 near.empty() ? "layers: " + all : format("did you mean \"{}\"?", near)};
}

}  // namespace

std::span<const PhysicsLayer> physicsLayers() { return kLayers; }

Result<unsigned> physicsLayersNamed(std::string_view names) {
    unsigned layers = 0;
    while (!names.empty()) {
        const std::size_t comma = std::min(names.find(','), names.size());
        const std::string_view name = names.substr(0, comma);
        names.remove_prefix(std::min(comma + 1, names.size()));
        const auto row = std::find_if(kLayers.begin(), kLayers.end(),
                                      [name](const PhysicsLayer& layer) { return layer.name == name; });
        if (row == kLayers.end() && name != "all") return unknownLayer(name);
        layers |= row != kLayers.end() ? row->bit : allLayers();
    }
    return layers;
}

PhysicsView::PhysicsView() : layers{0} {
    for (const PhysicsLayer& layer : kLayers) layers |= layer.atFirst ? layer.bit : 0;
}

PhysicsReach PhysicsView::reachOf(const PhysicsLayer& layer) const {
    if (!on) return PhysicsReach::Off;
    if ((layers & layer.bit) != 0) return PhysicsReach::All;
    return (ofSelected & layer.bit) != 0 ? PhysicsReach::Selected : PhysicsReach::Off;
}

void PhysicsView::setReach(const PhysicsLayer& layer, PhysicsReach reach) {
    layers &= ~layer.bit;
    ofSelected &= ~layer.bit;
    if (reach == PhysicsReach::All) layers |= layer.bit;
    if (reach == PhysicsReach::Selected) ofSelected |= layer.bit;
    if (reach != PhysicsReach::Off) on = true;
}

void PhysicsView::toggle(const PhysicsLayer& layer) {
    setReach(layer, reachOf(layer) == PhysicsReach::All ? PhysicsReach::Off : PhysicsReach::All);
}

bool PhysicsView::handle(const Event& event) {
    if (event.kind != EventKind::KeyDown || event.repeated) return false;
    if (event.key == Key::F3) {
        on = !on;
        return true;
    }
    if (!on || !event.modifiers.control) return false;
    for (const PhysicsLayer& layer : kLayers) {
        if (layer.key == event.key && layer.withShift == event.modifiers.shift) toggle(layer);
    }
    return false;
}

}  // namespace plumb
