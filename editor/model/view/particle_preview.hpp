#pragma once

#include <vector>

#include "editor/model/document/document.hpp"
#include "scene/particles.hpp"

namespace plumb::editor {

/// The particles of the emitters that are selected, or below what is selected, while the game does not run.
/// They live here: the document is only read. An emitter that does not loop begins again by itself.
class ParticlePreview {
public:
    /// Goes on by the time since the last frame. Anew when other emitters are selected.
    void advance(const Document& document, double seconds);
    /// Nothing is shown any more, e.g. because a game plays.
    void clear();
    /// All emitters begin anew.
    void restart();
    /// Each sends its burst at once, or a handful if it has none.
    void burst(const Document& document);

    [[nodiscard]] bool shows() const { return !emitters_.empty(); }
    [[nodiscard]] const std::vector<EntityId>& emitters() const { return emitters_; }
    [[nodiscard]] const Particles& particles() const { return particles_; }
    /// s from what is shown to the last step
    [[nodiscard]] float back() const { return static_cast<float>(kStep - rest_); }

private:
    static constexpr double kStep = 1.0 / 60.0;  // s

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
    double rest_ = 0.0;  // s that no step has used yet
};

}  // namespace plumb::editor
