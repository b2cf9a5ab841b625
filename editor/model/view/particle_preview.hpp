#pragma once

#include <vector>

#include "editor/model/document/document.hpp"
#include "scene/particles.hpp"

namespace plumb::editor {

/// Simulates the particles of selected emitters, and of those below selected entities, while no game runs.
/// The document is only read. An emitter that does not loop restarts automatically.
class ParticlePreview {
public:
    /// Advances by the time since the last frame. Restarts if other emitters are selected.
    void advance(const Document& document, double seconds);
    /// Removes all particles and emitters, e.g. because a game starts.
    void clear();
    /// Removes all particles and restarts all emitters.
    void restart();
    /// Makes each emitter emit its burst, or 30 particles if it has none.
    void burst(const Document& document);

    [[nodiscard]] bool shows() const { return !emitters_.empty(); }
    [[nodiscard]] const std::vector<EntityId>& emitters() const { return emitters_; }
    [[nodiscard]] const Particles& particles() const { return particles_; }
    /// Time from the shown moment to the last simulated step, s; for interpolation.
    [[nodiscard]] float back() const { return static_cast<float>(kStep - rest_); }

private:
    static constexpr double kStep = 1.0 / 60.0;  // s: duration of a simulation step

    struct Seen {
        std::uint64_t selection = ~0ull;
        std::uint64_t scene = ~0ull;
        friend bool operator==(const Seen&, const Seen&) = default;
    };

    void findEmitters(const Document& document);
    void step(const World& world);

    Particles particles_;
    std::vector<EntityId> emitters_;
    Seen seen_;
    double rest_ = 0.0;  // s: elapsed time that is not simulated yet
};

}  // namespace plumb::editor
