#pragma once

#include <string_view>
#include <vector>

#include "app/effect_rows.hpp"
#include "app/game.hpp"
#include "app/game_content.hpp"
#include "app/system_order.hpp"
#include "scene/components.hpp"
#include "scene/systems/camera_system.hpp"

namespace plumb::test {

/// A pile of crates in a game that has every system, although only the physics is required.
class PileGame : public Game {
public:
    /// @param without  an effect whose systems are not added
    explicit PileGame(int crates = 12, std::string_view without = {}) {
        content.useSystemOrder(world);
        for (const SystemRow& system : systemTable()) {
            if (without.empty() || system.effect != without) system.add(world);
        }
        world.resource<PictureSize>();  // scenes add this resource
        Entity floor = world.createEntity();
        floor.addComponent<Transform>(-400.0f, 200.0f);
        floor.addComponent<BoxCollider>(1200, 20);
        floor.addComponent<StaticBody>();
        for (int i = 0; i < crates; ++i) {
            Entity crate = world.createEntity();
            crate.addComponent<Transform>(static_cast<float>(i % 5) * 17.0f,
                                          150.0f - 18.0f * static_cast<float>(i / 5));
            crate.addComponent<BoxCollider>(16, 16);
            crate.addComponent<RigidBody>();
        }
    }
    void play(int ticks) {
        for (int i = 0; i < ticks; ++i) tickGame(*this, InputFrame{});
    }
};

/// Indices of the effects in the effect table that are not effects of the physics.
inline std::vector<std::size_t> gameEffects() {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < engineEffects().rows().size(); ++i) {
        if (engineEffects().rows()[i].physics == physics::Effect::Count) rows.push_back(i);
    }
    return rows;
}

inline bool hasSystem(std::size_t row) {
    for (const EffectSystem& system : engineEffects().systems()) {
        if (system.effect == engineEffects().rows()[row].name) return true;
    }
    return false;
}

}  // namespace plumb::test
