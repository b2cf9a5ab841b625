#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "gameplay/components.hpp"
#include "gameplay/label_values.hpp"
#include "physics/soft/softbody.hpp"
#include "scene/components.hpp"
#include "scene/components/name.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/soft_sync.hpp"
#include "scene/world_transform.hpp"
#include "tests/app/projects/project_content.hpp"
#include "tests/support/places.hpp"

namespace plumb {

/// Names of the scenes of the gallery, without the menu and the overlay.
inline std::vector<std::string> galleryScenes() {
    std::vector<std::string> scenes;
    const Path folder = test::sourceFolder() / "projects/physics-playground/scenes";
    for (const std::string& file : filesBelow(folder, ".scene.json")) {
        const std::string name = file.substr(0, file.find('.'));
        if (name != "menu" && name != "pause") scenes.push_back(name);
    }
    return scenes;
}

/// A scene of projects/physics-playground or another project that is played without a window.
struct Playground {
    static Project project(const std::string& name) {
        Result<Project> loaded = loadProject(test::sourceFolder() / "projects" / name);
        EXPECT_TRUE(loaded.ok());
        return *loaded;
    }

    ProjectGame played;
    SceneGame& game = played.game;
    InputFrame frame;

    explicit Playground(const std::string& scene, const std::string& sample = "physics-playground")
        : played{project(sample), scene} {
        game.onCreate();
        EXPECT_FALSE(game.failure()) << scene;
    }

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tickGame(game, frame);
    }
    void hold(Key key, int ticks) {
        frame.set(key, true);
        run(ticks);
        frame.set(key, false);
    }
    /// Runs until a condition is true, for at most `most` ticks. @return number of ticks
    template <class So>
    int runUntil(int most, So so) {
        int ticks = 0;
        while (ticks < most && !so()) run(1), ++ticks;
        return ticks;
    }

    EntityId find(std::string_view name) {
        for (auto [entity, named] : std::as_const(game.world).query<const Name>(withPaused)) {
            if (game.world.texts().find(named.text) == name) return entity.id();
        }
        ADD_FAILURE() << "there is no " << name;
        return {};
    }
    /// Returns all entities whose names begin with a text, in the order of the scene.
    std::vector<EntityId> all(std::string_view beginning) {
        std::vector<std::pair<std::int32_t, EntityId>> found;
        for (auto [entity, named, from] : std::as_const(game.world).query<const Name, const SceneEntity>()) {
            if (game.world.texts().find(named.text).starts_with(beginning))
                found.push_back({from.order, entity.id()});
        }
        EXPECT_FALSE(found.empty()) << "no entity name begins with " << beginning;
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<EntityId> entities;
        for (const auto& [order, entity] : found) entities.push_back(entity);
        return entities;
    }
    Vec2 at(EntityId entity) { return worldPose(game.world, entity).position; }
    Vec2 at(std::string_view name) { return at(find(name)); }
    const RigidBody& body(std::string_view name) {
        return std::as_const(game.world).get<RigidBody>(find(name));
    }
    std::vector<Vec2> places(std::string_view beginning) {
        std::vector<Vec2> list;
        for (const EntityId entity : all(beginning)) list.push_back(at(entity));
        return list;
    }

    /// The value of a property of a script; T is the type in which worlds store it.
    template <class T>
    T& property(std::string_view name, std::string_view script, std::string_view field) {
        const TypeInfo& type = *game.types.find(script);
        return *static_cast<T*>(type.find(field)->in(game.world.find(type, find(name))));
    }
    /// The text that replaces {word} in labels.
    std::string shown(std::string_view word) {
        const std::string* text = game.world.resource<LabelValues>().find(word);
        return text == nullptr ? std::string{} : *text;
    }

    PhysicsState& physics() { return game.world.resource<PhysicsState>(); }
    /// Positions of the particles of a soft body, px.
    std::vector<Vec2> particles(std::string_view name) {
        const EntityId entity = find(name);
        std::vector<Vec2> list;
        for (const SoftLinkage& linkage : physics().softBodies) {
            if (linkage.entity != entity) continue;
            for (const physics::SoftParticle& particle : physics::particlesOf(physics().world, linkage.body))
                list.push_back(positionInPixels(particle.place, physics().scale));
        }
        EXPECT_FALSE(list.empty()) << name << " is not a soft body";
        return list;
    }
};

}  // namespace plumb
